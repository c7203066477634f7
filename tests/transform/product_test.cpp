// Products against quadrature on the sphere, against values in directions, and against each other by both routes.
#include <zonal/scalar/quadrature.hpp>
#include <zonal/transform/product.hpp>
#include <zonal/zonal.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "../accuracy.hpp"
#include "../catch.hpp"

namespace {

using Real = long double;

// Functions of up to K bands at the nodes of a rule whose sum is the integral of three of them of N, N and K = 2N - 1
// bands: Gauss in z, uniform in phi.
template <int K>
struct Sphere {
  std::vector<zonal::Sh<K, Real>> basis;
  std::vector<Real> weights;

  Sphere() {
    const zonal::HalfGaussRule<K + 1> rule;
    const int columns = 2 * K + 1;
    for (int i = 0; i < 2 * rule.count; ++i) {
      const Real z = i % 2 == 0 ? rule.nodes[i / 2] : -rule.nodes[i / 2], r = std::sqrt(1 - z * z);
      if (i % 2 == 1 && !(z < 0)) continue;
      for (int j = 0; j < columns; ++j) {
        const Real phi = 2 * zonal::kPi * (Real(j) + 0.3L) / columns;
        basis.push_back(zonal::evaluate<K>(std::array<Real, 3>{r * std::cos(phi), r * std::sin(phi), z}));
        weights.push_back(rule.weights[i / 2] * 2 * zonal::kPi / columns);
      }
    }
  }
  Real value(const double* coefficients, int size, std::size_t node) const {
    Real sum = 0;
    for (int i = 0; i < size; ++i) sum += Real(coefficients[i]) * basis[node][i];
    return sum;
  }
  /// Of two functions' product: all coefficients.
  zonal::Sh<K, Real> product(const double* a, const double* b, int size) const {
    zonal::Sh<K, Real> sum{};
    for (std::size_t node = 0; node < basis.size(); ++node) {
      const Real weighted = value(a, size, node) * value(b, size, node) * weights[node];
      for (int i = 0; i < sum.size(); ++i) sum[i] += basis[node][i] * weighted;
    }
    return sum;
  }
  Real triple(const double* a, const double* b, const double* c, int size) const {
    Real sum = 0;
    for (std::size_t k = 0; k < basis.size(); ++k) {
      sum += value(a, size, k) * value(b, size, k) * value(c, size, k) * weights[k];
    }
    return sum;
  }
};

template <class C>
C random_coefficients(std::mt19937& random) {
  C c{};
  for (auto& x : c) x = std::uniform_real_distribution<double>(-1, 1)(random);
  return c;
}
template <class C>
double norm(const C& c) {
  Real sum = 0;
  for (const auto& x : c) sum += Real(x) * Real(x);
  return static_cast<double>(std::sqrt(sum));
}
// Of the first coefficients of b, as many as a has.
template <class A, class B>
double distance(const A& a, const B& b) {
  Real sum = 0;
  for (int i = 0; i < a.size(); ++i) sum += (Real(a[i]) - Real(b[i])) * (Real(a[i]) - Real(b[i]));
  return static_cast<double>(std::sqrt(sum));
}
template <int N>
zonal::Sh<N, double> as_sh(const zonal::Zh<N, double>& zh) {
  zonal::Sh<N, double> sh{};
  for (int l = 0; l < N; ++l) sh(l, 0) = zh[l];
  return sh;
}

// Truncated and full, zonal and triple, at N bands, in double and in float.
template <int N>
void check_bands(Met& met) {
  constexpr double bound = 5e-16, float_bound = 3e-7;
  using Sh = zonal::Sh<N, double>;
  using Zh = zonal::Zh<N, double>;
  std::mt19937 random(40 + N);
  const Sh a = random_coefficients<Sh>(random), b = random_coefficients<Sh>(random),
           c = random_coefficients<Sh>(random);
  const Zh y = random_coefficients<Zh>(random), z = random_coefficients<Zh>(random);
  const Sh y_sh = as_sh(y), z_sh = as_sh(z);
  const Sphere<2 * N - 1> sphere;
  CAPTURE(N);
  const auto ab = sphere.product(a.values, b.values, N * N);
  CHECK(met.meet(distance(zonal::full_product(a, b), ab) / norm(ab)));
  CHECK(distance(zonal::product(a, b), ab) <= bound * norm(ab));
  const auto az = sphere.product(a.values, z_sh.values, N * N);
  CHECK(distance(zonal::product(a, z), az) <= bound * norm(az));
  const auto yz = sphere.product(y_sh.values, z_sh.values, N * N);
  CHECK(distance(as_sh(zonal::product(y, z)), yz) <= bound * norm(yz));
  const double abc = static_cast<double>(sphere.triple(a.values, b.values, c.values, N * N));
  CHECK(std::abs(zonal::triple_product(a, b, c) - abc) <= bound * norm(ab) * norm(c));

  // The whole product is in every direction the product of the values.
  const auto whole = zonal::full_product(a, b);
  for (std::size_t node = 0; node < sphere.basis.size(); node += 7) {
    const Real values = sphere.value(a.values, N * N, node) * sphere.value(b.values, N * N, node);
    CHECK(std::abs(double(sphere.value(whole.values, whole.size(), node) - values)) <= bound * N * norm(ab));
  }

  using FloatSh = zonal::Sh<N, float>;
  const auto in_float = zonal::full_product(FloatSh(a), FloatSh(b));
  CHECK(distance(in_float, ab) <= float_bound * norm(ab));
}

// A colour with + and * alone, of which nothing is black.
struct Colour {
  double r = std::nan(""), g = r;
  friend Colour operator+(const Colour& a, const Colour& b) { return {a.r + b.r, a.g + b.g}; }
  friend Colour operator*(const Colour& a, double s) { return {a.r * s, a.g * s}; }
  friend Colour operator*(const Colour& a, const Colour& b) { return {a.r * b.r, a.g * b.g}; }
  double operator[](int i) const { return i == 0 ? r : g; }
};

// Colours by numbers and by colours, each channel as alone.
template <int N>
void check_colours() {
  std::mt19937 random(60 + N);
  using Sh = zonal::Sh<N, double>;
  const Sh a[] = {random_coefficients<Sh>(random), random_coefficients<Sh>(random)};
  const Sh b[] = {random_coefficients<Sh>(random), random_coefficients<Sh>(random)};
  const auto z = random_coefficients<zonal::Zh<N, double>>(random);
  zonal::Sh<N, Colour> colours, others;
  for (int i = 0; i < N * N; ++i) {
    colours[i] = {a[0][i], a[1][i]};
    others[i] = {b[0][i], b[1][i]};
  }
  const auto check = [](const auto& product, const auto& first, const auto& second) {
    for (int i = 0; i < product.size(); ++i) {
      CAPTURE(N, i);
      CHECK(std::abs(product[i][0] - first[i]) <= 1e-15 * norm(first));
      CHECK(std::abs(product[i][1] - second[i]) <= 1e-15 * norm(second));
    }
  };
  check(zonal::product(colours, b[0]), zonal::product(a[0], b[0]), zonal::product(a[1], b[0]));
  check(zonal::product(b[0], colours), zonal::product(a[0], b[0]), zonal::product(a[1], b[0]));
  check(zonal::product(colours, others), zonal::product(a[0], b[0]), zonal::product(a[1], b[1]));
  check(zonal::product(colours, z), zonal::product(a[0], z), zonal::product(a[1], z));
  const Colour triple = zonal::triple_product(colours, b[0], a[0]);
  CHECK(std::abs(triple.g - zonal::triple_product(a[1], b[0], a[0])) <= 1e-13);
}

// Both routes, at the numbers of bands where the other is taken as well.
template <int N, int K>
void check_routes() {
  std::mt19937 random(50 + N);
  const auto a = random_coefficients<zonal::Sh<N, double>>(random),
             b = random_coefficients<zonal::Sh<N, double>>(random);
  const auto z = random_coefficients<zonal::Zh<N, double>>(random);
  const auto by_gaunt = zonal::detail::product_by_gaunt<K>(a, b), by_rings = zonal::detail::product_by_rings<K>(a, b);
  CAPTURE(N, K);
  CHECK(distance(by_gaunt, by_rings) <= 2e-15 * norm(a) * norm(b));
  CHECK(distance(zonal::detail::product_by_gaunt(a, z), zonal::detail::product_by_rings(a, z)) <=
        2e-15 * norm(a) * norm(z));
}

}  // namespace

