// A quadrature over the directions wi of an RGL material (rgl.hpp) seen from one wo, made of the pieces on which the
// file's tables are smooth.
//
// Between samples the tables are polynomials, at them they have kinks: a rule that knows nothing of them needs some
// hundreds of nodes along each axis before it stops to see them, and more where they crowd about a sharp peak. On the
// square of the half vector m = (theta, phi) the kinks lie well. Those of vndf and ndf are straight; those of rgb,
// which is on another square, are where the warp passes a multiple of its spacing: whole rows of u.y, since the second
// coordinate of the warp depends on u.y alone, and on a row roots of quadratics, since along it the density is linear.
// The horizon of wi cuts a row at tan(2 theta) = -cot(theta_o) / cos(phi - phi_o), and beside it f, which is tabulated
// times the cosine, grows as its inverse: pieces halve towards it. Each piece then has a Gauss rule.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "../scalar/constexpr_math.hpp"
#include "../scalar/index.hpp"
#include "../scalar/quadrature.hpp"
#include "../scalar/scalar.hpp"
#include "rgl_tables.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

/// The cosine of wi below which f is tabulated times the cosine over this.
inline constexpr double rgl_least_cosine = 1e-4;

/// Is each slice its own mirror image in u.y = 1/2, up to the rounding of floats?
inline bool is_mirrored(const float* values, const GridShape& shape) {
  const float bound = 1e-6F * *std::max_element(values, values + shape.size());
  for (std::size_t row = 0; row < shape.rows / 2; ++row) {
    for (std::size_t column = 0; column < shape.columns; ++column) {
      const float difference = values[shape.index(row, column)] - values[shape.index(shape.rows - 1 - row, column)];
      if (!(std::abs(difference) <= bound)) return false;
    }
  }
  return true;
}

/// Of the function linear between v[0], v[1], ...: the integral up to each place, in units of their distance.
template <class V>
void integrate_linear(const V& v, std::size_t count, std::vector<double>& integral) {
  integral.assign(count, 0.0);
  for (std::size_t i = 1; i < count; ++i) integral[i] = integral[i - 1] + 0.5 * (v[i - 1] + v[i]);
}

/// Adds the places in (0, 1) where that integral, over the whole, is 1/parts, ..., (parts - 1)/parts; of a function
/// that is zero everywhere, the places themselves.
template <class V>
void add_quantiles(const V& v, const std::vector<double>& integral, std::size_t parts, std::vector<double>& places) {
  const double total = integral.back(), cells = double(integral.size() - 1);
  std::size_t cell = 0;
  for (std::size_t k = 1; k < parts; ++k) {
    const double target = total * double(k) / double(parts);
    while (cell + 2 < integral.size() && integral[cell + 1] <= target) ++cell;
    const double rest = target - integral[cell], low = v[cell], slope = v[cell + 1] - v[cell];
    const double root = std::sqrt((std::max)(low * low + 2.0 * rest * slope, 0.0));
    places.push_back(low + root > 0.0 ? (double(cell) + 2.0 * rest / (low + root)) / cells : double(k) / double(parts));
  }
}

/// Adds the lines between the cells of a grid; and more where it is so coarse that harmonics would not be smooth in a
/// cell.
inline void add_lines(std::size_t cells, std::vector<double>& places) {
  constexpr std::size_t least_cells = 100;
  const std::size_t parts = cells * ((least_cells + cells - 1) / cells);
  for (std::size_t k = 1; k < parts; ++k) places.push_back(double(k) / double(parts));
}

