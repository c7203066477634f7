// Numbers side by side in one of the compiler's own vectors: next to nothing to compile. They are a scalar for kernels
// that add, subtract and multiply only, as the basis does; one with all that a scalar can do, of any number of lanes,
// is the Packet (packet.hpp).
#pragma once

#include <cstddef>
#include <utility>

#include "colour.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

// The compiler's own vectors; nvcc knows them, but not all that is done with them.
#if defined(__GNUC__) && !defined(__CUDACC__)
#define ZONAL_COMPILER_VECTORS
inline constexpr bool kLanesAreRegisters = true;
#else
inline constexpr bool kLanesAreRegisters = false;
#endif

/// Floats in one register of the target this file is compiled for: 16 with AVX-512, 8 with AVX, else 4.
#if defined(__AVX512F__)
inline constexpr int kNativeLanes = 16;
#elif defined(__AVX__)
inline constexpr int kNativeLanes = 8;
#else
inline constexpr int kNativeLanes = 4;
#endif

/// The same for any built-in type: half as many doubles.
template <class T>
inline constexpr int native_lanes_v = static_cast<int>(kNativeLanes * sizeof(float) / sizeof(T));

/// `count` numbers of a built-in type T: a power of 2, up to what one register holds.
template <class T, int count>
class Lanes {
  static_assert(is_builtin_scalar_v<T> && count >= 1 && (count & (count - 1)) == 0, "2, 4, 8 ... built-in scalars");
  static constexpr auto bytes = static_cast<std::size_t>(count) * sizeof(T);

 public:
#if defined(ZONAL_COMPILER_VECTORS)
  typedef T Vector __attribute__((vector_size(bytes)));
  // Where any numbers stand. (A memcpy to and from it costs GCC registers.)
  typedef T InMemory __attribute__((vector_size(bytes), aligned(alignof(T)), may_alias));
  /// What comparing two gives: in each lane all bits set, or none.
  using Mask = decltype(Vector{} < Vector{});
#else
  struct Vector {
    T numbers[count];
    T& operator[](int i) { return numbers[i]; }
    const T& operator[](int i) const { return numbers[i]; }
  };
  using InMemory = Vector;
  struct Mask {
    bool holds[count];
  };
#endif
  static constexpr int width = count;

  Lanes() = default;
  template <class C, class = std::enable_if_t<std::is_arithmetic_v<C>>>
  ZONAL_INLINE explicit Lanes(C constant) {
#if defined(ZONAL_COMPILER_VECTORS)
    values_ = static_cast<T>(constant) - Vector{};
#else
    for (T& number : values_.numbers) number = static_cast<T>(constant);
#endif
  }
  /// `source` and `target` may have any alignment.
  ZONAL_INLINE static Lanes load(const T* source) {
    Lanes x;
    x.values_ = *reinterpret_cast<const InMemory*>(source);
    return x;
  }
  ZONAL_INLINE void store(T* target) const { *reinterpret_cast<InMemory*>(target) = values_; }
  ZONAL_INLINE explicit Lanes(const Vector& values) : values_(values) {}
  ZONAL_INLINE const Vector& vector() const { return values_; }
#if defined(ZONAL_COMPILER_VECTORS)
  /// The same bits as another of the compiler's own vector types, and back.
  template <class V>
  ZONAL_INLINE V as() const {
    return reinterpret_cast<V>(values_);
  }
  template <class V>
  ZONAL_INLINE static Lanes from(V vector) {
    return Lanes(reinterpret_cast<Vector>(vector));
  }
#endif

#if defined(ZONAL_COMPILER_VECTORS)
  /// *this += a * b, fused where the compiler may: clang++ does so within one expression only.
  ZONAL_INLINE void add_product(const Lanes& a, const Lanes& b) { values_ = values_ + a.values_ * b.values_; }
  ZONAL_INLINE friend Lanes operator-(const Lanes& a) { return Lanes(-a.values_); }
  ZONAL_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.values_ + b.values_); }
  ZONAL_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.values_ - b.values_); }
  ZONAL_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.values_ * b.values_); }
  ZONAL_INLINE friend Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.values_ / b.values_); }
  ZONAL_INLINE friend Lanes abs(const Lanes& a) {
    return from(reinterpret_cast<Mask>(a.values_) & ~reinterpret_cast<Mask>(-Vector{}));  // all but the sign
  }
  ZONAL_INLINE friend Mask operator<(const Lanes& a, const Lanes& b) { return a.values_ < b.values_; }
  ZONAL_INLINE friend Mask operator<=(const Lanes& a, const Lanes& b) { return a.values_ <= b.values_; }
  ZONAL_INLINE static Lanes select(const Mask& mask, const Lanes& a, const Lanes& b) {
    return Lanes(mask ? a.values_ : b.values_);
  }
