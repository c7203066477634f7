// The measured materials of the RGL database, isotropic and anisotropic, RGB (files *_rgb.bsdf).
//
// A file is a tensor file (tensor_file.hpp) with these fields, float32 unless said otherwise:
//
//   description  uint8 [length]
//   jacobian     uint8 [1]: whether rgb was divided by D / (4 sigma)
//   phi_i        [P]            azimuths of the direction i, radians, increasing; P <= 2: an isotropic material
//   theta_i      [T]            its angles to the normal, radians, increasing
//   sigma        [., .]         projected area of the microfacets seen from i
//   ndf          [., .]         D, the distribution of their normals m, 1/sr
//   vndf         [P, T, ., .]   the density of those visible from i, on the square of m
//   luminance    [P, T, R, R]   for sampling only: its shape is checked, it is not read
//   rgb          [P, T, 3, R, R]  f cos(theta of the other direction) / (D / (4 sigma)), clamped below at zero
//
// A direction is on the unit square at u = (sqrt(2 theta / pi), (phi + pi) / (2 pi)); functions on a square are
// bilinear between samples at its grid's corners, rows over u.y, columns, the last index, over u.x. An isotropic
// material's m has its azimuth counted from i's. rgb is on another square, to which the inverse of the warp maps m: the
// cumulative distributions of vndf, first that of the rows, then that along the row, so that samples are dense where
// normals are visible [1, 4]. Between phi_i and theta_i everything is linear, beyond their ends constant.
//
// By reciprocity either direction may be i; here it is wo, towards the eye, as in pbrt and Mitsuba.
//
// [1] J. Dupuy, W. Jakob, "An Adaptive Parameterization for Efficient Material Acquisition and Rendering", ACM TOG
//     37(6), 2018; https://rgl.epfl.ch/materials.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "../scalar/constexpr_math.hpp"
#include "brdf.hpp"
#include "tensor_file.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

/// A place between two of several nodes, as fractions of the first and of the second.
struct NodePair {
  std::size_t below, above;
  double t;
};

/// Nodes increase; beyond the ends t is 0 or 1.
inline NodePair node_pair(const std::vector<float>& nodes, double x) {
  if (nodes.size() == 1) return {0, 0, 0.0};
  const auto after =
      std::upper_bound(nodes.begin() + 1, nodes.end() - 1, x, [](double a, float b) { return a < double(b); });
  const auto above = static_cast<std::size_t>(after - nodes.begin());
  const double low = double(nodes[above - 1]), high = double(nodes[above]);
  return {above - 1, above, std::clamp((x - low) / (high - low), 0.0, 1.0)};
}

/// Of the functions tabulated at nodes of phi and theta, the four around a place, and their weights.
struct SliceBlend {
  std::array<std::size_t, 4> slice;
  std::array<double, 4> weight;
};

inline SliceBlend slice_blend(const NodePair& phi, const NodePair& theta, std::size_t theta_count) {
  const double p = phi.t, t = theta.t;
  return {{phi.below * theta_count + theta.below, phi.below * theta_count + theta.above,
           phi.above * theta_count + theta.below, phi.above * theta_count + theta.above},
          {(1.0 - p) * (1.0 - t), (1.0 - p) * t, p * (1.0 - t), p * t}};
}

/// A cell of a grid on the unit square, and a place in it, in [0, 1]^2.
struct GridCell {
  std::size_t column, row;
  double x, y;
};

struct GridShape {
  std::size_t rows, columns;

  std::size_t size() const { return rows * columns; }
  std::size_t index(std::size_t row, std::size_t column) const { return row * columns + column; }

  GridCell cell(const glm::dvec2& u) const {
    const auto axis = [](double place, std::size_t count) {
      const double x = place > 0.0 ? (std::min)(place, 1.0) * double(count - 1) : 0.0;
      const std::size_t below = (std::min)(static_cast<std::size_t>(x), count - 2);
      return std::pair(below, x - double(below));
    };
    const auto [column, x] = axis(u.x, columns);
    const auto [row, y] = axis(u.y, rows);
    return {column, row, x, y};
  }
};

inline double mix(double a, double b, double t) { return a + t * (b - a); }

/// A function on the unit square.
struct SquareFunction {
  GridShape shape;
  std::vector<float> values;

