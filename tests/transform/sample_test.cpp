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

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "../drawn_directions.hpp"

namespace {

using drawn::Direction;
using drawn::pi;

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

double value_of(const zonal::Sh<9, double>& sh, const Direction& d) {
  const zonal::Sh<9, double> basis = zonal::evaluate<9>(d);
  double value = 0;
  for (int k = 0; k < 81; ++k) value += sh[k] * basis[k];
  return value;
}

template <class T>
void check_draws(const Function& function, Met& met) {
  constexpr int side = 600;
  const zonal::ShSampler<9, T> sampler{zonal::Sh<9, T>(function.sh)};
  INFO(function.name);
  CHECK_FALSE(sampler.is_uniform());
  std::mt19937 random(23);
  std::uniform_real_distribution<T> uniform(T(0), T(1));
  std::vector<double> counts(std::size_t{drawn::cells});
  double worst_length = 0, worst_pdf = 0;
  const double integral = function.sh[0] * std::sqrt(4 * pi);
  double largest = 0;
  for (int i = 0; i < side * side; ++i) {
    const auto direction = sampler.sample(uniform(random), uniform(random));
    const double x = double(direction.x), y = double(direction.y), z = double(direction.z);
    ++counts[std::size_t(drawn::cell_of(x, y, z))];
    worst_length = std::max(worst_length, std::abs(x * x + y * y + z * z - 1));
    if (i % 16 != 0) continue;
    const double scale = 1 / std::sqrt(x * x + y * y + z * z);
    const double value = value_of(function.sh, {x * scale, y * scale, z * scale});
    largest = std::max(largest, value / integral);
    worst_pdf = std::max(worst_pdf, std::abs(double(direction.pdf) - value / integral));
    worst_pdf = std::max(worst_pdf, std::abs(double(direction.pdf - sampler.pdf(Direction{x, y, z}))));
  }
  constexpr double epsilon = double(std::numeric_limits<T>::epsilon());
  CHECK(worst_length <= 6 * epsilon);
  CHECK(met.meet(worst_pdf / (epsilon * largest)));
  std::vector<double> expected =
      drawn::shares(6, [&](const Direction& d) { return value_of(function.sh, d) / integral; });
  for (double& share : expected) share *= side * side;
  CHECK(drawn::chi_squared_probability(counts, expected) >= 1e-4);
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
  Met met("transform", "ShSampler");
  for (const Function& function : functions()) check_draws<float>(function, met);
  CHECK_MET(met);
}

TEST_CASE("Directions drawn from spherical harmonics follow their density: chi-squared, in double") {
  Met met("transform", "ShSampler");
  for (const Function& function : functions()) check_draws<double>(function, met);
  CHECK_MET(met);
}

TEST_CASE("Directions drawn at the ends of the unit square are directions") {
  for (const Function& function : functions()) {
    const zonal::ShSampler<9, float> sampler{zonal::Sh<9, float>(function.sh)};
    for (const float u : {0.0F, 1e-30F, 0x1p-24F, 0.5F, 1 - 0x1p-24F, 1.0F}) {
      for (const float v : {0.0F, 1e-30F, 0x1p-24F, 0.5F, 1 - 0x1p-24F, 1.0F}) {
        const auto direction = sampler.sample(u, v);
        INFO(function.name << ", u " << u << ", v " << v << ": " << direction.x << ", " << direction.y << ", "
                           << direction.z);
        CHECK(std::abs(direction.x * direction.x + direction.y * direction.y + direction.z * direction.z - 1) <= 1e-6F);
        CHECK(direction.pdf >= 0);
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
    const auto direction = sampler.sample(0.25F, 0.5F);
    CHECK(direction.z == Catch::Approx(-0.5F).margin(1e-6));
    CHECK(direction.pdf == Catch::Approx(1 / (4 * pi)).epsilon(1e-6));
  }
}