TEST_CASE("product: what its definition is by quadrature, by the Gaunt coefficients") {
  Met met("transform", "full_product");
  check_bands<1>(met);
  check_bands<2>(met);
  check_bands<3>(met);
  check_bands<5>(met);
  CHECK_MET(met);
}

TEST_CASE("product: what its definition is by quadrature, by rings") {
  Met met("transform", "full_product");
  check_bands<6>(met);
  check_bands<13>(met);  // its loops are not written out
  CHECK_MET(met);
}

TEST_CASE("product: by rings what it is by the Gaunt coefficients") {
  check_routes<1, 1>();
  check_routes<2, 3>();
  check_routes<4, 4>();
  check_routes<4, 6>();
}

TEST_CASE("product: colours by numbers and by colours, each channel as alone") {
  check_colours<1>();
  check_colours<3>();
  check_colours<6>();
}

TEST_CASE("product: with 1 it is the other function, with a function and its inverse it is 1") {
  std::mt19937 random(70);
  const auto a = random_coefficients<zonal::Sh<5, double>>(random);
  zonal::Sh<5, double> one{};
  one[0] = 2 * std::sqrt(std::acos(-1.0));
  CHECK(distance(zonal::product(a, one), a) <= 1e-15 * norm(a));
  CHECK(distance(zonal::product(one, a), a) <= 1e-15 * norm(a));
  // x^2 + y^2 + z^2 = 1
  zonal::Sh<3, double> x{}, y{}, z{};
  const double length = std::sqrt(4 * std::acos(-1.0) / 3);
  x(1, 1) = y(1, -1) = -length, z(1, 0) = length;
  CHECK(distance(zonal::product(x, x) + zonal::product(y, y) + zonal::product(z, z), zonal::with_bands<3>(one)) <=
        1e-15);
}