  double operator()(const glm::dvec2& u) const {
    const GridCell c = shape.cell(u);
    const auto at = [&](std::size_t row, std::size_t column) { return double(values[shape.index(row, column)]); };
    return mix(mix(at(c.row, c.column), at(c.row, c.column + 1), c.x),
               mix(at(c.row + 1, c.column), at(c.row + 1, c.column + 1), c.x), c.y);
  }
};

/// Densities on the unit square, one per slice, and the map of each that makes it uniform. Negative values count as
/// zero. Throws std::invalid_argument where a density is zero everywhere.
class SquareWarp {
 public:
  SquareWarp() = default;
  SquareWarp(GridShape shape, std::vector<float> density) : shape_(shape), density_(std::move(density)) {
    const std::size_t slices = density_.size() / shape_.size();
    along_row_.resize(density_.size());
    rows_.resize(slices * shape_.rows);
    for (std::size_t slice = 0; slice < slices; ++slice) accumulate(slice);
  }

  /// Where the square's place u goes: the mass of the rows below it, and along its row, of the blended density. Both
  /// are sums of the slices' own, for a cumulative distribution is linear in its density.
  glm::dvec2 operator()(const glm::dvec2& u, const SliceBlend& blend) const {
    const GridCell c = shape_.cell(u);
    const auto across = [&](const std::vector<float>& values, std::size_t column) {
      return mix(blended(values, shape_.size(), shape_.index(c.row, column), blend),
                 blended(values, shape_.size(), shape_.index(c.row + 1, column), blend), c.y);
    };
    const double left = across(density_, c.column), right = across(density_, c.column + 1);
    const double mass = across(along_row_, c.column) + c.x * (left + 0.5 * c.x * (right - left));
    const double row_mass = across(along_row_, shape_.columns - 1);

    const std::size_t last = shape_.columns - 1;
    const double low = blended(along_row_, shape_.size(), shape_.index(c.row, last), blend);
    const double high = blended(along_row_, shape_.size(), shape_.index(c.row + 1, last), blend);
    const double below = blended(rows_, shape_.rows, c.row, blend) + c.y * (low + 0.5 * c.y * (high - low));
    // an empty row: any place of it will do
    return {row_mass > 0.0 ? mass / row_mass : u.x, below};
  }

 private:
  static double blended(const std::vector<float>& values, std::size_t stride, std::size_t index,
                        const SliceBlend& blend) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 4; ++i) sum += blend.weight[i] * double(values[blend.slice[i] * stride + index]);
    return sum;
  }

  void accumulate(std::size_t slice) {
    float* const density = density_.data() + slice * shape_.size();
    float* const along_row = along_row_.data() + slice * shape_.size();
    float* const rows = rows_.data() + slice * shape_.rows;
    std::vector<double> sums(shape_.size()), row_sums(shape_.rows);
    for (std::size_t i = 0; i < shape_.size(); ++i) {
      density[i] = (std::max)(density[i], 0.0F);
      if (i % shape_.columns != 0) sums[i] = sums[i - 1] + 0.5 * (double(density[i - 1]) + double(density[i]));
    }
    const auto row_mass = [&](std::size_t row) { return sums[shape_.index(row, shape_.columns - 1)]; };
    for (std::size_t row = 1; row < shape_.rows; ++row) {
      row_sums[row] = row_sums[row - 1] + 0.5 * (row_mass(row - 1) + row_mass(row));
    }
    const double total = row_sums.back();
    if (!(total > 0.0)) throw std::invalid_argument("a density of vndf is zero everywhere");
    for (std::size_t i = 0; i < shape_.size(); ++i) {
      density[i] = float(double(density[i]) / total);
      along_row[i] = float(sums[i] / total);
    }
    for (std::size_t row = 0; row < shape_.rows; ++row) rows[row] = float(row_sums[row] / total);
  }

  GridShape shape_{};
  // of each slice, over its total: the density, its integral along the row up to there, that of the rows before; all
  // in units of a cell
  std::vector<float> density_, along_row_, rows_;
};

inline double polar_angle(const glm::dvec3& v) { return std::atan2(std::hypot(v.x, v.y), v.z); }
inline double azimuth(const glm::dvec3& v) { return std::atan2(v.y, v.x); }

/// The place of a direction on the unit square; phi of any turn.
inline glm::dvec2 square_place(double theta, double phi) {
  const double turn = (phi + double(kPi)) / (2.0 * double(kPi));
  return {std::sqrt(theta * 2.0 / double(kPi)), turn - std::floor(turn)};
}

}  // namespace detail

