// The basis at a direction, degree after degree, all orders of a degree in one loop.
//
// The unrolled kernel (basis/evaluate.hpp) has a recurrence in z. Next to a pole its errors grow as l^2: 3e-11 at
// degree 1000 in double. Here each q_l^m is a sum of differences (basis/difference_step.hpp), in t = 1 - |z|, which
// comes from x and y: with d normalised as q,
//
//   n = (l-m-1) d_(l-1) - (2l-1) t q_(l-1),   q_l = g ((l+m) q_(l-1) + n),   d_l = g n,   g = g_l^m
//
// and what is left is less than 1e-13 at degree 1000, most of it by the direction's length, which rounding has left
// next to 1, to the m-th power. z < 0 changes the sign where l+m is odd.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

#include "../basis/evaluate.hpp"
#include "../scalar/lanes.hpp"
#include "coefficients.hpp"
#include "many_bands.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What evaluating N bands writes into, so that kernels allocate nothing: one for each thread.
template <class T>
class BasisSpace {
 public:
  explicit BasisSpace(int bands) : bands_(bands), numbers_(8 * row_size()) {}
  int bands() const { return bands_; }

  /// By order, 0 <= m < N and to the end of a block: q_l^m, d_l^m, and the powers' real and imaginary parts.
  T* q() { return row(0); }
  T* d() { return row(1); }
  T* real() { return row(2); }
  T* imaginary() { return row(3); }
  /// Y_l^m by m, two rows by turns.
  T* values(int l) { return row(l % 2 == 0 ? 5 : 7); }
  void clear() { std::fill(row(0), row(8), T(0)); }

 private:
  // Room for what is computed beyond the last order, and for the next order of it.
  std::size_t row_size() const {
    return static_cast<std::size_t>(detail::whole_blocks(bands_ + 1) + detail::order_block);
  }
  T* row(std::size_t i) { return numbers_.data() + i * row_size(); }

  int bands_;
  std::vector<T> numbers_;
};

namespace detail {

// Orders side by side in a register, in the order of their row or the other way round.
template <class T>
using RowLanes = Lanes<T, (native_lanes_v<T> * sizeof(T) > 32 ? 32 / static_cast<int>(sizeof(T)) : native_lanes_v<T>)>;
template <int width>
struct ReversedLanes {
  static constexpr int at(int lane) { return width - 1 - lane; }
};
template <class T>
inline constexpr T first_orders[order_block] = {0, 1, 2, 3, 4, 5, 6, 7};

// power_scale (x + iy)^m for 0 <= m < count, each from that of the block before it.
template <class T>
void scaled_powers(T x, T y, int count, T* c, T* s) {
  using L = RowLanes<T>;
  T real = power_scale<T>(), imaginary = T(0), block_real = T(1), block_imaginary = T(0);
  for (int m = 0; m < L::width; ++m) {
    c[m] = real, s[m] = imaginary;
    turn(x, y, real, imaginary);
    turn(x, y, block_real, block_imaginary);
  }
  L next_c = L::load(c), next_s = L::load(s);
  for (int m = L::width; m < count; m += L::width) {
    turn(L(block_real), L(block_imaginary), next_c, next_s);
    next_c.store(c + m);
    next_s.store(s + m);
  }
}

// Degree l from the one before: q and d, and the values, of Y_l^m to row[m], of Y_l^-m to row[-m]. Orders beyond l keep
// their diagonal for q and 0 for d.
template <class T>
void advance_degree(int l, const T* g, T t, T sign, const T* c, const T* s, T* q, T* d, T* row) {
  using L = RowLanes<T>;
  const L orders = L::load(first_orders<T>), of_sum(2 * l - 1), t_lanes(t), sign_lanes(sign);
  for (int m = 0; m <= l; m += L::width) {
    const L last = L::load(q + m), scale = sign_lanes * L::load(g + m);
    const L n = next_difference(L(l - 1 - m) - orders, of_sum, t_lanes, last, L::load(d + m));
    const L next = L::select(orders < L(l - m), scale * ((L(l + m) + orders) * last + n), last);
    next.store(q + m);
    (scale * n).store(d + m);
    const L down = next * L::load(s + m);
    L::template shuffle<ReversedLanes<L::width>>(down, down).store(row - m - (L::width - 1));
    (next * L::load(c + m)).store(row + m);  // the second of the two has row[0]
  }
}
}  // namespace detail

/// visit(l, row) for the degrees 0 to N-1, one after the other, at a unit vector: row[m] = Y_l^m, -l <= m <= l, until
/// the degree after the next. All that others are made of, in memory for a few rows. `direction` is anything with v[0],
/// v[1], v[2], or v.x, v.y, v.z.
template <class T, class Direction, class Visit>
void visit_degrees(const ManyBands<T>& bands, const Direction& direction, BasisSpace<T>& space, Visit&& visit) {
  const auto v = detail::as_direction<T>(direction);
  assert(detail::is_unit<T>(v.x, v.y, v.z));
  assert(space.bands() >= bands.bands());
  const T t = (v.x * v.x + v.y * v.y) / (T(1) + abs(v.z)), sign = v.z < T(0) ? T(-1) : T(1);
  space.clear();
  std::copy(bands.diagonal(), bands.diagonal() + bands.bands(), space.q());
  detail::scaled_powers(v.x, v.y, bands.bands(), space.real(), space.imaginary());
  for (int l = 0; l < bands.bands(); ++l) {
    T* const row = space.values(l);
    detail::advance_degree(l, bands.scale_of_degree(l), t, sign, space.real(), space.imaginary(), space.q(), space.d(),
                           row);
    visit(l, static_cast<const T*>(row));
  }
}

/// N*N values to `values`, in the order l(l+1)+m.
template <class T, class Direction>
void evaluate(const ManyBands<T>& bands, const Direction& direction, BasisSpace<T>& space, T* values) {
  visit_degrees(bands, direction, space,
                [values](int l, const T* row) { std::copy(row - l, row + l + 1, values + l * l); });
}
template <class T, class Direction>
ManySh<T> evaluate(const ManyBands<T>& bands, const Direction& direction) {
  BasisSpace<T> space(bands.bands());
  ManySh<T> sh(bands.bands());
  evaluate(bands, direction, space, sh.data());
  return sh;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
