// Fits against exact functions, against the normal equations in long double, against the singular values of all samples
// at once, and on samples that do not suffice.
#include <zonal/fit/least_squares.hpp>
#include <zonal/transform/dot.hpp>

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "../accuracy.hpp"
#include "../catch.hpp"

namespace {

constexpr int N = 4;
using Vec3 = std::array<double, 3>;
using Sh = zonal::Sh<N, double>;

struct Samples {
  std::vector<Vec3> directions;
  std::vector<double> values, weights;
};

Vec3 random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const Vec3 v{normal(random), normal(random), normal(random)};
  const double length = std::hypot(v[0], v[1], v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}
Sh random_function(std::mt19937& random) {
  Sh sh{};
  for (double& c : sh) c = std::uniform_real_distribution<double>(-1, 1)(random);
  return sh;
}
// Of a function with noise, everywhere or in a cone about an axis.
Samples sample(std::mt19937& random, const Sh& sh, int count, double noise, double least_cosine = -1) {
  Samples samples;
  std::uniform_real_distribution<double> uniform;
  while (int(samples.values.size()) < count) {
    const Vec3 d = random_direction(random);
    if (d[0] < least_cosine) continue;
    samples.directions.push_back(d);
    samples.values.push_back(zonal::reconstruct(sh, d) + noise * (2 * uniform(random) - 1));
    samples.weights.push_back(0.1 + uniform(random));
  }
  return samples;
}
auto fit(const Samples& s, double smoothness = 0) {
  return zonal::fit_samples<N>(zonal::direction_span(s.directions.data(), s.directions.size()), s.values.data(),
                               s.weights.data(), smoothness);
}
double distance(const Sh& a, const Sh& b) {
  const Sh d = a - b;
  return std::sqrt(zonal::dot(d, d));
}

using Real = long double;
using Matrix = std::vector<std::vector<Real>>;  // rows
// Rows of basis values and the value, by the weight's root, scaled as the formula says; and rows of the penalty.
Matrix design(const Samples& s, double smoothness) {
  Real total = 0;
  for (const double w : s.weights) total += w;
  Matrix rows;
  for (std::size_t k = 0; k < s.values.size(); ++k) {
    const auto& d = s.directions[k];
    const auto y = zonal::evaluate<N>(std::array<Real, 3>{d[0], d[1], d[2]});
    const Real factor = std::sqrt(4 * zonal::kPi * Real(s.weights[k]) / total);
    auto& row = rows.emplace_back(N * N + 1);
    for (int i = 0; i < N * N; ++i) row[std::size_t(i)] = factor * y[i];
    row.back() = factor * Real(s.values[k]);
  }
  for (int l = 0, i = 0; l < N; ++l) {
    for (; i < (l + 1) * (l + 1); ++i) {
      rows.emplace_back(N * N + 1)[std::size_t(i)] = std::sqrt(Real(smoothness)) * Real(l * (l + 1));
    }
  }
  return rows;
}
// By the normal equations and Gauss's elimination.
std::vector<Real> solve_normal_equations(const Matrix& rows) {
  constexpr std::size_t size = N * N;
  Matrix normal(size, std::vector<Real>(size + 1));
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j <= size; ++j) normal[i][j] += row[i] * row[j];
    }
  }
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < size; ++k) {
      if (k == i) continue;
      const Real factor = normal[k][i] / normal[i][i];
      for (std::size_t j = i; j <= size; ++j) normal[k][j] -= factor * normal[i][j];
    }
  }
  std::vector<Real> solution;
  for (std::size_t i = 0; i < size; ++i) solution.push_back(normal[i][size] / normal[i][i]);
  return solution;
}
double condition_of(const Matrix& rows) {
  Eigen::MatrixXd matrix(Eigen::Index(rows.size()), N * N);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (int i = 0; i < N * N; ++i) matrix(Eigen::Index(k), i) = double(rows[k][std::size_t(i)]);
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix);
  return svd.singularValues()[0] / svd.singularValues()[N * N - 1];
}

struct Colour {
  float c[3];
  float operator[](int i) const { return c[i]; }
  [[maybe_unused]] friend Colour operator+(const Colour& a, const Colour& b) {
    return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
  }
  [[maybe_unused]] friend Colour operator*(const Colour& a, float s) { return {{a[0] * s, a[1] * s, a[2] * s}}; }
};

}  // namespace

