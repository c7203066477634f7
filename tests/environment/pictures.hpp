// What the tests of environments share: sizes of pictures in every mapping, and slow checks.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <zonal/environment/environment.hpp>

inline std::array<double, 3> unit(std::array<double, 3> v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (double& x : v) x /= length;
  return v;
}

/// A picture with about `size` texels from pole to pole.
inline std::pair<int, int> picture_size(zonal::Mapping mapping, int size) {
  using zonal::Mapping;
  switch (mapping) {
    case Mapping::equirectangular: return {2 * size, size};
    case Mapping::vertical_cross: return {3 * size, 4 * size};
    case Mapping::horizontal_cross: return {4 * size, 3 * size};
    case Mapping::vertical_faces: return {size, 6 * size};
    case Mapping::horizontal_faces: return {6 * size, size};
    default: return {size, size};
  }
}

/// body(mapping object, width, height) for all mappings and sizes.
template <class Body>
void for_each_mapping(const std::vector<int>& sizes, const Body& body) {
  for (const int size : sizes) {
    for (int i = 0; i < zonal::kMappingCount; ++i) {
      const auto [width, height] = picture_size(zonal::Mapping(i), size);
      zonal::visit_mapping(zonal::Mapping(i),
                           [&, w = width, h = height](auto tag) { body(typename decltype(tag)::Type(w, h), w, h); });
    }
  }
}

/// The area on the sphere of a texel, by central differences in parts of it; negative where it has no directions in
/// places.
template <class M>
double swept_area(const M& mapping, int column, int row) {
  constexpr int parts = 60;  // even, so that an edge through the middle or along the diagonal is met
  constexpr double step = 1e-4;
  double area = 0;
  for (int i = 0; i < parts; ++i) {
    for (int j = 0; j < parts; ++j) {
      const double x = column + (i + 0.5) / parts, y = row + (j + 0.5) / parts, e = step;
      const std::array<double, 3> d[4] = {mapping.direction(x - e, y), mapping.direction(x + e, y),
                                          mapping.direction(x, y - e), mapping.direction(x, y + e)};
      double u[3], v[3];
      for (std::size_t k = 0; k < 3; ++k) u[k] = (d[1][k] - d[0][k]) / (2 * e), v[k] = (d[3][k] - d[2][k]) / (2 * e);
      for (const auto& w : d) {
        if (w[0] * w[0] + w[1] * w[1] + w[2] * w[2] < 0.5) return -1;
      }
      area += std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
    }
  }
  return area / (parts * parts);
}
