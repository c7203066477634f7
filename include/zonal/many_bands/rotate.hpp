// Rotations of functions of many bands: Rz(a) Ry(b) Rz(c) = Z(a) S Z(-b) S Z(c) as in transform/rotate.hpp, with S, the
// exchange of y and z, made for one degree at a time by its recurrence (transform/swap_matrix.hpp) and applied to as
// many functions as there are.
//
// The recurrence starts at 2^(1-l), which ends with the range of double.
#pragma once

#include <cstddef>
#include <vector>

#include "../transform/rotate.hpp"
#include "coefficients.hpp"
#include "many_bands.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Beyond it rotations are refused: the exchange of y and z then starts with numbers below the least.
template <class T>
inline constexpr int greatest_rotation_bands = greatest_bands<T> < 1020 ? greatest_bands<T> : 1020;

/// A turn about z, prepared for N bands, from x towards y.
template <class T>
class ManyTurn {
 public:
  ManyTurn(int bands, T cos_angle, T sin_angle) {
    detail::check_bands(bands, greatest_bands<T>, "ManyTurn");
    const auto count = static_cast<std::size_t>(bands);
    cosine_.assign(count, T(1));
    sine_.assign(count, T(0));
    if (count > 1) cosine_[1] = cos_angle, sine_[1] = sin_angle;
    for (std::size_t m = 2; m < count; ++m) {
      cosine_[m] = cosine_[m - m / 2], sine_[m] = sine_[m - m / 2];
      detail::turn(cosine_[m / 2], sine_[m / 2], cosine_[m], sine_[m]);
    }
  }
  int bands() const { return static_cast<int>(cosine_.size()); }
  T cosine(int m) const { return cosine_[static_cast<std::size_t>(m)]; }
  T sine(int m) const { return sine_[static_cast<std::size_t>(m)]; }

  /// Degree l of a function, orders -l to l; in place where `out` is `in`.
  template <class C>
  void turn_degree(int l, const C* in, C* out) const {
    out[l] = in[l];
    for (int m = 1; m <= l; ++m) {
      detail::turn_pair(cosine(m), sine(m), in[l + m], in[l - m], out[l + m], out[l - m]);
    }
  }

 private:
  std::vector<T> cosine_, sine_;
};

/// A function of N*N coefficients turned about z; in place where `to` is f.
template <class C, class T>
void rotate(const C* f, const ManyTurn<T>& turn, C* to) {
  for (int l = 0; l < turn.bands(); ++l) turn.turn_degree(l, f + l * l, to + l * l);
}
template <class C, class T>
ManySh<C> rotate(const ManySh<C>& f, const ManyTurn<T>& turn) {
  detail::check_enough_bands(turn.bands(), f.bands(), "rotate: a turn");
  ManySh<C> r(f.bands());
  for (int l = 0; l < f.bands(); ++l) turn.turn_degree(l, f.data() + l * l, r.data() + l * l);
  return r;
}

/// The exchange of y and z, one degree at a time: memory for N*N numbers.
template <class T>
class SwapOfDegree {
 public:
  explicit SwapOfDegree(int bands) {
    detail::check_bands(bands, greatest_rotation_bands<T>, "SwapOfDegree");
    const auto count = static_cast<std::size_t>(bands);
    entries_.resize(count * count);
    last_.resize(count);
    second_.resize(count);
  }

  /// Makes that of degree l >= 0. Degrees in order cost least.
  void set_degree(int l) {
    degree_ = l;
    find_corner(l);
    double* const last = last_.data();
    double* const second = second_.data();
    last[0] = static_cast<double>(corner_);
    for (int m = 1; m <= l; ++m) last[m] = last[m - 1] * static_cast<double>(detail::next_swap_edge(l, m, 1));
    for (int m = 0; m <= l; ++m) second[m] = 0;
    for (int k = l; k >= 0; --k) {
      if (k < l)
        next_row(l, static_cast<double>(detail::swap_of_next(l, k)), static_cast<double>(detail::swap_of_second(l, k)));
      const double scale = k == 0 ? static_cast<double>(detail::swap_of_zero) : 1;
      T* const row = entries_.data() + static_cast<std::size_t>(k) * static_cast<std::size_t>(l + 1);
      for (int m = 0; m <= l; ++m) row[m] = static_cast<T>(scale * last[m]);
    }
  }

