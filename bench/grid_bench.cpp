// Gradient paper, Table 2: value and gradient of 648 lights at the vertices of an 8^3 grid, on all cores.
#include <algorithm>
#include <cmath>

#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <zonal/grid/add_lights.hpp>
#include <zonal/grid/add_polygons.hpp>

#include "bench.hpp"
#include "built_bands.hpp"
#include "square_light.hpp"

namespace zonal_bench {
namespace {

using zonal::CoefficientGrid;

const auto on_all_cores = [](int count, const auto& body) { tbb::parallel_for(0, count, body); };

// Grid and light as close as the paper's figures look: the box ends one unit below the light.
template <int N>
CoefficientGrid<N> empty_grid() {
  return {{-1, -1, -1}, {1, 1, 1}, glm::ivec3(8)};
}

// The greatest error at the vertices of the box's diagonal, of the largest coefficient, against each triangle in
// double.
template <int N>
double error_of(const CoefficientGrid<N>& grid, const std::vector<ColouredLight<zonal::TriangleLight<float>>>& lights) {
  double worst = 0, largest = 0;
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 vertex(i);
    const auto got = grid.value(vertex);
    for (int c = 0; c < 3; ++c) {
      zonal::Sh<N, double> exact{};
      for (const auto& light : lights) {
        exact += zonal::project<N>(widened(light.light), glm::dvec3(grid.position(vertex)), 1e-10) *
                 static_cast<double>(light.colour[c]);
      }
      for (int k = 0; k < N * N; ++k) {
        worst = std::max(worst, std::abs(static_cast<double>(got[k][c]) - exact[k]));
        largest = std::max(largest, std::abs(exact[k]));
      }
    }
  }
  return worst / largest;
}

// Times add(grid), of which the whole counts as one item.
template <int N, class Add>
void time_grid(benchmark::State& state, const Add& add) {
  CoefficientGrid<N> grid = empty_grid<N>();
  for (auto _ : state) {
    add(grid);
    benchmark::DoNotOptimize(grid.data());
    benchmark::ClobberMemory();
  }
  state.counters[lanes_counter] = zonal::kNativeLanes;
  state.counters["threads"] = tbb::info::default_concurrency();
  state.counters[time_counter] =
      benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <int N>
void spheres(benchmark::State& state) {
  const auto lights = as_spheres(square_of_triangles(18));
  time_grid<N>(state, [&](auto& grid) { zonal::add_lights(grid, lights, on_all_cores); });
}

template <int N>
void triangles_as_spheres(benchmark::State& state) {
  const auto lights = as_modulated_spheres(square_of_triangles(18));
  time_grid<N>(state, [&](auto& grid) { zonal::add_lights(grid, lights, on_all_cores); });
}

template <int N>
void triangles(benchmark::State& state) {
  const auto lights = square_of_triangles(18);
  const double tolerance = 1e-4;
  time_grid<N>(state, [&](auto& grid) { zonal::add_lights(grid, lights, tolerance, on_all_cores); });
  CoefficientGrid<N> grid = empty_grid<N>();
  zonal::add_lights(grid, lights, tolerance, on_all_cores);
  state.counters["error"] = error_of(grid, lights);
}

}  // namespace

void register_grid(const Effort& effort) {
  // Wall-clock time: it is that of all threads together.
  for_bands(Built<Bands<5, 6, 7, 8, 9>, Bands<5>>{}, [&](auto n) {
    register_benchmark("grid-spheres", n, "packet", spheres<n>, effort)->UseRealTime();
    register_benchmark("grid-triangles-as-spheres", n, "packet", triangles_as_spheres<n>, effort)->UseRealTime();
    register_benchmark("grid-triangles", n, "packet", triangles<n>, effort)->UseRealTime();
  });
}

}  // namespace zonal_bench
