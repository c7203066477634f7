// Rotations: by their definition on harmonics, by another recurrence, as a group; with the angles that are hard.
#include <zonal/environment/rgb.hpp>
#include <zonal/transform/dense_rotation.hpp>
#include <zonal/transform/orient.hpp>
#include <zonal/transform/rotate.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Core>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "ivanic_ruedenberg.hpp"

namespace {

using Vector = std::array<double, 3>;
using zonal::Rotation;
using zonal::Sh;
constexpr double pi = 3.14159265358979323846;

struct Frame {
  double axes[3][3];  // where x, y and z go

  Vector operator()(const Vector& v) const {
    Vector r{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) r[k] += v[i] * axes[i][k];
    }
    return r;
  }
};

/// Rz(a) Ry(b) Rz(c), in more digits than double has.
Frame frame_of(long double a, long double b, long double c) {
  const long double ca = std::cos(a), sa = std::sin(a), cb = std::cos(b), sb = std::sin(b), cc = std::cos(c),
                    sc = std::sin(c);
  return {{{double(ca * cb * cc - sa * sc), double(sa * cb * cc + ca * sc), double(-sb * cc)},
           {double(-ca * cb * sc - sa * cc), double(ca * cc - sa * cb * sc), double(sb * sc)},
           {double(ca * sb), double(sa * sb), double(cb)}}};
}

/// Random ones; and b at 0 and pi, and next to them down to where it is nothing, with any a and c.
std::vector<Frame> frames() {
  std::vector<Frame> all;
  std::mt19937 random(31);
  std::uniform_real_distribution<double> turn(-pi, pi);
  for (int i = 0; i < 60; ++i) all.push_back(frame_of(turn(random), std::acos(turn(random) / pi), turn(random)));
  for (const double distance : {0.0, 1e-300, 1e-40, 1e-20, 1e-16, 1e-8, 1e-4, 1e-2}) {
    for (const double side : {0.0, pi}) {
      all.push_back(frame_of(turn(random), std::abs(side - distance), turn(random)));
      all.push_back(frame_of(0, std::abs(side - distance), turn(random)));
      all.push_back(frame_of(turn(random), std::abs(side - distance), pi / 2));
    }
  }
  for (const double a : {0.0, pi / 2, pi, -pi / 2}) {
    for (const double b : {0.0, pi / 2, pi}) all.push_back(frame_of(a, b, pi / 2));
  }
  return all;
}

template <int N, class T>
Rotation<N, T> rotation_of(const Frame& frame, double sign = 1) {
  T axes[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) axes[i][k] = T(sign * frame.axes[i][k]);
  }
  return Rotation<N, T>::from_axes(axes[0], axes[1], axes[2]);
}

template <int N, class T>
Sh<N, T> random_sh(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Sh<N, T> sh;
  for (T& coefficient : sh) coefficient = T(normal(random));
  return sh;
}

/// The length of the difference over that of b.
template <int N, class A, class B>
double distance(const Sh<N, A>& a, const Sh<N, B>& b) {
  double difference = 0, length = 0;
  for (int i = 0; i < N * N; ++i) {
    difference += (double(a[i]) - double(b[i])) * (double(a[i]) - double(b[i]));
    length += double(b[i]) * double(b[i]);
  }
  return std::sqrt(difference / length);
}

struct Worst {
  double error = 0;
  std::size_t number = 0;  // of the frame
  void meet(double e, std::size_t i) {
    if (!(e <= error)) error = e, number = i;
  }
};

