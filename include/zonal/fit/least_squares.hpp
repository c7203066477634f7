// Coefficients from scattered samples: weighted least squares, smoothed by the Laplacian where that is asked for.
//
// The coefficients c make
//
//   (4 pi / W) sum over samples w |f(direction) - value|^2  +  smoothness sum over l, m (l (l + 1) c_l^m)^2
//
// least, W being the sum of the weights w: an estimate of the integral of the squared error, and `smoothness` times
// that of the squared Laplacian, which falls hardest on high degrees. The normal equations are not formed, for they
// square the condition: samples are folded into a triangle by Householder's reflections, a block at a time [1], whose
// singular values are those of all samples. Blocks are of one size whatever batches the samples come in, so results do
// not depend on these, to the bit. Double throughout. Needs Eigen.
//
// [1] Golub, Van Loan, Matrix Computations, 4th ed., section 5.3 and 6.5.
#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "../basis/batch.hpp"
#include "../basis/sh.hpp"
#include "../scalar/colour.hpp"
#include "../scalar/constexpr_math.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

/// The triangle of the rows (basis values, sample's values), weighted, for any number of unknowns and channels.
class SampleTriangle {
 public:
  struct Solution {
    Eigen::MatrixXd coefficients;  // unknowns x channels
    Eigen::VectorXd residuals;     // of each channel: root of the mean of the squares
    double condition;
    int rank;
  };

  SampleTriangle(int unknowns, int channels)
      : unknowns_(unknowns), channels_(channels), rows_(Eigen::MatrixXd::Zero(columns() + block_rows(), columns())) {}

  int columns() const { return unknowns_ + channels_; }
  int block_rows() const { return 2 * columns() + 64; }
  double total_weight() const { return total_weight_; }

  /// `row` has columns() numbers. They are multiplied by the weight's root.
  void add(const double* row, double weight) {
    const double factor = std::sqrt(weight);
    for (int i = 0; i < columns(); ++i) rows_(filled_, i) = factor * row[i];
    total_weight_ += weight;
    if (++filled_ == rows_.rows()) fold();
  }

  /// `penalty` has a factor for each unknown, which is drawn to 0 by it.
  Solution solve(const Eigen::VectorXd& penalty) {
    fold();
    Solution solution{Eigen::MatrixXd::Zero(unknowns_, channels_), Eigen::VectorXd::Zero(channels_), 0, 0};
    solution.condition = std::numeric_limits<double>::infinity();
    if (!(total_weight_ > 0)) return solution;
    const double scale = std::sqrt(4 * double(kPi) / total_weight_);
    Eigen::MatrixXd matrix = scale * rows_.topLeftCorner(unknowns_, unknowns_);
    Eigen::MatrixXd right = scale * rows_.topRightCorner(unknowns_, channels_);
    if (penalty.any()) {  // further rows, whose right side is 0
      Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(2 * unknowns_, columns());
      whole.topLeftCorner(unknowns_, unknowns_) = matrix;
      whole.topRightCorner(unknowns_, channels_) = right;
      whole.bottomLeftCorner(unknowns_, unknowns_).diagonal() = penalty;
      const Eigen::MatrixXd folded = whole.householderQr().matrixQR().topRows(unknowns_);
      matrix = folded.leftCols(unknowns_).triangularView<Eigen::Upper>();
      right = folded.rightCols(channels_);
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> svd(matrix,
                                                                           Eigen::ComputeFullU | Eigen::ComputeFullV);
    const auto& singular = svd.singularValues();
    solution.rank = int(svd.rank());
    if (solution.rank == unknowns_) solution.condition = singular[0] / singular[unknowns_ - 1];
    solution.coefficients = svd.solve(right);

    // What no coefficients could reach stands below the triangle's unknowns; what these ones do not reach is beside it.
    const Eigen::MatrixXd missed =
        rows_.topLeftCorner(unknowns_, unknowns_) * solution.coefficients - rows_.topRightCorner(unknowns_, channels_);
    const Eigen::MatrixXd beyond = rows_.block(unknowns_, unknowns_, channels_, channels_);
    for (int channel = 0; channel < channels_; ++channel) {
      const double squares = missed.col(channel).squaredNorm() + beyond.col(channel).squaredNorm();
      solution.residuals[channel] = std::sqrt(squares / total_weight_);
    }
    return solution;
  }

 private:
  /// Rows above the triangle's into it; it stays at the top, the rest is zero again.
  void fold() {
    if (filled_ == columns()) return;
    const Eigen::MatrixXd triangle = rows_.topRows(filled_).householderQr().matrixQR().topRows(columns());
    rows_.setZero();
    rows_.topRows(columns()) = triangle.triangularView<Eigen::Upper>();
    filled_ = columns();
  }

  int unknowns_, channels_;
  Eigen::MatrixXd rows_;  // the triangle, and what waits to be folded into it
  Eigen::Index filled_ = columns();
  double total_weight_ = 0;
};

}  // namespace detail

/// What a fit gives. C is a number or a colour: `residuals` has one number a channel.
template <int N, class C>
struct Fit {
  static constexpr std::size_t channels = sizeof(C) / sizeof(detail::number_t<C>);

