// A narrow number with a wide companion that walks beside it: the rounding error of a kernel, measured.
#pragma once

#include "scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Decisions follow the narrow value, so both take the same path; constants are rounded once for each.
template <class Narrow = float, class Wide = double>
struct Shadow {
  Narrow value;
  Wide wide;

  Shadow() = default;
  template <class C, class = std::enable_if_t<std::is_arithmetic_v<C>>>
  explicit Shadow(C constant) : value(static_cast<Narrow>(constant)), wide(static_cast<Wide>(constant)) {}
  Shadow(Narrow narrow, Wide exact) : value(narrow), wide(exact) {}

  /// An input: the companion starts at the value that the kernel is really given.
  static Shadow input(Narrow narrow) { return {narrow, static_cast<Wide>(narrow)}; }

  /// How far rounding has carried the narrow value from the wide one.
  Wide error() const { return static_cast<Wide>(value) - wide; }

  Shadow operator-() const { return {-value, -wide}; }
  friend Shadow operator+(const Shadow& a, const Shadow& b) { return {a.value + b.value, a.wide + b.wide}; }
  friend Shadow operator-(const Shadow& a, const Shadow& b) { return {a.value - b.value, a.wide - b.wide}; }
  friend Shadow operator*(const Shadow& a, const Shadow& b) { return {a.value * b.value, a.wide * b.wide}; }
  friend Shadow operator/(const Shadow& a, const Shadow& b) { return {a.value / b.value, a.wide / b.wide}; }

  friend bool operator<(const Shadow& a, const Shadow& b) { return a.value < b.value; }
  friend bool operator<=(const Shadow& a, const Shadow& b) { return a.value <= b.value; }
  friend bool operator>(const Shadow& a, const Shadow& b) { return a.value > b.value; }
  friend bool operator>=(const Shadow& a, const Shadow& b) { return a.value >= b.value; }

  friend Shadow select(bool mask, const Shadow& a, const Shadow& b) { return mask ? a : b; }
  friend Shadow minimum(const Shadow& a, const Shadow& b) { return b < a ? b : a; }
  friend Shadow maximum(const Shadow& a, const Shadow& b) { return a < b ? b : a; }
  friend Shadow abs(const Shadow& a) { return a.value < Narrow(0) ? -a : a; }
  friend Shadow sqrt(const Shadow& a) { return {sqrt(a.value), sqrt(a.wide)}; }
};

template <class Narrow, class Wide>
struct ScalarTraits<Shadow<Narrow, Wide>> {
  using Lane = Narrow;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
