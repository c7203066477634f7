// Floats side by side in the compiler's own vectors, for sums over arrays: no Eigen, and next to nothing to compile.
// What a kernel runs on is a Packet (packet.hpp), which is a scalar with all that one can do.
#pragma once

#include <cstddef>

#include "scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Floats in one register of the target this file is compiled for: 16 with AVX-512, 8 with AVX, else 4.
#if defined(__AVX512F__)
inline constexpr int kNativeLanes = 16;
#elif defined(__AVX__)
inline constexpr int kNativeLanes = 8;
#else
inline constexpr int kNativeLanes = 4;
#endif

/// `lanes` consecutive floats of an array: a power of 2, up to kNativeLanes.
template <int lanes>
class FloatLanes {
 public:
  ZONAL_INLINE static FloatLanes filled(float x) {
    FloatLanes filled;
#if defined(__GNUC__)
    filled.values_ = x - Vector{};
#else
    for (float& value : filled.values_.floats) value = x;
#endif
    return filled;
  }
  /// `source` and `target` may have any alignment.
  ZONAL_INLINE static FloatLanes load(const float* source) {
    FloatLanes x;
    x.values_ = *reinterpret_cast<const InMemory*>(source);
    return x;
  }
  ZONAL_INLINE void store(float* target) const { *reinterpret_cast<InMemory*>(target) = values_; }

  /// *this += a * b, in one rounding where the target has such an operation.
  ZONAL_INLINE void add_product(const FloatLanes& a, const FloatLanes& b) {
#if defined(__GNUC__)
    values_ += a.values_ * b.values_;
#else
    for (int i = 0; i < lanes; ++i) values_.floats[i] += a.values_.floats[i] * b.values_.floats[i];
#endif
  }

 private:
#if defined(__GNUC__)
  typedef float Vector __attribute__((vector_size(lanes * sizeof(float))));
  // Where any floats stand. (A memcpy to and from it costs GCC registers.)
  typedef float InMemory __attribute__((vector_size(lanes * sizeof(float)), aligned(alignof(float)), may_alias));
#else
  struct Vector {
    float floats[lanes];
  };
  using InMemory = Vector;
#endif
  Vector values_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
