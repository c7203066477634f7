// A colour, for those who have no other: three numbers that can be added and multiplied.
#pragma once

#include "../scalar/colour.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Red, green and blue; c[0], c[1], c[2]. Coefficients may be of it, as of glm::vec3.
template <class T>
struct Rgb {
  using value_type = T;
  T r, g, b;

  static constexpr int length() { return 3; }
  constexpr T& operator[](int i) { return i == 0 ? r : i == 1 ? g : b; }
  constexpr const T& operator[](int i) const { return i == 0 ? r : i == 1 ? g : b; }

  template <class U>
  constexpr explicit operator Rgb<U>() const {
    return {static_cast<U>(r), static_cast<U>(g), static_cast<U>(b)};
  }
  friend constexpr Rgb operator-(const Rgb& x) { return {-x.r, -x.g, -x.b}; }
  friend constexpr Rgb operator+(const Rgb& x, const Rgb& y) { return {x.r + y.r, x.g + y.g, x.b + y.b}; }
  friend constexpr Rgb operator-(const Rgb& x, const Rgb& y) { return {x.r - y.r, x.g - y.g, x.b - y.b}; }
  friend constexpr Rgb operator*(const Rgb& x, const Rgb& y) { return {x.r * y.r, x.g * y.g, x.b * y.b}; }
  friend constexpr Rgb operator*(const Rgb& x, T s) { return {x.r * s, x.g * s, x.b * s}; }
  friend constexpr Rgb operator*(T s, const Rgb& x) { return x * s; }
  friend constexpr Rgb operator/(const Rgb& x, T s) { return {x.r / s, x.g / s, x.b / s}; }
  constexpr Rgb& operator+=(const Rgb& x) { return *this = *this + x; }
  friend constexpr bool operator==(const Rgb& x, const Rgb& y) {
    return detail::is_equal(x.r, y.r) && detail::is_equal(x.g, y.g) && detail::is_equal(x.b, y.b);
  }
  friend constexpr bool operator!=(const Rgb& x, const Rgb& y) { return !(x == y); }
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
