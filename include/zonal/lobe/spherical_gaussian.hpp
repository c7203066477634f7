// The spherical Gaussian.
//
// z_l = 4 pi K_l e^-lambda i_l(lambda) with the modified spherical Bessel function i_l. Two regimes, both computed
// and one selected, because a kernel does not branch:
//
// - lambda < N^2/2: downward recurrence of the ratio rho_l = i_l / i_(l-1) = lambda / (2l+1 + lambda rho_(l+1)), which
//   contracts errors by rho^2 a step. It starts at degree 4N + 8 from rho_l = lambda / (l + sqrt(l(l+1) + lambda^2)),
//   right to second order for small and for large lambda.
// - beyond: upward recurrence i_(l+1) = i_(l-1) - (2l+1)/lambda i_l, which amplifies errors by at most
//   exp(N^2/lambda).
//
// For lambda < 1, where 1 - e^(-2 lambda) cancels, i_0 comes from sum (2l+1) i_l = e^lambda.
#pragma once

#include <type_traits>

#include "../basis/normalisation.hpp"
#include "../basis/sh.hpp"
#include "../scalar/math.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// f = exp(sharpness (cos theta - 1)), 0 <= sharpness; f = 1 on the axis.
template <class T>
struct SphericalGaussian {
  static_assert(!std::is_integral_v<T>, "a sharpness of type int: write 5.0f");
  T sharpness;
};

namespace detail {
// Downward: the ratios, rho_l to ratios[l] for 1 <= l < bands; returns 1 + rho_1 (3 + rho_2 (5 + ...)) = e^lambda /
// i_0.
template <class T>
ZONAL_INLINE constexpr T gaussian_ratios(const T& lambda, int bands, T* ratios) {
  const int start = 4 * bands + 8;
  const T lambda2 = lambda * lambda;
  T rho = lambda / (T(start) + sqrt(T(start * (start + 1)) + lambda2));
  T sum = T(2 * start + 1);
  for (int l = start - 1; l >= 1; --l) {
    sum = T(2 * l + 1) + rho * sum;
    rho = lambda / (T(2 * l + 1) + lambda * rho);
    if (l < bands) ratios[l] = rho;
  }
  return T(1) + rho * sum;
}

// e^-lambda i_l by both ways, from l = 0 upwards. Each divides by a safe value where it is not selected.
template <class T>
struct GaussianIntegrals {
  mask_t<T> is_tiny, is_sharp;
  T safe, fall, i0, before, upward, downward;

  ZONAL_INLINE constexpr GaussianIntegrals(const T& lambda, const T& sum, int bands)
      : is_tiny(lambda < T(1)),
        is_sharp(T(0.5 * bands * bands) < lambda),
        safe(maximum(lambda, T(1))),
        fall(exp(T(-2) * safe)),
        i0(select(is_tiny, T(1) / sum, (T(1) - fall) / (safe + safe))),
        before(i0),
        upward(((T(1) + fall) * T(0.5L) - i0) / safe),
        downward(i0) {}
  // Degree l >= 1 from the one before.
  ZONAL_INLINE constexpr T next(int l, const T& ratio) {
    if (l > 1) {
      const T next = before - T(2 * l - 1) / safe * upward;
      before = upward;
      upward = next;
    }
    downward = downward * ratio;
    return select(is_sharp, upward, downward);
  }
};
}  // namespace detail

/// Its zonal coefficients to sink(l, value).
template <int N, class T, class Sink>
ZONAL_INLINE constexpr void project(const SphericalGaussian<T>& lobe, Sink&& sink) {
  Zh<N, T> ratio{};
  const T sum = detail::gaussian_ratios(lobe.sharpness, N, ratio.values);
  detail::GaussianIntegrals<T> integrals(lobe.sharpness, sum, N);
  constexpr auto scale_0 = rounded<T>(4 * kPi * detail::zonal_normalisation<0>);
  sink(Index<0>{}, T(scale_0) * integrals.i0);
  unroll<1, N>([&](auto l) ZONAL_INLINE {
    constexpr auto scale = rounded<T>(4 * kPi * detail::zonal_normalisation<l>);
    sink(l, T(scale) * integrals.next(l, ratio.values[l]));
  });
}

template <int N, class T>
constexpr Zh<N, T> project(const SphericalGaussian<T>& lobe) {
  Zh<N, T> zh{};
  project<N>(lobe, [&](auto l, const T& value) ZONAL_INLINE { zh.values[l] = value; });
  return zh;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
