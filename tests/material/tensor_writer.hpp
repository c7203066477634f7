// Writes RGL material files of known BRDFs: GGX with a roughness along x and one along y.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "../files.hpp"
#include "support.hpp"

namespace material_test {

struct Tensor {
  std::string name;
  int type;  // 1: uint8, 10: float32
  std::vector<std::uint64_t> shape;
  std::string data;
};

inline Tensor bytes_tensor(const std::string& name, const std::string& bytes) {
  return {name, 1, {bytes.size()}, bytes};
}
inline Tensor float_tensor(const std::string& name, const std::vector<std::uint64_t>& shape,
                           const std::vector<float>& values) {
  return {name, 10, shape, {reinterpret_cast<const char*>(values.data()), 4 * values.size()}};
}

inline std::string tensor_file(const std::vector<Tensor>& tensors) {
  using file_test::raw;
  std::size_t offset = 18;
  for (const Tensor& t : tensors) offset += 2 + t.name.size() + 2 + 1 + 8 + 8 * t.shape.size();
  std::string list = std::string("tensor_file\0\1\0", 14) + raw(std::uint32_t(tensors.size())), data;
  for (const Tensor& t : tensors) {
    list += raw(std::uint16_t(t.name.size())) + t.name + raw(std::uint16_t(t.shape.size())) + char(t.type) +
            raw(std::uint64_t(offset + data.size()));
    for (const std::uint64_t extent : t.shape) list += raw(extent);
    data += t.data;
  }
  return list + data;
}

/// Microfacets of two roughnesses, with the reflectance of a metal that differs by channel.
struct Microfacets {
  double alpha_x, alpha_y;

  double distribution(const glm::dvec3& m) const {
    const double x = m.x / alpha_x, y = m.y / alpha_y, sum = x * x + y * y + m.z * m.z;
    return 1.0 / (pi * alpha_x * alpha_y * sum * sum);
  }
  /// The projected area seen from w: the integral of D max(w . m, 0).
  double projected_area(const glm::dvec3& w) const { return 0.5 * (w.z + length(w)); }
  double length(const glm::dvec3& w) const {
    return std::sqrt(alpha_x * alpha_x * w.x * w.x + alpha_y * alpha_y * w.y * w.y + w.z * w.z);
  }
  glm::dvec3 operator()(const glm::dvec3& wi, const glm::dvec3& wo) const {
    if (wi.z <= 0.0 || wo.z <= 0.0) return glm::dvec3(0.0);
    const glm::dvec3 m = glm::normalize(wi + wo);
    const double visibility = 0.5 / (wo.z * length(wi) + wi.z * length(wo));
    return reflectance(zonal::SchlickFresnel{{0.9F, 0.6F, 0.2F}}, glm::dot(wi, m)) * (distribution(m) * visibility);
  }
};

/// The grid of a material file; samples are at the corners of its cells.
struct RglGrid {
  int phi_nodes = 1, theta_nodes = 12, square = 64, rgb = 48;
  int symmetry = 1;
  bool jacobian = true;
};

inline double square_theta(double u) { return 0.5 * pi * u * u; }
inline double square_phi(double u) { return (2.0 * u - 1.0) * pi; }

/// Where, in [0, 1], the integral of the function linear between v(0), ..., v(count - 1) reaches `part` of the whole:
/// cell by cell, then by bisection.
template <class V>
double place_of(const V& v, int count, double part) {
  const auto integral = [&](int i, double t) { return t * (v(i) + 0.5 * t * (v(i + 1) - v(i))); };
  double left = 0.0;
  for (int i = 0; i + 1 < count; ++i) left += part * integral(i, 1.0);
  int cell = 0;
  for (; cell + 2 < count && left > integral(cell, 1.0); ++cell) left -= integral(cell, 1.0);
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 45; ++i) {
    const double middle = 0.5 * (low + high);
    (integral(cell, middle) < left ? low : high) = middle;
  }
  return (cell + low) / (count - 1);
}

/// A density on the unit square, bilinear between size * size samples (rows over y), and where a uniform place of it
/// comes from.
class Density {
 public:
  Density(int size, std::vector<double> values) : n_(size), values_(std::move(values)) {
    for (int row = 0; row < n_; ++row) {
      double sum = 0.0;
      for (int i = 0; i + 1 < n_; ++i) sum += 0.5 * (at(row, i) + at(row, i + 1));
      row_masses_.push_back(sum);
    }
  }