/// body(place, weight) for the nodes of the rule on every piece between `begin`, the sorted places inside, and `end`.
template <class Body>
void for_each_piece_node(std::vector<double>& places, double begin, double end, const QuadratureRule& rule,
                         const Body& body) {
  // Of a direction that is no number there are places that are none, and these would not be sorted.
  const auto is_outside = [&](double place) { return !(place > begin && place < end); };
  places.erase(std::remove_if(places.begin(), places.end(), is_outside), places.end());
  places.push_back(end);
  std::sort(places.begin(), places.end());
  double left = begin;
  for (const double right : places) {
    if (right - left < 1e-13) continue;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      body(left + 0.5 * (right - left) * (1.0 + rule.nodes[i]), 0.5 * (right - left) * rule.weights[i]);
    }
    left = right;
  }
}

/// A material's tables as one outgoing direction blends them.
class RglNodes {
 public:
  /// phi_o: the azimuth of wo in the frame in which m's is tabulated. `half`: the tables are their own mirror images in
  /// u.y = 1/2, but for rgb, of which that part is taken; phi_o is 0.
  RglNodes(const RglArrays& arrays, const SliceBlend& blend, double theta_o, double phi_o, double scale, bool half)
      : a_(arrays), sin_o_(std::sin(theta_o)), cos_o_(std::cos(theta_o)), phi_o_(phi_o), scale_(scale), half_(half) {
    const GridShape& shape = a_.vndf.shape();
    density_.assign(shape.size(), 0.0);
    rgb_.assign(a_.rgb_shape.size(), glm::dvec3(0.0));
    for (std::size_t k = 0; k < blend.count; ++k) {
      const float* density = a_.vndf.density(blend.slice[k]);
      for (std::size_t i = 0; i < shape.size(); ++i) density_[i] += blend.weight[k] * double(density[i]);
      const float* rgb = a_.rgb.data() + 3 * blend.slice[k] * a_.rgb_shape.size();
      for (std::size_t i = 0; i < rgb_.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) rgb_[i][int(c)] += blend.weight[k] * double(rgb[c * rgb_.size() + i]);
      }
    }
    if (half_) symmetrise_rgb();
    const std::size_t columns = a_.ndf.shape.columns;
    for (std::size_t i = columns; i < a_.ndf.shape.size() && ndf_has_one_row_; ++i) {
      ndf_has_one_row_ = detail::is_equal(a_.ndf.values[i], a_.ndf.values[i - columns]);
    }
    for (std::size_t row = 0; row < shape.rows; ++row) {
      integrate_linear(&density_[shape.index(row, 0)], shape.columns, along_row_);
      row_mass_.push_back(along_row_.back());
    }
    integrate_linear(row_mass_, shape.rows, rows_);
  }

  /// visit(wi, f times solid angle) for the nodes on every piece; wi in the frame of phi_o.
  template <class Visit>
  void visit(int level, const Visit& visit) {
    // Rows are the smoother direction, and the first rule is there to be compared with.
    const QuadratureRule across_rows = gauss_legendre(level + 1), along_row = gauss_legendre((std::max)(level + 1, 2));
    std::vector<double> places;
    add_lines(a_.vndf.shape().rows - 1, places);
    if (a_.ndf.shape.rows != a_.vndf.shape().rows && !ndf_has_one_row_) add_lines(a_.ndf.shape.rows - 1, places);
    add_quantiles(row_mass_, rows_, a_.rgb_shape.rows - 1, places);
    add_grazing_lines(places);
    const double first = half_ ? 0.5 : 0.0;
    places.erase(std::remove_if(places.begin(), places.end(), [&](double place) { return !(place > first); }),
                 places.end());
    divide_where_horizon_runs(first, places);
    for_each_piece_node(places, first, 1.0, across_rows, [&](double v, double weight) {
      set_row(v);
      visit_row(along_row, (half_ ? 2.0 : 1.0) * weight, visit);
    });
  }

 private:
  void symmetrise_rgb() {
    for (std::size_t row = 0; row < (a_.rgb_shape.rows + 1) / 2; ++row) {
      for (std::size_t column = 0; column < a_.rgb_shape.columns; ++column) {
        glm::dvec3& one = rgb_[a_.rgb_shape.index(row, column)];
        glm::dvec3& other = rgb_[a_.rgb_shape.index(a_.rgb_shape.rows - 1 - row, column)];
        one = other = 0.5 * (one + other);
      }
    }
  }

  /// Where m stands across the plane of wo, the horizon's place on a row changes over cos(theta_o) of phi: pieces
  /// double from there.
  void add_grazing_lines(std::vector<double>& places) const {
    const double turn = 2.0 * double(kPi), widest = 1.0 / double(a_.vndf.shape().rows - 1);
    for (const double side : {-0.25, 0.25}) {
      const double across = (phi_o_ + double(kPi)) / turn + side;
      places.push_back(across - std::floor(across));
      for (double gap = (std::max)(0.5 * cos_o_ / turn, 1e-6); gap < widest; gap *= 2.0) {
        for (const double place : {across - gap, across + gap}) places.push_back(place - std::floor(place));
      }
    }
  }

  /// The horizon crosses the lines of rgb at places that nothing above knows: pieces in which it crosses some are
  /// divided, so that it crosses half a cell in each.
  void divide_where_horizon_runs(double first, std::vector<double>& places) {
    constexpr int most_parts = 16;
    places.push_back(1.0);
    std::sort(places.begin(), places.end());
    const double cells = double(a_.rgb_shape.columns - 1);
    const auto place_of_horizon = [&](double v) {
      set_row(v);
      return along_row_.back() > 0.0 ? cells * warped(horizon()) : 0.0;
    };
    double left = first, left_place = place_of_horizon(first);
    const std::size_t count = places.size();
    for (std::size_t i = 0; i < count; ++i) {
      const double right = places[i], right_place = place_of_horizon(right);
      const int parts = index_below(std::ceil(2.0 * std::abs(right_place - left_place)), most_parts);
      for (int k = 1; k < parts; ++k) places.push_back(left + (right - left) * k / parts);
      left = right, left_place = right_place;
    }
  }

  /// All tables on the row u.y = v.
  void set_row(double v) {
    const double phi = (2.0 * v - 1.0) * double(kPi);
    cos_m_ = std::cos(phi);
    sin_m_ = std::sin(phi);
    cos_difference_ = std::cos(phi - phi_o_);

    const GridShape& shape = a_.vndf.shape();
    const GridCell at = shape.cell({0.0, v});
    row_density_.resize(shape.columns);
    for (std::size_t i = 0; i < shape.columns; ++i) {
      row_density_[i] = mix(density_[shape.index(at.row, i)], density_[shape.index(at.row + 1, i)], at.y);
    }
    integrate_linear(row_density_, shape.columns, along_row_);
    const double low = row_mass_[at.row], high = row_mass_[at.row + 1];
    const double below = (rows_[at.row] + at.y * (low + 0.5 * at.y * (high - low))) / rows_.back();

    const GridCell at_rgb = a_.rgb_shape.cell({0.0, below});
    row_rgb_.resize(a_.rgb_shape.columns);
    for (std::size_t i = 0; i < row_rgb_.size(); ++i) {
      const glm::dvec3& one = rgb_[a_.rgb_shape.index(at_rgb.row, i)];
      row_rgb_[i] = one + at_rgb.y * (rgb_[a_.rgb_shape.index(at_rgb.row + 1, i)] - one);
    }
    const GridCell at_ndf = a_.ndf.shape.cell({0.0, v});
    row_ndf_.resize(a_.ndf.shape.columns);
    for (std::size_t i = 0; i < row_ndf_.size(); ++i) {
      row_ndf_[i] = mix(double(a_.ndf.values[a_.ndf.shape.index(at_ndf.row, i)]),
                        double(a_.ndf.values[a_.ndf.shape.index(at_ndf.row + 1, i)]), at_ndf.y);
    }
  }

  /// On that row: the warp's first coordinate, any where the row is empty,
  double warped(double u) const {
    if (!(along_row_.back() > 0.0)) return u;
    const GridCell at = a_.vndf.shape().cell({u, 0.0});
    const double left = row_density_[at.column], right = row_density_[at.column + 1];
    return (along_row_[at.column] + at.x * (left + 0.5 * at.x * (right - left))) / along_row_.back();
  }

  /// rgb D / (4 sigma),
  glm::dvec3 value(double u) const {
    const GridCell at_rgb = a_.rgb_shape.cell({warped(u), 0.0});
    const glm::dvec3& one = row_rgb_[at_rgb.column];
    const glm::dvec3 rgb = (glm::max)(one + at_rgb.x * (row_rgb_[at_rgb.column + 1] - one), 0.0);
    if (!a_.jacobian) return rgb * scale_;
    const GridCell at_ndf = a_.ndf.shape.cell({u, 0.0});
    return rgb * (scale_ * (std::max)(mix(row_ndf_[at_ndf.column], row_ndf_[at_ndf.column + 1], at_ndf.x), 0.0));
  }

  /// and where wi.z is zero: wi.z = a cos(2 theta - b).
  double horizon() const {
    const double theta = 0.5 * std::atan2(cos_o_, -sin_o_ * cos_difference_);
    return std::sqrt((std::min)(theta * 2.0 / double(kPi), 1.0));
  }

  template <class Visit>
  void visit_row(const QuadratureRule& rule, double row_weight, const Visit& visit) {
    const double right_angle = 0.5 * double(kPi), a = std::hypot(cos_o_, sin_o_ * cos_difference_);
    const double u_horizon = horizon();
    if (!(u_horizon > 0.0)) return;

    places_.clear();
    add_lines(a_.vndf.shape().columns - 1, places_);
    if (a_.ndf.shape.columns != a_.vndf.shape().columns) add_lines(a_.ndf.shape.columns - 1, places_);
    add_quantiles(row_density_, along_row_, a_.rgb_shape.columns - 1, places_);
    const double widest = 2.0 / double(a_.vndf.shape().columns - 1);
    for (double gap = 0.5 * rgl_least_cosine / (a * 2.0 * right_angle * u_horizon); gap < widest; gap *= 2.0) {
      if (gap < u_horizon) places_.push_back(u_horizon - gap);
    }
    for_each_piece_node(places_, 0.0, u_horizon, rule, [&](double u, double weight) {
      const glm::dvec3 reflected = value(u);
      if (reflected == glm::dvec3(0.0)) return;
      const double theta = right_angle * u * u, sine = std::sin(theta), cosine = std::cos(theta);
      const double cos_half = sin_o_ * cos_difference_ * sine + cos_o_ * cosine;  // wo . m
      const glm::dvec3 wi = 2.0 * cos_half * glm::dvec3(sine * cos_m_, sine * sin_m_, cosine) - outgoing();
      // d wi = 4 (wo . m) dm, and dm = sin(theta) d theta d phi
      const double solid_angle = 4.0 * cos_half * sine * (2.0 * right_angle * u * weight) * (4.0 * right_angle);
      visit(wi, reflected * (row_weight * solid_angle / (std::max)(wi.z, rgl_least_cosine)));
    });
  }

  glm::dvec3 outgoing() const { return {sin_o_ * std::cos(phi_o_), sin_o_ * std::sin(phi_o_), cos_o_}; }

  const RglArrays& a_;
  double sin_o_, cos_o_, phi_o_, scale_;
  bool half_, ndf_has_one_row_ = true;
  std::vector<double> density_, row_mass_, rows_;  // of vndf: itself, its rows' integrals, and theirs
  std::vector<glm::dvec3> rgb_;
  // of the row at hand
  double cos_m_ = 1.0, sin_m_ = 0.0, cos_difference_ = 1.0;
  std::vector<double> row_density_, along_row_, row_ndf_, places_;
  std::vector<glm::dvec3> row_rgb_;
};

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
