// Writes files of the MERL format from known BRDFs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "../files.hpp"
#include "support.hpp"

namespace material_test {

inline constexpr std::size_t merl_bins = 90 * 90 * 180;
inline constexpr double merl_scale[3] = {1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};

struct Pair {
  glm::dvec3 wi, wo;
};

/// The directions of half and difference angles, by the rotations that define them.
inline Pair directions(double theta_half, double theta_difference, double phi_difference) {
  const auto rotate_y = [](const glm::dvec3& v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return glm::dvec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x);
  };
  const glm::dvec3 d = direction(theta_difference, phi_difference);
  return {rotate_y(d, theta_half), rotate_y({-d.x, -d.y, d.z}, theta_half)};
}

/// The middle of a bin.
inline Pair middle(int half, int theta, int phi) {
  const double root = (half + 0.5) / 90.0;
  return directions(root * root * 0.5 * pi, (theta + 0.5) / 90.0 * 0.5 * pi, (phi + 0.5) / 180.0 * pi);
}

/// A file as MERL's own program writes it: planes of channels, phi fastest, -1 where a direction is below the horizon.
template <class F>
std::string merl_bytes(const F& brdf) {
  std::string bytes =
      file_test::raw(std::int32_t{90}) + file_test::raw(std::int32_t{90}) + file_test::raw(std::int32_t{180});
  std::vector<double> planes(3 * merl_bins);
  for (int h = 0; h < 90; ++h) {
    for (int t = 0; t < 90; ++t) {
      for (int p = 0; p < 180; ++p) {
        const Pair pair = middle(h, t, p);
        const bool measured = pair.wi.z > 0.0 && pair.wo.z > 0.0;
        const glm::dvec3 f = measured ? brdf(pair.wi, pair.wo) : glm::dvec3(0.0);
        const auto i = std::size_t(p + 180 * (t + 90 * h));
        for (int c = 0; c < 3; ++c) planes[i + merl_bins * std::size_t(c)] = measured ? f[c] / merl_scale[c] : -1.0;
      }
    }
  }
  bytes.append(reinterpret_cast<const char*>(planes.data()), 8 * planes.size());
  return bytes;
}
inline std::string merl_bytes(const zonal::Brdf& brdf) {
  return merl_bytes([&](const glm::dvec3& wi, const glm::dvec3& wo) { return evaluate(brdf, wi, wo); });
}

}  // namespace material_test