TEST_CASE("fit: a function of N bands is found again, from as many samples as unknowns or more, in any channel") {
  Met met("fit", "fit_samples");
  std::mt19937 random(1);
  for (const int count : {N * N, 40, 1000}) {
    const Sh sh = random_function(random);
    const Samples s = sample(random, sh, count, 0);
    const auto found = fit(s);
    CAPTURE(count, found.condition);
    CHECK(found.rank == N * N);
    CHECK(found.used == std::size_t(count));
    CHECK(found.left_out == 0);
    // Relative to the function: 2.3e-15 times the condition is the worst of 600 draws by SSE2, AVX2 and AVX-512 each.
    CHECK(met.meet(distance(found.sh, sh) / (found.condition * distance(sh, Sh{}))));
    CHECK(found.residuals[0] <= 1e-14);
  }
  CHECK_MET(met);
}

TEST_CASE("fit: what the normal equations give in long double, with noise, weights and smoothness") {
  std::mt19937 random(2);
  for (const double smoothness : {0.0, 1e-4, 1e-2, 1.0, 1e6}) {
    const Samples s = sample(random, random_function(random), 300, 0.5);
    const Matrix rows = design(s, smoothness);
    const std::vector<Real> expected = solve_normal_equations(rows);
    const auto found = fit(s, smoothness);
    CAPTURE(smoothness);
    Real squares = 0;  // of the samples, without the smoothness
    for (std::size_t k = 0; k < s.values.size(); ++k) {
      Real missed = -rows[k].back();
      for (std::size_t i = 0; i < expected.size(); ++i) missed += rows[k][i] * expected[i];
      squares += missed * missed;
    }
    for (int i = 0; i < N * N; ++i) CHECK(std::abs(double(found.sh[i] - expected[std::size_t(i)])) <= 2e-15);
    CHECK(std::abs(found.residuals[0] - double(std::sqrt(squares / (4 * zonal::kPi)))) <= 1e-15);
    const double condition = condition_of(rows);
    CHECK(std::abs(found.condition - condition) <= 1e-13 * condition);
  }
}

TEST_CASE("fit: the condition of samples that are all in a cone, and what smoothness makes of it") {
  std::mt19937 random(3);
  const Sh sh = random_function(random);
  const Samples s = sample(random, sh, 200, 0, 0.9);
  const auto found = fit(s);
  const double condition = condition_of(design(s, 0));
  CHECK(condition > 1e5);
  CHECK(std::abs(found.condition - condition) <= 1e-15 * condition * condition);
  CHECK(distance(found.sh, sh) <= 2e-15 * condition);
  CHECK(fit(s, 1e-3).condition < 1e3);
}

TEST_CASE("fit: results do not depend on batches, nor on channels beside, to the bit") {
  std::mt19937 random(4);
  const Samples s = sample(random, random_function(random), 997, 0.5);
  const auto at_once = fit(s, 1e-3);
  for (const std::size_t batch : {std::size_t{1}, std::size_t{7}, std::size_t{500}}) {
    zonal::SampleFitter<N, double> fitter;
    for (std::size_t first = 0; first < s.values.size(); first += batch) {
      const std::size_t count = std::min(batch, s.values.size() - first);
      fitter.add(zonal::direction_span(&s.directions[first], count), &s.values[first], &s.weights[first]);
    }
    CHECK(fitter.solve(1e-3).sh == at_once.sh);
    CHECK(fitter.solve(1e-3).sh == at_once.sh);  // it may be asked again
  }
  // In float, in three channels, of which the second is that one.
  std::vector<std::array<float, 3>> colours, directions;
  std::vector<float> weights, values;
  for (std::size_t k = 0; k < s.values.size(); ++k) {
    const auto& d = s.directions[k];
    directions.push_back({float(d[0]), float(d[1]), float(d[2])});
    values.push_back(float(s.values[k]));
    weights.push_back(float(s.weights[k]));
    colours.push_back({1.0F, values.back(), 0.0F});
  }
  std::vector<Colour> as_colours;
  for (const auto& c : colours) as_colours.push_back({{c[0], c[1], c[2]}});
  const auto span = zonal::direction_span(directions.data(), directions.size());
  const auto one = zonal::fit_samples<N>(span, values.data(), weights.data());
  const auto three = zonal::fit_samples<N>(span, as_colours.data(), weights.data());
  for (int i = 0; i < N * N; ++i) {
    CHECK(std::abs(three.sh[i][1] - one.sh[i]) <= 1e-6F);
    CHECK(std::abs(three.sh[i][0] - (i == 0 ? 2 * std::sqrt(std::acos(-1.0F)) : 0.0F)) <= 1e-6F);
    CHECK(std::abs(three.sh[i][2]) <= 1e-12F);
  }
  CHECK(std::abs(three.residuals[1] - one.residuals[0]) <= 1e-12);
  CHECK(std::abs(three.condition - one.condition) <= 1e-12 * one.condition);
}

