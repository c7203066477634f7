// zonal-limits          what share of the processor's limit kernels reach, at 5 and 10 bands
// zonal-limits --quick  the same table, of times that mean nothing
//
// The build makes it for this machine's processor and, where that has AVX-512, for AVX2 too: zonal-limits-avx2.

#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <zonal/basis/batch.hpp>
#include <zonal/file/standard_output.hpp>
#include <zonal/grid/interpolate.hpp>
#include <zonal/transform/reconstruct_batch.hpp>

#include "../gather_kernels.hpp"
#include "../gather_scene.hpp"
#include "../kernel_facts.hpp"
#include "../limits.hpp"
#include "../results.hpp"
#include "../run_kernel.hpp"

namespace zonal_bench {
namespace {

using Lanes = zonal::Packet<float, zonal::kNativeLanes>;
using zonal_report::Body;

struct Row {
  std::string name;
  Work work;
  double registers;  // of lanes, that a call of the body goes through
  Body body;
};

// An entry of the registry. Its inputs and results stand in the first-level cache.
template <class Entry, int N>
Row kernel_row() {
  const KernelFacts facts = facts_of<Entry, N>();
  const auto data = std::make_shared<KernelData<Lanes>>(draw_data<Lanes>(facts, N));
  const Work work{facts.count, static_cast<double>(data->input_size), static_cast<double>(data->outputs.size())};
  return {kernel_name(Entry::name, N), work, static_cast<double>(data->runs), [data] { run_on_all<Entry, N>(*data); }};
}

// 400 lights, which stand in the second-level cache.
template <int N, int NE>
Row gather_row() {
  struct Scene {
    Random random;
    zonal::MaterialTable material = random_material(random);
    zonal::HvlCache<NE> cache{random_lights(random, 400, material)};
    std::vector<zonal::Receiver> receivers = random_receivers(random, 16);
  };
  const auto scene = std::make_shared<Scene>();
  Work work{facts_of<kernels::HvlRadiance<NE>, N>().count};
  work.count.additions += 3;  // to the sum over the lights
  work.loads = zonal::field_count<zonal::HvlRecord<NE, float>>;
  const double registers = scene->cache.packet_count() * static_cast<double>(scene->receivers.size());
  return {format("gather<%d, %d>", N, NE), work, registers, [scene] {
            for (const zonal::Receiver& receiver : scene->receivers) {
              auto radiance = zonal::gather<N, NE>(scene->cache, receiver, scene->material);
              benchmark::DoNotOptimize(radiance);
            }
          }};
}

std::vector<glm::vec3> random_directions(std::size_t count) {
  Random random;
  std::vector<glm::vec3> directions;
  for (std::size_t i = 0; i < count; ++i) directions.push_back(random.unit_vector());
  return directions;
}

// One function in many directions: the basis fused with a dot product, nothing of it stored.
template <int N>
Row fused_row() {
  constexpr int count = 1024;
  zonal::Sh<N, float> function;
  for (int i = 0; i < function.size(); ++i) function[i] = 1.0F / float(i + 1);
  Work work{facts_of<kernels::Evaluate, N>().count, 3, 1};
  for (int* kind : {&work.count.multiplications, &work.count.additions, &work.count.fused}) *kind += N * N;
  return {kernel_name("reconstruct", N), work, count / Lanes::width,
          [function, directions = random_directions(count), values = std::vector<float>(count)]() mutable {
            zonal::reconstruct(function, zonal::direction_span(directions.data(), directions.size()), values.data());
            benchmark::ClobberMemory();
          }};
}

// As many directions as fill half of the second-level cache.
template <int N, class Results>
Row batch_row(const char* name) {
  constexpr std::size_t count = (std::size_t{512} << 10) / (sizeof(float) * N * N) / 16 * 16;
  const std::vector<glm::vec3> directions = random_directions(count);
  // Whole cache lines.
  const auto memory = std::make_shared<std::vector<Lanes>>(count * N * N / Lanes::width);
  const Work work{facts_of<kernels::Evaluate, N>().count, 3, N * N};
  return {kernel_name(name, N), work, static_cast<double>(count / Lanes::width), [directions, memory] {
            auto* const numbers = reinterpret_cast<float*>(memory->data());
            const auto span = zonal::direction_span(directions.data(), directions.size());
            if constexpr (std::is_same_v<Results, zonal::CoefficientRows<float>>) {
              zonal::evaluate<N>(span, Results{numbers});
            } else {
              zonal::evaluate<N>(span, Results{numbers, directions.size()});
            }
            benchmark::ClobberMemory();
          }};
}

// A grid of one cell, whose corners stand in the first-level cache at 5 bands. One look-up counts as a register.
template <int N>
Row look_up_row() {
  using Grid = zonal::CoefficientGrid<N>;
  const auto grid = std::make_shared<Grid>(glm::vec3(0), glm::vec3(1), glm::ivec3(2));
  const auto places = std::make_shared<std::vector<glm::vec3>>();
  Random random;
  for (int i = 0; i < 64; ++i) places->push_back(0.5F + 0.5F * random.unit_vector());
  Work work;  // of the sums of 8 corners' values and gradients; their weights cost little beside
  work.loads = double(8 * Grid::vertex_size) / Lanes::width;
  work.count.multiplications = work.count.additions = work.count.fused = int(work.loads);
  return {kernel_name("interpolate", N), work, double(places->size()), [grid, places] {
            for (const glm::vec3& place : *places) {
              auto value = zonal::interpolate<zonal::Interpolation::hermite, glm::vec3>(*grid, place);
              benchmark::DoNotOptimize(value);
            }
          }};
}

template <int N>
void add_rows(std::vector<Row>& rows) {
  rows.push_back(kernel_row<kernels::Evaluate, N>());
  rows.push_back(batch_row<N, zonal::CoefficientPlanes<float>>("evaluate planes"));
  rows.push_back(batch_row<N, zonal::CoefficientRows<float>>("evaluate rows"));
  rows.push_back(kernel_row<kernels::EvaluateWithGradient, N>());
  rows.push_back(fused_row<N>());
  rows.push_back(kernel_row<kernels::Cap, N>());
  rows.push_back(kernel_row<kernels::Orient, N>());
  rows.push_back(kernel_row<kernels::Convolve, N>());
  rows.push_back(kernel_row<kernels::Rotate, N>());
  rows.push_back(look_up_row<N>());
  rows.push_back(gather_row<N, 1>());
  rows.push_back(gather_row<N, 3>());
}

void print(const Limits& limits, const std::vector<Row>& rows, const std::vector<double>& seconds) {
  const double bytes = sizeof(Lanes);
  std::printf(
      "Shares of the limit, %d lanes, one thread. At best, ns for a register: multiply-add %.3f; additions and\n"
      "multiply-adds by turns %.3f; divide %.2f; root %.2f; load %.3f (%.0f GB/s); store %.3f (%.0f GB/s).\n\n",
      Lanes::width, limits.multiply, limits.operation, limits.divide, limits.root, limits.load, bytes / limits.load,
      limits.store, bytes / limits.store);
  std::printf(
      "kernel/bands               mul   add fused   div  root   cmp  load store |  limit binds             ns  "
      "share\n");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [name, work, registers, body] = rows[i];
    const Bound bound = find_bound(limits, work);
    const double ns = 1e9 * seconds[i] / registers;
    const zonal::OperationCount& count = work.count;
    std::printf("%-24s %5d %5d %5d %5d %5d %5d %5.0f %5.0f | %6.2f %-11s %8.2f %5.0f%%\n", name.c_str(),
                count.multiplications, count.additions, count.fused, count.divisions, count.functions,
                count.comparisons, work.loads, work.stores, bound.ns, bound.name, ns, 100 * bound.ns / ns);
  }
}

int run(bool is_quick_run) {
  const zonal_report::Repetitions repetitions =
      is_quick_run ? zonal_report::Repetitions{1, 1e-4} : zonal_report::Repetitions{15, 0.002};
  std::vector<Row> rows;
  for_bands(Built<Bands<5, 10>, Bands<5>>{}, [&](auto n) { add_rows<n>(rows); });
  std::vector<Body> bodies;
  for (const Row& row : rows) bodies.push_back(row.body);
  const Limits limits = measure_limits(repetitions);
  print(limits, rows, median_seconds(bodies, repetitions));
  return 0;
}

}  // namespace
}  // namespace zonal_bench

int main(int argc, char** argv) {
  const std::string_view option = argc > 1 ? argv[1] : "";
  if (argc > 2 || (argc == 2 && option != "--quick")) {
    std::fprintf(stderr, "usage: zonal-limits [--quick]\n");
    return 2;
  }
  try {
    return zonal::with_standard_output([&] { return zonal_bench::run(argc == 2); });
  } catch (const std::exception& error) {
    std::fprintf(stderr, "zonal-limits: %s\n", error.what());
    return 1;
  }
}
