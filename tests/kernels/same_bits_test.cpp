// The hashes of what every kernel gives, as other compilers, options and processors have them: ../same_bits. Here by
// this compiler without optimisation, for this machine's processor.
#include <fstream>
#include <string>

#include "../same_bits/bits.hpp"
#include "kernel_checks.hpp"
#include "shader_functions.hpp"

namespace {

struct Kernel {
  const KernelRuns& runs;
  const char* name;
  std::vector<zonal::kernels::Parameter> parameters;
  std::size_t output_count;

  explicit Kernel(const KernelRuns& kernel) : runs(kernel), name(kernel.name) {
    const RecordedFunction function =
        kernel.record != nullptr ? kernel.record(zonal::shader::all_orders)
                                 : zonal_glsl::find_function(kernel.name)->record(run_bands, zonal::shader::all_orders);
    parameters = function.parameters;
    output_count = function.outputs.size();
  }
  template <class T>
  std::vector<T> run(const std::vector<T>& inputs) const {
    return runs.run(inputs, output_count);
  }
};

}  // namespace

TEST_CASE("Every kernel of the registry gives the bits that it gives everywhere, in packets too") {
  std::vector<KernelRuns> kernels;
  append_basis_runs(kernels);
  append_scene_runs(kernels);
  append_unwritten_runs(kernels);
  std::ifstream kept(ZONAL_TEST_DATA "/same_bits.txt");
  std::string expected;
  for (const KernelRuns& runs : kernels) {
    const Kernel kernel(runs);
    same_bits::Line<Kernel> line(kernel, run_bands);
    line.add_packets<float, 8>();
    line.add_packets<double, 4>();
    REQUIRE(std::getline(kept, expected));
    CHECK(line.text() == expected);
  }
  CHECK_FALSE(std::getline(kept, expected));
}
