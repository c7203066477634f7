// Coefficients of colours as functions of numbers, channel by channel, and their luminance.
#pragma once

#include <type_traits>

#include "../scalar/luminance.hpp"
#include "../transform/reconstruct_adjoint.hpp"  // channels_v, channel_of

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// One channel, as numbers T.
template <class T, int N, class C>
constexpr Sh<N, T> take_channel(const Sh<N, C>& sh, int which) {
  Sh<N, T> r{};
  for (int i = 0; i < N * N; ++i) r.values[i] = static_cast<T>(channel_of(sh.values[i], which));
  return r;
}

// The weights of RGB in luminance; of any other number of channels their mean.
template <class C>
constexpr double luminance_weight(int i) {
  return channels_v<C> == 3 ? kLuminanceWeights[i] : 1.0 / channels_v<C>;
}

template <class T, int N, class C>
constexpr Sh<N, T> luminance_of(const Sh<N, C>& sh) {
  Sh<N, T> r{};
  for (int c = 0; c < channels_v<C>; ++c) r += take_channel<T>(sh, c) * static_cast<T>(luminance_weight<C>(c));
  return r;
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