/// Harmonics of a rotated direction are the rotated harmonics of the direction; and mirrored ones.
template <int N, class T>
Worst worst_of_harmonics() {
  Worst worst;
  std::mt19937 random(32);
  std::normal_distribution<double> normal;
  const std::vector<Frame> all = frames();
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const double sign : {1.0, -1.0}) {
      Vector d{normal(random), normal(random), normal(random)};
      const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
      for (double& v : d) v *= sign / length;
      const Sh<N, double> expected = zonal::evaluate<N>(all[i](d));
      for (double& v : d) v *= sign;
      worst.meet(distance(rotate(Sh<N, T>(zonal::evaluate<N>(d)), rotation_of<N, T>(all[i], sign)), expected), i);
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("Harmonics of a rotated direction are the rotated harmonics") {
  const Worst of_double = worst_of_harmonics<10, double>(), of_float = worst_of_harmonics<10, float>(),
              of_many = worst_of_harmonics<21, double>();
  CAPTURE(of_double.number, of_float.number, of_many.number);
  CHECK(of_double.error <= 9e-14);
  CHECK(of_many.error <= 2e-13);
  CHECK(of_float.error <= 4e-6);
}

TEST_CASE("A rotation is the matrix of Ivanic and Ruedenberg, and orthogonal") {
  constexpr int N = 10;
  Worst worst, orthogonal;
  const std::vector<Frame> all = frames();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Rotation<N, double> rotation = rotation_of<N, double>(all[i]);
    const ivanic_ruedenberg::Matrices reference(all[i].axes, N);
    std::vector<Sh<N, double>> columns;
    for (int l = 0; l < N; ++l) {
      for (int n = -l; n <= l; ++n) {
        Sh<N, double> unit{};
        unit(l, n) = 1;
        columns.push_back(rotate(unit, rotation));
        for (int m = -l; m <= l; ++m) worst.meet(std::abs(columns.back()(l, m) - reference(l, m, n)), i);
      }
    }
    for (int l = 1; l < N; ++l) {
      for (int a = l * l; a < (l + 1) * (l + 1); ++a) {
        for (int b = l * l; b < (l + 1) * (l + 1); ++b) {
          double product = a == b ? -1 : 0;
          for (int k = 0; k < N * N; ++k) product += columns[std::size_t(a)][k] * columns[std::size_t(b)][k];
          orthogonal.meet(std::abs(product) / l, i);
        }
      }
    }
  }
  CAPTURE(worst.number, orthogonal.number);
  CHECK(worst.error <= 1e-13);
  CHECK(orthogonal.error <= 1e-14);
}

TEST_CASE("Rotations have inverses and products") {
  constexpr int N = 10;
  Worst inverse, product, inverse_float;
  std::mt19937 random(33);
  const std::vector<Frame> all = frames();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Sh<N, double> f = random_sh<N, double>(random);
    const double sign = i % 3 == 0 ? -1 : 1;
    const Rotation<N, double> a = rotation_of<N, double>(all[i], sign),
                              b = rotation_of<N, double>(all[all.size() - 1 - i]);
    inverse.meet(distance(rotate(rotate(f, a), a.inverse()), f), i);
    product.meet(distance(rotate(f, a * b), rotate(rotate(f, b), a)), i);
    const Rotation<N, float> single = rotation_of<N, float>(all[i], sign);
    const Sh<N, float> g(f);
    inverse_float.meet(distance(rotate(rotate(g, single), single.inverse()), g), i);
  }
  CAPTURE(inverse.number, product.number, inverse_float.number);
  CHECK(inverse.error <= 1e-13);
  CHECK(product.error <= 1e-13);
  CHECK(inverse_float.error <= 4e-6);

  Rotation<N, float> thousandth = Rotation<N, float>::from_axis_angle(Vector{0.48, 0.6, 0.64}, float(2 * pi / 1000)),
                     all_of;
  for (int i = 0; i < 1000; ++i) all_of = thousandth * all_of;
  const Sh<N, float> f = random_sh<N, float>(random);
  CHECK(distance(rotate(f, all_of), f) <= 1e-3);  // and still of its length
  CHECK(distance(rotate(rotate(f, all_of), all_of.inverse()), f) <= 4e-6);
}

