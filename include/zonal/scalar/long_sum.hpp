// Sums of any number of terms whose rounding error does not grow with it.
//
// Terms are added up plainly in blocks of `terms_in_block`, and the blocks' sums by Kahan's compensated addition [1]:
// in kernels that sum, all but one addition in 64 stay what they were. With u half an epsilon and n terms x, to first
// order,
//
//   |computed - sum| <= (63 + 2) u sum |x|
//
// for every n below 1/u, and of lanes that are added at the end log2 of their number u more. One block's sum is the
// plain one, to the bit. -ffast-math takes the compensation away: then it is (64 + n/64) u.
//
// [1] Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., 2002, section 4.3.
#pragma once

#include <cstddef>
#include <vector>

#include "scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

inline constexpr int terms_in_block = 64;

/// A sum that keeps what each addition has rounded away.
template <class T>
class CompensatedSum {
 public:
  ZONAL_INLINE void add(const T& x) {
    const T owed = x - lost_, next = sum_ + owed;
    lost_ = (next - sum_) - owed;
    sum_ = next;
  }
  const T& value() const { return sum_; }

 private:
  T sum_ = T(0), lost_ = T(0);
};

/// The totals of many sums, as kernels hold them: of what has a member for_each_sum(visit), visit(T&). Takes no memory
/// before the first block is full.
template <class T>
class LongSums {
 public:
  /// Takes over what a block has summed up, which then is zero.
  template <class Sums>
  void take(Sums& sums) {
    std::size_t count = 0, i = 0;
    sums.for_each_sum([&](const T&) { ++count; });
    totals_.resize(count);
    sums.for_each_sum([&](T& sum) {
      totals_[i++].add(sum);
      sum = T(0);
    });
  }
  /// Adds the last block, and gives the totals back in its place.
  template <class Sums>
  void finish(Sums& sums) {
    if (totals_.empty()) return;
    take(sums);
    std::size_t i = 0;
    sums.for_each_sum([&](T& sum) { sum = totals_[i++].value(); });
    totals_.clear();
  }

 private:
  std::vector<CompensatedSum<T>> totals_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
