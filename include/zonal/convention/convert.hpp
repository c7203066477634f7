// Coefficients from one convention to another, and the basis functions that a convention has.
#pragma once

#include "../basis/evaluate.hpp"
#include "../scalar/vector3.hpp"
#include "convention.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

// c plus a number: of a colour, plus that much in each of its components.
template <class T>
T plus_number(T c, double number) {
  if constexpr (!is_colour_v<T>) {
    return c + T(number);
  } else {
    static_assert(plain_length_v<T> != 0, "an offset needs colours of which the components are known: GLM's, Eigen's");
    for (int i = 0; i < plain_length_v<T>; ++i) numbers_of(&c)[i] += static_cast<number_t<T>>(number);
    return c;
  }
}

// The constant function that an offset is, as coefficient (0, 0) of radiance in this library's convention.
constexpr long double offset_of_radiance(const Convention& convention) {
  return static_cast<long double>(convention.offset) * constexpr_sqrt(4 * kPi) /
         quantity_factor(convention.quantity, 0);
}

}  // namespace detail

/// The same function in another convention: `sh` holds the numbers as `from` stores them, the result as `to` does, both
/// in the order that they have there (sh[i], not sh(l, m)). T is a number or a colour.
///
/// Directions keep their coordinates; for the world of another engine, where another axis is up, see change_frame().
/// From irradiance to radiance, degrees that a clamped cosine takes away (3, 5, 7, ...) are zeros. A convention that is
/// defined to degree 3 is refused for more than 4 bands: std::invalid_argument (refuse.hpp).
///
/// One rounding a coefficient, and those of rotate() where the axes differ.
template <int N, class T>
Sh<N, T> convert(const Sh<N, T>& sh, const Convention& from, const Convention& to) {
  using Number = detail::number_t<T>;
  detail::check_convention(from, N);
  detail::check_convention(to, N);
  const auto scaled = [](const T& value, long double factor) {
    return T(detail::times(value, static_cast<Number>(factor)));
  };
  const bool are_same_axes = from.axes == to.axes;
  Sh<N, T> turned = sh;
  if (!are_same_axes) {
    Sh<N, T> ours;
    for (int l = 0; l < N; ++l) {
      for (int m = -l; m <= l; ++m) {
        ours.values[sh_index(l, m)] =
            scaled(sh.values[stored_index(from.order, l, m)], 1 / detail::stored_factor(from, l, m));
      }
    }
    // From the harmonics' axes to coordinates, and to the other harmonics' axes.
    turned = detail::with_axes_at(detail::with_axes_at(ours, from.axes), detail::inverse(to.axes));
  }
  Sh<N, T> r;
  for (int l = 0; l < N; ++l) {
    const long double quantity = detail::quantity_ratio(from.quantity, to.quantity, l);
    for (int m = -l; m <= l; ++m) {
      const int at = are_same_axes ? stored_index(from.order, l, m) : sh_index(l, m);
      const long double factor =
          detail::stored_factor(to, l, m) / (are_same_axes ? detail::stored_factor(from, l, m) : 1);
      r.values[stored_index(to.order, l, m)] = scaled(turned.values[at], quantity * factor);
    }
  }
  const long double offset = (detail::offset_of_radiance(from) - detail::offset_of_radiance(to)) *
                             detail::quantity_factor(to.quantity, 0) * detail::stored_factor(to, 0, 0);
  if (offset > 0 || offset < 0) r.values[0] = detail::plus_number(r.values[0], static_cast<double>(offset));
  return r;
}

/// The basis functions of a convention at a direction, in the order in which it stores coefficients: B_i of
/// convention.hpp. Neither quantity, scale nor offset play a part.
template <int N, class T, class V>
Sh<N, T> evaluate_in(const Convention& convention, const V& direction) {
  detail::check_convention(convention, N);
  const auto d = detail::as_direction<T>(direction);
  const T coordinates[3] = {d.x, d.y, d.z};
  const auto along = [&](Axis axis) { return T(detail::sign(axis)) * coordinates[detail::coordinate(axis)]; };
  const T of_harmonics[3] = {along(convention.axes.x), along(convention.axes.y), along(convention.axes.z)};
  const Sh<N, T> y = evaluate<N>(of_harmonics);
  Sh<N, T> r;
  for (int l = 0; l < N; ++l) {
    for (int m = -l; m <= l; ++m) {
      r.values[stored_index(convention.order, l, m)] = T(detail::basis_factor(convention, l, m)) * y(l, m);
    }
  }
  return r;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
