// The arithmetic of coefficients, number by number; directions of any kind; sums of coloured samples.
#include <zonal/basis/gradient.hpp>
#include <zonal/zonal.hpp>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <random>
#include <type_traits>

#include "../catch.hpp"

namespace {

using zonal::EvenSh;
using zonal::Sh;
using zonal::Zh;

// A colour of one's own: what a user writes, and no more.
struct Rgb {
  float r, g, b;
  friend Rgb operator+(const Rgb& a, const Rgb& c) { return {a.r + c.r, a.g + c.g, a.b + c.b}; }
  friend Rgb operator*(float s, const Rgb& c) { return {s * c.r, s * c.g, s * c.b}; }
  friend bool operator==(const Rgb& a, const Rgb& c) { return !(a.r < c.r || a.r > c.r) && !(a.g < c.g || a.g > c.g); }
};

struct Xyz {
  float x, y, z;
};

template <class C>
C random_coefficients(std::mt19937& random) {
  C c;
  for (auto& value : c) value = static_cast<std::decay_t<decltype(value)>>(std::normal_distribution<double>()(random));
  return c;
}

// Every operation of Kind<N, T> is that of its numbers, to the bit.
template <class C>
void check_arithmetic() {
  using T = std::decay_t<decltype(C{}[0])>;
  std::mt19937 random(7);
  const C a = random_coefficients<C>(random), b = random_coefficients<C>(random);
  const T s = T(0.7);
  const auto is = [&](const C& got, auto expected) {
    for (int i = 0; i < C::size(); ++i) {
      CAPTURE(C::size(), i, a[i], b[i]);
      CHECK(got[i] == expected(a[i], b[i]));
    }
  };
  is(-a, [](T x, T) { return -x; });
  is(a + b, [](T x, T y) { return x + y; });
  is(a - b, [](T x, T y) { return x - y; });
  is(a * s, [&](T x, T) { return x * s; });
  is(s * a, [&](T x, T) { return x * s; });
  is(a / s, [&](T x, T) { return x / s; });
  // Numbers of another type are made T's.
  is(a * 0.7, [&](T x, T) { return x * s; });
  is(0.7L * a, [&](T x, T) { return x * T(0.7L); });
  is(3 * a, [](T x, T) { return 3 * x; });
  is(a / 3, [](T x, T) { return x / 3; });
  C c = a;
  is(c += b, [](T x, T y) { return x + y; });
  is(c -= b, [](T x, T y) { return (x + y) - y; });
  c = a;
  is(c *= 2, [](T x, T) { return 2 * x; });
  is(c /= 4, [](T x, T) { return x / 2; });
  static_assert(std::is_trivially_copyable_v<C> && std::is_aggregate_v<C>);

  CHECK(a == a);
  CHECK_FALSE(a != a);
  for (int i = 0; i < C::size(); ++i) {
    c = a;
    c[i] = std::nextafter(c[i], T(9));
    CHECK(c != a);
    CHECK_FALSE(a == c);
    c[i] = std::numeric_limits<T>::quiet_NaN();
    CHECK(c != c);
  }
}

// Of the first bands, and the conversion of scalars.
template <template <int, class> class Kind>
void check_bands() {
  std::mt19937 random(8);
  const auto a = random_coefficients<Kind<4, double>>(random);
  const Kind<2, double> first = zonal::with_bands<2>(a);
  const Kind<6, double> more = zonal::with_bands<6>(a);
  const auto floats = Kind<4, float>(a);
  for (int i = 0; i < more.size(); ++i) {
    CAPTURE(i);
    if (i < first.size()) CHECK(first[i] == a[i]);
    CHECK(more[i] == (i < a.size() ? a[i] : 0.0));
    if (i < a.size()) CHECK(floats[i] == static_cast<float>(a[i]));
  }
  CHECK(zonal::with_bands<4>(more) == a);
  CHECK(Kind<4, double>(floats) != a);
  static_assert(!std::is_convertible_v<Kind<4, double>, Kind<4, float>>, "only when asked for");
}

glm::vec3 make(const glm::vec3*, float r, float g, float b) { return {r, g, b}; }
Eigen::Vector3f make(const Eigen::Vector3f*, float r, float g, float b) { return {r, g, b}; }
Rgb make(const Rgb*, float r, float g, float b) { return {r, g, b}; }
template <class C>
float channel(const C& c, int i) {
  return c[i];
}
float channel(const Rgb& c, int i) { return i == 0 ? c.r : i == 1 ? c.g : c.b; }

// A sum of samples, channel by channel. `N` on both sides of what is written out.
template <int N, class C>
void check_samples() {
  std::mt19937 random(9);
  std::normal_distribution<float> normal;
  Sh<N, C> sum;
  for (C& c : sum) c = make(static_cast<const C*>(nullptr), 0, 0, 0);
  Sh<N, double> channels[3]{};
  for (int k = 0; k < 20; ++k) {
    const float x = normal(random), y = normal(random), z = normal(random), length = std::sqrt(x * x + y * y + z * z);
    const Xyz d{x / length, y / length, z / length};
    const C colour = make(static_cast<const C*>(nullptr), std::abs(x), std::abs(y), std::abs(z));
    if (k % 2 == 0) {
      sum += zonal::evaluate<N>(d) * colour;
    } else {
      sum += colour * zonal::evaluate<N>(d);
    }
    const auto basis = Sh<N, double>(zonal::evaluate<N>(d));
    for (int c = 0; c < 3; ++c) channels[c] += basis * channel(colour, c);
  }
  for (int i = 0; i < N * N; ++i) {
    for (int c = 0; c < 3; ++c) {
      CAPTURE(N, i, c);
      CHECK(std::abs(static_cast<double>(channel(sum[i], c)) - channels[c][i]) <= 2e-6);
    }
  }
  const Sh<N + 1, C> more = zonal::with_bands<N + 1>(sum, make(static_cast<const C*>(nullptr), 0, 0, 0));
  CHECK(channel(more[N * N], 2) == 0);
  CHECK(channel(more[N * N - 1], 2) == channel(sum[N * N - 1], 2));
  CHECK(zonal::with_bands<N>(more) == sum);
}

// A lobe whose colour changes with the degree, turned and convolved.
template <class C>
void check_coloured_lobe() {
  const auto z = zonal::project<3>(zonal::PhongLobe<float>{4.0F});
  const C colour = make(static_cast<const C*>(nullptr), 1, 2, 3);
  const Zh<3, C> lobe = z * colour;
  const Xyz d{0.48F, 0.6F, 0.64F};
  const Sh<3, C> turned = zonal::orient(lobe, d), smooth = zonal::convolve(zonal::evaluate<3>(d), lobe);
  const Sh<3, float> turned_1 = zonal::orient(z, d), smooth_1 = zonal::convolve(zonal::evaluate<3>(d), z);
  const Zh<3, C> twice = zonal::convolve(z, lobe);
  for (int c = 0; c < 3; ++c) {
    const auto factor = static_cast<float>(c + 1);
    for (int i = 0; i < 9; ++i) {
      CHECK(std::abs(channel(turned[i], c) - factor * turned_1[i]) <= 1e-6F);
      CHECK(std::abs(channel(smooth[i], c) - factor * smooth_1[i]) <= 1e-6F);
    }
    CHECK(std::abs(channel(twice[2], c) - factor * zonal::convolve(z, z)[2]) <= 1e-6F);
  }
}

}  // namespace

