// Rotation matrices of real harmonics by recurrence in the degree: dense, and the reference for rotate.hpp.
//
// [1] J. Ivanic, K. Ruedenberg, "Rotation Matrices for Real Spherical Harmonics. Direct Determination by Recursion",
//     Journal of Physical Chemistry 100(15), 1996, with the additions and corrections of 102(45), 1998.
#pragma once

#include <cmath>
#include <cstdlib>
#include <vector>

namespace ivanic_ruedenberg {

/// Degree l, rows and columns of the orders -l to l; axes[i] is where axis i goes. In the Condon-Shortley phase, where
/// harmonics of odd order have the opposite sign of those of [1].
class Matrices {
 public:
  Matrices(const double (&axes)[3][3], int bands) : degrees_{{1.0}} {
    constexpr int axis_of[3] = {1, 2, 0};  // of the orders -1, 0, 1: y, z, x
    std::vector<double> first;
    for (const int row : axis_of) {
      for (const int column : axis_of) first.push_back(axes[column][row]);
    }
    degrees_.push_back(first);
    for (int l = 2; l < bands; ++l) {
      std::vector<double> next;
      for (int m = -l; m <= l; ++m) {
        for (int n = -l; n <= l; ++n) next.push_back(element(l, m, n));
      }
      degrees_.push_back(next);
    }
  }

  double operator()(int l, int m, int n) const { return (m + n) % 2 == 0 ? at(l, m, n) : -at(l, m, n); }

 private:
  double at(int l, int m, int n) const { return degrees_[std::size_t(l)][std::size_t((2 * l + 1) * (l + m) + l + n)]; }

  // [1], Table 1.
  double element(int l, int m, int n) const {
    const int a = std::abs(m);
    const double d = std::abs(n) < l ? (l + n) * (l - n) : 2 * l * (2 * l - 1);
    const double u = std::sqrt((l + m) * (l - m) / d);
    const double v = m == 0 ? -0.5 * std::sqrt(2.0 * (l - 1) * l / d) : 0.5 * std::sqrt((l + a - 1) * (l + a) / d);
    const double w = m == 0 ? 0.0 : -0.5 * std::sqrt((l - a - 1) * (l - a) / d);
    double sum = 0;
    if (a < l) sum += u * p(0, l, m, n);
    sum += v * big_v(l, m, n);
    if (a < l - 1 && m != 0) sum += w * big_w(l, m, n);
    return sum;
  }
  // [1], Table 2.
  double big_v(int l, int m, int n) const {
    if (m == 0) return p(1, l, 1, n) + p(-1, l, -1, n);
    if (m == 1) return std::sqrt(2.0) * p(1, l, 0, n);
    if (m == -1) return std::sqrt(2.0) * p(-1, l, 0, n);
    return m > 0 ? p(1, l, m - 1, n) - p(-1, l, 1 - m, n) : p(1, l, m + 1, n) + p(-1, l, -m - 1, n);
  }
  double big_w(int l, int m, int n) const {
    return m > 0 ? p(1, l, m + 1, n) + p(-1, l, -m - 1, n) : p(1, l, m - 1, n) - p(-1, l, 1 - m, n);
  }
  double p(int i, int l, int m, int n) const {
    if (n == l) return at(1, i, 1) * at(l - 1, m, l - 1) - at(1, i, -1) * at(l - 1, m, 1 - l);
    if (n == -l) return at(1, i, 1) * at(l - 1, m, 1 - l) + at(1, i, -1) * at(l - 1, m, l - 1);
    return at(1, i, 0) * at(l - 1, m, n);
  }

  std::vector<std::vector<double>> degrees_;
};

}  // namespace ivanic_ruedenberg
