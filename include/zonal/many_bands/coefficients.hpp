// Coefficients of as many bands as the program finds out when it runs.
#pragma once

#include <cassert>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "../basis/sh.hpp"
#include "../scalar/refuse.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {
/// What both kinds of coefficients are: numbers or colours, [i] (asserted in debug builds), data(). Black at first.
template <class T>
class CoefficientVector {
 public:
  int size() const { return static_cast<int>(values_.size()); }
  T* data() { return values_.data(); }
  const T* data() const { return values_.data(); }
  T* begin() { return data(); }
  T* end() { return data() + size(); }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size(); }
  T& operator[](int i) { return values_[place(i)]; }
  const T& operator[](int i) const { return values_[place(i)]; }

 protected:
  CoefficientVector(int bands, bool is_zonal, const char* refusal) {
    if (bands < 1) refuse(refusal);
    const auto count = static_cast<std::size_t>(bands);
    values_.assign(is_zonal ? count : count * count, zero<T>(0));
  }
  CoefficientVector(const T* begin, const T* end) : values_(begin, end) {}

 private:
  std::size_t place(int i) const {
    assert(0 <= i && i < size());
    return static_cast<std::size_t>(i);
  }
  std::vector<T> values_;
};
}  // namespace detail

/// N bands, N*N coefficients in the order l(l+1)+m, as Sh has them, and f(l, m), asserted as well.
template <class T>
class ManySh : public detail::CoefficientVector<T> {
 public:
  explicit ManySh(int bands)
      : detail::CoefficientVector<T>(bands, false, "a ManySh has at least one band"), bands_(bands) {}
  template <int N>
  explicit ManySh(const Sh<N, T>& sh) : detail::CoefficientVector<T>(sh.begin(), sh.end()), bands_(N) {}

  int bands() const { return bands_; }
  T& operator()(int l, int m) { return (*this)[place(l, m)]; }
  const T& operator()(int l, int m) const { return (*this)[place(l, m)]; }

 private:
  int place(int l, int m) const {
    assert(0 <= l && l < bands_ && -l <= m && m <= l);
    return sh_index(l, m);
  }
  int bands_;
};

/// N zonal coefficients, as Zh has them: z[l].
template <class T>
class ManyZh : public detail::CoefficientVector<T> {
 public:
  explicit ManyZh(int bands) : detail::CoefficientVector<T>(bands, true, "a ManyZh has at least one band") {}
  template <int N>
  explicit ManyZh(const Zh<N, T>& zh) : detail::CoefficientVector<T>(zh.begin(), zh.end()) {}

  int bands() const { return this->size(); }
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
