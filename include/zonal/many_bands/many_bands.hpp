// What the kernels of many bands take from tables, made once for a number of bands.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "../basis/difference_step.hpp"
#include "../basis/normalisation.hpp"
#include "../basis/table.hpp"
#include "../scalar/refuse.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// More are refused. The factors of the basis outgrow the range of the numbers at some 260 bands in float, 2180 in
/// double.
template <class T>
inline constexpr int greatest_bands = std::is_same_v<T, float> ? 250 : 2000;

namespace detail {
inline void check_bands(int bands, int greatest, const char* what) {
  if (1 <= bands && bands <= greatest) return;
  refuse(std::string(what) + ": " + std::to_string(bands) + " bands; from 1 to " + std::to_string(greatest) +
         " are possible");
}

// Of a function that a kernel of so many bands takes.
inline void check_enough_bands(int bands, int needed, const char* what) {
  if (bands >= needed) return;
  refuse(std::string(what) + " of " + std::to_string(bands) + " bands, where " + std::to_string(needed) +
         " are needed");
}

// Y_l^m is the product of q_l^m, which grows to 10^(l/5) next to the poles, and a power of the sine, which is as small.
// The power is kept this many times as large as it is, the factor as many times smaller, so that both stay numbers.
template <class T>
constexpr T power_scale() {
  T scale = 1;
  for (int i = 0; i < (std::is_same_v<T, float> ? 60 : 500); ++i) scale *= 2;
  return scale;
}

// Orders are computed so many at a time, also beyond the last.
inline constexpr int order_block = 8;
constexpr int whole_blocks(int orders) { return (orders + order_block - 1) / order_block * order_block; }

// g_l^m = sqrt((2l+1) / ((2l-1) (l+m) (l-m))): q_l^m = g_l^m ((l+m) q_(l-1)^m + ...), see evaluate.hpp.
constexpr long double difference_scale(int l, int m) {
  return constexpr_sqrt((2 * l + 1.0L) / ((2 * l - 1.0L) * (l + m) * (l - m)));
}
}  // namespace detail

/// The constants of N bands, 1 <= N <= greatest_bands<T>; T is float or double. N*N/2 numbers, a tenth of a second for
/// 1000 bands. Any number of threads may read one.
template <class T>
class ManyBands {
  static_assert(std::is_same_v<T, float> || std::is_same_v<T, double>, "float or double");

 public:
  explicit ManyBands(int bands) : bands_(bands) {
    detail::check_bands(bands, greatest_bands<T>, "ManyBands");
    long double diagonal = 0;
    for (int l = 0; l < bands; ++l) {
      diagonal = detail::next_diagonal(l, diagonal);
      diagonal_.push_back(static_cast<T>(diagonal / static_cast<long double>(detail::power_scale<T>())));
      first_.push_back(scale_.size());
      for (int m = 0; m < l; ++m) scale_.push_back(static_cast<T>(detail::difference_scale(l, m)));
      scale_.resize(first_.back() + at(detail::whole_blocks(l + 1)));
      normalisation_.push_back(static_cast<T>(detail::zonal_normalisation_of(l)));
      to_degree_.push_back(static_cast<T>(detail::zonal_to_degree_of(l)));
      integral_.push_back(static_cast<T>(detail::zonal_integral_of(l)));
      for (int m = 0; m < 2; ++m) {
        of_step_[m].push_back(static_cast<T>(l > m ? detail::difference_of_step(l, m) : 0));
        of_sum_[m].push_back(static_cast<T>(l > m ? detail::difference_of_sum(l, m) : 0));
      }
    }
  }
  int bands() const { return bands_; }

  /// q_m^m over the scale of the powers, of 0 <= m < N.
  const T* diagonal() const { return diagonal_.data(); }
  /// g_l^m of 0 <= m < l, and zeros to the end of the block in which order l is.
  const T* scale_of_degree(int l) const { return scale_.data() + first_[at(l)]; }
  /// Of zonal coefficients: K_l, 1 / K_l and 2 pi K_l (basis/normalisation.hpp).
  T normalisation(int l) const { return normalisation_[at(l)]; }
  T to_degree(int l) const { return to_degree_[at(l)]; }
  T integral(int l) const { return integral_[at(l)]; }
  /// The factors of the difference of degree l > m, m = 0 or 1 (basis/difference_step.hpp).
  T of_step(int l, int m) const { return of_step_[m][at(l)]; }
  T of_sum(int l, int m) const { return of_sum_[m][at(l)]; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  int bands_;
  std::vector<std::size_t> first_;
  std::vector<T> diagonal_, scale_, normalisation_, to_degree_, integral_, of_step_[2], of_sum_[2];
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
