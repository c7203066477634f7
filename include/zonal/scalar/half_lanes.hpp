// Many half floats to floats and back, by the target's own instructions where it has them: to the bit what to_float and
// to_half give, but for what is no number.
#pragma once

#include <cstddef>

#include "half.hpp"
#include "lanes.hpp"

// All processors with AVX2 have the conversions too.
#if defined(ZONAL_COMPILER_VECTORS) && defined(__AVX2__) && defined(__F16C__)
#include <immintrin.h>
#define ZONAL_HALF_REGISTERS
#endif

// GCC 12 takes the undefined register inside its own AVX-512 intrinsics for a mistake (GCC bug 105593).
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// Pairs of halves that lie in one word each: the first of each pair, and the second. Halves pass through shuffles in
// pairs, in half the number of them.
using HalfPairs = Lanes<float, kNativeLanes>;
struct SplitPairs {
  Lanes<float, kNativeLanes> first, second;
};

#if defined(ZONAL_HALF_REGISTERS) && defined(__AVX512BW__)
ZONAL_INLINE inline SplitPairs split(const HalfPairs& pairs) {
  const __m512i order = _mm512_set_epi16(31, 29, 27, 25, 23, 21, 19, 17, 15, 13, 11, 9, 7, 5, 3, 1, 30, 28, 26, 24, 22,
                                         20, 18, 16, 14, 12, 10, 8, 6, 4, 2, 0);
  const __m512i parted = _mm512_permutexvar_epi16(order, pairs.as<__m512i>());
  return {HalfPairs::from(_mm512_cvtph_ps(_mm512_castsi512_si256(parted))),
          HalfPairs::from(_mm512_cvtph_ps(_mm512_extracti64x4_epi64(parted, 1)))};
}
ZONAL_INLINE inline HalfPairs join(const HalfPairs& first, const HalfPairs& second) {
  constexpr int to_nearest = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC;
  const __m512i order = _mm512_set_epi16(31, 15, 30, 14, 29, 13, 28, 12, 27, 11, 26, 10, 25, 9, 24, 8, 23, 7, 22, 6, 21,
                                         5, 20, 4, 19, 3, 18, 2, 17, 1, 16, 0);
  const __m256i low = _mm512_cvtps_ph(first.as<__m512>(), to_nearest);
  const __m256i high = _mm512_cvtps_ph(second.as<__m512>(), to_nearest);
  return HalfPairs::from(_mm512_permutexvar_epi16(order, _mm512_inserti64x4(_mm512_castsi256_si512(low), high, 1)));
}
#elif defined(ZONAL_HALF_REGISTERS) && !defined(__AVX512F__)
ZONAL_INLINE inline SplitPairs split(const HalfPairs& pairs) {
  const __m256i words = pairs.as<__m256i>();
  const __m256i parted = _mm256_permute4x64_epi64(
      _mm256_packus_epi32(_mm256_and_si256(words, _mm256_set1_epi32(0xffff)), _mm256_srli_epi32(words, 16)), 0xd8);
  return {HalfPairs::from(_mm256_cvtph_ps(_mm256_castsi256_si128(parted))),
          HalfPairs::from(_mm256_cvtph_ps(_mm256_extracti128_si256(parted, 1)))};
}
ZONAL_INLINE inline HalfPairs join(const HalfPairs& first, const HalfPairs& second) {
  constexpr int to_nearest = _MM_FROUND_TO_NEAREST_INT;
  const __m128i low = _mm256_cvtps_ph(first.as<__m256>(), to_nearest);
  const __m128i high = _mm256_cvtps_ph(second.as<__m256>(), to_nearest);
  const __m256i words = _mm256_cvtepu16_epi32(low), shifted = _mm256_slli_epi32(_mm256_cvtepu16_epi32(high), 16);
  return HalfPairs::from(_mm256_or_si256(words, shifted));
}
#else
ZONAL_INLINE inline SplitPairs split(const HalfPairs& pairs) {
  Half halves[2 * kNativeLanes];
  float words[kNativeLanes], first[kNativeLanes], second[kNativeLanes];
  pairs.store(words);
  std::memcpy(halves, words, sizeof halves);
  for (int i = 0; i < kNativeLanes; ++i) first[i] = to_float(halves[2 * i]), second[i] = to_float(halves[2 * i + 1]);
  return {HalfPairs::load(first), HalfPairs::load(second)};
}
ZONAL_INLINE inline HalfPairs join(const HalfPairs& first, const HalfPairs& second) {
  Half halves[2 * kNativeLanes];
  float words[kNativeLanes], a[kNativeLanes], b[kNativeLanes];
  first.store(a), second.store(b);
  for (int i = 0; i < kNativeLanes; ++i) halves[2 * i] = to_half(a[i]), halves[2 * i + 1] = to_half(b[i]);
  std::memcpy(words, halves, sizeof halves);
  return HalfPairs::load(words);
}
#endif

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal

#undef ZONAL_HALF_REGISTERS
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
