// Coefficients: Sh (all of a band-limited function), EvenSh (even in phi), Zh (symmetric about the axis).
#pragma once

#include <cassert>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "../scalar/colour.hpp"
#include "../scalar/unroll.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

// Where the coefficient of degree l (0 <= l) and order m (-l <= m <= l) stands.
constexpr int sh_index(int l, int m) { return l * (l + 1) + m; }
// The same when only m >= 0 is stored.
constexpr int even_index(int l, int m) { return l * (l + 1) / 2 + m; }
// Whether Y_l^m is the same above and below the plane z = 0.
constexpr bool is_even_in_z(int l, int m) { return (l + m) % 2 == 0; }

namespace detail {

template <class S, class = void>
inline constexpr bool is_coefficients_v = false;
template <class S>
inline constexpr bool is_coefficients_v<S, std::void_t<typename S::IsCoefficients>> = true;

// A factor for coefficients, which are no factors themselves.
template <class S, class R>
using IfFactor = std::enable_if_t<!is_coefficients_v<S>, R>;

// Up to so many numbers the loops of products and sums are written out. A product then needs no array in memory where
// it is added to another at once, nor do the basis values that it is made of: two to three times as fast as with a
// loop.
inline constexpr int longest_product = 128;

// What the three kinds of coefficient arrays, Kind<N, T>, share: storage, iteration, the arithmetic of a vector space.
// A factor is a number of any built-in type, which becomes one of T's first, another T, or whatever T can be multiplied
// by. Numbers times a colour are colours: Sh<N, float> * glm::vec3 is an Sh<N, glm::vec3>.
template <template <int, class> class Kind, int N, int Size, class T>
struct Coefficients {
  using IsCoefficients = void;
  using Derived = Kind<N, T>;
  template <class S>
  using Product = Kind<N, product_t<T, factor_t<T, S>>>;

  T values[static_cast<std::size_t>(Size)];

  static constexpr int bands = N;
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

  /// The same coefficients as another scalar or colour, each by static_cast: Sh<5, double>(sh).
  template <class U, class = decltype(static_cast<U>(std::declval<const T&>()))>
  ZONAL_DEVICE constexpr explicit operator Kind<N, U>() const {
    Kind<N, U> r{};
    for (int i = 0; i < Size; ++i) r.values[i] = static_cast<U>(values[i]);
    return r;
  }

  constexpr Derived& operator+=(const Derived& b) {
    return combine(b, [](const auto& x, const auto& y) ZONAL_INLINE { return x + y; });
  }
  constexpr Derived& operator-=(const Derived& b) {
    return combine(b, [](const auto& x, const auto& y) ZONAL_INLINE { return x - y; });
  }
  template <class S>
  constexpr Derived& operator*=(const S& s) {
    const auto factor = static_cast<factor_t<T, S>>(s);
    for_each<Size>([&](auto i) ZONAL_INLINE { set_product(values[i], values[i], factor); });
    return static_cast<Derived&>(*this);
  }
  template <class S>
  constexpr Derived& operator/=(const S& s) {
    const auto divisor = static_cast<factor_t<T, S>>(s);
    for (int i = 0; i < Size; ++i) values[i] = values[i] / divisor;
    return static_cast<Derived&>(*this);
  }

  friend constexpr Derived operator-(Derived a) {
    for (int i = 0; i < Size; ++i) a.values[i] = -a.values[i];
    return a;
  }
  friend constexpr Derived operator+(Derived a, const Derived& b) { return a += b; }
  friend constexpr Derived operator-(Derived a, const Derived& b) { return a -= b; }
  template <class S>
  friend ZONAL_INLINE constexpr IfFactor<S, Product<S>> operator*(const Derived& a, const S& s) {
    if constexpr (std::is_same_v<Product<S>, Derived>) {
      Derived r = a;
      return r *= s;
    } else {
      const auto factor = static_cast<factor_t<T, S>>(s);
      Product<S> r;
      for_each<Size>([&](auto i) ZONAL_INLINE { set_product(r.values[i], a.values[i], factor); });
      return r;
    }
  }
  template <class S>
  friend ZONAL_INLINE constexpr IfFactor<S, Product<S>> operator*(const S& s, const Derived& a) {
    return a * s;
  }
  template <class S>
  friend constexpr IfFactor<S, Derived> operator/(Derived a, const S& s) {
    return a /= s;
  }