  /// That degree of a function, orders -l to l, not in place.
  template <class C>
  void apply(const C* in, C* out) const {
    using Number = detail::number_t<C>;
    const int l = degree_, parity = l % 2;
    for (int i = 0; i <= 2 * l; ++i) out[i] = detail::zero<C>(0);
    for (int k = 0; k <= l; ++k) {
      // By orders m that are, as l is, even or odd, and by the others.
      const C same = detail::times(Number(detail::swap_sign(l, parity, k)), in[l + k]);
      const C other = detail::times(Number(k > 0 ? detail::swap_sign(l, 1 - parity, k) : 0), in[l - k]);
      const C &even = parity == 0 ? same : other, &odd = parity == 0 ? other : same;
      if (is_even_in_z(l, k)) {
        add_row(k, even, odd, [&](int m) -> C& { return out[l + m]; });
      } else {
        add_row(k, even, odd, [&](int m) -> C& { return out[l - m]; });
      }
    }
    for (int m = 2; m <= l; ++m) {
      if (detail::swap_sign(m) > 0) continue;
      out[l + m] = detail::times(Number(-1), out[l + m]);
      out[l - m] = detail::times(Number(-1), out[l - m]);
    }
  }

 private:
  template <class C, class At>
  void add_row(int k, const C& even, const C& odd, const At& at) const {
    const T* const row = entries_.data() + static_cast<std::size_t>(k) * static_cast<std::size_t>(degree_ + 1);
    for (int m = 0; m + 1 <= degree_; m += 2) {
      detail::add_times(at(m), row[m], even);
      detail::add_times(at(m + 1), row[m + 1], odd);
    }
    if (degree_ % 2 == 0) detail::add_times(at(degree_), row[degree_], even);
  }
  // v_l of m = 0; from that of the degree before where it is known.
  void find_corner(int l) {
    if (corner_degree_ > l) corner_degree_ = 0, corner_ = 1 / detail::swap_of_zero;
    while (corner_degree_ < l) corner_ = detail::next_swap_corner(++corner_degree_, corner_);
  }
  void next_row(int l, double of_next, double of_second) {
    double* __restrict const last = last_.data();
    double* __restrict const second = second_.data();
    for (int m = 0; m <= l; ++m) {
      const double next = of_next * m * last[m] - of_second * second[m];
      second[m] = last[m];
      last[m] = next;
    }
  }

  int degree_ = 0, corner_degree_ = 0;
  long double corner_ = 1 / detail::swap_of_zero;
  std::vector<T> entries_;
  std::vector<double> last_, second_;
};

/// A rotation, or a rotation and a reflection, prepared for N bands.
template <class T>
class ManyRotation {
 public:
  /// Of a Rotation of any number of bands, which can be made of axes, quaternions or angles: Rotation<2, T>.
  template <int M>
  ManyRotation(int bands, const Rotation<M, T>& rotation)
      : turns_{of(bands, rotation.turn(0)), of(bands, rotation.turn(1)), of(bands, rotation.turn(2))},
        parity_(rotation.parity()) {
    static_assert(M >= 2, "a Rotation of one band tells nothing");
    detail::check_bands(bands, greatest_rotation_bands<T>, "ManyRotation");
  }
  int bands() const { return turns_[0].bands(); }

  /// Degree l of a function, orders -l to l; `swap` is set to this degree, `row` has room for 2l+1.
  template <class C>
  void rotate_degree(int l, const SwapOfDegree<T>& swap, const C* in, C* row, C* out) const {
    turns_[0].turn_degree(l, in, out);
    swap.apply(out, row);
    turns_[1].turn_degree(l, row, row);
    swap.apply(row, out);
    turns_[2].turn_degree(l, out, out);
    if (l % 2 == 0 || parity_ > T(0)) return;
    for (int i = 0; i <= 2 * l; ++i) out[i] = detail::times(detail::number_t<C>(-1), out[i]);
  }

 private:
  template <int M>
  static ManyTurn<T> of(int bands, const TurnAboutZ<M, T>& turn) {
    return ManyTurn<T>(bands, turn.cosine[1], turn.sine[1]);
  }
  ManyTurn<T> turns_[3];
  T parity_;
};

/// `count` functions of N*N coefficients, one after the other, rotated: N^3 multiplications each, and N^3/3 for the
/// exchange of y and z. `row` has room for 2N-1. Not in place.
template <class C, class T>
void rotate(const C* f, int count, const ManyRotation<T>& rotation, SwapOfDegree<T>& swap, C* row, C* to) {
  const int n = rotation.bands();
  const auto size = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
  for (int l = 0; l < n; ++l) {
    swap.set_degree(l);
    for (std::size_t i = static_cast<std::size_t>(l * l); i < size * static_cast<std::size_t>(count); i += size) {
      rotation.rotate_degree(l, swap, f + i, row, to + i);
    }
  }
}
template <class C, class T>
ManySh<C> rotate(const ManySh<C>& f, const ManyRotation<T>& rotation) {
  if (f.bands() != rotation.bands()) detail::refuse("rotate: the rotation is prepared for another number of bands");
  SwapOfDegree<T> swap(f.bands());
  std::vector<C> row(static_cast<std::size_t>(2 * f.bands() - 1), detail::zero<C>(0));
  ManySh<C> r(f.bands());
  rotate(f.data(), 1, rotation, swap, row.data(), r.data());
  return r;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
