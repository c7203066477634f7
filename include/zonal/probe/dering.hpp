// The weakest window that keeps a reconstruction from going below 0 [1].
//
// A window multiplies degree l by a factor that falls with l, the faster the smaller its width:
//
//   hann               (1 + cos(pi l / w)) / 2, 0 from l = w on          lanczos_fourth  the fourth power of
//   lanczos            sin(pi l / w) / (pi l / w), 0 from l = w on       laplacian       1 / (1 + l^2 (l+1)^2 / w^4)
//
// the last being what least squares give with 1/w^4 times the squared Laplacian added [2]. From no window on, the
// window is strengthened until the direction in which the function is least is no longer below 0 (no weaker window can
// do, for it fails there), the least value under that window is found anew, and so forth, until there is none below 0:
// and that is proved by the bound of least_value.hpp, not sampled. [1] takes the least value of a zonal function
// instead, by which the window may be stronger than it has to be, and bisects.
//
// [1] Sloan, Deringing spherical harmonics, SIGGRAPH Asia 2017 Technical Briefs.
// [2] Sloan, Stupid spherical harmonics tricks, GDC 2008.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "../environment/irradiance.hpp"
#include "../transform/window.hpp"
#include "channels.hpp"
#include "least_value.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

enum class DeringWindow { hann, lanczos, lanczos_fourth, laplacian };

/// What must not be negative: the function itself, or the irradiance by it (as E / pi of any normal).
enum class DeringOf { radiance, irradiance };

/// channel: each has a window of its own, as weak as it can be; colours shift where one channel rings more.
/// all_channels: one window, with which no channel is negative. luminance: one window, with which the luminance
/// (BT.709) is not negative, though channels may be.
enum class DeringBy { channel, all_channels, luminance };

struct DeringOptions {
  DeringWindow window = DeringWindow::lanczos_fourth;
  DeringOf of = DeringOf::radiance;
  DeringBy by = DeringBy::all_channels;
};

/// What it came to in a channel. Both errors are relative to the given coefficients.
struct DeringChannel {
  double strength = 0;          // 1 / width; 0: no window was needed
  double error = 0;             // of radiance: |given - windowed| / |given|, norms over the sphere
  double irradiance_error = 0;  // the same of irradiance
  double energy_lost = 0;       // 1 - |windowed|^2 / |given|^2, of radiance
  double least_before = 0;      // the least value of what must not be negative, E / pi or radiance
  double least_after = 0;       // a bound: no value of it is below
};

template <int N, class C>
struct Dering {
  Sh<N, C> sh;  // the windowed coefficients, of radiance as the given ones
  std::array<DeringChannel, std::size_t{detail::channels_v<C>}> channels;
  bool is_possible = true;  // false where a mean is not positive: `sh` is then what it was
};

/// The factor of degree l >= 0 by a window of the strength 1 / width, >= 0.
inline double dering_factor(DeringWindow window, int degree, double strength) {
  if (degree == 0 || !(strength > 0)) return 1;
  if (window == DeringWindow::laplacian) {
    const double x = degree * (degree + 1) * strength * strength;
    return 1 / (1 + x * x);
  }
  const double width = 1 / strength;
  const double factor = window_factor(window == DeringWindow::hann ? Window::hann : Window::sinc, degree, width);
  return window == DeringWindow::lanczos_fourth ? factor * factor * (factor * factor) : factor;
}

namespace detail {

template <int N>
constexpr Sh<N, double> ones() {
  Sh<N, double> r{};
  for (double& x : r.values) x = 1;
  return r;
}
template <int N>
Sh<N, double> windowed(const Sh<N, double>& f, DeringWindow window, double strength) {
  Sh<N, double> r{};
  for (int l = 0; l < N; ++l) {
    const double factor = dering_factor(window, l, strength);
    for (int i = l * l; i < (l + 1) * (l + 1); ++i) r[i] = factor * f[i];
  }
  return r;
}

// How fast a factor can fall with the strength, for each degree.
inline double steepest_fall(DeringWindow window, int degree) {
  switch (window) {
    case DeringWindow::hann: return degree * 1.5708;                    // pi/2 |sin|
    case DeringWindow::lanczos: return degree * 1.3707;                 // the greatest of |d/dx sin(pi x)/(pi x)|
    case DeringWindow::lanczos_fourth: return degree * 4 * 1.3707;      //
    default: return std::sqrt(double(degree * (degree + 1))) * 1.0655;  // 4 x^3 / (1 + x^4)^2 at x^4 = 3/5
  }
}

// A function that must not fall below `enough`, and a little more.
template <int N>
struct Dered {
  Sh<N, double> function;
  double enough, aim, tolerance;
  bool is_possible;  // a window can do no more than leave the mean

