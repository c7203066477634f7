// The doctor's first step: somebody's terms as sums of this library's harmonics, by least squares.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "../many_bands/evaluate.hpp"
#include "../many_bands/rotate.hpp"
#include "convention.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

using Direction = std::array<double, 3>;

namespace detail::doctor {

struct Matrix {
  int rows, columns;
  std::vector<double> values;
  Matrix(int row_count, int column_count)
      : rows(row_count),
        columns(column_count),
        values(static_cast<std::size_t>(row_count) * static_cast<std::size_t>(column_count)) {}
  double* operator[](int i) { return values.data() + static_cast<std::ptrdiff_t>(i) * columns; }
  const double* operator[](int i) const { return values.data() + static_cast<std::ptrdiff_t>(i) * columns; }
};

/// Cholesky's factor of a symmetric matrix in its lower half; false where it is not positive by some margin.
inline bool factorise(Matrix& a) {
  for (int j = 0; j < a.columns; ++j) {
    const double before = a[j][j];
    for (int k = 0; k < j; ++k) a[j][j] -= a[j][k] * a[j][k];
    if (!(a[j][j] > 1e-9 * before)) return false;
    a[j][j] = std::sqrt(a[j][j]);
    for (int i = j + 1; i < a.rows; ++i) {
      for (int k = 0; k < j; ++k) a[i][j] -= a[i][k] * a[j][k];
      a[i][j] /= a[j][j];
    }
  }
  return true;
}
inline void solve(const Matrix& factor, double* x) {
  for (int i = 0; i < factor.rows; ++i) {
    for (int k = 0; k < i; ++k) x[i] -= factor[i][k] * x[k];
    x[i] /= factor[i][i];
  }
  for (int i = factor.rows - 1; i >= 0; --i) {
    for (int k = i + 1; k < factor.rows; ++k) x[i] -= factor[k][i] * x[k];
    x[i] /= factor[i][i];
  }
}

inline Matrix basis_at(const std::vector<Direction>& directions, int bands) {
  const ManyBands<double> many(bands);
  BasisSpace<double> space(bands);
  Matrix y(static_cast<int>(directions.size()), bands * bands);
  for (int k = 0; k < y.rows; ++k) evaluate(many, directions[static_cast<std::size_t>(k)], space, y[k]);
  return y;
}

struct Fit {
  int bands = 0;             // of the harmonics that they were fitted by
  Matrix terms;              // their terms, one a row, by our harmonics
  std::vector<double> rest;  // root mean square of what is left of each
};

/// Least squares; bands 0 where the directions do not tell so many harmonics apart.
inline Fit fit(const std::vector<Direction>& directions, const Matrix& values, int bands) {
  const Matrix y = basis_at(directions, bands);
  Matrix gram(y.columns, y.columns);
  for (int k = 0; k < y.rows; ++k) {
    for (int i = 0; i < y.columns; ++i) {
      for (int j = 0; j <= i; ++j) gram[i][j] += y[k][i] * y[k][j];
    }
  }
  Fit r{0, Matrix(values.columns, y.columns), std::vector<double>(static_cast<std::size_t>(values.columns))};
  if (!factorise(gram)) return r;
  r.bands = bands;
  for (int term = 0; term < values.columns; ++term) {
    double* x = r.terms[term];
    for (int k = 0; k < y.rows; ++k) {
      for (int i = 0; i < y.columns; ++i) x[i] += y[k][i] * values[k][term];
    }
    solve(gram, x);
    double squares = 0;
    for (int k = 0; k < y.rows; ++k) {
      double left = values[k][term];
      for (int i = 0; i < y.columns; ++i) left -= x[i] * y[k][i];
      squares += left * left;
    }
    r.rest[static_cast<std::size_t>(term)] = std::sqrt(squares / y.rows);
  }
  return r;
}

// The harmonics about other axes by ours: row (l, m) is Y_l^m of the direction in these axes.
inline Matrix harmonics_about(const Axes& axes, int bands) {
  const ManyRotation<double> rotation(
      bands, Rotation<2, double>::from_axes(AxisVector<double>(axes.x), AxisVector<double>(axes.y),
                                            AxisVector<double>(axes.z)));
  Matrix r(bands * bands, bands * bands);
  for (int i = 0; i < r.rows; ++i) {
    ManySh<double> one(bands);
    one[i] = 1;
    const ManySh<double> turned = rotate(one, rotation);
    std::copy(turned.begin(), turned.end(), r[i]);
  }
  return r;
}

inline double dot(const double* a, const double* b, int count) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += a[i] * b[i];
  return sum;
}
}  // namespace detail::doctor
}  // namespace ZONAL_TARGET
}  // namespace zonal
