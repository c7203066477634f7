// zonal-shader-bench: the tables of the papers' GPU times, on this machine's driver.
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <zonal/file/standard_output.hpp>

#include "driver.hpp"
#include "example.hpp"
#include "scenes.hpp"

namespace {

constexpr int repetitions = 5;

/// HVL Table 1: lights down, bands across.
void time_gathers(Driver& driver, std::size_t receivers, const std::vector<std::size_t>& light_counts) {
  std::printf("gather, %zu receivers, ms   lights    3 bands    5 bands    7 bands    9 bands\n", receivers);
  for (const std::string shell : {"gather", "gather_reversed"}) {
    for (const std::size_t lights : light_counts) {
      std::printf("%-28s %6zu", shell.c_str(), lights);
      for (const int bands : {3, 5, 7, 9}) {
        const GatherScene scene(bands, lights, receivers);
        std::printf(" %10.3f", run_gather(driver, scene, gather_example(bands, shell), repetitions).milliseconds);
        std::fflush(stdout);
      }
      std::printf("\n");
    }
  }
}

/// Gradient paper, Table 2.
void time_grids(Driver& driver, int vertices, std::size_t lights, const std::vector<int>& band_counts) {
  std::printf("grid of %d^3, %zu spheres, ms\n%-22s", vertices, lights, "bands");
  for (const int bands : band_counts) std::printf(" %9d", bands);
  std::printf("\n");
  const GridScene scene(lights, glm::ivec3(vertices));
  for (const std::string shell : {"sum_lights", "sum_lights_reversed"}) {
    std::printf("%-22s", shell.c_str());
    for (const int bands : band_counts) {
      std::printf(" %9.3f", run_grid(driver, scene, bands, grid_example(bands, shell), repetitions).milliseconds);
      std::fflush(stdout);
    }
    std::printf("\n");
  }
}

int run_main(int argc, char** argv) {
  bool small = false;
  CLI::App app("Times the gather and the grid on this machine's OpenGL driver.", "zonal-shader-bench");
  app.add_flag("--small", small, "Sizes that a driver on the CPU can bear");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "zonal-shader-bench: %s\n", error.what());
    return 2;
  }
  std::string reason;
  const std::unique_ptr<Driver> driver = Driver::open(reason);
  if (driver == nullptr) {
    std::fprintf(stderr, "zonal-shader-bench: skipped: %s\n", reason.c_str());
    return 77;
  }
  std::printf("%s\n", driver->renderer().c_str());
  if (small) {
    time_gathers(*driver, 1024, {4});
    time_grids(*driver, 2, 8, {5});
  } else {
    time_gathers(*driver, 1280 * 1024, {64, 196, 400});
    time_grids(*driver, 8, 648, {5, 6, 7, 8, 9});
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return zonal::with_standard_output([&] { return run_main(argc, argv); });
  } catch (const std::exception& error) {
    std::fprintf(stderr, "zonal-shader-bench: %s\n", error.what());
    return 1;
  }
}
