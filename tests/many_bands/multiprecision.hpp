// What many bands are held against: textbook formulas in 34 and 100 digits, by Boost.Multiprecision.
#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_quad::backend_type,
                                           boost::multiprecision::et_off>;
using Widest = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_100::backend_type,
                                             boost::multiprecision::et_off>;
using WideVector = std::array<Wide, 3>;

/// A direction of any length, normalised.
template <class T>
WideVector wide_direction(const std::array<T, 3>& v) {
  const Wide x = v[0], y = v[1], z = v[2], length = sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

/// A sum of two doubles, 31 digits: a hundred times as fast as Wide, of a double's range. Needs nothing fused but what
/// says so. After Dekker, A floating-point technique for extending the available precision, 1971.
struct DoubleDouble {
  double high = 0, low = 0;

  DoubleDouble() = default;
  DoubleDouble(double x) : high(x) {}
  DoubleDouble(double a, double b) : high(a), low(b) {}
  explicit DoubleDouble(const Wide& x) : high(static_cast<double>(x)), low(static_cast<double>(Wide(x - Wide(high)))) {}
  explicit operator double() const { return high + low; }

  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const double sum = a.high + b.high, part = sum - a.high;
    return tidy(sum, ((a.high - (sum - part)) + (b.high - part)) + (a.low + b.low));
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
    return a + DoubleDouble(-b.high, -b.low);
  }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const double product = a.high * b.high;
    return tidy(product, std::fma(a.high, b.high, -product) + (a.high * b.low + a.low * b.high));
  }

 private:
  // |a| >= |b|, or a = 0.
  static DoubleDouble tidy(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
  }
};
using DoubleDoubleVector = std::array<DoubleDouble, 3>;

inline DoubleDoubleVector as_double_doubles(const WideVector& v) {
  return {DoubleDouble(v[0]), DoubleDouble(v[1]), DoubleDouble(v[2])};
}

/// (x+iy)^m of growing m.
template <class Number>
struct PowerOf {
  Number real = 1, imaginary = 0;
  int m = 0;

  void raise(const std::array<Number, 3>& v, int to) {
    for (; m < to; ++m) {
      const Number next = v[0] * real - v[1] * imaginary;
      imaginary = v[0] * imaginary + v[1] * real;
      real = next;
    }
  }
};
using WidePower = PowerOf<Wide>;

/// Y_l^m and Y_l^-m of one order m and of the degrees l = m ... bands-1, from
///   Y_l^m = K_l p_l Re (x+iy)^m,  K_l = sqrt(2 - [m = 0]) sqrt((2l+1)/(4 pi) (l-m)! (2m)! / (l+m)!),
///   (l-m) p_l = (2l-1) z p_(l-1) - (l+m-1) p_(l-2),   p_m = (-1)^m (2m-1)!! / sqrt((2m)!)
/// for K_l p_l, which doubles can hold at 1000 bands.
template <class Number>
class ColumnOf {
 public:
  ColumnOf(int bands, int m) : bands_(bands), m_(m) {
    for (int i = 1; i <= m; ++i) first_ *= -sqrt(Wide(2 * i - 1) / (2 * i));
    first_ *= sqrt((m == 0 ? 1 : 2) * Wide(2 * m + 1) / (4 * boost::math::constants::pi<Wide>()));
    Wide last_ratio = 0;
    for (int l = m + 1; l < bands; ++l) {
      const Wide ratio = sqrt(Wide(2 * l + 1) * (l - m) / (Wide(2 * l - 1) * (l + m)));  // K_l / K_(l-1)
      of_last_.push_back(Wide(2 * l - 1) / (l - m) * ratio);
      of_second_.push_back(Wide(l + m - 1) / (l - m) * ratio * last_ratio);
      last_ratio = ratio;
    }
  }
  /// The constants of another, rounded to this number.
  template <class Other>
  explicit ColumnOf(const ColumnOf<Other>& other)
      : bands_(other.bands_),
        m_(other.m_),
        first_(other.first_),
        of_last_(other.of_last_.begin(), other.of_last_.end()),
        of_second_(other.of_second_.begin(), other.of_second_.end()) {}

  int order() const { return m_; }

  /// sink(l, Y_l^m, Y_l^-m) at a unit vector, of which `power` has a power up to the m-th.
  template <class Sink>
  void visit(const std::array<Number, 3>& v, PowerOf<Number>& power, const Sink& sink) const {
    power.raise(v, m_);
    Number last = first_, second = 0;
    for (int l = m_; l < bands_; ++l) {
      if (l > m_) {
        const auto i = static_cast<std::size_t>(l - m_ - 1);
        const Number next = of_last_[i] * v[2] * last - of_second_[i] * second;
        second = last;
        last = next;
      }
      sink(l, Number(last * power.real), Number(last * power.imaginary));
    }
  }

 private:
  template <class>
  friend class ColumnOf;

  int bands_, m_;
  Number first_ = 1;
  std::vector<Number> of_last_, of_second_;
};
using WideColumn = ColumnOf<Wide>;

/// P_0(u) ... P_(count-1)(u).
inline std::vector<Widest> widest_legendre(int count, const Widest& u) {
  std::vector<Widest> p{1, u};
  for (int l = 2; l < count; ++l) {
    const auto i = static_cast<std::size_t>(l);
    p.push_back(((2 * l - 1) * u * p[i - 1] - (l - 1) * p[i - 2]) / l);
  }
  p.resize(static_cast<std::size_t>(count));
  return p;
}

/// e^-x i_l(x) of the modified spherical Bessel function, x > 0: by its power series, or far out by its finite sum.
inline Widest scaled_bessel(int l, const Widest& x) {
  Widest term = 1, sum = 1;
  if (x < 2000) {  // x^l / (2l+1)!! sum of (x^2/2)^k / (k! (2l+3) (2l+5) ... (2l+2k+1))
    for (int k = 1; term > sum * Widest(1e-40); ++k) {
      term *= x * x / (2 * Widest(k) * (2 * l + 2 * k + 1));
      sum += term;
    }
    for (int i = 1; i <= l; ++i) sum *= x / (2 * i + 1);
    return sum * exp(-x);
  }
  for (int k = 1; k <= l; ++k) {  // sum of (-1)^k (l+k)! / (k! (l-k)! (2x)^k) / (2x), but for e^-2x
    term *= -Widest(l + k) * (l - k + 1) / (k * 2 * x);
    sum += term;
  }
  return sum / (2 * x);
}
