// The discontinuity filter of 27 floats a pixel, in place and by one thread, beside copying them twice.
#include <cstring>

#include <zonal/screen/filter.hpp>

#include "bench.hpp"
#include "screen_pictures.hpp"

namespace zonal_bench {
namespace {

constexpr int width = 1280, height = 720;
using Radiance = zonal::RadiancePicture<screen_bands>;

zonal::SurfacePicture surfaces_of(const ScreenCase& screen) {
  zonal::SurfacePicture surfaces(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float depth = 1 + 0.01F * float(y);
      const bool odd = screen.broken_every > 0 && (x / screen.broken_every + y / screen.broken_every) % 2 == 1;
      surfaces.set_surface(x, y, {0.01F * depth * float(x), -1, -depth}, {0, 1, 0}, depth, odd ? 1 : 0, 0);
    }
  }
  return surfaces;
}

Radiance filled_picture() {
  Radiance picture(width, height);
  for (std::size_t i = 0; i < picture.size(); ++i) picture.data()[i] = float(i % 17);
  return picture;
}

void count_pixels(benchmark::State& state) {
  state.counters[time_counter] = benchmark::Counter(
      double(width) * height, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters[lanes_counter] = zonal::kNativeLanes;
}

void run_copies(benchmark::State& state) {
  const Radiance source = filled_picture();
  Radiance target = source;
  for (auto _ : state) {
    for (int copy = 0; copy < 2; ++copy) {
      std::memcpy(target.data(), source.data(), source.size() * sizeof(float));
      benchmark::ClobberMemory();
    }
  }
  count_pixels(state);
}

void run_filter(benchmark::State& state, const ScreenCase& screen) {
  const zonal::SurfacePicture surfaces = surfaces_of(screen);
  Radiance picture = filled_picture();
  for (auto _ : state) {
    zonal::filter(picture, surfaces, {screen.sets_side, screen.sets_side});
    benchmark::ClobberMemory();
  }
  count_pixels(state);
}

}  // namespace

void register_screen(const Effort& effort) {
  register_benchmark("screen-two-copies", screen_bands, "float", run_copies, effort);
  for (const ScreenCase& screen : screen_cases) {
    register_benchmark(
        "screen-filter", screen_bands, screen.name, [=](auto& state) { run_filter(state, screen); }, effort);
  }
}

}  // namespace zonal_bench
