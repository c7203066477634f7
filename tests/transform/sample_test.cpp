// Directions drawn from spherical harmonics: their density integrates to one, and they follow it.
#include <zonal/scalar/quadrature.hpp>
#include <zonal/transform/sample.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "../catch.hpp"

namespace {

constexpr double pi = 3.14159265358979323846;

struct Direction {
  double x, y, z;
};

/// visit(direction, weight): exact for polynomials up to degree 2 rings - 1.
template <class Visit>
void for_each_node(int rings, const Visit& visit) {
  const zonal::QuadratureRule rule = zonal::gauss_legendre(rings);
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double z = rule.nodes[i], s = std::sqrt((1 - z) * (1 + z));
    for (int j = 0; j < 2 * rings; ++j) {
      const double phi = (j + 0.3) * pi / rings;
      visit(Direction{s * std::cos(phi), s * std::sin(phi), z}, rule.weights[i] * pi / rings);
    }
  }
}

template <int N, class F>
zonal::Sh<N, double> project(const F& f) {
  zonal::Sh<N, double> sh{};
  for_each_node(2 * N, [&](const Direction& d, double weight) { sh += zonal::evaluate<N>(d) * (f(d) * weight); });
  return sh;
}

struct Function {
  std::string name;
  zonal::Sh<9, double> sh;
};

/// None is negative: squares of functions of 5 bands have 9, some with lines of double zeros; peaks at the poles, at
/// phi = 0, and elsewhere.
std::vector<Function> functions() {
  std::vector<Function> all{{"constant", project<9>([](const Direction&) { return 1e-20; })},
                            {"peak at z", project<9>([](const Direction& d) { return std::pow(1 + d.z, 8); })},
                            {"peak at -z", project<9>([](const Direction& d) { return 1e20 * std::pow(1 - d.z, 8); })},
                            {"peak at x", project<9>([](const Direction& d) { return std::pow(1 + d.x, 8); })},
                            {"zero on y = 0", project<9>([](const Direction& d) { return std::pow(d.y, 8); })},
                            {"zero on z = 0", project<9>([](const Direction& d) { return std::pow(d.z, 8); })}};
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 4; ++i) {
    zonal::Sh<5, double> root;
    for (double& coefficient : root) coefficient = normal(random);
    const auto square = [&](const Direction& d) {
      const zonal::Sh<5, double> basis = zonal::evaluate<5>(d);
      double sum = 0;
      for (int k = 0; k < 25; ++k) sum += root[k] * basis[k];
      return sum * sum;
    };
    all.push_back({"square " + std::to_string(i), project<9>(square)});
  }
  return all;
}

constexpr int rows = 24, columns = 48;  // of equal solid angle

int cell_of(double x, double y, double z) {
  const double turn = std::atan2(y, x) / (2 * pi);
  const int row = std::min(rows - 1, static_cast<int>((z + 1) / 2 * rows));
  const int column = std::min(columns - 1, static_cast<int>((turn < 0 ? turn + 1 : turn) * columns));
  return row * columns + column;
}

/// The function's share of each cell.
std::vector<double> shares(const zonal::Sh<9, double>& sh) {
  const double integral = sh[0] * std::sqrt(4 * pi);
  const zonal::QuadratureRule rule = zonal::gauss_legendre(8);
  std::vector<double> all(std::size_t{rows * columns});
  for (int cell = 0; cell < rows * columns; ++cell) {
    for (std::size_t i = 0; i < 8; ++i) {
      for (std::size_t j = 0; j < 8; ++j) {
        const double z = -1 + 2.0 / rows * (cell / columns + (1 + rule.nodes[i]) / 2), s = std::sqrt((1 - z) * (1 + z));
        const double phi = 2 * pi / columns * (cell % columns + (1 + rule.nodes[j]) / 2);
        const zonal::Sh<9, double> basis = zonal::evaluate<9>(Direction{s * std::cos(phi), s * std::sin(phi), z});
        double value = 0;
        for (int k = 0; k < 81; ++k) value += sh[k] * basis[k];
        all[std::size_t(cell)] += value / integral * rule.weights[i] * rule.weights[j] * pi / (rows * columns);
      }
    }
  }
  return all;
}

/// The share of chi-squared's distribution above `statistic`, by Wilson and Hilferty's approximation.
double probability_above(double statistic, double freedom) {
  const double variance = 2 / (9 * freedom);
  const double normal = (std::cbrt(statistic / freedom) - 1 + variance) / std::sqrt(variance);
  return 0.5 * std::erfc(normal / std::sqrt(2.0));
}