#else
  void add_product(const Lanes& a, const Lanes& b) { *this = *this + a * b; }
  friend Lanes operator-(const Lanes& a) {
    return map(a, a, [](T x, T) { return -x; });
  }
  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return map(a, b, [](T x, T y) { return x + y; });
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return map(a, b, [](T x, T y) { return x - y; });
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return map(a, b, [](T x, T y) { return x * y; });
  }
  friend Lanes operator/(const Lanes& a, const Lanes& b) {
    return map(a, b, [](T x, T y) { return x / y; });
  }
  friend Lanes abs(const Lanes& a) {
    return map(a, a, [](T x, T) { return x > T(0) ? x : T(0) - x; });
  }
  friend Mask operator<(const Lanes& a, const Lanes& b) {
    Mask r;
    for (int i = 0; i < count; ++i) r.holds[i] = a.values_[i] < b.values_[i];
    return r;
  }
  friend Mask operator<=(const Lanes& a, const Lanes& b) {
    Mask r;
    for (int i = 0; i < count; ++i) r.holds[i] = a.values_[i] <= b.values_[i];
    return r;
  }
  static Lanes select(const Mask& mask, const Lanes& a, const Lanes& b) {
    Lanes r;
    for (int i = 0; i < count; ++i) r.values_[i] = mask.holds[i] ? a.values_[i] : b.values_[i];
    return r;
  }
#endif

  /// Lane i is number at(i) of a's lanes followed by b's: At::at is constexpr.
  template <class At>
  ZONAL_INLINE static Lanes shuffle(const Lanes& a, const Lanes& b) {
    return shuffle<At>(a, b, std::make_integer_sequence<int, count>{});
  }

 private:
#if defined(ZONAL_COMPILER_VECTORS)
  template <class At, int... i>
  ZONAL_INLINE static Lanes shuffle(const Lanes& a, const Lanes& b, std::integer_sequence<int, i...>) {
#if defined(__clang__)
    return Lanes(Vector(__builtin_shufflevector(a.values_, b.values_, At::at(i)...)));
#else
    using Number = std::conditional_t<sizeof(T) == sizeof(int), int, long long>;
    typedef Number Numbers __attribute__((vector_size(bytes)));
    return Lanes(__builtin_shuffle(a.values_, b.values_, Numbers{Number(At::at(i))...}));
#endif
  }
#else
  template <class F>
  static Lanes map(const Lanes& a, const Lanes& b, F f) {
    Lanes r;
    for (int i = 0; i < count; ++i) r.values_.numbers[i] = f(a.values_.numbers[i], b.values_.numbers[i]);
    return r;
  }
  template <class At, int... i>
  static Lanes shuffle(const Lanes& a, const Lanes& b, std::integer_sequence<int, i...>) {
    Lanes r;
    ((r.values_.numbers[i] = At::at(i) < count ? a.values_.numbers[At::at(i)] : b.values_.numbers[At::at(i) - count]),
     ...);
    return r;
  }
#endif
  Vector values_;
};

template <class T, int count>
struct ScalarTraits<Lanes<T, count>> {
  using Lane = T;
};
namespace detail {
template <class T, int count>
inline constexpr bool is_colour_v<Lanes<T, count>> = false;  // though they have no order
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
