// Coefficients of colours as functions in double, channel by channel, and their luminance.
#pragma once

#include <cstddef>

#include "../basis/sh.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// 1 of a number; of a colour, GLM's, Eigen's, Rgb, how many numbers it is.
template <class C>
inline constexpr int channels_v = is_builtin_scalar_v<C> ? 1 : plain_length_v<C>;

template <class C>
constexpr number_t<C>& channel(C& colour, int i) {
  if constexpr (is_builtin_scalar_v<C>) {
    return static_cast<void>(i), colour;
  } else {
    return numbers_of(&colour)[i];
  }
}
template <class C>
constexpr const number_t<C>& channel(const C& colour, int i) {
  if constexpr (is_builtin_scalar_v<C>) {
    return static_cast<void>(i), colour;
  } else {
    return numbers_of(&colour)[i];
  }
}

// The weights of RGB in luminance, ITU-R BT.709; of any other number of channels their mean.
template <class C>
constexpr double luminance_weight(int i) {
  constexpr double weights[3] = {0.2126, 0.7152, 0.0722};
  return channels_v<C> == 3 ? weights[i] : 1.0 / channels_v<C>;
}

template <int N, class C>
constexpr Sh<N, double> channel_of(const Sh<N, C>& sh, int which) {
  Sh<N, double> r{};
  for (int i = 0; i < r.size(); ++i) r[i] = static_cast<double>(channel(sh[i], which));
  return r;
}
template <int N, class C>
constexpr Sh<N, double> luminance_of(const Sh<N, C>& sh) {
  Sh<N, double> r{};
  for (int c = 0; c < channels_v<C>; ++c) r += channel_of(sh, c) * luminance_weight<C>(c);
  return r;
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
