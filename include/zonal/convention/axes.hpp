// Axes and frames: which way x, y and z go. A y that is up in one engine is z in another, and one of the axes may point
// the other way, which makes a right-handed frame left-handed.
#pragma once

#include <string>

#include "../basis/sh.hpp"
#include "../scalar/refuse.hpp"
#include "../transform/rotate.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

enum class Axis : signed char { x = 1, y = 2, z = 3, minus_x = -1, minus_y = -2, minus_z = -3 };

constexpr Axis operator-(Axis axis) { return static_cast<Axis>(-static_cast<int>(axis)); }

/// Three axes in the coordinates in which directions are given.
struct Axes {
  Axis x = Axis::x, y = Axis::y, z = Axis::z;
  friend constexpr bool operator==(const Axes& a, const Axes& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
  friend constexpr bool operator!=(const Axes& a, const Axes& b) { return !(a == b); }
};

/// What is to the right, up and ahead in a system's coordinates.
struct Frame {
  Axis right, up, forward;
};

namespace detail {

// The coordinate (0 to 2) along which an axis runs, and its sign.
constexpr int coordinate(Axis axis) {
  const int number = static_cast<int>(axis);
  return (number < 0 ? -number : number) - 1;
}
constexpr int sign(Axis axis) { return static_cast<int>(axis) < 0 ? -1 : 1; }

// "x", "-y", ...
inline std::string axis_name(Axis axis) { return std::string(sign(axis) < 0 ? "-" : "") + "xyz"[coordinate(axis)]; }

constexpr bool is_one(Axis axis) { return static_cast<int>(axis) != 0 && coordinate(axis) < 3; }
constexpr bool are_three(Axis a, Axis b, Axis c) {
  return is_one(a) && is_one(b) && is_one(c) && coordinate(a) != coordinate(b) && coordinate(b) != coordinate(c) &&
         coordinate(c) != coordinate(a);
}
inline void check_axes(Axis a, Axis b, Axis c) {
  if (!are_three(a, b, c)) refuse("axes that are not along three coordinates");
}

template <class T>
struct AxisVector {
  T v[3] = {T(0), T(0), T(0)};
  constexpr explicit AxisVector(Axis axis) { v[coordinate(axis)] = T(sign(axis)); }
  constexpr const T& operator[](int i) const { return v[i]; }
};

/// The function turned (or mirrored) so that the coordinate axes go where `to` says.
template <int N, class T>
Sh<N, T> with_axes_at(const Sh<N, T>& sh, const Axes& to) {
  using Number = number_t<T>;
  if (to == Axes{}) return sh;
  return rotate(
      sh, Rotation<N, Number>::from_axes(AxisVector<Number>(to.x), AxisVector<Number>(to.y), AxisVector<Number>(to.z)));
}

// The axis that `map` takes this one to, `map` saying where x, y and z go; and the map backwards.
constexpr Axis mapped(const Axes& map, Axis axis) {
  const Axis to = coordinate(axis) == 0 ? map.x : coordinate(axis) == 1 ? map.y : map.z;
  return sign(axis) < 0 ? -to : to;
}
constexpr Axes inverse(const Axes& map) {
  Axis back[3] = {};
  const Axis to[3] = {map.x, map.y, map.z}, from[3] = {Axis::x, Axis::y, Axis::z};
  for (int i = 0; i < 3; ++i) back[coordinate(to[i])] = sign(to[i]) < 0 ? -from[i] : from[i];
  return {back[0], back[1], back[2]};
}
}  // namespace detail

constexpr bool is_right_handed(const Frame& frame) {
  // Even permutations of (right, up, backward) keep the hand, and so do two signs.
  const int a = detail::coordinate(frame.right), b = detail::coordinate(frame.up);
  const int permutation = (b - a + 3) % 3 == 1 ? 1 : -1;
  return permutation * detail::sign(frame.right) * detail::sign(frame.up) * -detail::sign(frame.forward) > 0;
}

/// Where the axes x, y and z of one frame are in the coordinates of another.
inline Axes axes_between(const Frame& from, const Frame& to) {
  detail::check_axes(from.right, from.up, from.forward);
  detail::check_axes(to.right, to.up, to.forward);
  const Axes of_from = detail::inverse({from.right, from.up, from.forward});  // coordinates to right, up, forward
  const Axes of_to{to.right, to.up, to.forward};
  return {detail::mapped(of_to, of_from.x), detail::mapped(of_to, of_from.y), detail::mapped(of_to, of_from.z)};
}

/// The same light in another system's coordinates: what came from above in `from` comes from above in `to`.
/// Coefficients are in this library's convention before and after; T is a number or a colour. From one hand to the
/// other it mirrors. Rounding: that of rotate().
template <int N, class T>
Sh<N, T> change_frame(const Sh<N, T>& sh, const Frame& from, const Frame& to) {
  return detail::with_axes_at(sh, axes_between(from, to));
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
