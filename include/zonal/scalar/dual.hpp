// Numbers that carry their derivatives: forward automatic differentiation, to test the analytic gradients with.
#pragma once

#include <array>

#include "scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A value and K partial derivatives. Nest it, Dual<Dual<double, 3>, 3>, for second derivatives.
template <class T, int K>
struct Dual {
  T value;
  std::array<T, static_cast<std::size_t>(K)> partial;

  Dual() = default;
  template <class C, class = std::enable_if_t<std::is_arithmetic_v<C>>>
  explicit Dual(C constant) : value(T(constant)) {
    partial.fill(T(0));
  }
  Dual(const T& v, const std::array<T, static_cast<std::size_t>(K)>& d) : value(v), partial(d) {}

  /// The k-th independent variable.
  static Dual variable(const T& v, int k) {
    Dual r(0);
    r.value = v;
    r.partial[static_cast<std::size_t>(k)] = T(1);
    return r;
  }

  Dual operator-() const { return chain(*this, -value, T(-1)); }
  friend Dual operator+(const Dual& a, const Dual& b) { return chain(a, b, a.value + b.value, T(1), T(1)); }
  friend Dual operator-(const Dual& a, const Dual& b) { return chain(a, b, a.value - b.value, T(1), T(-1)); }
  friend Dual operator*(const Dual& a, const Dual& b) { return chain(a, b, a.value * b.value, b.value, a.value); }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const T quotient = a.value / b.value;
    return chain(a, b, quotient, T(1) / b.value, -quotient / b.value);
  }

  friend auto operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend auto operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend auto operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend auto operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }

  template <class Mask>
  friend Dual select(const Mask& mask, const Dual& a, const Dual& b) {
    Dual r(select(mask, a.value, b.value), a.partial);
    for (std::size_t k = 0; k < K; ++k) r.partial[k] = select(mask, a.partial[k], b.partial[k]);
    return r;
  }
  friend Dual minimum(const Dual& a, const Dual& b) { return select(b < a, b, a); }
  friend Dual maximum(const Dual& a, const Dual& b) { return select(a < b, b, a); }
  friend Dual abs(const Dual& a) { return select(a < Dual(0), -a, a); }
  friend Dual sqrt(const Dual& a) {
    const T root = sqrt(a.value);
    return chain(a, root, T(1) / (root + root));
  }

 private:
  // f(a) with df/da, and f(a, b) with both.
  static Dual chain(const Dual& a, const T& f, const T& df_da) {
    Dual r(f, a.partial);
    for (T& d : r.partial) d = df_da * d;
    return r;
  }
  static Dual chain(const Dual& a, const Dual& b, const T& f, const T& df_da, const T& df_db) {
    Dual r(f, a.partial);
    for (std::size_t k = 0; k < K; ++k) r.partial[k] = df_da * a.partial[k] + df_db * b.partial[k];
    return r;
  }
};

template <class T, int K>
struct ScalarTraits<Dual<T, K>> {
  using Lane = lane_t<T>;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