/// Cells that are expected to have few count as one.
template <class Counts>
double chi_squared_probability(const Counts& counts, const std::vector<double>& expected) {
  double statistic = 0, rest = 0, rest_expected = 0;
  int freedom = -1;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] < 10) {
      rest += counts[i], rest_expected += expected[i];
    } else {
      statistic += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i], ++freedom;
    }
  }
  if (rest_expected >= 10) {
    statistic += (rest - rest_expected) * (rest - rest_expected) / rest_expected, ++freedom;
  } else {
    CHECK(rest <= 40);
  }
  return freedom > 0 ? probability_above(statistic, freedom) : 1.0;
}

template <class T>
void check_draws(const Function& function) {
  constexpr int side = 600;
  const zonal::ShSampler<9, T> sampler{zonal::Sh<9, T>(function.sh)};
  INFO(function.name);
  CHECK_FALSE(sampler.is_uniform());
  std::mt19937 random(23);
  std::uniform_real_distribution<T> uniform(T(0), T(1));
  std::vector<double> counts(std::size_t{rows * columns});
  double worst_length = 0, worst_pdf = 0;
  const double integral = function.sh[0] * std::sqrt(4 * pi);
  double largest = 0;
  for (int i = 0; i < side * side; ++i) {
    const auto drawn = sampler.sample(uniform(random), uniform(random));
    const double x = double(drawn.x), y = double(drawn.y), z = double(drawn.z);
    ++counts[std::size_t(cell_of(x, y, z))];
    worst_length = std::max(worst_length, std::abs(x * x + y * y + z * z - 1));
    if (i % 16 != 0) continue;
    const double scale = 1 / std::sqrt(x * x + y * y + z * z);
    const zonal::Sh<9, double> basis = zonal::evaluate<9>(Direction{x * scale, y * scale, z * scale});
    double value = 0;
    for (int k = 0; k < 81; ++k) value += function.sh[k] * basis[k];
    largest = std::max(largest, value / integral);
    worst_pdf = std::max(worst_pdf, std::abs(double(drawn.pdf) - value / integral));
    worst_pdf = std::max(worst_pdf, std::abs(double(drawn.pdf - sampler.pdf(Direction{x, y, z}))));
  }
  constexpr double epsilon = double(std::numeric_limits<T>::epsilon());
  CHECK(worst_length <= 6 * epsilon);
  CHECK(worst_pdf <= 40 * epsilon * largest);
  std::vector<double> expected = shares(function.sh);
  for (double& share : expected) share *= side * side;
  CHECK(chi_squared_probability(counts, expected) >= 1e-4);
}

}  // namespace

TEST_CASE("The density of directions drawn from spherical harmonics integrates to one") {
  for (const Function& function : functions()) {
    const zonal::ShSampler<9, double> sampler(function.sh);
    double sum = 0;
    for_each_node(12, [&](const Direction& d, double weight) { sum += sampler.pdf(d) * weight; });
    INFO(function.name);
    CHECK(std::abs(sum - 1) <= 1e-13);
  }
}

TEST_CASE("Directions drawn from spherical harmonics follow their density: chi-squared, in float") {
  for (const Function& function : functions()) check_draws<float>(function);
}

TEST_CASE("Directions drawn from spherical harmonics follow their density: chi-squared, in double") {
  for (const Function& function : functions()) check_draws<double>(function);
}

TEST_CASE("Directions drawn at the ends of the unit square are directions") {
  for (const Function& function : functions()) {
    const zonal::ShSampler<9, float> sampler{zonal::Sh<9, float>(function.sh)};
    for (const float u : {0.0F, 1e-30F, 0x1p-24F, 0.5F, 1 - 0x1p-24F, 1.0F}) {
      for (const float v : {0.0F, 1e-30F, 0x1p-24F, 0.5F, 1 - 0x1p-24F, 1.0F}) {
        const auto drawn = sampler.sample(u, v);
        INFO(function.name << ", u " << u << ", v " << v << ": " << drawn.x << ", " << drawn.y << ", " << drawn.z);
        CHECK(std::abs(drawn.x * drawn.x + drawn.y * drawn.y + drawn.z * drawn.z - 1) <= 1e-6F);
        CHECK(drawn.pdf >= 0);
      }
    }
  }
}

TEST_CASE("Directions of a function without a positive integral are uniform") {
  const float infinity = std::numeric_limits<float>::infinity();
  for (const float first : {0.0F, -1.0F, infinity, std::nanf("")}) {
    const zonal::ShSampler<2, float> sampler{zonal::Sh<2, float>{{first, 1, 2, 3}}};
    INFO(first);
    CHECK(sampler.is_uniform());
    const auto drawn = sampler.sample(0.25F, 0.5F);
    CHECK(drawn.z == Catch::Approx(-0.5F).margin(1e-6));
    CHECK(drawn.pdf == Catch::Approx(1 / (4 * pi)).epsilon(1e-6));
  }
}
