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

/// N bands, N*N coefficients in the order l(l+1)+m, as Sh has them: f[i], f(l, m) (asserted in debug builds), data().
/// T is a number, or a colour. Black at first.
template <class T>
class ManySh {
 public:
  explicit ManySh(int bands) : bands_(bands) {
    if (bands < 1) detail::refuse("a ManySh has at least one band");
    values_.assign(static_cast<std::size_t>(bands) * static_cast<std::size_t>(bands), detail::zero<T>(0));
  }
  template <int N>
  explicit ManySh(const Sh<N, T>& sh) : bands_(N), values_(sh.begin(), sh.end()) {}

  int bands() const { return bands_; }
  int size() const { return static_cast<int>(values_.size()); }
  T* data() { return values_.data(); }
  const T* data() const { return values_.data(); }
  T* begin() { return data(); }
  T* end() { return data() + size(); }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size(); }
  T& operator[](int i) { return values_[place(i)]; }
  const T& operator[](int i) const { return values_[place(i)]; }
  T& operator()(int l, int m) { return values_[place(l, m)]; }
  const T& operator()(int l, int m) const { return values_[place(l, m)]; }

 private:
  std::size_t place(int i) const {
    assert(0 <= i && i < size());
    return static_cast<std::size_t>(i);
  }
  std::size_t place(int l, int m) const {
    assert(0 <= l && l < bands_ && -l <= m && m <= l);
    return static_cast<std::size_t>(sh_index(l, m));
  }
  int bands_;
  std::vector<T> values_;
};

/// N zonal coefficients, as Zh has them: z[l].
template <class T>
class ManyZh {
 public:
  explicit ManyZh(int bands) {
    if (bands < 1) detail::refuse("a ManyZh has at least one band");
    values_.assign(static_cast<std::size_t>(bands), detail::zero<T>(0));
  }
  template <int N>
  explicit ManyZh(const Zh<N, T>& zh) : values_(zh.begin(), zh.end()) {}

  int bands() const { return size(); }
  int size() const { return static_cast<int>(values_.size()); }
  T* data() { return values_.data(); }
  const T* data() const { return values_.data(); }
  T* begin() { return data(); }
  T* end() { return data() + size(); }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size(); }
  T& operator[](int l) { return values_[place(l)]; }
  const T& operator[](int l) const { return values_[place(l)]; }

 private:
  std::size_t place(int l) const {
    assert(0 <= l && l < size());
    return static_cast<std::size_t>(l);
  }
  std::vector<T> values_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