  Dered(const Sh<N, double>& f, double epsilon) : function(f) {
    const double mean = f[0] * double(zonal_normalisation<0>), all = sum_of_degrees(f);
    enough = (std::max)(2 * epsilon * all, 1e-6 * mean), aim = 2 * enough, tolerance = enough / 8;
    is_possible = mean > aim ? all < std::numeric_limits<double>::infinity() : !(all > 0) && !(all < 0);
    if (std::isnan(all)) is_possible = false;
  }
};

// The first strength from the given one on at which f is not below its aim in the direction.
template <int N>
double first_strength(const Dered<N>& f, DeringWindow window, double strength, const std::array<double, 3>& d) {
  double of_degree[std::size_t{N}] = {}, fall = 0;
  evaluate<N>(d[0], d[1], d[2],
              [&](auto l, auto m, double y) { of_degree[l] += f.function.values[sh_index(l, m)] * y; });
  for (int l = 1; l < N; ++l) fall += steepest_fall(window, l) * std::abs(of_degree[l]);
  constexpr double strongest = 1e3;  // beyond it nothing but the mean is left
  while (strength < strongest) {
    double value = -f.aim;
    for (int l = 0; l < N; ++l) value += dering_factor(window, l, strength) * of_degree[l];
    if (value >= 0) break;
    // It cannot come to 0 within value / fall; what is passed over beyond that is within a quarter of a percent.
    strength += (std::max)({-value / fall, 0.0025 * strength, 1e-5});
  }
  return strength;
}

// The weakest window with which none of the functions is below what is enough; 0: none is.
template <int N>
double weakest_strength(const Dered<N>* functions, int count, DeringWindow window) {
  double strength = 0;
  for (int passed = 0, i = 0; passed < count && strength < 1e3; i = (i + 1) % count) {
    const Dered<N>& f = functions[i];
    const LeastValue least = least_value(windowed(f.function, window, strength), f.enough, f.tolerance);
    if (least.bound >= f.enough - f.tolerance) {
      ++passed;
    } else {
      strength = 1.002 * first_strength(f, window, strength, least.direction);
      passed = 0;
      --i;  // this one once more
    }
  }
  return strength;
}

// |a - b| / |a|
template <int N>
double relative_error(const Sh<N, double>& a, const Sh<N, double>& b) {
  const double square = dot(a, a);
  return square > 0 ? std::sqrt(dot(a - b, a - b) / square) : 0;
}
}  // namespace detail

/// Radiance's coefficients under the weakest window with which it, or the irradiance by it, is nowhere below 0, and
/// what that costs. C is a number or a colour, GLM's, Eigen's or Rgb. The width is at most 1 % less than that of the
/// weakest window that leaves 2e-6 of the mean everywhere, or 4 ulp (of the number type) of the sum of the degrees'
/// greatest values if more: room for the rounding of the coefficients, and of reconstruct.
template <int N, class C>
Dering<N, C> dering(const Sh<N, C>& radiance, const DeringOptions& options = {}) {
  constexpr int count = detail::channels_v<C>;
  using T = detail::number_t<C>;
  using Function = Sh<N, double>;
  constexpr auto epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
  const auto seen = [&](const Function& f) { return options.of == DeringOf::irradiance ? irradiance_over_pi(f) : f; };
  Dering<N, C> result{radiance, {}, true};
  std::vector<detail::Dered<N>> functions;
  if (options.by == DeringBy::luminance) {
    functions.emplace_back(seen(detail::luminance_of<double>(radiance)), epsilon);
  } else {
    for (int c = 0; c < count; ++c) functions.emplace_back(seen(detail::take_channel<double>(radiance, c)), epsilon);
  }
  for (const auto& f : functions) result.is_possible = result.is_possible && f.is_possible;

  double common = 0;
  if (result.is_possible && options.by != DeringBy::channel) {
    common = detail::weakest_strength(functions.data(), static_cast<int>(functions.size()), options.window);
  }
  for (int c = 0; c < count; ++c) {
    DeringChannel& channel = result.channels[std::size_t(c)];
    channel.strength = common;
    if (result.is_possible && options.by == DeringBy::channel) {
      channel.strength = detail::weakest_strength(&functions[std::size_t(c)], 1, options.window);
    }
    if (channel.strength > 0) {
      const Function factors = detail::windowed(detail::ones<N>(), options.window, channel.strength);
      for (int i = 0; i < N * N; ++i) {
        T& number = detail::channel_of(result.sh[i], c);
        number = static_cast<T>(static_cast<double>(number) * factors[i]);
      }
    }
    const Function before = detail::take_channel<double>(radiance, c),
                   after = detail::take_channel<double>(result.sh, c);
    channel.error = detail::relative_error(before, after);
    channel.irradiance_error = detail::relative_error(irradiance_over_pi(before), irradiance_over_pi(after));
    channel.energy_lost = dot(before, before) > 0 ? 1 - dot(after, after) / dot(before, before) : 0;
    const detail::Dered<N> now(seen(after), epsilon);
    channel.least_before = least_value(seen(before), 1e-3).value;
    channel.least_after = detail::least_value(now.function, now.enough, now.tolerance).bound;
  }
  return result;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
