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
// Light's paths may be followed either way only if f(a, b) = f(b, a), and real files do not keep to that: a
// colour-shifting film's two values differ by a factor of 1.5 as a rule and of 4 in one pair of a hundred, a leaf's by
// 1.1 and 1.6. The direction i of the file is wo here, towards the eye, as in pbrt and Mitsuba; wi is towards the light.
// Whoever exchanges them renders another material: see hvl.hpp for what virtual lights send out.
//
// A projection is integrated over the pieces between the tables' kinks, rgl_nodes.hpp: 90 angles of a real file (vndf
// of 128 x 128, rgb of 32 x 32) take 1.5 to 2.5 s at a tolerance of 3e-3, and are within 5e-4 (1.6e-3 at 89 degrees) of
// a brute-force sum of 10^6 values.
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
#include "rgl_nodes.hpp"
#include "rgl_tables.hpp"
#include "tensor_file.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A material of the RGL database. f(wi, wo) only; sampling is not offered.
class RglBrdf {
 public:
  explicit RglBrdf(RglArrays arrays) : a_(std::move(arrays)) {
    if (!isotropic()) {
      symmetry_ = int(std::lround(2.0 * double(kPi) / double(a_.phi.back() - a_.phi[0])));
      return;
    }
    is_mirrored_ = detail::is_mirrored(a_.ndf.values.data(), a_.ndf.shape);
    for (std::size_t slice = 0; slice < a_.vndf.slices() && is_mirrored_; ++slice) {
      is_mirrored_ = detail::is_mirrored(a_.vndf.density(slice), a_.vndf.shape());
    }
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
  glm::dvec3 operator()(const glm::dvec3& wi, const glm::dvec3& wo) const {
    if (!detail::above_horizon(wi, wo)) return glm::dvec3(0.0);
    const glm::dvec3 mirror = to_measured_part(wo);
    const glm::dvec3 m = mirror * (wi + wo);
    const View view = view_from(mirror * wo);
    const glm::dvec2 u =
        detail::square_place(detail::polar_angle(m), detail::azimuth(m) - (isotropic() ? view.phi : 0.0));
    const glm::dvec3 rgb = (glm::max)(interpolate_rgb(a_.vndf(u, view.blend), view.blend), 0.0);
    const double density = a_.jacobian ? (std::max)(a_.ndf(u), 0.0) : 1.0;
    return rgb * (view.scale * density / (std::max)(wi.z, detail::rgl_least_cosine));
  }

  /// visit(wi, f(wi, wo) times a solid angle), glm::dvec3 both, for the nodes of a quadrature over the hemisphere made
  /// of the pieces on which the tables are smooth, level from 0: see rgl_nodes.hpp. wo: a unit vector, z > 0. Of an
  /// isotropic material, the nodes are those of its part that is even about the plane of wo, and may stand on one side
  /// of it only: for integrals with functions that are even as well.
  template <class Visit>
  void for_each_node(const glm::dvec3& wo, int level, const Visit& visit) const {
    const glm::dvec3 mirror = to_measured_part(wo);
    const View view = view_from(mirror * wo);
    if (!(view.scale > 0.0)) return;
    const double turn = isotropic() ? view.phi : 0.0, cosine = std::cos(turn), sine = std::sin(turn);
    detail::RglNodes nodes(a_, view.blend, view.theta, view.phi - turn, view.scale, is_mirrored_);
    nodes.visit(level, [&](const glm::dvec3& wi, const glm::dvec3& weighted) {
      visit(mirror * glm::dvec3(cosine * wi.x - sine * wi.y, sine * wi.x + cosine * wi.y, wi.z), weighted);
    });
  }

 private:
  /// What of the tables the direction wo sees, and 1 / (4 sigma); zero where no facet is seen.
  struct View {
    double theta, phi;
    detail::SliceBlend blend;
    double scale;
  };

  View view_from(const glm::dvec3& wo) const {
    View view{detail::polar_angle(wo), detail::azimuth(wo), {}, 1.0};
    // of the half and the quarter turn, whose azimuths are not positive, pi is -pi
    if (symmetry_ != 1) view.phi = -std::abs(view.phi);
    view.blend = detail::slice_blend(detail::node_pair(a_.phi, view.phi), detail::node_pair(a_.theta, view.theta),
                                     a_.theta.size());
    if (a_.jacobian) {
      const double sigma = a_.sigma(detail::square_place(view.theta, view.phi));
      view.scale = sigma > 0.0 ? 0.25 / sigma : 0.0;
    }
    return view;
  }

  /// The signs of x, y and z that turn or mirror wo to an azimuth among those measured.
  glm::dvec3 to_measured_part(const glm::dvec3& wo) const {
    if (symmetry_ == 1) return glm::dvec3(1.0);
    const bool flip_y = wo.y > 0.0, flip_x = symmetry_ == 4 ? wo.x > 0.0 : flip_y;
    return {flip_x ? -1.0 : 1.0, flip_y ? -1.0 : 1.0, 1.0};
  }

  glm::dvec3 interpolate_rgb(const glm::dvec2& u, const detail::SliceBlend& blend) const {
    const detail::GridCell c = a_.rgb_shape.cell(u);
    const double weight[4] = {(1.0 - c.x) * (1.0 - c.y), c.x * (1.0 - c.y), (1.0 - c.x) * c.y, c.x * c.y};
    const std::size_t first = a_.rgb_shape.index(c.row, c.column), columns = a_.rgb_shape.columns;
    const std::size_t corner[4] = {first, first + 1, first + columns, first + columns + 1};
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < blend.count; ++i) {
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
  bool is_mirrored_ = false;  // an isotropic material whose tables of m are their own mirror images
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
