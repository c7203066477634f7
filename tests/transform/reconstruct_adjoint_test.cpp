// Values along vectors and their derivatives: against the gradient of the basis in long double, dual numbers and
// differences; near poles, along short and long vectors; in packets; splats, and where they are clamped.
#include <Eigen/Core>
#include <glm/vec3.hpp>
#include <zonal/basis/gradient.hpp>
#include <zonal/scalar/dual.hpp>
#include <zonal/scalar/packet.hpp>
#include <zonal/transform/reconstruct_adjoint.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

#include "../accuracy.hpp"
#include "../basis/directions.hpp"
#include "../catch.hpp"

namespace {

using zonal::ColourRule;
using zonal::reconstruct_along;
using zonal::reconstruct_with_adjoint;
using zonal::Sh;
using zonal::sh_index;

template <class T>
using Colour = glm::vec<3, T>;

template <class T>
struct Sample {
  Vector3<T> vector;
  Colour<T> by_value;
};

/// Vectors to all sides and near poles, a third of them each of length 1, short and long.
template <class T>
std::vector<Sample<T>> samples(int count, T shortest, T longest) {
  std::vector<Sample<T>> all;
  std::mt19937 random(21);
  std::uniform_real_distribution<T> uniform(-1, 1);
  for (const Vector3<T>& d : directions_and_poles<T>(count, 20)) {
    const T length = all.size() % 3 == 0 ? T(1) : all.size() % 3 == 1 ? shortest : longest;
    all.push_back({{d[0] * length, d[1] * length, d[2] * length}, {uniform(random), uniform(random), uniform(random)}});
  }
  return all;
}
template <int N, class T>
Sh<N, Colour<T>> coefficients(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<T> uniform(-1, 1);
  Sh<N, Colour<T>> sh;
  for (Colour<T>& c : sh) c = {uniform(random), uniform(random), uniform(random)};
  return sh;
}

/// The greatest errors, in epsilons of the sum of the terms' greatest magnitudes: of value, by_sh, by_direction.
template <int N, class T>
std::array<double, 3> greatest_errors(T shortest, T longest) {
  using Long = long double;
  std::array<double, 3> greatest{};
  const auto see = [&](std::size_t what, Long error, Long unit) {
    greatest[what] = std::max(greatest[what], double(std::abs(error) / unit / std::numeric_limits<T>::epsilon()));
  };
  unsigned seed = 0;
  for (const Sample<T>& sample : samples<T>(2000, shortest, longest)) {
    const Sh<N, Colour<T>> sh = coefficients<N, T>(++seed);
    const auto found = reconstruct_with_adjoint(sh, sample.vector, sample.by_value);
    const Long x = sample.vector[0], y = sample.vector[1], z = sample.vector[2];
    const Long length = std::sqrt(x * x + y * y + z * z);
    const auto basis = zonal::evaluate_with_gradient<N>(Vector3<Long>{x / length, y / length, z / length});
    Long value[3] = {}, size[3] = {}, slope[3] = {}, slope_size = 0;
    for (int l = 0; l < N; ++l) {
      const Long largest = std::sqrt((2 * l + 1) / (4 * zonal::kPi));  // of the degree, by the addition theorem
      const Long steepest = largest * std::sqrt(Long(l * (l + 1)));
      for (int i = sh_index(l, -l); i <= sh_index(l, l); ++i) {
        Long by_basis = 0, by_basis_size = 0;
        for (int c = 0; c < 3; ++c) {
          const Long a = sh[i][c], by = sample.by_value[c];
          value[c] += a * basis.value[i], size[c] += std::abs(a) * largest;
          by_basis += a * by, by_basis_size += std::abs(a * by);
          see(1, found.by_sh[i][c] - by * basis.value[i], std::abs(by) * largest);
        }
        for (int k = 0; k < 3; ++k) slope[k] += by_basis * basis.gradient[k][i] / length;
        slope_size += by_basis_size * steepest / length;
      }
    }
    for (int c = 0; c < 3; ++c) see(0, found.value[c] - value[c], size[c]);
    for (int k = 0; k < 3; ++k) see(2, found.by_direction[k] - slope[k], slope_size);
  }
  return greatest;
}

}  // namespace

TEST_CASE("adjoint: what the gradient of the basis comes to, near poles, along short and long vectors") {
  // The loosest is the promise: it is that of the basis itself, which is by_sh. What sums up is closer.
  const auto check = [](const std::array<double, 3>& errors, double value, const Accuracy& promise) {
    CAPTURE(errors[0], errors[1], errors[2]);
    CHECK(errors[0] <= value);
    CHECK(errors[1] <= promise.bound);
    CHECK(errors[2] <= 1.5);
  };
  const auto promise = [](const char* scalar, int bands) {
    return accuracy_of("reconstruct_with_adjoint", scalar, bands);
  };
  check(greatest_errors<3, float>(1e-17F, 1e17F), 1.5, promise("float", 3));
  check(greatest_errors<4, float>(1e-17F, 1e17F), 1.5, promise("float", 4));
  check(greatest_errors<10, float>(1e-17F, 1e17F), 3, promise("float", 10));
  check(greatest_errors<4, double>(1e-150, 1e150), 1.5, promise("double", 4));
  check(greatest_errors<10, double>(1e-150, 1e150), 3, promise("double", 10));
}

