// Pictures in a disc: a mirror ball, and the angular map.
//
// [1] Debevec, Rendering synthetic objects into real scenes, SIGGRAPH 1998, and his Light Probe Image Gallery.
#pragma once

#include <array>
#include <cmath>

#include "../scalar/constexpr_math.hpp"
#include "../scalar/vector3.hpp"
#include "solid_angle.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// A disc of radius `reach` in the square picture, whose half side is 1: p to the right, q up. A texel belongs to it
// whose middle does, and nothing else does: what stands in the others is no part of the disc, or a mixture with what is
// none.
struct Disc {
  int size;
  double reach;

  // The picture's coordinates of a place.
  std::array<double, 2> texel(double p, double q) const {
    return {within(0.5 * size * (1 + p), 0, size), within(0.5 * size * (1 - q), 0, size)};
  }
  double right(double column) const { return (2 * column - size) / size; }
  double up(double row) const { return (size - 2 * row) / size; }
  // The square of a texel's distance from the middle. By whole numbers: the same for texels that are mirror images.
  double distance2(int column, int row) const {
    const double p = 2.0 * column + 1 - size, q = 2.0 * row + 1 - size;
    return (p * p + q * q) / (double(size) * size);
  }
  bool has(int column, int row) const { return distance2(column, row) < reach * reach; }

  // Texels of each row that it has, from the row's middle to the right: visit(row, first column, last column + 1), for
  // the upper half of the rows and a middle one.
  template <class Visit>
  void half_rows(const Visit& visit) const {
    int end = size / 2;
    for (int row = 0; row < (size + 1) / 2; ++row) {
      while (end < size && has(end, row)) ++end;
      visit(row, size / 2, end);
    }
  }
};

// 1 / ((2k + first)(2k + first - 1)), times -pi^2: from a term of the series below to the next.
template <int first>
struct PiSeriesSteps {
  static constexpr int count = 15;
  double step[count + 1] = {};
  constexpr PiSeriesSteps() {
    for (int k = 1; k <= count; ++k) {
      step[k] = static_cast<double>(-kPi * kPi / ((2 * k + first) * (2 * k + first - 1)));
    }
  }
};

// sum of (-pi^2 x)^k / (2k + first)!, to 3e-16 for 0 <= x <= 1.1: with `first` 0 cos(pi r), with 1 sin(pi r)/(pi r), at
// x = r^2.
template <int first, class T>
T pi_series(const T& x) {
  constexpr PiSeriesSteps<first> steps;
  T sum = T(1);
  for (int k = steps.count; k >= 1; --k) sum = T(1) + T(steps.step[k]) * x * sum;
  return sum;
}

}  // namespace detail

/// A ball that mirrors, seen from afar (orthographic) by an eye that looks forward, +x: the picture's upper edge is up,
/// +z, its left edge left, +y. The middle of the ball shows what is behind the eye, its rim what is behind the ball,
/// straight ahead. Of that a real picture shows nothing: it may be told to leave out all within `dead_angle` (radians,
/// 0 to pi) of forward. Square; the ball touches its edges. Texels beside the ball have no direction. All that are on
/// it have the same solid angle, for the reflected angle is twice the normal's [1]. What all mappings have:
/// mapping.hpp.
struct MirrorSphere {
  static constexpr const char* name = "mirror sphere";
  int size;
  double dead_angle;

  MirrorSphere(int width, int, double angle = 0)
      : size(width), dead_angle(angle), disc_{width, std::cos(angle / 2)}, texel_solid_angle_(0) {
    double count = 0;
    disc_.half_rows([&](int row, int first, int end) {  // four mirror images, but where the middle cuts a texel
      const double columns = end - first;
      const double whole = size % 2 == 0 ? 2 * columns : columns > 0 ? 2 * columns - 1 : 0;
      count += 2 * row + 1 == size ? whole : 2 * whole;
    });
    if (count > 0) texel_solid_angle_ = covered() / count;
  }
  static constexpr const char* what_is_wrong(int width, int height) {
    return width == height ? "" : "it is not square";
  }
  double covered() const {
    const double half_sine = std::sin((double(kPi) - dead_angle) / 2);
    return double(4 * kPi) * half_sine * half_sine;
  }

  bool has_direction(int column, int row) const { return disc_.has(column, row); }

  std::array<double, 3> direction(double column, double row) const {
    const double p = disc_.right(column), q = disc_.up(row), r2 = p * p + q * q;
    if (!(r2 <= 1)) return {0, 0, 0};
    const double depth = std::sqrt(1 - r2);  // the normal is (-depth, -p, q); the ray to be mirrored (1, 0, 0)
    return {2 * r2 - 1, -2 * depth * p, 2 * depth * q};
  }

  template <class V>
  std::array<double, 2> texel(const V& v) const {
    const auto d = detail::as_direction<double>(v);
    const double backward = 1 - d.x, length = std::sqrt(backward * backward + d.y * d.y + d.z * d.z);
    return length > 0 ? disc_.texel(-d.y / length, d.z / length) : disc_.texel(0, 1);
  }

  double solid_angle(int column, int row) const { return has_direction(column, row) ? texel_solid_angle_ : 0.0; }

 private:
  detail::Disc disc_;
  double texel_solid_angle_;
};

/// The angle from forward, +x, grows evenly with the distance from the middle of the picture, up to pi, backward, at
/// the rim of the disc [1]; the picture's upper edge is up, +z, its left edge left, +y. Square; texels beside the disc
/// have no direction. What all mappings have: mapping.hpp.
struct AngularMap {
  static constexpr const char* name = "angular map";
  int size;