TEST_CASE("fit: the scale of weights does not matter, nor do samples of weight 0, nor the length of directions") {
  std::mt19937 random(5);
  Samples s = sample(random, random_function(random), 100, 0.5);
  const auto before = fit(s, 1e-2);
  for (double& w : s.weights) w *= 1e20;
  for (Vec3& d : s.directions) {
    for (double& x : d) x *= 3;
  }
  s.directions.push_back({1, 0, 0});
  s.values.push_back(1e100);
  s.weights.push_back(0);
  const auto after = fit(s, 1e-2);
  CHECK(distance(before.sh, after.sh) <= 1e-14);
  CHECK(std::abs(before.residuals[0] - after.residuals[0]) <= 1e-14);
}

TEST_CASE("fit: bad samples are left out and counted") {
  std::mt19937 random(6);
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const Samples good = sample(random, random_function(random), 60, 0.5);
  Samples s = good;
  const auto append = [&s](const Vec3& d, double value, double weight) {
    s.directions.push_back(d);
    s.values.push_back(value);
    s.weights.push_back(weight);
  };
  append({0, 0, 0}, 1, 1);
  append({nan, 0, 1}, 1, 1);
  append({inf, 0, 1}, 1, 1);
  append({0, 0, 1}, nan, 1);
  append({0, 0, 1}, -inf, 1);
  append({0, 0, 1}, 1e200, 1);
  append({0, 0, 1}, 1, nan);
  append({0, 0, 1}, 1, inf);
  append({0, 0, 1}, 1, -1);
  const auto expected = fit(good), found = fit(s);
  CHECK(found.sh == expected.sh);
  CHECK(found.used == 60);
  CHECK(found.left_out == 9);
}

TEST_CASE("fit: too few samples give the least coefficients that fit, and say so") {
  std::mt19937 random(7);
  const double inf = std::numeric_limits<double>::infinity();
  const auto is_infinite = [&](double x) { return x >= inf; };

  const auto none = zonal::SampleFitter<N, double>().solve();
  CHECK(none.rank == 0);
  CHECK(is_infinite(none.condition));
  CHECK(none.sh == Sh{});
  Samples weightless = sample(random, random_function(random), 20, 0);
  for (double& w : weightless.weights) w = 0;
  for (const double smoothness : {0.0, 1.0}) {
    const auto zeros = fit(weightless, smoothness);
    CHECK(zeros.rank == 0);
    CHECK(zeros.sh == Sh{});
    CHECK(zeros.residuals[0] <= 0);
  }

  // Fewer than unknowns: they are met exactly, and no function of N bands that meets them has a smaller norm.
  const Sh sh = random_function(random);
  const Samples few = sample(random, sh, 9, 0);
  const auto found = fit(few);
  CHECK(found.rank == 9);
  CHECK(is_infinite(found.condition));
  CHECK(found.residuals[0] <= 1e-14);
  for (std::size_t k = 0; k < few.values.size(); ++k) {
    CHECK(std::abs(zonal::reconstruct(found.sh, few.directions[k]) - few.values[k]) <= 1e-13);
  }
  CHECK(std::abs(zonal::dot(found.sh, sh - found.sh)) <= 1e-13);  // the rest is across what was found

  // All in one place: one number is known, the mean there.
  Samples heap;
  for (int k = 0; k < 100; ++k) {
    heap.directions.push_back({0.6, 0, 0.8});
    heap.values.push_back(k % 2);
    heap.weights.push_back(1);
  }
  const auto of_heap = fit(heap);
  CHECK(of_heap.rank == 1);
  CHECK(std::abs(zonal::reconstruct(of_heap.sh, Vec3{0.6, 0, 0.8}) - 0.5) <= 1e-14);
  CHECK(std::abs(of_heap.residuals[0] - 0.5) <= 1e-14);
  // With smoothness it is that mean everywhere, for a constant costs nothing.
  const auto smooth = fit(heap, 1e-3);
  CHECK(smooth.rank == N * N);
  CHECK(std::abs(zonal::reconstruct(smooth.sh, Vec3{0, 1, 0}) - 0.5) <= 1e-12);
}