TEST_CASE("adjoint: what dual numbers and differences say, of numbers and of splats") {
  constexpr int N = 4, size = N * N;
  using Dual = zonal::Dual<double, size + 3>;
  const auto check = [&](auto rule) {
    constexpr ColourRule by_rule = rule();
    int clamped = 0;
    unsigned seed = 0;
    for (const Sample<double>& sample : samples<double>(300, 1e-3, 1e3)) {
      const auto colours = coefficients<N, double>(++seed);
      Sh<N, double> sh;
      Sh<N, Dual> dual_sh;
      for (int i = 0; i < size; ++i) sh[i] = colours[i].x, dual_sh[i] = Dual::variable(sh[i], i);
      const Vector3<double>& v = sample.vector;
      std::array<Dual, 3> dual_v;
      for (std::size_t k = 0; k < 3; ++k) dual_v[k] = Dual::variable(v[k], size + static_cast<int>(k));
      const double by = sample.by_value.x, length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);

      const auto found = reconstruct_with_adjoint<by_rule>(sh, v, by);
      const Dual expected = reconstruct_along<by_rule>(dual_sh, dual_v);
      const auto partial = [&](int i) { return by * expected.partial[static_cast<std::size_t>(i)]; };
      CAPTURE(v[0], v[1], v[2], by, found.value, expected.value);
      CHECK(found.value == reconstruct_along<by_rule>(sh, v));
      CHECK(std::abs(found.value - expected.value) <= 1e-14);
      for (int i = 0; i < size; ++i) CHECK(std::abs(found.by_sh[i] - partial(i)) <= 1e-14);
      for (int k = 0; k < 3; ++k) CHECK(std::abs(found.by_direction[k] - partial(size + k)) * length <= 1e-13);
      if (by_rule == ColourRule::splat && expected.value <= 0) {
        ++clamped;
        for (const double derivative : found.by_sh) CHECK(derivative == 0);
        for (const double derivative : found.by_direction) CHECK(derivative == 0);
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        auto above = v, below = v;
        const double h = 1e-6 * length;
        above[k] += h, below[k] -= h;
        const double slope = (reconstruct_along<by_rule>(sh, above) - reconstruct_along<by_rule>(sh, below)) / (2 * h);
        CHECK(std::abs(found.by_direction[k] - by * slope) * length <= 1e-8);
      }
    }
    if (by_rule == ColourRule::splat) CHECK(clamped > 50);
  };
  check(std::integral_constant<ColourRule, ColourRule::plain>{});
  check(std::integral_constant<ColourRule, ColourRule::splat>{});
}

TEST_CASE("adjoint: a splat's colour is half more and at least 0, and at 0 itself it is derived") {
  Sh<2, float> sh{};
  const Vector3<float> v{0, 0, 2};
  sh[0] = -0.5F / zonal::evaluate<2>(Vector3<float>{0, 0, 1})[0];  // half more is 0
  const float just_below = std::nextafter(sh[0], -10.0F);
  auto at = reconstruct_with_adjoint<ColourRule::splat>(sh, v, 3.0F);
  REQUIRE(at.value == 0);
  CHECK(at.by_sh[0] > 0.8F);
  sh[0] = 2 * just_below;
  at = reconstruct_with_adjoint<ColourRule::splat>(sh, v, 3.0F);
  CHECK(at.value == 0);
  CHECK(at.by_sh[0] == 0);
  sh[0] = 0;
  CHECK(reconstruct_along<ColourRule::splat>(sh, v) == 0.5F);
  CHECK(reconstruct_along(sh, v) == 0);
}

