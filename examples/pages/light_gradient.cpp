// What a sphere light sends to a point, and how that changes when the point moves: coefficients and their gradient, by
// which a value computed once serves a neighbourhood. Needs GLM, headers alone:
//
//   g++ -std=c++17 -O2 -Iinclude examples/pages/light_gradient.cpp -o light_gradient
#include <zonal/light/sphere.hpp>
#include <zonal/zonal.hpp>

#include <cmath>
#include <cstdio>

int main() {
  const zonal::SphereLight<float> lamp{{0, 0, 3}, 0.5F};  // centre and radius in metres; its radiance is 1
  const glm::vec3 here(0.4F, 0.3F, 0), normal(0, 0, 1);

  // Radiance in five bands at `here`, and its derivatives by x, y and z of the place, per metre.
  const zonal::ShGradient<5, float> at = zonal::project_with_gradient<5>(lamp, here);

  for (const glm::vec3& step : {glm::vec3(0), glm::vec3(0.1F, 0, 0), glm::vec3(0, 0, 0.1F), glm::vec3(0, 0, 0.2F)}) {
    const auto carried = at.value + at.gradient[0] * step.x + at.gradient[1] * step.y + at.gradient[2] * step.z;
    const auto there = zonal::project<5>(lamp, here + step);
    const float by_gradient = zonal::reconstruct_convolved(carried, zonal::LambertLobe{}, normal);
    const float anew = zonal::reconstruct_convolved(there, zonal::LambertLobe{}, normal);

    // E / pi of a sphere of radiance 1 that stands above the horizon in full: (r / d)^2 times the cosine.
    const glm::vec3 to_lamp = lamp.center - (here + step);
    const float d = std::sqrt(to_lamp.x * to_lamp.x + to_lamp.y * to_lamp.y + to_lamp.z * to_lamp.z);
    const float exact = lamp.radius * lamp.radius / (d * d) * to_lamp.z / d;
    std::printf("%.1f %.1f %.1f: E / pi %.5f by the gradient, %.5f anew, %.5f exactly\n", double(step.x),
                double(step.y), double(step.z), double(by_gradient), double(anew), double(exact));
  }
}

// It prints:
//   0.0 0.0 0.0: E / pi 0.02606 by the gradient, 0.02606 anew, 0.02666 exactly
//   0.1 0.0 0.0: E / pi 0.02577 by the gradient, 0.02573 anew, 0.02627 exactly
//   0.0 0.0 0.1: E / pi 0.02774 by the gradient, 0.02782 anew, 0.02845 exactly
//   0.0 0.0 0.2: E / pi 0.02942 by the gradient, 0.02977 anew, 0.03042 exactly