TEST_CASE("product: the numbers of Gaunt coefficients that are not zero") {
  // Of all ordered pairs, and of pairs once, as a plain list of triples has them.
  const auto count = [](const auto& gaunt, bool once) {
    int n = 0;
    for (const auto& pair : gaunt.pairs) {
      const bool is_square = pair.l == pair.k && pair.m == pair.n;
      // cos cos, sin sin, and sin cos, cos sin if they are two: to (j, m + n) and to (j, m - n).
      for (int t = pair.first; t < pair.last; ++t) {
        const int sines = pair.m > 0 ? (pair.n > 0 ? 4 : 2) : 1;
        const bool is_mean = pair.n > 0 && pair.m == pair.n && t >= pair.middle;  // the sine of order 0 is none
        if (once) {
          n += is_mean ? 2 : is_square && sines == 4 ? 3 : sines;
        } else {
          n += (is_mean ? 2 : sines) * (is_square ? 1 : 2);
        }
      }
    }
    return n;
  };
  CHECK(count(zonal::detail::gaunt_table<3, 3>, false) == 83);
  CHECK(count(zonal::detail::gaunt_table<5, 5>, false) == 1158);
  CHECK(count(zonal::detail::gaunt_table<6, 6>, false) == 2907);
  CHECK(count(zonal::detail::gaunt_table<3, 3>, true) == 52);
  CHECK(count(zonal::detail::gaunt_table<5, 5>, true) == 623);
  CHECK(count(zonal::detail::gaunt_table<6, 6>, true) == 1517);
}

TEST_CASE("quadrature: the half rule of compile time is the rule of run time") {
  const auto check = [](const auto& half, const zonal::QuadratureRule& rule) {
    const std::size_t last = rule.nodes.size() - 1;
    for (std::size_t i = 0; i < std::size_t(half.count); ++i) {
      CAPTURE(rule.nodes.size(), i);
      CHECK(std::abs(double(half.nodes[i]) - rule.nodes[last - i]) <= 1e-15);
      CHECK(std::abs(double(half.weights[i]) - rule.weights[last - i]) <= 1e-13 * rule.weights[last - i]);
    }
  };
  constexpr zonal::HalfGaussRule<7> seven;
  check(zonal::HalfGaussRule<1>(), zonal::gauss_legendre(1));
  check(zonal::HalfGaussRule<2>(), zonal::gauss_legendre(2));
  check(seven, zonal::gauss_legendre(7));
  check(zonal::HalfGaussRule<60>(), zonal::gauss_legendre(60));
}
