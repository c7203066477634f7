// Light probes to light everywhere: pictures taken at scattered places of a room become coefficients on a grid, and
// between.
//
//   g++ -std=c++17 -O2 -Iinclude examples/pages/light_field.cpp -o light_field
#include <zonal/field/resample.hpp>
#include <zonal/grid/interpolate.hpp>
#include <zonal/lobe/lambert.hpp>
#include <zonal/transform/convolve.hpp>

#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include <glm/glm.hpp>

namespace {

// The room: dim walls, and a window in the ceiling, two metres above, half of it red.
glm::vec3 radiance(const glm::vec3& place, const glm::vec3& direction) {
  if (direction.z > 0) {
    const glm::vec3 there = place + direction * ((2 - place.z) / direction.z);
    if (std::abs(there.x) < 0.5f && std::abs(there.y) < 0.5f) return there.x < 0 ? glm::vec3(9, 1, 1) : glm::vec3(5);
  }
  return glm::vec3(0.2f);
}

// On a floor, by 90 x 360 directions: the truth.
glm::vec3 irradiance(const glm::vec3& place) {
  glm::vec3 sum(0);
  for (int i = 0; i < 90; ++i) {
    for (int j = 0; j < 360; ++j) {  // equal steps of the squared sine of the angle from the normal are equal shares
      const float sine2 = (float(i) + 0.5f) / 90, phi = (float(j) + 0.5f) * float(zonal::kPi) / 180;
      const float sine = std::sqrt(sine2);
      sum += radiance(place, {sine * std::cos(phi), sine * std::sin(phi), std::sqrt(1 - sine2)});
    }
  }
  return sum * float(zonal::kPi) / (90.0f * 360.0f);
}

}  // namespace

int main() {
  // The camera looks along x; its pictures are of a mirror ball of 5 cm, seen from afar.
  const float ball = 0.05f;
  const zonal::DirectionBuckets buckets(zonal::Mapping::mirror_sphere, 48, 48, glm::quat(1, 0, 0, 0));
  std::vector<zonal::ProbePlace> probes;
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    const auto coordinate = [&] { return float(random() % 1000) / 500 - 1; };
    const float x = coordinate(), y = coordinate(), z = coordinate();
    probes.push_back({{x, y, z}, {1, 0, 0}});
  }
  // What each probe shows in each direction. Of picture files, buckets.sort() does this.
  std::vector<zonal::RadianceSample> samples;
  for (std::size_t b = 0; b < buckets.size(); ++b) {
    for (const zonal::ProbePlace& probe : probes) {
      const glm::vec3 w = buckets[b].direction, light = radiance(zonal::ray_origin(probe, w, ball), w);
      samples.push_back({light.x, light.y, light.z});
    }
  }

  zonal::CoefficientGrid<3> grid(glm::vec3(-1), glm::vec3(1), glm::ivec3(12));  // with gradients
  zonal::resample(grid, buckets, samples, probes, ball);

  std::printf("    x   irradiance       truth\n");
  for (float x = -0.8f; x < 0.9f; x += 0.4f) {
    const glm::vec3 place(x, 0.2f, -0.5f), truth = irradiance(place);
    const auto light = zonal::interpolate<zonal::Interpolation::hermite>(grid, place);
    const glm::vec3 up(0, 0, 1), e = zonal::reconstruct_convolved(light, zonal::LambertLobe{}, up) * float(zonal::kPi);
    std::printf("%5.1f   %.2f %.2f %.2f   %.2f %.2f %.2f\n", double(x), double(e.r), double(e.g), double(e.b),
                double(truth.r), double(truth.g), double(truth.b));
  }
}

// It prints:
//       x   irradiance       truth
//    -0.8   1.52 0.96 0.96   1.52 0.95 0.95
//    -0.4   1.71 1.04 1.04   1.59 1.01 1.01
//     0.0   1.73 1.10 1.10   1.65 1.05 1.05
//     0.4   1.63 1.07 1.07   1.58 1.03 1.03
//     0.8   1.47 1.04 1.04   1.46 1.01 1.01
