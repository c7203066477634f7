// The spherical harmonics coefficients of a BRDF of which a quadrature's nodes are known.
//
// To evaluate 231 harmonics at every node, 21 bands, would cost more than all else. But harmonics of N bands are smooth
// on the scale of 1/N: they are interpolated, each node's share going to the 6 x 6 places about it on a grid of theta
// and phi, from where the coefficients follow once. In the degree 21 of 21 bands with cosine the interpolation errs by
// 5e-5 of the harmonic's largest value, in lower degrees by the sixth power of the degree less.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "../scalar/index.hpp"
#include "brdf.hpp"
#include "projection.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

/// Lagrange's weights at six places, -2 to 3, of a point t in [0, 1].
inline void lagrange_weights(double t, double (&w)[6]) {
  const double a = t + 2.0, b = t + 1.0, c = t, d = t - 1.0, e = t - 2.0, f = t - 3.0;
  const double ab = a * b, cd = c * d, ef = e * f;
  w[0] = b * cd * ef / -120.0;
  w[1] = a * cd * ef / 24.0;
  w[2] = ab * d * ef / -12.0;
  w[3] = ab * c * ef / 12.0;
  w[4] = ab * cd * f / -24.0;
  w[5] = ab * cd * e / 120.0;
}

/// One axis of the grid: `first` + i * step, i = 0 .. size - 1, so that [low, high] has places enough about it.
struct GridAxis {
  double first, step;
  int size;

  GridAxis(double low, double high, double widest_step) {
    const int cells = int(std::ceil((high - low) / widest_step));
    step = (high - low) / cells;
    first = low - 2.0 * step;
    size = cells + 6;
  }
  double place(int i) const { return first + i * step; }
  /// The first of the six places about x, and their weights.
  int weigh(double x, double (&weights)[6]) const {
    const double position = (x - first) / step;
    const int below = (std::max)(index_below(position, size - 4), 2);
    lagrange_weights(position - below, weights);
    return below - 2;
  }
};

/// Sums of nodes of a quadrature, and their N bands of coefficients in the frame of phi = 0. `parity` even: the
/// integrand counts as even in phi, and only the coefficients of m >= 0 are to be had; odd: those of both signs.
template <int N, Parity parity>
class NodeSums {
 public:
  NodeSums()
      : theta_(0.0, 0.5 * double(kPi), 0.465 / N),
        phi_(parity == Parity::even ? 0.0 : -double(kPi), double(kPi), 0.465 / N),
        sums_(std::size_t(3 * theta_.size * phi_.size)) {}

  /// wi: a unit vector, z >= 0; weighted: f times the node's solid angle.
  void add(const glm::dvec3& wi, const glm::dvec3& weighted) {
    double row_weight[6], column_weight[6], column[18];
    const double y = parity == Parity::even ? std::abs(wi.y) : wi.y;
    const int row = theta_.weigh(std::atan2(std::sqrt(wi.x * wi.x + wi.y * wi.y), wi.z), row_weight);
    const int first = phi_.weigh(std::atan2(y, wi.x), column_weight);
    for (int j = 0; j < 6; ++j) {
      for (int c = 0; c < 3; ++c) column[3 * j + c] = column_weight[j] * weighted[c];
    }
    double* place = &sums_[std::size_t(3 * (row * phi_.size + first))];
    for (int i = 0; i < 6; ++i, place += 3 * phi_.size) {
      for (int k = 0; k < 18; ++k) place[k] += row_weight[i] * column[k];
    }
  }

  /// Of cos(m phi); or, for odd, of sin(m phi): (l, m) is then the coefficient of (l, -m).
  template <Parity wanted = Parity::even>
  BrdfProjection<N> project() const {
    std::vector<double> wave(std::size_t(N * phi_.size));
    for (int j = 0; j < phi_.size; ++j) {
      for (int m = 0; m < N; ++m) {
        const double angle = m * phi_.place(j);
        wave[std::size_t(j * N + m)] = wanted == Parity::even ? std::cos(angle) : std::sin(angle);
      }
    }
    BrdfProjection<N> result;
    for (int i = 0; i < theta_.size; ++i) {
      glm::dvec3 moments[std::size_t(N)] = {};
      for (int j = 0; j < phi_.size; ++j) {
        const double* sum = &sums_[std::size_t(3 * (i * phi_.size + j))];
        for (int m = 0; m < N; ++m) {
          moments[m] += glm::dvec3(sum[0], sum[1], sum[2]) * wave[std::size_t(j * N + m)];
        }
      }
      add_ring<N>(moments, std::cos(theta_.place(i)), std::sin(theta_.place(i)), 1.0, result);
    }
    return result;
  }

 private:
  GridAxis theta_, phi_;
  std::vector<double> sums_;  // RGB
};

/// What project_brdf returns, by a quadrature of the BRDF's own: refined until no coefficient moves by more than
/// tolerance times the largest.
template <int N>
BrdfProjection<N> project_nodes(const BrdfNodes& nodes, double cos_outgoing, double tolerance) {
  const glm::dvec3 wo(std::sqrt((1.0 - cos_outgoing) * (1.0 + cos_outgoing)), 0.0, cos_outgoing);
  const auto at_level = [&](int level) {
    NodeSums<N, Parity::even> sums;
    nodes(wo, level, [&sums](const glm::dvec3& wi, const glm::dvec3& weighted) { sums.add(wi, weighted); });
    BrdfProjection<N> result = sums.project();
    result.theta_nodes = level + 1;
    return result;
  };
  return refine_projection(brdf_node_levels, tolerance, at_level);
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