TEST_CASE("Every way to a rotation is the same rotation, and turns the way it says") {
  constexpr int N = 6;
  std::mt19937 random(34);
  const auto x = zonal::evaluate<N>(Vector{1, 0, 0}), y = zonal::evaluate<N>(Vector{0, 1, 0}),
             z = zonal::evaluate<N>(Vector{0, 0, 1});
  const auto quarter = [](const Vector& axis) { return Rotation<N, double>::from_axis_angle(axis, pi / 2); };
  CHECK(distance(rotate(x, quarter({0, 0, 1})), y) <= 1e-14);
  CHECK(distance(rotate(y, quarter({1, 0, 0})), z) <= 1e-14);
  CHECK(distance(rotate(z, quarter({0, 1, 0})), x) <= 1e-14);
  CHECK(distance(rotate_about_z(x, 0.0, 1.0), y) <= 1e-14);

  for (int i = 0; i < 100; ++i) {
    std::uniform_real_distribution<double> uniform(-pi, pi);
    const double a = uniform(random), b = std::abs(uniform(random)), c = uniform(random);
    const Frame frame = frame_of(a, b, c);
    const Sh<N, double> f = random_sh<N, double>(random), expected = rotate(f, rotation_of<N, double>(frame));
    CAPTURE(a, b, c);
    CHECK(distance(rotate(f, Rotation<N, double>::from_zyz(a, b, c)), expected) <= 1e-14);
    const double w = std::cos(b / 2) * std::cos((a + c) / 2), qz = std::cos(b / 2) * std::sin((a + c) / 2),
                 qx = -std::sin(b / 2) * std::sin((a - c) / 2), qy = std::sin(b / 2) * std::cos((a - c) / 2);
    CHECK(distance(rotate(f, Rotation<N, double>::from_quaternion(3 * w, 3 * qx, 3 * qy, 3 * qz)), expected) <= 1e-14);
    const double angle = 2 * std::acos(std::abs(w)), scale = (w < 0 ? -1 : 1) / std::sqrt(qx * qx + qy * qy + qz * qz);
    const Vector axis{qx * scale, qy * scale, qz * scale};
    CHECK(distance(rotate(f, Rotation<N, double>::from_axis_angle(axis, angle)), expected) <= 1e-13);
    const glm::dmat3 matrix(frame.axes[0][0], frame.axes[0][1], frame.axes[0][2], frame.axes[1][0], frame.axes[1][1],
                            frame.axes[1][2], frame.axes[2][0], frame.axes[2][1], frame.axes[2][2]);
    const glm::dmat3 large = 1e3 * matrix;
    CHECK(distance(rotate(f, Rotation<N, double>::from_axes(large[0], large[1], large[2])), expected) <= 1e-14);
    const glm::dvec3 turned = matrix * glm::dvec3(0, 0, 1);
    CHECK(distance(rotate(z, rotation_of<N, double>(frame)), zonal::evaluate<N>(turned)) <= 1e-14);
    CHECK(distance(rotate(f, zonal::TurnAboutZ<N, double>(std::cos(a), std::sin(a))),
                   rotate(f, Rotation<N, double>::from_zyz(0, 0, a))) <= 1e-14);
  }
}

TEST_CASE("A mirror image by the plane y = 0 changes the sign of what is odd in y") {
  constexpr int N = 6;
  std::mt19937 random(35);
  const Sh<N, float> f = random_sh<N, float>(random);
  const auto mirror = Rotation<N, float>::from_axes(Vector{1, 0, 0}, Vector{0, -1, 0}, Vector{0, 0, 1});
  const Sh<N, float> mirrored = rotate(f, mirror);
  CHECK(mirror.parity() < 0);
  for (int l = 0; l < N; ++l) {
    for (int m = -l; m <= l; ++m) CHECK(std::abs(mirrored(l, m) - (m < 0 ? -f(l, m) : f(l, m))) <= 2e-6F);
  }
}

TEST_CASE("orient is the rotation of a zonal function") {
  constexpr int N = 8;
  std::mt19937 random(36);
  zonal::Zh<N, double> lobe;
  Sh<N, double> upright{};
  for (int l = 0; l < N; ++l) upright(l, 0) = lobe[l] = std::uniform_real_distribution<double>(-1, 1)(random);
  for (const Frame& frame : frames()) {
    CHECK(distance(rotate(upright, rotation_of<N, double>(frame)), orient(lobe, frame.axes[2])) <= 2e-14);
  }
}

TEMPLATE_TEST_CASE("Colours are rotated channel by channel", "", glm::vec3, glm::dvec3, Eigen::Vector3f,
                   zonal::Rgb<float>, zonal::Rgb<double>) {
  constexpr int N = 5;
  using Number = zonal::component_t<TestType>;
  std::mt19937 random(37);
  const Rotation<N, Number> rotation = Rotation<N, Number>::from_zyz(Number(0.3), Number(2.1), Number(-1.2));
  const Rotation<N, Number> all[] = {rotation, rotation_of<N, Number>(frame_of(1, 2, 3), -1)};
  std::vector<Sh<N, TestType>> f(1);  // of its own memory: what reads beyond it is seen by the sanitizer
  Sh<N, Number> channels[3];
  for (int c = 0; c < 3; ++c) {
    channels[c] = random_sh<N, Number>(random);
    for (int i = 0; i < N * N; ++i) f[0][i][c] = channels[c][i];
  }
  for (const auto& r : all) {
    const Sh<N, TestType> rotated = rotate(f[0], r);
    for (int c = 0; c < 3; ++c) {
      const Sh<N, Number> expected = rotate(channels[c], r);
      Sh<N, Number> channel;
      for (int i = 0; i < N * N; ++i) channel[i] = rotated[i][c];
      CHECK(distance(channel, expected) <= 4 * double(std::numeric_limits<Number>::epsilon()));
    }
  }
}