  AngularMap(int width, int) : size(width), disc_{width, 1}, scale_(1) {
    // Together the disc's texels have covered(): they reach a little over its rim, or leave a little of it out. Their
    // sum is a flux through the edges that they do not share: the density is the divergence of (1 - cos pi r) / r^2 (p,
    // q).
    double flux = 0;
    int above = size / 2;
    const double columns = size % 2 == 0 ? 1 : 0.5;  // of which half is to the right of the middle
    disc_.half_rows([&](int row, int first, int end) {
      const double rows = 2 * row + 1 == size ? 1 : 2;  // mirror images
      if (end > first) flux += 2 * rows * edge_flux(row, end);
      for (int column = above; column < end; ++column) {
        flux += 2 * 2 * (column == first ? columns : 1) * edge_flux(column, size - row);
      }
      above = end;
    });
    if (flux > 0) scale_ = covered() / flux;
  }
  static constexpr const char* what_is_wrong(int width, int height) {
    return width == height ? "" : "it is not square";
  }
  static constexpr double covered() { return double(4 * kPi); }

  bool has_direction(int column, int row) const { return disc_.has(column, row); }

  std::array<double, 3> direction(double column, double row) const {
    const double p = disc_.right(column), q = disc_.up(row), r2 = p * p + q * q;
    if (!(r2 <= 1)) return {0, 0, 0};
    std::array<double, 3> d;
    set_direction(p, q, d[0], d[1], d[2]);
    return d;
  }

  template <class V>
  std::array<double, 2> texel(const V& v) const {
    const auto d = detail::as_direction<double>(v);
    const double sine = std::hypot(d.y, d.z), r = std::atan2(sine, d.x) / double(kPi);
    return sine > 0 ? disc_.texel(-r * d.y / sine, r * d.z / sine) : disc_.texel(0, r);
  }

  /// The integral of pi sin(pi r) / r, which is analytic, by a Gauss-Legendre rule as long as it has to be (to 1e-14 of
  /// it); at the rim over the whole texel. Times what makes their sum 4 pi: 1 + O(1 / size^2).
  double solid_angle(int column, int row) const {
    return has_direction(column, row) ? density_integral(double(column), row) : 0.0;
  }

  /// Direction and solid angle of texels on the disc, in any scalar: lanes of texels of a row.
  template <class T>
  void direction_and_solid_angle(const T& column, int row, T (&direction)[3], T& solid_angle) const {
    const T p = (T(2) * column + T(1 - size)) * T(1.0 / size);
    set_direction(p, T(disc_.up(row + 0.5)), direction[0], direction[1], direction[2]);
    solid_angle = density_integral(column, row);
  }

 private:
  template <class T>
  static void set_direction(const T& p, const T& q, T& x, T& y, T& z) {
    const T r2 = p * p + q * q, sine = T(double(kPi)) * detail::pi_series<1>(r2);  // over r
    x = detail::pi_series<0>(r2);
    y = -sine * p;
    z = sine * q;
  }
  template <class T>
  T density_integral(const T& column, int row) const {
    T sum = T(0);
    for_nodes([&](double x, double x_weight) {
      const T p = (T(2) * (column + T(x)) - T(size)) * T(1.0 / size), p2 = p * p;
      for_nodes([&](double y, double y_weight) {
        const double q = disc_.up(row + y);
        sum = sum + T(x_weight * y_weight) * detail::pi_series<1>(p2 + T(q * q));
      });
    });
    const double side = 2.0 / size;
    return T(scale_ * double(kPi * kPi) * side * side) * sum;
  }
  // Gauss-Legendre on [0, 1]: visit(place, weight). The fewer the larger the picture.
  template <class Visit>
  void for_nodes(const Visit& visit) const {
    struct Node {
      double place, weight;  // the positive half of those of [-1, 1]
    };
    static constexpr Node three[] = {{0, 0.88888888888888888889}, {0.77459666924148337704, 0.55555555555555555556}};
    static constexpr Node eight[] = {{0.18343464249564980494, 0.36268378337836198297},
                                     {0.52553240991632898582, 0.31370664587788728734},
                                     {0.79666647741362673959, 0.22238103445337447054},
                                     {0.96028985649753623168, 0.10122853629037625915}};
    const bool is_large = size > 192;
    const Node *node = is_large ? three : eight, *end = is_large ? three + 2 : eight + 4;
    const int parts = size < 4 ? 4 : 1;
    for (int part = 0; part < parts; ++part) {
      for (const Node* n = node; n != end; ++n) {
        visit((part + 0.5 + 0.5 * n->place) / parts, 0.5 * n->weight / parts);
        if (n->place > 0) visit((part + 0.5 - 0.5 * n->place) / parts, 0.5 * n->weight / parts);
      }
    }
  }
  // Outwards through the edge from texel corner to corner along `from`, at the distance of the corner `at` from the
  // middle.
  double edge_flux(int from, int at) const {
    const double distance = disc_.right(at);
    double sum = 0;
    for_nodes([&](double x, double weight) {
      const double along = disc_.right(from + x), r2 = distance * distance + along * along;
      sum += weight * distance * edge_density(r2);
    });
    return 2.0 / size * sum;
  }
  // (1 - cos pi r) / r^2 = (pi^2 / 2) (sin(pi r / 2) / (pi r / 2))^2.
  static double edge_density(double r2) {
    const double sinc = detail::pi_series<1>(r2 / 4);
    return double(kPi * kPi) / 2 * sinc * sinc;
  }

  detail::Disc disc_;
  double scale_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
