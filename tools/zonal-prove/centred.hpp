// Intervals in which a function's values over a cell lie, by Boost.Interval and the mean value theorem.
//
// A cell is a box of parameters p, |p_k - centre_k| <= radius_k. Beside the interval of its values, `range`, a quantity
// has that of its values at the centre and those of its slopes over the cell: f(p) lies in centre + sum of slope_k
// (p_k - centre_k) as well [1], which is narrower by far where the cell is small.
//
// [1] Moore, Kearfott and Cloud, Introduction to Interval Analysis, SIAM, 2009, section 6.3.
#pragma once

#include <boost/numeric/interval.hpp>

#include <cmath>
#include <limits>

namespace zonal_prove {

namespace interval_lib = boost::numeric::interval_lib;
using SafeInterval = boost::numeric::interval<
    double, interval_lib::policies<interval_lib::rounded_math<double>, interval_lib::checking_base<double>>>;
/// While one lives the processor rounds as intervals need it.
using Rounding = SafeInterval::traits_type::rounding;
using Interval = interval_lib::unprotect<SafeInterval>::type;

constexpr int parameter_count = 2;

struct Cell {
  double low[parameter_count], high[parameter_count];

  Interval range(int k) const { return {low[k], high[k]}; }
  double middle(int k) const { return low[k] + (high[k] - low[k]) / 2; }
  /// Where p_k - middle_k lies.
  Interval offset(int k) const { return range(k) - Interval(middle(k)); }
};

/// What all quantities over a cell have in common.
struct CellOffsets {
  Interval of[parameter_count];
};

struct Centred {
  Interval centre{0}, range{0};
  Interval slope[parameter_count] = {Interval(0), Interval(0)};

  Centred() = default;
  explicit Centred(const Interval& constant) : centre(constant), range(constant) {}

  /// Narrows the range by the mean value theorem.
  void narrow(const CellOffsets& offsets) {
    Interval other = centre;
    for (int k = 0; k < parameter_count; ++k) other += slope[k] * offsets.of[k];
    const double low = std::fmax(range.lower(), other.lower()), high = std::fmin(range.upper(), other.upper());
    if (low <= high) range.assign(low, high);
  }
  /// Something of at most this size is added.
  void widen(double size) {
    const Interval error(-size, size);
    centre += error;
    range += error;
  }
};

inline double magnitude(const Interval& a) { return std::fmax(-a.lower(), a.upper()); }

/// f(a) with f' over a.
template <class Function>
Centred chain(const Centred& a, Function f, const Interval& derivative) {
  Centred result;
  result.centre = f(a.centre);
  result.range = f(a.range);
  for (int k = 0; k < parameter_count; ++k) result.slope[k] = derivative * a.slope[k];
  return result;
}
template <class Function>
Centred combine(const Centred& a, const Centred& b, Function f, const Interval& by_a, const Interval& by_b) {
  Centred result;
  result.centre = f(a.centre, b.centre);
  result.range = f(a.range, b.range);
  for (int k = 0; k < parameter_count; ++k) result.slope[k] = by_a * a.slope[k] + by_b * b.slope[k];
  return result;
}

inline Centred operator-(const Centred& a) {
  return chain(
      a, [](const Interval& x) { return -x; }, Interval(-1));
}
inline Centred operator+(const Centred& a, const Centred& b) {
  Centred result;
  result.centre = a.centre + b.centre;
  result.range = a.range + b.range;
  for (int k = 0; k < parameter_count; ++k) result.slope[k] = a.slope[k] + b.slope[k];
  return result;
}
inline Centred operator-(const Centred& a, const Centred& b) {
  Centred result;
  result.centre = a.centre - b.centre;
  result.range = a.range - b.range;
  for (int k = 0; k < parameter_count; ++k) result.slope[k] = a.slope[k] - b.slope[k];
  return result;
}
inline Centred operator*(const Centred& a, const Centred& b) {
  return combine(
      a, b, [](const Interval& x, const Interval& y) { return x * y; }, b.range, a.range);
}
inline Centred square(const Centred& a) {
  return chain(
      a, [](const Interval& x) { return boost::numeric::square(x); }, Interval(2) * a.range);
}
inline Centred operator/(const Centred& a, const Centred& b) {
  const Interval by_a = Interval(1) / b.range;
  return combine(
      a, b, [](const Interval& x, const Interval& y) { return x / y; }, by_a, -(a.range / b.range) * by_a);
}
inline Centred sqrt(const Centred& a) {
  const auto root = [](const Interval& x) {
    return boost::numeric::sqrt(Interval(std::fmax(x.lower(), 0), std::fmax(x.upper(), 0)));
  };
  return chain(a, root, Interval(1) / (Interval(2) * root(a.range)));
}

/// Either of two: where it is not known which one is chosen.
inline Centred hull(const Centred& a, const Centred& b) {
  Centred result;
  result.centre = boost::numeric::hull(a.centre, b.centre);
  result.range = boost::numeric::hull(a.range, b.range);
  for (int k = 0; k < parameter_count; ++k) result.slope[k] = boost::numeric::hull(a.slope[k], b.slope[k]);
  return result;
}

}  // namespace zonal_prove
