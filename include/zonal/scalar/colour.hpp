// What a coefficient may be: a scalar, or a colour, which is anything that can be added and multiplied by a number.
//
// A GLM or Eigen vector, or a struct of one's own: with c[0] of the number's type, or else multiplied by float.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// The type of A * B, and void where there is none.
template <class A, class B>
constexpr auto product_of(int) -> std::decay_t<decltype(std::declval<const A&>() * std::declval<const B&>())>*;
template <class A, class B>
constexpr void* product_of(long);
template <class A, class B>
using ProductOf = std::remove_pointer_t<decltype(product_of<A, B>(0))>;
template <class A, class B>
inline constexpr bool has_product_v = !std::is_void_v<ProductOf<A, B>>;

// Whether T has components, by which it can be multiplied. A packet has lanes, by which it cannot.
template <class T, class = void>
inline constexpr bool has_components_v = false;
template <class T>
inline constexpr bool has_components_v<T, std::void_t<component_t<T>>> =
    has_product_v<T, component_t<T>> || has_product_v<component_t<T>, T>;

template <class T, class = void>
inline constexpr bool has_order_v = false;
template <class T>
inline constexpr bool has_order_v<T, std::void_t<mask_t<T>>> = true;

template <class T>
inline constexpr bool is_colour_v = !std::is_arithmetic_v<T> && (has_components_v<T> || !has_order_v<T>);

// The number that a T is multiplied by: a scalar itself; of a colour its component.
template <class T>
constexpr auto number_of() {
  if constexpr (!is_colour_v<T>) {
    return static_cast<T*>(nullptr);
  } else if constexpr (has_components_v<T>) {
    return static_cast<component_t<T>*>(nullptr);
  } else {
    return static_cast<float*>(nullptr);
  }
}
template <class T>
using number_t = std::remove_pointer_t<decltype(number_of<T>())>;

// A type that can be kept: Eigen's expressions refer to what they are made of.
template <class T>
std::decay_t<T> kept(long);
template <class T>
typename T::PlainObject kept(int);
template <class T>
using kept_t = decltype(kept<T>(0));

// a * b, or b * a where a colour has that only.
template <class A, class B, class = std::enable_if_t<has_product_v<A, B> || has_product_v<B, A>>>
ZONAL_INLINE constexpr auto times(const A& a, const B& b) {
  if constexpr (has_product_v<A, B>) {
    return a * b;
  } else {
    return b * a;
  }
}

// What a product is, as a value: of a colour and a number it is the colour. (Eigen's own products are expressions.)
template <class A, class T, class Product = std::decay_t<decltype(times(std::declval<A>(), std::declval<T>()))>>
using product_t =
    std::conditional_t<is_builtin_scalar_v<Product>, Product, std::conditional_t<is_builtin_scalar_v<A>, T, A>>;

// What S is as a factor of a T: a built-in number becomes the T's own.
template <class T, class S>
using factor_t = std::conditional_t<std::is_arithmetic_v<S>, number_t<T>, kept_t<S>>;

// Black, where it is known: of a scalar, of GLM's and of Eigen's vectors; of any other type what C{} is.
template <class C>
constexpr auto zero(int) -> std::decay_t<decltype(C(C::Zero()))> {
  return C::Zero();
}
template <class C>
constexpr C zero(long) {
  if constexpr (is_colour_v<C>) {
    return C{};
  } else {
    return C(0);
  }
}

// How many numbers a vector of GLM's or Eigen's is, one after the other; 0 for any other type. Compilers see through
// arrays of numbers only: sums of vectors become two to four times faster.
template <class T, class = void>
inline constexpr int plain_length_v = 0;
template <class T>
inline constexpr int plain_length_v<
    T, std::enable_if_t<is_builtin_scalar_v<typename T::value_type> && std::is_trivially_copyable_v<T> &&
                        std::is_same_v<decltype(std::declval<T&>()[0]), typename T::value_type&> &&
                        sizeof(T) == static_cast<std::size_t>(T::length()) * sizeof(typename T::value_type)>> =
    static_cast<int>(T::length());
template <class T>
inline constexpr int plain_length_v<
    T, std::enable_if_t<is_builtin_scalar_v<typename T::Scalar> && (T::SizeAtCompileTime > 0) &&
                        sizeof(T) == static_cast<std::size_t>(T::SizeAtCompileTime) * sizeof(typename T::Scalar)>> =
    static_cast<int>(T::SizeAtCompileTime);

// The numbers of such vectors, all in one row.
template <class T>
ZONAL_INLINE constexpr number_t<T>* numbers_of(T* vectors) {
  return static_cast<number_t<T>*>(static_cast<void*>(vectors));
}
template <class T>
ZONAL_INLINE constexpr const number_t<T>* numbers_of(const T* vectors) {
  return static_cast<const number_t<T>*>(static_cast<const void*>(vectors));
}

// to = a * b. Of Eigen's vectors number by number: their own products are expressions, which compilers see through as
// little as through the vectors.
template <class T, class A, class B>
ZONAL_INLINE constexpr void set_product(T& to, const A& a, const B& b) {
  constexpr int length = std::is_trivially_copyable_v<T> ? 0 : plain_length_v<T>;
  if constexpr (length != 0 && std::is_same_v<A, number_t<T>> && std::is_same_v<B, T>) {
    for (int i = 0; i < length; ++i) numbers_of(&to)[i] = a * numbers_of(&b)[i];
  } else if constexpr (length != 0 && std::is_same_v<A, T> && std::is_same_v<B, number_t<T>>) {
    for (int i = 0; i < length; ++i) numbers_of(&to)[i] = numbers_of(&a)[i] * b;
  } else {
    to = times(a, b);
  }
}

// sum += a * b and sum -= a * b, in one rounding where scalars have such an operation. Colours need no minus.
template <class T, class A, class B>
ZONAL_INLINE constexpr void add_times(T& sum, const A& a, const B& b) {
  if constexpr (std::is_same_v<A, T> && std::is_same_v<B, T> && !is_colour_v<T>) {
    add_product(sum, a, b);
  } else {
    sum = sum + times(a, b);
  }
}
template <class T, class A, class B>
ZONAL_INLINE constexpr void subtract_times(T& sum, const A& a, const B& b) {
  if constexpr (std::is_same_v<A, T> && std::is_same_v<B, T> && !is_colour_v<T>) {
    subtract_product(sum, a, b);
  } else {
    sum = sum + times(T(times(a, b)), number_t<T>(-1));
  }
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