TEST_CASE("The derivative of a rotation") {
  constexpr int N = 10;
  std::mt19937 random(38);
  const Sh<N, double> f = random_sh<N, double>(random);
  const zonal::RotationDerivative<N, double> derivative = rotation_derivative(f);
  const Sh<N, double> by_axis[] = {derivative.x, derivative.y, derivative.z};
  constexpr double step = 1e-4;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vector v{};
    v[axis] = 1;
    const auto at = [&](double angle) { return rotate(f, Rotation<N, double>::from_axis_angle(v, angle)); };
    // Of sixth order; degree 9 changes by up to 9 a radian.
    const Sh<N, double> difference =
        (45.0 * (at(step) - at(-step)) - 9.0 * (at(2 * step) - at(-2 * step)) + (at(3 * step) - at(-3 * step))) /
        (60 * step);
    CAPTURE(axis);
    CHECK(distance(by_axis[axis], difference) <= 1e-10);
  }
  // [L_x, L_y] = L_z
  const Sh<N, double> commutator = rotation_derivative(derivative.y).x - rotation_derivative(derivative.x).y;
  Met met("transform", "rotation_derivative");
  met.meet(distance(commutator, derivative.z));
  CHECK_WORST_MET(met);
}

TEST_CASE("What is no number, or nothing, gives no numbers") {
  const Sh<3, float> f{{1, 2, 3, 4, 5, 6, 7, 8, 9}};
  const auto check = [&](const Rotation<3, float>& rotation) {
    const Sh<3, float> rotated = rotate(f, rotation);
    for (int i = 1; i < 9; ++i) CHECK(std::isnan(rotated[i]));
  };
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (int place = 0; place < 9; ++place) {
      Frame frame = frame_of(0.3, 1.1, -0.7);
      frame.axes[place / 3][place % 3] = wrong;
      CAPTURE(place, wrong);
      check(rotation_of<3, float>(frame));
    }
  }
  for (const auto& nothing : {rotation_of<3, float>(Frame{}), Rotation<3, float>::from_quaternion(0, 0, 0, 0)}) {
    const Sh<3, float> rotated = rotate(f, nothing);  // in every degree
    CHECK(std::isnan(rotated[1] + rotated[2] + rotated[3]));
    CHECK(std::isnan(rotated[4] + rotated[5] + rotated[6] + rotated[7] + rotated[8]));
  }
}

namespace {

template <int N, class T>
void check_dense(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return T(normal(random)); };
  auto rotation = Rotation<N, T>::from_quaternion(draw(), draw(), draw(), draw());
  if (seed % 2 == 1) {  // and a reflection
    using Axis = std::array<T, 3>;
    rotation = rotation * Rotation<N, T>::from_axes(Axis{-1, 0, 0}, Axis{0, 1, 0}, Axis{0, 0, 1});
  }
  const zonal::DenseRotation<N, T> dense(rotation);
  for (int round = 0; round < 20; ++round) {
    Sh<N, T> f;
    T norm = 0;
    for (T& value : f) value = draw(), norm += value * value;
    const Sh<N, T> expected = zonal::rotate(f, rotation), given = dense(f);
    const T bound = T(4 * N) * std::numeric_limits<T>::epsilon() * std::sqrt(norm);
    for (int i = 0; i < N * N; ++i) {
      CAPTURE(N, sizeof(T), seed, round, i, given[i], expected[i]);
      REQUIRE(std::abs(given[i] - expected[i]) <= bound);
    }
  }
}

}  // namespace

TEST_CASE("a rotation as a matrix is the rotation") {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    check_dense<2, float>(seed), check_dense<3, float>(seed), check_dense<5, float>(seed), check_dense<10, float>(seed);
    check_dense<2, double>(seed), check_dense<4, double>(seed), check_dense<9, double>(seed);
  }
  const zonal::DenseRotation<1, float> nothing(Rotation<2, float>::from_quaternion(1, 2, 3, 4));
  REQUIRE(nothing(Sh<1, float>{{3}})[0] == 3);
}