  /// Whether all coefficients are equal, to the bit but for the sign of 0; a NaN equals nothing.
  friend constexpr bool operator==(const Derived& a, const Derived& b) {
    for (int i = 0; i < Size; ++i) {
      if (!are_equal(a.values[i], b.values[i])) return false;
    }
    return true;
  }
  friend constexpr bool operator!=(const Derived& a, const Derived& b) { return !(a == b); }

 private:
  static constexpr bool are_equal(const T& a, const T& b) {
    if constexpr (is_builtin_scalar_v<T>) {
      return is_equal(a, b);
    } else {
      return a == b;
    }
  }
  // body(i) for all i below Count, written out if they are few.
  template <int Count, class F>
  ZONAL_INLINE static constexpr void for_each(F&& body) {
    if constexpr (Count <= longest_product) {
      unroll<0, Count>(body);
    } else {
      for (int i = 0; i < Count; ++i) body(i);
    }
  }
  // Each of its values is f of it and of b's; of vectors, each number.
  template <class F>
  ZONAL_INLINE constexpr Derived& combine(const Derived& b, F f) {
    constexpr int length = plain_length_v<T>;
    if constexpr (length != 0) {
      auto* to = numbers_of(values);
      const auto* from = numbers_of(b.values);
      for_each<Size * length>([&](auto i) ZONAL_INLINE { to[i] = f(to[i], from[i]); });
    } else {
      for_each<Size>([&](auto i) ZONAL_INLINE { values[i] = f(values[i], b.values[i]); });
    }
    return static_cast<Derived&>(*this);
  }
};
}  // namespace detail

/// N bands (degrees 0 to N-1), N*N coefficients in the order l(l+1)+m: sh[i], sh(l, m) (both asserted in debug builds)
/// or get<l, m>(sh). T is any scalar, or a colour: anything with + and *, such as glm::vec3 or Eigen::Vector3f. Sh{}
/// holds what T{} is: zeros for built-in scalars and GLM, nothing in particular for Eigen. Trivially copyable when T
/// is. Sums, multiples, == and the explicit conversion to another T, here and of EvenSh and Zh: detail::Coefficients.
template <int N, class T>
struct Sh : detail::Coefficients<Sh, N, N * N, T> {
  static_assert(N >= 1, "an Sh has at least one band");
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
struct EvenSh : detail::Coefficients<EvenSh, N, N*(N + 1) / 2, T> {
  static_assert(N >= 1, "an EvenSh has at least one band");
  static constexpr int index(int l, int m) {
    assert(0 <= l && l < N && 0 <= m && m <= l);
    return even_index(l, m);
  }
  constexpr T& operator()(int l, int m) { return this->values[index(l, m)]; }
  constexpr const T& operator()(int l, int m) const { return this->values[index(l, m)]; }
};

/// Zonal coefficients z_l = integral of f Y_l^0, of a function of the angle to the z axis alone.
template <int N, class T>
struct Zh : detail::Coefficients<Zh, N, N, T> {
  static_assert(N >= 1, "a Zh has at least one band");
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

namespace detail {
template <int M, template <int, class> class Kind, int N, class T>
constexpr Kind<M, T> with_bands(const Kind<N, T>& a, const T& black) {
  Kind<M, T> r{};
  for (int i = 0; i < r.size(); ++i) r.values[i] = i < a.size() ? a.values[i] : black;
  return r;
}
}  // namespace detail

/// The first M bands: those beyond are left out, those that are missing are zeros. Of a colour that is neither a GLM
/// nor an Eigen vector zero is what T{} is, or `black`.
template <int M, int N, class T>
constexpr Sh<M, T> with_bands(const Sh<N, T>& sh, const T& black = detail::zero<T>(0)) {
  return detail::with_bands<M>(sh, black);
}
template <int M, int N, class T>
constexpr EvenSh<M, T> with_bands(const EvenSh<N, T>& sh, const T& black = detail::zero<T>(0)) {
  return detail::with_bands<M>(sh, black);
}
template <int M, int N, class T>
constexpr Zh<M, T> with_bands(const Zh<N, T>& zh, const T& black = detail::zero<T>(0)) {
  return detail::with_bands<M>(zh, black);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
