// Compiled once for each processor. What it takes of the standard library, of GLM, of yours has to melt into it:
// numbers and arrays do; containers, strings and streams stay in other files. check_symbols.cmake tells.
#include "kernels.hpp"

#include <zonal/environment/rgb.hpp>
#include <zonal/transform/reconstruct_batch.hpp>
#include <zonal/zonal.hpp>

#include <cmath>

namespace {

struct Vec3 {
  float x, y, z;
};

void reconstruct(const float (&coefficients)[75], const float* directions, std::size_t count, float* values) {
  zonal::Sh<5, zonal::Rgb<float>> sh;
  for (int i = 0; i < 25; ++i) sh[i] = {coefficients[3 * i], coefficients[3 * i + 1], coefficients[3 * i + 2]};
  zonal::reconstruct(sh, zonal::DirectionSpan<float>::triples(directions, count),
                     reinterpret_cast<zonal::Rgb<float>*>(values));
}

void light_floor(float height, float radius, const float* places, std::size_t count, float* values) {
  for (std::size_t k = 0; k < count; ++k) {
    const float x = -places[2 * k], y = -places[2 * k + 1], distance = std::sqrt(x * x + y * y + height * height);
    const auto cap = zonal::SphericalCap<float>::from_sphere(distance, radius);
    const auto radiance = zonal::orient(zonal::project<5>(cap), Vec3{x / distance, y / distance, height / distance});
    values[k] = zonal::reconstruct_convolved(radiance, zonal::LambertLobe{}, Vec3{0, 0, 1});
  }
}

}  // namespace

extern const Kernels KERNELS{reconstruct, light_floor};