TEST_CASE("coefficients: each operation is that of the numbers") {
  check_arithmetic<Sh<1, float>>();
  check_arithmetic<Sh<3, float>>();
  check_arithmetic<EvenSh<4, double>>();
  check_arithmetic<Zh<5, float>>();
}

TEST_CASE("coefficients: bands left out and added, scalars converted") {
  check_bands<Sh>();
  check_bands<EvenSh>();
  check_bands<Zh>();
  const Sh<2, double> one{{{1, 2, 3, 4}}};
  CHECK(Sh<2, glm::vec3>(Sh<2, glm::dvec3>(Sh<2, double>(one) * glm::dvec3(1, 2, 3)))[3] == glm::vec3(4, 8, 12));
  CHECK(zonal::with_bands<2>(Zh<1, Eigen::Vector3f>{{{Eigen::Vector3f(1, 2, 3)}}})[1] == Eigen::Vector3f(0, 0, 0));
}

TEST_CASE("coefficients: times a colour they are colours, and samples add up") {
  check_samples<1, glm::vec3>();
  check_samples<5, glm::vec3>();
  check_samples<5, Eigen::Vector3f>();
  check_samples<3, Rgb>();
  check_samples<12, glm::vec3>();  // more than are written out
  Sh<2, glm::vec3> a = Sh<2, float>{{{1, 2, 3, 4}}} * glm::vec3(1, 2, 3);
  CHECK((a - a * 2)[1] == glm::vec3(-2, -4, -6));
  CHECK((-a / 2.0)[1] == glm::vec3(-1, -2, -3));
  CHECK((a * glm::vec3(0, 1, 2))[3] == glm::vec3(0, 8, 24));
  CHECK((a -= a)[3] == glm::vec3(0));
  // An expression is no type to keep.
  const Sh<2, Eigen::Vector3f> sum =
      Sh<2, float>{{{1, 2, 3, 4}}} * (Eigen::Vector3f(1, 2, 3) + Eigen::Vector3f(1, 1, 1));
  CHECK(sum[2] == Eigen::Vector3f(6, 9, 12));
}

TEST_CASE("coefficients: lobes of colours, turned and convolved") {
  check_coloured_lobe<glm::vec3>();
  check_coloured_lobe<Eigen::Vector3f>();
  check_coloured_lobe<Rgb>();
}

TEST_CASE("directions: x, y and z by name, or by number, are the same") {
  const Xyz named{0.48F, 0.6F, 0.64F};
  const std::array<float, 3> numbered{0.48F, 0.6F, 0.64F};
  const auto y = zonal::evaluate<4>(numbered);
  CHECK(zonal::evaluate<4>(named) == y);
  CHECK(zonal::evaluate<4>(numbered.data()) == y);
  CHECK(zonal::evaluate_with_gradient<3>(named).gradient[1] == zonal::evaluate_with_gradient<3>(numbered).gradient[1]);
  CHECK(zonal::evaluate_with_hessian<3>(named).hessian[4] == zonal::evaluate_with_hessian<3>(numbered).hessian[4]);
  const auto lobe = zonal::project<4>(zonal::PhongLobe<float>{4.0F});
  CHECK(zonal::orient(lobe, named) == zonal::orient(lobe, numbered));
  CHECK(zonal::reconstruct(y, named) == zonal::reconstruct(y, numbered));
  CHECK(zonal::reconstruct_convolved(y, lobe, named) == zonal::reconstruct_convolved(y, lobe, numbered));
}