/// The arrays of a material, as the file has them: see above.
struct RglArrays {
  std::string description;
  bool jacobian = true;
  std::vector<float> phi, theta;
  detail::SquareFunction sigma, ndf;
  detail::SquareWarp vndf;
  detail::GridShape rgb_shape{};
  std::vector<float> rgb;
};

/// A material of the RGL database. f(wi, wo) only; sampling is not offered.
class RglBrdf {
 public:
  explicit RglBrdf(RglArrays arrays) : a_(std::move(arrays)) {
    if (isotropic()) return;
    symmetry_ = int(std::lround(2.0 * double(kPi) / double(a_.phi.back() - a_.phi[0])));
  }

  const std::string& description() const { return a_.description; }
  bool isotropic() const { return a_.phi.size() <= 2; }
  /// 1, 2 or 4: the whole turn of phi_i is measured, or a half or a quarter of it, the rest being its image: turned by
  /// pi, or mirrored in the planes x = 0 and y = 0 as well.
  int symmetry() const { return symmetry_; }

  /// The BRDF, RGB in 1/sr, for unit vectors in the local frame; zero when either has z <= 0. As what is tabulated is f
  /// times the cosine of wi, that cosine is held at 1e-4 where it is less. Greatest error against the function a file
  /// was written from, relative to its largest value, directions within 60 degrees of the normal: GGX of roughness 0.2
  /// and 0.5, vndf of 64 * 64, rgb of 48 * 48, 12 angles, 2e-2; at one of the file's own angles, roughness 0.3, 1e-3.
  glm::dvec3 operator()(glm::dvec3 wi, glm::dvec3 wo) const {
    if (!detail::above_horizon(wi, wo)) return glm::dvec3(0.0);
    to_measured_part(wi, wo);
    const double theta_o = detail::polar_angle(wo), phi_o = detail::azimuth(wo);
    const glm::dvec3 m = wi + wo;
    const glm::dvec2 u = detail::square_place(detail::polar_angle(m), detail::azimuth(m) - (isotropic() ? phi_o : 0.0));
    const detail::SliceBlend blend =
        detail::slice_blend(detail::node_pair(a_.phi, phi_o), detail::node_pair(a_.theta, theta_o), a_.theta.size());

    const glm::dvec3 rgb = (glm::max)(interpolate_rgb(a_.vndf(u, blend), blend), 0.0);
    const double sigma = a_.jacobian ? 4.0 * a_.sigma(detail::square_place(theta_o, phi_o)) : 1.0;
    const double density = a_.jacobian ? (std::max)(a_.ndf(u), 0.0) : 1.0;
    return sigma > 0.0 ? rgb * (density / (sigma * (std::max)(wi.z, 1e-4))) : glm::dvec3(0.0);
  }

 private:
  /// Turns or mirrors both directions so that wo's azimuth is among those measured.
  void to_measured_part(glm::dvec3& wi, glm::dvec3& wo) const {
    if (symmetry_ == 1) return;
    const bool flip_y = wo.y > 0.0, flip_x = symmetry_ == 4 ? wo.x > 0.0 : flip_y;
    for (glm::dvec3* v : {&wi, &wo}) *v = {flip_x ? -v->x : v->x, flip_y ? -v->y : v->y, v->z};
  }

  glm::dvec3 interpolate_rgb(const glm::dvec2& u, const detail::SliceBlend& blend) const {
    const detail::GridCell c = a_.rgb_shape.cell(u);
    const double weight[4] = {(1.0 - c.x) * (1.0 - c.y), c.x * (1.0 - c.y), (1.0 - c.x) * c.y, c.x * c.y};
    const std::size_t first = a_.rgb_shape.index(c.row, c.column), columns = a_.rgb_shape.columns;
    const std::size_t corner[4] = {first, first + 1, first + columns, first + columns + 1};
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const float* values = a_.rgb.data() + (3 * blend.slice[i] + channel) * a_.rgb_shape.size();
        double value = 0.0;
        for (std::size_t k = 0; k < 4; ++k) value += weight[k] * double(values[corner[k]]);
        sum[int(channel)] += blend.weight[i] * value;
      }
    }
    return sum;
  }

  RglArrays a_;
  int symmetry_ = 1;
};

namespace detail {

// The fields of an RGL file, checked against each other before any is read.
class RglReader {
 public:
  explicit RglReader(const std::filesystem::path& path) : file_(path) {}

