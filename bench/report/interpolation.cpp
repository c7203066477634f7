// The three interpolations over resolutions: 5 bands of 64 sphere lights about a box, on one thread.
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>
#include <glm/geometric.hpp>
#include <zonal/grid/add_lights.hpp>
#include <zonal/grid/interpolate.hpp>
#include <zonal/light/sphere.hpp>

#include "timing.hpp"

namespace zonal_report {
namespace {

using zonal::CoefficientGrid, zonal::Interpolation;
using Light = zonal::ColouredLight<zonal::SphereLight<float>>;

constexpr int N = 5;
const auto one_by_one = [](int count, const auto& body) {
  for (int i = 0; i < count; ++i) body(i);
};

glm::vec3 random_point(std::mt19937& random) {
  std::uniform_real_distribution<float> uniform(-1, 1);
  const float x = uniform(random), y = uniform(random);
  return {x, y, uniform(random)};
}

// Outside the box from -1 to 1, in every direction.
std::vector<Light> lights_about_the_box() {
  std::mt19937 random(3);
  std::vector<Light> lights;
  while (lights.size() < 64) {
    const glm::vec3 center = 2.5F * random_point(random);
    const glm::vec3 beyond = glm::max(glm::abs(center) - 1.0F, glm::vec3(0));
    const float radius = 0.2F + 0.1F * random_point(random).x;
    if (glm::length(beyond) < 0.4F + radius) continue;
    lights.push_back({{center, radius}, glm::vec3(1.5F) + random_point(random)});
  }
  return lights;
}

// What the interpolation reads, and no more.
template <Interpolation method>
using Grid = CoefficientGrid<N, zonal::blocks_read(method) == 1 ? zonal::GridContent::values
                                                                : zonal::GridContent::values_and_gradients>;

template <Interpolation method>
Grid<method> grid_of(int resolution, const std::vector<Light>& lights) {
  Grid<method> grid(glm::vec3(-1), glm::vec3(1), glm::ivec3(resolution));
  zonal::add_lights(grid, lights, one_by_one);
  return grid;
}

// What all lights together are at a place, RGB.
zonal::ShGradient<N, glm::dvec3> exact_at(const std::vector<Light>& lights, const glm::vec3& place) {
  zonal::ShGradient<N, glm::dvec3> sum{};
  for (const Light& light : lights) {
    const zonal::SphereLight<double> wide{glm::dvec3(light.light.center), double(light.light.radius)};
    const auto sh = zonal::project_with_gradient<N>(wide, glm::dvec3(place));
    for (int i = 0; i < N * N; ++i) {
      sum.value[i] += sh.value[i] * glm::dvec3(light.colour);
      for (int axis = 0; axis < 3; ++axis) sum.gradient[axis][i] += sh.gradient[axis][i] * glm::dvec3(light.colour);
    }
  }
  return sum;
}

struct Truth {
  std::vector<glm::vec3> places;
  std::vector<zonal::ShGradient<N, glm::dvec3>> exact;
};
Truth truth(const std::vector<Light>& lights, int count) {
  std::mt19937 random(4);
  Truth truth;
  for (int i = 0; i < count; ++i) {
    truth.places.push_back(random_point(random));
    truth.exact.push_back(exact_at(lights, truth.places.back()));
  }
  return truth;
}

// Mean |difference| of coefficients over mean |coefficient|.
class MeanError {
 public:
  template <class Sh>
  void add(const Sh& got, const zonal::Sh<N, glm::dvec3>& exact) {
    for (int i = 0; i < N * N; ++i) {
      difference_ += glm::dot(glm::abs(glm::dvec3(got[i]) - exact[i]), glm::dvec3(1));
      size_ += glm::dot(glm::abs(exact[i]), glm::dvec3(1));
    }
  }
  double relative() const { return difference_ / size_; }

 private:
  double difference_ = 0, size_ = 0;
};

struct Line {
  const char* method;
  int resolution;
  double kibibytes, value_error, gradient_error;
  Body build, lookup, lookup_with_gradient;
};

template <Interpolation method>
Line line(const char* name, int resolution, const std::vector<Light>& lights, const Truth& truth) {
  const auto grid = std::make_shared<Grid<method>>(grid_of<method>(resolution, lights));
  MeanError value, gradient;
  for (std::size_t i = 0; i < truth.places.size(); ++i) {
    const auto got = zonal::interpolate_with_gradient<method>(*grid, truth.places[i]);
    value.add(got.value, truth.exact[i].value);
    for (int axis = 0; axis < 3; ++axis) gradient.add(got.gradient[axis], truth.exact[i].gradient[axis]);
  }
  return {name,
          resolution,
          double(grid->size()) * sizeof(float) / 1024,
          value.relative(),
          gradient.relative(),
          [resolution, &lights] {
            Grid<method> fresh = grid_of<method>(resolution, lights);
            benchmark::DoNotOptimize(fresh.data());
          },
          [grid, &truth] {
            for (const glm::vec3& place : truth.places) {
              auto sh = zonal::interpolate<method>(*grid, place);
              benchmark::DoNotOptimize(sh);
            }
          },
          [grid, &truth] {
            for (const glm::vec3& place : truth.places) {
              auto sh = zonal::interpolate_with_gradient<method>(*grid, place);
              benchmark::DoNotOptimize(sh);
            }
          }};
}

std::vector<int> resolutions(Effort effort) {
  return choose<std::vector<int>>(effort, {3, 6}, {2, 3, 4, 5, 6, 8, 10, 13, 16, 20, 25},
                                  {2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 14, 16, 18, 20, 22, 25, 28, 32});
}

// As large as the largest of the others, which keep four numbers where this keeps one.
std::vector<int> trilinear_resolutions(Effort effort) {
  std::vector<int> result = resolutions(effort);
  const std::vector<int> more = choose<std::vector<int>>(effort, {10}, {32, 40}, {36, 40, 45, 51});
  result.insert(result.end(), more.begin(), more.end());
  return result;
}

}  // namespace

void print_interpolation(Effort effort) {
  const auto lights = lights_about_the_box();
  const Truth at = truth(lights, choose(effort, 50, 2000, 10000));
  std::vector<Line> lines;
  for (const int resolution : trilinear_resolutions(effort)) {
    lines.push_back(line<Interpolation::trilinear>("trilinear", resolution, lights, at));
  }
  for (const int resolution : resolutions(effort)) {
    lines.push_back(line<Interpolation::taylor>("taylor", resolution, lights, at));
    lines.push_back(line<Interpolation::hermite>("hermite", resolution, lights, at));
  }
  std::vector<Body> bodies;
  for (const Line& line : lines) {
    bodies.insert(bodies.end(), {line.build, line.lookup, line.lookup_with_gradient});
  }
  const auto seconds = median_seconds(bodies, repetitions(effort));
  const double places = double(at.places.size());
  print_row("method", "bands", "lights", "resolution", "kibibytes", "build_ms", "lookup_ns", "lookup_with_gradient_ns",
            "value_error", "gradient_error");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Line& line = lines[i];
    print_row(line.method, N, lights.size(), line.resolution, line.kibibytes, 1e3 * seconds[3 * i],
              1e9 * seconds[3 * i + 1] / places, 1e9 * seconds[3 * i + 2] / places, line.value_error,
              line.gradient_error);
  }
}

}  // namespace zonal_report