// [Kerbl et al. 2023], as their renderer has it, with its constants.
TEST_CASE("adjoint: a splat is what 3D Gaussian splatting makes of it") {
  constexpr double c0 = 0.28209479177387814, c1 = 0.4886025119029199;
  constexpr double c2[] = {1.0925484305920792, -1.0925484305920792, 0.31539156525252005, -1.0925484305920792,
                           0.5462742152960396};
  constexpr double c3[] = {-0.5900435899266435, 2.890611442640554, -0.4570457994644658, 0.3731763325901154,
                           -0.4570457994644658, 1.445305721320277, -0.5900435899266435};
  unsigned seed = 0;
  for (const Sample<double>& sample : samples<double>(200, 0.1, 30.0)) {
    const Vector3<double>& v = sample.vector;
    const auto [x, y, z] = normalized(v[0], v[1], v[2]);
    const double xx = x * x, yy = y * y, zz = z * z;
    const double basis[16] = {c0,
                              -c1 * y,
                              c1 * z,
                              -c1 * x,
                              c2[0] * x * y,
                              c2[1] * y * z,
                              c2[2] * (2 * zz - xx - yy),
                              c2[3] * x * z,
                              c2[4] * (xx - yy),
                              c3[0] * y * (3 * xx - yy),
                              c3[1] * x * y * z,
                              c3[2] * y * (4 * zz - xx - yy),
                              c3[3] * z * (2 * zz - 3 * xx - 3 * yy),
                              c3[4] * x * (4 * zz - xx - yy),
                              c3[5] * z * (xx - yy),
                              c3[6] * x * (xx - 3 * yy)};
    const auto sh = coefficients<4, double>(++seed);
    const auto found = reconstruct_with_adjoint<ColourRule::splat>(sh, v, sample.by_value);
    for (int c = 0; c < 3; ++c) {
      double sum = 0.5;
      for (int i = 0; i < 16; ++i) sum += basis[i] * sh[i][c];
      CAPTURE(v[0], v[1], v[2], c);
      CHECK(std::abs(found.value[c] - std::max(sum, 0.0)) <= 1e-14);
      for (int i = 0; i < 16; ++i) {
        CHECK(std::abs(found.by_sh[i][c] - (sum < 0 ? 0 : basis[i] * sample.by_value[c])) <= 1e-14);
      }
    }
  }
}

TEST_CASE("adjoint: colours of other libraries, channel by channel, and packets, lane by lane") {
  constexpr int N = 4, W = 8;
  using P = zonal::Packet<float, W>;
  const auto all = samples<float>(W, 1e-2F, 1e2F);
  Sh<N, P> packet_sh;
  std::array<P, 3> packet_v;
  P packet_by(0);
  for (int lane = 0; lane < W; ++lane) {
    const auto sh = coefficients<N, float>(unsigned(lane));
    const Sample<float>& sample = all[std::size_t(lane)];
    for (int i = 0; i < N * N; ++i) packet_sh[i].set(lane, sh[i].x);
    for (std::size_t k = 0; k < 3; ++k) packet_v[k].set(lane, sample.vector[k]);
    packet_by.set(lane, sample.by_value.x);
  }
  const auto packet = reconstruct_with_adjoint<ColourRule::splat>(packet_sh, packet_v, packet_by);
  for (int lane = 0; lane < W; ++lane) {
    const auto sh = coefficients<N, float>(unsigned(lane));
    const Sample<float>& sample = all[std::size_t(lane)];
    const auto colour = reconstruct_with_adjoint<ColourRule::splat>(sh, sample.vector, sample.by_value);
    const Vector3<float>& v = sample.vector;
    const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    float by_direction[3] = {};
    Sh<N, Eigen::Vector3f> eigen_sh;
    for (int i = 0; i < N * N; ++i) eigen_sh[i] = {sh[i].x, sh[i].y, sh[i].z};
    for (int c = 0; c < 3; ++c) {
      Sh<N, float> channel;
      for (int i = 0; i < N * N; ++i) channel[i] = sh[i][c];
      const auto one = reconstruct_with_adjoint<ColourRule::splat>(channel, sample.vector, sample.by_value[c]);
      CAPTURE(lane, c);
      CHECK(one.value == Approx(colour.value[c]).margin(1e-6));
      for (int i = 0; i < N * N; ++i) CHECK(one.by_sh[i] == Approx(colour.by_sh[i][c]).margin(1e-6));
      for (int k = 0; k < 3; ++k) by_direction[k] += one.by_direction[k];
      if (c > 0) continue;
      CHECK(packet.value[lane] == Approx(one.value).margin(1e-6));
      for (int i = 0; i < N * N; ++i) CHECK(packet.by_sh[i][lane] == Approx(one.by_sh[i]).margin(1e-6));
      for (int k = 0; k < 3; ++k) CHECK(std::abs(packet.by_direction[k][lane] - one.by_direction[k]) * length <= 1e-5F);
    }
    for (int k = 0; k < 3; ++k) CHECK(std::abs(by_direction[k] - colour.by_direction[k]) * length <= 1e-5F);
    const Eigen::Vector3f by{sample.by_value.x, sample.by_value.y, sample.by_value.z};
    const auto in_eigen = reconstruct_with_adjoint<ColourRule::splat>(eigen_sh, sample.vector, by);
    for (int c = 0; c < 3; ++c) CHECK(in_eigen.value[c] == colour.value[c]);
    for (int i = 0; i < N * N; ++i) CHECK(in_eigen.by_sh[i][1] == colour.by_sh[i][1]);
    for (int k = 0; k < 3; ++k) CHECK(in_eigen.by_direction[k] == colour.by_direction[k]);
  }
}

TEST_CASE("adjoint: a vector of length 0 has no direction") {
  const auto none = reconstruct_with_adjoint(coefficients<3, float>(1), Vector3<float>{0, 0, 0}, {1, 1, 1});
  CHECK(std::isnan(none.value.x));
  CHECK(std::isnan(none.by_direction[0]));
}