  Sh<N, C> sh;
  /// Root of the weighted mean of |f(direction) - value|^2, in the unit of the values; 0 of no samples.
  std::array<double, channels> residuals;
  /// By how much the coefficients' relative error may exceed that of the values: the greatest singular value over the
  /// least of what was solved, smoothness included. Infinity where `rank` is less than N*N: then other coefficients fit
  /// as well, and `sh` has the least sum of squares among them.
  double condition;
  int rank;
  std::size_t used, left_out;  // samples
};

/// Samples of a function, to be fitted by N bands; they are added in batches of any size. C is float, double or a
/// colour made of these alone: glm::vec3, Eigen::Vector3f, a struct of three floats with c[i].
///
/// Left out, and counted: samples whose direction is zero, whose weight is negative, or of which any number is NaN,
/// infinite, or larger than 1e100. A weight of 0 is one that counts for nothing, and so does one below 1e-100.
template <int N, class C>
class SampleFitter {
 public:
  static_assert(N >= 1, "bands out of range: N >= 1");
  using Number = detail::number_t<C>;
  static constexpr int channels = static_cast<int>(Fit<N, C>::channels);
  static_assert(is_builtin_scalar_v<Number> && sizeof(C) == std::size_t{channels} * sizeof(Number),
                "values of floats or doubles, and nothing else");

  /// Directions of any length but 0; `values` and `weights` are as many. Without weights all count the same.
  template <class T>
  void add(const DirectionSpan<T>& directions, const C* values, const std::common_type_t<T>* weights = nullptr) {
    for (std::size_t k = 0; k < directions.count; ++k) {
      const std::size_t at = k * directions.stride;
      const double weight = weights == nullptr ? 1.0 : double(weights[k]);
      add({double(directions.x[at]), double(directions.y[at]), double(directions.z[at])}, values[k], weight);
    }
  }

  /// One sample.
  void add(const std::array<double, 3>& direction, const C& value, double weight = 1.0) {
    std::array<double, std::size_t{N * N + channels}> row;
    const Number* const numbers = detail::numbers_of(&value);
    bool is_good = 0 <= weight && weight <= most;
    for (int c = 0; c < channels; ++c) {
      row[std::size_t(N * N + c)] = double(numbers[c]);
      is_good = is_good && std::abs(double(numbers[c])) <= most;
    }
    std::array<double, 3> d = direction;
    if (std::hypot(d[0], d[1], d[2]) < 1e-290) {  // a length of few digits
      for (double& x : d) x *= 0x1p+200;
    }
    const double length = std::hypot(d[0], d[1], d[2]);
    if (!(is_good && 0 < length && length <= most)) {
      ++left_out_;
      return;
    }
    evaluate<N>(d[0] / length, d[1] / length, d[2] / length,
                [&](auto l, auto m, double y) { row[std::size_t(sh_index(l, m))] = y; });
    triangle_.add(row.data(), weight < least ? 0.0 : weight);
    ++used_;
  }

  /// The best coefficients for the samples so far; more may follow. smoothness >= 0, in units of the values' squared
  /// per squared Laplacian: 0 fits as closely as N bands can; smoothness (l (l + 1))^2 = 1 halves degree l of a well
  /// sampled function. From 1e14 on all counts as that: it leaves the mean. What is negative or no number counts as 0.
  Fit<N, C> solve(double smoothness = 0) {
    Eigen::VectorXd penalty(N * N);
    constexpr double most_smoothness = 1e14;  // more, and degree 0 would seem to be unknown beside the others
    const double factor = smoothness > 0 ? std::sqrt((std::min)(smoothness, most_smoothness)) : 0.0;
    for (int l = 0, i = 0; l < N; ++l) {
      for (; i < (l + 1) * (l + 1); ++i) penalty[i] = factor * l * (l + 1);
    }
    const auto solution = triangle_.solve(penalty);
    Fit<N, C> fit{};
    Number* const numbers = detail::numbers_of(fit.sh.values);
    for (int i = 0; i < N * N; ++i) {
      for (int c = 0; c < channels; ++c) numbers[i * channels + c] = Number(solution.coefficients(i, c));
    }
    for (int c = 0; c < channels; ++c) fit.residuals[std::size_t(c)] = solution.residuals[c];
    fit.condition = solution.condition;
    fit.rank = solution.rank;
    fit.used = used_;
    fit.left_out = left_out_;
    return fit;
  }

 private:
  static constexpr double most = 1e100;    // squares of values, weighted, stay finite,
  static constexpr double least = 1e-100;  // and those of basis values, weighted, are numbers of all digits

  detail::SampleTriangle triangle_{N * N, channels};
  std::size_t used_ = 0, left_out_ = 0;
};

/// The N bands that fit samples best: `values` and `weights` are as many as directions; without weights all count the
/// same. Formula: at the top of this file; what becomes of bad samples: SampleFitter.
template <int N, class T, class C>
Fit<N, C> fit_samples(const DirectionSpan<T>& directions, const C* values,
                      const std::common_type_t<T>* weights = nullptr, double smoothness = 0) {
  SampleFitter<N, C> fitter;
  fitter.add(directions, values, weights);
  return fitter.solve(smoothness);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
