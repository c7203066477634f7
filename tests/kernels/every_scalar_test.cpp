// Every kernel of the registry in every scalar, against itself in long double, which the rooms' tests set against
// definitions. That records are to the bit what C++ computes: ../shader/record_test.cpp, and here for those that are no
// shader functions. Compiled without fused multiplication and addition, for just that.
#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "kernel_checks.hpp"
#include "shader_functions.hpp"

namespace {

using zonal::shader::all_orders;

const std::vector<KernelRuns>& all_kernels() {
  static const std::vector<KernelRuns> all = [] {
    std::vector<KernelRuns> kernels;
    append_basis_runs(kernels);
    append_scene_runs(kernels);
    append_unwritten_runs(kernels);
    return kernels;
  }();
  return all;
}

KernelBound bound_of(const char* name) {
  const auto is_its = [&](const KernelBound& row) { return std::string_view(row.kernel) == name; };
  REQUIRE(std::count_if(std::begin(kernel_bounds), std::end(kernel_bounds), is_its) == 1);
  return *std::find_if(std::begin(kernel_bounds), std::end(kernel_bounds), is_its);
}

Subject subject_of(const KernelRuns& kernel) {
  return {kernel,
          kernel.record != nullptr ? kernel.record(all_orders)
                                   : zonal_glsl::find_function(kernel.name)->record(run_bands, all_orders),
          bound_of(kernel.name)};
}

template <class Check>
void for_every_kernel(Check check) {
  for (const KernelRuns& kernel : all_kernels()) {
    INFO(kernel.name);
    check(subject_of(kernel));
  }
}

}  // namespace

TEST_CASE("Every kernel of the registry in float and double") {
  for_every_kernel([](const Subject& subject) {
    check_builtin<float>(subject);
    check_builtin<double>(subject);
  });
}

TEST_CASE("Every kernel of the registry in packets") {
  for_every_kernel([](const Subject& subject) {
    check_packet<float, 8>(subject);
    check_packet<double, 4>(subject);
  });
}

TEST_CASE("Every kernel of the registry in dual numbers") { for_every_kernel(check_dual); }

TEST_CASE("Every kernel of the registry in shadow pairs") { for_every_kernel(check_shadow); }

TEST_CASE("Every kernel that is no shader function, recorded, to the bit") {
  for (const KernelRuns& kernel : all_kernels()) {
    if (kernel.record == nullptr) continue;
    INFO(kernel.name);
    check_record(subject_of(kernel));
  }
}

TEST_CASE("No kernel stands twice in the registry, and each has one bound") {
  std::set<std::string> names;
  for (const KernelRuns& kernel : all_kernels()) CHECK(names.insert(kernel.name).second);
  for (const auto& entry : zonal_glsl::shader_functions()) {
    const bool is_colour = entry.name.find("_colour") != std::string_view::npos;
    CHECK(names.count(std::string(entry.name)) == (is_colour ? 0 : 1));
  }
  for (const KernelBound& row : kernel_bounds) CHECK(names.erase(row.kernel) == 1);
  CHECK(names.empty());
}
