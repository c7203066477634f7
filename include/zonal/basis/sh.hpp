// Coefficients: Sh (all of a band-limited function), EvenSh (even in phi), Zh (symmetric about the axis).
#pragma once

#include <cassert>
#include <cstddef>

#include "../scalar/target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

// Where the coefficient of degree l (0 <= l) and order m (-l <= m <= l) stands.
constexpr int sh_index(int l, int m) { return l * (l + 1) + m; }
// The same when only m >= 0 is stored.
constexpr int even_index(int l, int m) { return l * (l + 1) / 2 + m; }
// Whether Y_l^m is the same above and below the plane z = 0.
constexpr bool is_even_in_z(int l, int m) { return (l + m) % 2 == 0; }

namespace detail {
// What the three kinds of coefficient arrays share: storage, iteration and the arithmetic of a vector space.
template <class Derived, int Size, class T>
struct Coefficients {
  T values[static_cast<std::size_t>(Size)];

  static constexpr int size() { return Size; }
  constexpr T& operator[](int i) {
    assert(0 <= i && i < Size);
    return values[i];
  }
  constexpr const T& operator[](int i) const {
    assert(0 <= i && i < Size);
    return values[i];
  }
  constexpr T* begin() { return values; }
  constexpr T* end() { return values + Size; }
  constexpr const T* begin() const { return values; }
  constexpr const T* end() const { return values + Size; }

  constexpr Derived& operator+=(const Derived& b) {
    for (int i = 0; i < Size; ++i) values[i] = values[i] + b.values[i];
    return static_cast<Derived&>(*this);
  }
  template <class S>
  constexpr Derived& operator*=(const S& s) {
    for (int i = 0; i < Size; ++i) values[i] = values[i] * s;
    return static_cast<Derived&>(*this);
  }
  friend constexpr Derived operator+(Derived a, const Derived& b) { return a += b; }
  friend constexpr Derived operator-(Derived a, const Derived& b) {
    for (int i = 0; i < Size; ++i) a.values[i] = a.values[i] - b.values[i];
    return a;
  }
  template <class S>
  friend constexpr Derived operator*(Derived a, const S& s) {
    return a *= s;
  }
};
}  // namespace detail

/// N bands (degrees 0 to N-1), N*N coefficients in the order l(l+1)+m: sh[i], sh(l, m) (both asserted in debug builds)
/// or get<l, m>(sh). T is any scalar, or a colour: anything with + and *, such as glm::vec3 or Eigen::Vector3f. Sh{} holds
/// what T{} is: zeros for built-in scalars and GLM, nothing in particular for Eigen. Trivially copyable when T is.
template <int N, class T>
struct Sh : detail::Coefficients<Sh<N, T>, N * N, T> {
  static_assert(N >= 1, "an Sh has at least one band");
  static constexpr int bands = N;
  static constexpr int index(int l, int m) {
    assert(0 <= l && l < N && -l <= m && m <= l);
    return sh_index(l, m);
  }
  constexpr T& operator()(int l, int m) { return this->values[index(l, m)]; }
  constexpr const T& operator()(int l, int m) const { return this->values[index(l, m)]; }
};

/// The m >= 0 half, N(N+1)/2 coefficients in the order l(l+1)/2+m. It is all there is of a function that is
/// even in phi, such as an isotropic material in the frame where the outgoing direction has phi = 0.
template <int N, class T>
struct EvenSh : detail::Coefficients<EvenSh<N, T>, N*(N + 1) / 2, T> {
  static_assert(N >= 1, "an EvenSh has at least one band");
  static constexpr int bands = N;
  static constexpr int index(int l, int m) {
    assert(0 <= l && l < N && 0 <= m && m <= l);
    return even_index(l, m);
  }
  constexpr T& operator()(int l, int m) { return this->values[index(l, m)]; }
  constexpr const T& operator()(int l, int m) const { return this->values[index(l, m)]; }
};

/// Zonal coefficients z_l = integral of f Y_l^0, of a function of the angle to the z axis alone.
template <int N, class T>
struct Zh : detail::Coefficients<Zh<N, T>, N, T> {
  static_assert(N >= 1, "a Zh has at least one band");
  static constexpr int bands = N;
};

/// The coefficient of degree l and order m; a degree or order outside the bands does not compile.
template <int l, int m, int N, class T>
constexpr const T& get(const Sh<N, T>& sh) {
  static_assert(0 <= l && l < N, "degree out of range: 0 <= l < N");
  static_assert(-l <= m && m <= l, "order out of range: -l <= m <= l");
  return sh.values[sh_index(l, m)];
}
template <int l, int m, int N, class T>
constexpr const T& get(const EvenSh<N, T>& sh) {
  static_assert(0 <= l && l < N, "degree out of range: 0 <= l < N");
  static_assert(0 <= m && m <= l, "order out of range: 0 <= m <= l");
  return sh.values[even_index(l, m)];
}
template <int l, int N, class T>
constexpr const T& get(const Zh<N, T>& zh) {
  static_assert(0 <= l && l < N, "degree out of range: 0 <= l < N");
  return zh.values[l];
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