  glm::dvec2 at_mass(double mass_x, double mass_y) const {
    const double y = place_of([&](int row) { return row_masses_[std::size_t(row)]; }, n_, mass_y);
    const int row = std::min(int(y * (n_ - 1)), n_ - 2);
    const double t = y * (n_ - 1) - row;
    return {place_of([&](int i) { return (1.0 - t) * at(row, i) + t * at(row + 1, i); }, n_, mass_x), y};
  }

 private:
  double at(int row, int column) const { return values_[std::size_t(row * n_ + column)]; }

  int n_;
  std::vector<double> values_, row_masses_;
};

/// The fields of the material's file. Where the reflected direction is below the horizon the value is zero.
inline std::vector<Tensor> rgl_tensors(const Microfacets& f, const RglGrid& grid) {
  const bool isotropic = grid.phi_nodes <= 2;
  const auto n = std::uint64_t(grid.square), r = std::uint64_t(grid.rgb);
  const auto p = std::uint64_t(grid.phi_nodes), t = std::uint64_t(grid.theta_nodes);
  std::vector<float> phi_i, theta_i, sigma, ndf, vndf, rgb, luminance;
  for (int i = 0; i < grid.phi_nodes; ++i) {
    phi_i.push_back(isotropic ? float(i) : float(-pi + 2.0 * pi / grid.symmetry * i / (grid.phi_nodes - 1)));
  }
  for (int i = 0; i < grid.theta_nodes; ++i) theta_i.push_back(float(0.5 * pi * i / grid.theta_nodes));
  const auto on_square = [&](int column, int row, double turn) {
    return direction(square_theta(column / double(grid.square - 1)), square_phi(row / double(grid.square - 1)) + turn);
  };
  for (int row = 0; row < grid.square; ++row) {
    for (int column = 0; column < grid.square; ++column) {
      const glm::dvec3 w = on_square(column, row, 0.0);
      sigma.push_back(float(f.projected_area(w)));
      ndf.push_back(float(f.distribution(w)));
    }
  }
  for (const float phi : phi_i) {
    for (const float theta : theta_i) {
      const glm::dvec3 wo = direction(double(theta), double(phi));
      const double turn = isotropic ? double(phi) : 0.0, area = f.projected_area(wo);
      std::vector<double> density;
      for (int row = 0; row < grid.square; ++row) {
        for (int column = 0; column < grid.square; ++column) {
          const double u = column / double(grid.square - 1);
          const glm::dvec3 m = on_square(column, row, turn);
          const double jacobian = 2.0 * pi * pi * u * std::sin(square_theta(u));
          density.push_back(double(float(f.distribution(m) * std::fmax(glm::dot(wo, m), 0.0) / area * jacobian)));
          vndf.push_back(float(density.back()));
        }
      }
      const Density visible(grid.square, density);
      std::vector<glm::dvec3> values;
      for (int row = 0; row < grid.rgb; ++row) {
        for (int column = 0; column < grid.rgb; ++column) {
          const glm::dvec2 u = visible.at_mass(column / double(grid.rgb - 1), row / double(grid.rgb - 1));
          const glm::dvec3 m = direction(square_theta(u.x), square_phi(u.y) + turn);
          const glm::dvec3 wi = 2.0 * glm::dot(wo, m) * m - wo;
          const double divisor = grid.jacobian ? f.distribution(m) / (4.0 * area) : 1.0;
          values.push_back(glm::dot(wo, m) > 0.0 ? f(wi, wo) * (wi.z / divisor) : glm::dvec3(0.0));
        }
      }
      for (int c = 0; c < 3; ++c) {
        for (const glm::dvec3& value : values) rgb.push_back(float(value[c]));
      }
      for (const glm::dvec3& value : values) luminance.push_back(float(value.y));
    }
  }
  return {bytes_tensor("description", "microfacets"),
          float_tensor("phi_i", {p}, phi_i),
          float_tensor("theta_i", {t}, theta_i),
          float_tensor("sigma", {n, n}, sigma),
          float_tensor("ndf", {n, n}, ndf),
          float_tensor("vndf", {p, t, n, n}, vndf),
          float_tensor("luminance", {p, t, r, r}, luminance),
          float_tensor("rgb", {p, t, 3, r, r}, rgb),
          bytes_tensor("jacobian", std::string(1, grid.jacobian ? '\1' : '\0'))};
}

}  // namespace material_test