  RglArrays read() {
    using Type = TensorField::Type;
    if (file_.has("spectra")) file_.fail("is a spectral material; this reads those in RGB");
    const TensorField& description = file_.field("description", Type::u8, 1);
    const TensorField& jacobian = file_.field("jacobian", Type::u8, 1);
    const TensorField& phi = file_.field("phi_i", Type::f32, 1);
    const TensorField& theta = file_.field("theta_i", Type::f32, 1);
    const TensorField& sigma = file_.field("sigma", Type::f32, 2);
    const TensorField& ndf = file_.field("ndf", Type::f32, 2);
    const TensorField& vndf = file_.field("vndf", Type::f32, 4);
    const TensorField& luminance = file_.field("luminance", Type::f32, 4);
    const TensorField& rgb = file_.field("rgb", Type::f32, 5);
    check(jacobian.shape[0] == 1, "jacobian");
    check(phi.shape[0] >= 1 && theta.shape[0] >= 1, "phi_i and theta_i");
    for (const TensorField* by_direction : {&vndf, &luminance, &rgb}) {
      check(by_direction->shape[0] == phi.shape[0] && by_direction->shape[1] == theta.shape[0], "phi_i and theta_i");
    }
    check(rgb.shape[2] == 3 && rgb.shape[3] == luminance.shape[2] && rgb.shape[4] == luminance.shape[3], "rgb");

    RglArrays arrays;
    const std::vector<unsigned char> letters = file_.read_bytes(description);
    arrays.description.assign(letters.begin(), letters.end());
    arrays.jacobian = file_.read_bytes(jacobian)[0] != 0;
    arrays.phi = read_angles("phi_i", phi, 2.0 * double(kPi));
    arrays.theta = read_angles("theta_i", theta, 0.5 * double(kPi));
    check_turn(arrays.phi);
    arrays.sigma = {grid_shape(sigma, "sigma"), file_.read_floats("sigma", sigma)};
    arrays.ndf = {grid_shape(ndf, "ndf"), file_.read_floats("ndf", ndf)};
    arrays.rgb_shape = grid_shape(rgb, "rgb");
    arrays.rgb = file_.read_floats("rgb", rgb);
    const GridShape vndf_shape = grid_shape(vndf, "vndf");
    try {
      arrays.vndf = SquareWarp(vndf_shape, file_.read_floats("vndf", vndf));
    } catch (const std::invalid_argument& error) {
      file_.fail(std::string("is damaged: ") + error.what());
    }
    return arrays;
  }

 private:
  void check(bool good, const std::string& what) const {
    if (!good) file_.fail("is damaged: the shapes of its fields do not go together: " + what);
  }
  /// The last two dimensions.
  GridShape grid_shape(const TensorField& field, const std::string& name) const {
    const std::uint64_t rows = field.shape[field.shape.size() - 2], columns = field.shape.back();
    check(rows >= 2 && columns >= 2, name);
    return {static_cast<std::size_t>(rows), static_cast<std::size_t>(columns)};
  }
  std::vector<float> read_angles(const std::string& name, const TensorField& field, double largest) {
    std::vector<float> angles = file_.read_floats(name, field);
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const bool increases = i == 0 || angles[i] > angles[i - 1];
      if (!increases || std::abs(double(angles[i])) > largest + 1e-3) {
        file_.fail("is damaged: element " + std::to_string(i) + " of " + name);
      }
    }
    return angles;
  }
  /// Of an anisotropic material: the whole turn, the half [-pi, 0], or the quarter [-pi, -pi/2].
  void check_turn(const std::vector<float>& phi) const {
    if (phi.size() <= 2) return;
    const double turns = 2.0 * double(kPi) / (double(phi.back()) - double(phi[0]));
    for (const double part : {1.0, 2.0, 4.0}) {
      if (std::abs(turns - part) < 0.5) return;
    }
    file_.fail("has phi_i of neither the whole turn nor its half or quarter");
  }

  TensorFile file_;
};

}  // namespace detail

/// Reads a material of the RGL database, its RGB file. Throws FileError unless all fields are there, within the file,
/// of the shapes above, with finite numbers only, angles increasing and in range, and no density zero everywhere.
inline RglBrdf load_rgl(const std::filesystem::path& path) { return RglBrdf(detail::RglReader(path).read()); }

}  // namespace ZONAL_TARGET
}  // namespace zonal
