// What a scalar type T must offer, and the same for the built-in floating-point types.
//
// Every kernel of this library is a function template on T and never branches on data. It uses only
//
//   T(c)                          a constant, from long double or int, rounded once
//   + - * / unary-               arithmetic
//   < <= > >=                     comparisons, which give a mask_t<T>
//   select(mask, a, b)            a where the mask holds, b elsewhere; both are computed
//   minimum maximum abs sqrt      found by argument-dependent lookup
//
// Ready-made scalars: float, double, long double (here), Packet (packet.hpp), Dual (dual.hpp),
// Shadow (shadow.hpp) and Recorder (recorder.hpp). A type of your own joins by offering the list above
// and, where its precision is not that of double, a specialisation of ScalarTraits.
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "target.hpp"

/// A kernel melts into its caller, whatever its size: sinks and packets cost nothing only then, and GCC gives up early.
/// Where no speed is asked for, as where kernels are recorded, it may be defined as nothing beforehand: a fifth less to
/// compile.
#if defined(ZONAL_INLINE)
#elif defined(_MSC_VER) && !defined(__clang__)
#define ZONAL_INLINE
#else
#define ZONAL_INLINE __attribute__((always_inline))
#endif

namespace zonal {
inline namespace ZONAL_TARGET {

template <class T>
inline constexpr bool is_builtin_scalar_v = std::is_floating_point_v<T>;

template <class T, class R>
using IfBuiltin = std::enable_if_t<is_builtin_scalar_v<T>, R>;

/// What the library needs to know about a scalar. `Lane` is the built-in type of its constants and precision.
template <class T>
struct ScalarTraits {
  using Lane = std::conditional_t<is_builtin_scalar_v<T>, T, double>;
};

template <class T>
using lane_t = typename ScalarTraits<T>::Lane;

/// Binary digits of the mantissa: 24 for float. Kernels choose the length of a series by it.
template <class T>
inline constexpr int digits_v = std::numeric_limits<lane_t<T>>::digits;

/// What a constant of a kernel is kept as: rounded to T when the kernel is compiled, or as exact as there is, for a T
/// that rounds by itself. Kernels hold each constant as a `constexpr auto` of their own: no table is read and no root
/// computed at run time, be it in a debug build, and a graphics processor gets the value instead of a host's address.
template <class T>
using constant_t = std::conditional_t<is_builtin_scalar_v<T>, T, long double>;

template <class T>
constexpr constant_t<T> rounded(long double constant) {
  return static_cast<constant_t<T>>(constant);
}

/// What comparing two T gives: bool for the built-in types.
template <class T>
using mask_t = std::decay_t<decltype(std::declval<T>() < std::declval<T>())>;

/// Whether any lane is set, for work that may be left out; true of a scalar that does not tell, such as a recording.
template <class T>
struct AnyLane {
  ZONAL_INLINE static constexpr bool of(const mask_t<T>& mask) {
    if constexpr (is_builtin_scalar_v<T>) {
      return mask;
    } else {
      return static_cast<void>(mask), true;
    }
  }
};

namespace detail {
template <class V, class C = decltype(std::declval<const V&>()[0])>
std::decay_t<C> component_of(int);
template <class V, class C = decltype(std::declval<const V&>().x)>
std::decay_t<C> component_of(long);  // where there is no [0]
}  // namespace detail

/// The component type of a direction: of anything with v[0], v[1], v[2], such as a GLM or Eigen vector, std::array, a
/// pointer; or with v.x, v.y, v.z.
template <class V>
using component_t = decltype(detail::component_of<V>(0));

template <class T>
constexpr IfBuiltin<T, T> select(bool mask, T a, T b) {
  return mask ? a : b;
}
template <class T>
constexpr IfBuiltin<T, T> minimum(T a, T b) {
  return b < a ? b : a;
}
template <class T>
constexpr IfBuiltin<T, T> maximum(T a, T b) {
  return a < b ? b : a;
}
template <class T>
constexpr IfBuiltin<T, T> abs(T a) {
  return a < T(0) ? -a : a;
}
template <class T>
ZONAL_DEVICE IfBuiltin<T, T> sqrt(T a) {
  return std::sqrt(a);
}

namespace detail {
/// a == b where just that is meant: users compile with -Wfloat-equal.
template <class T>
constexpr IfBuiltin<T, bool> is_equal(T a, T b) {
  return a <= b && a >= b;
}
}  // namespace detail

/// sum += a * b. Packets have one that folds (packet.hpp).
template <class T>
ZONAL_INLINE constexpr void add_product(T& sum, const T& a, const T& b) {
  sum = sum + a * b;
}
/// sum -= a * b.
template <class T>
ZONAL_INLINE constexpr void subtract_product(T& sum, const T& a, const T& b) {
  sum = sum - a * b;
}

template <class T>
ZONAL_INLINE constexpr T clamp(T x, T low, T high) {
  return minimum(maximum(x, low), high);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
