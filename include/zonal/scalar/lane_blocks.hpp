// Lanes to and from numbers that lie otherwise: triples, rows, and memory that the caches need not hold.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lanes.hpp"

#if defined(ZONAL_COMPILER_VECTORS) && defined(__AVX__)
#include <immintrin.h>
#elif defined(ZONAL_COMPILER_VECTORS) && defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// Numbers that shuffles move about by themselves: 16 bytes. Wider registers are several of these.
template <class T>
inline constexpr int chunk_v = static_cast<int>(16 / sizeof(T));

// Past the caches, where the target can: `target` is aligned to all lanes. Then finish_streams().
template <class T, int width>
ZONAL_INLINE inline void stream(const Lanes<T, width>& lanes, T* target) {
  [[maybe_unused]] constexpr auto bytes = sizeof(lanes);
#if defined(ZONAL_COMPILER_VECTORS) && defined(__AVX512F__)
  if constexpr (bytes == 64)
    return _mm512_stream_si512(reinterpret_cast<__m512i*>(target), lanes.template as<__m512i>());
#endif
#if defined(ZONAL_COMPILER_VECTORS) && defined(__AVX__)
  if constexpr (bytes == 32)
    return _mm256_stream_si256(reinterpret_cast<__m256i*>(target), lanes.template as<__m256i>());
#endif
#if defined(ZONAL_COMPILER_VECTORS) && defined(__SSE2__)
  if constexpr (bytes == 16) return _mm_stream_si128(reinterpret_cast<__m128i*>(target), lanes.template as<__m128i>());
#endif
  lanes.store(target);
}
inline void finish_streams() {
#if defined(ZONAL_COMPILER_VECTORS) && defined(__SSE2__)
  _mm_sfence();
#endif
}

// Chunks that stand `stride` numbers apart, side by side.
template <class T, int width>
ZONAL_INLINE inline Lanes<T, width> load_chunks(const T* source, std::size_t stride) {
  constexpr int chunks = width / chunk_v<T>;
  const auto chunk = [&](std::size_t i) ZONAL_INLINE { return source + i * stride; };
#if defined(ZONAL_COMPILER_VECTORS) && defined(__AVX512F__)
  if constexpr (chunks == 4) {
    __m512 r = _mm512_castps128_ps512(_mm_loadu_ps(reinterpret_cast<const float*>(chunk(0))));
    r = _mm512_insertf32x4(r, _mm_loadu_ps(reinterpret_cast<const float*>(chunk(1))), 1);
    r = _mm512_insertf32x4(r, _mm_loadu_ps(reinterpret_cast<const float*>(chunk(2))), 2);
    r = _mm512_insertf32x4(r, _mm_loadu_ps(reinterpret_cast<const float*>(chunk(3))), 3);
    return Lanes<T, width>::from(r);
  }
#endif
#if defined(ZONAL_COMPILER_VECTORS) && defined(__AVX__)
  if constexpr (chunks == 2) {
    const __m256 low = _mm256_castps128_ps256(_mm_loadu_ps(reinterpret_cast<const float*>(chunk(0))));
    return Lanes<T, width>::from(_mm256_insertf128_ps(low, _mm_loadu_ps(reinterpret_cast<const float*>(chunk(1))), 1));
  }
#endif
  if constexpr (chunks == 1) {
    return Lanes<T, width>::load(source);
  } else {
    T numbers[static_cast<std::size_t>(width)];
    for (int i = 0; i < width; ++i) numbers[i] = chunk(std::size_t(i / chunk_v<T>))[i % chunk_v<T>];
    return Lanes<T, width>::load(numbers);
  }
}

// In each chunk, `unit` numbers of a and of b by turns, from the lower or the upper half of both.
template <class T, int width, int unit, bool is_upper>
struct Interleaved {
  static constexpr int at(int lane) {
    constexpr int chunk = chunk_v<T>;
    const int place = lane % chunk, pair = place / unit;
    return lane - place + (is_upper ? chunk / 2 : 0) + pair / 2 * unit + place % unit + (pair % 2 == 0 ? 0 : width);
  }
};

// `width` columns of numbers, `height` apart in memory, to as many rows as a chunk has numbers, of `width` numbers
// each.
template <class T, int width>
ZONAL_INLINE inline void transpose_chunk(const T* columns, std::size_t height, T* rows, std::size_t row_stride) {
  using L = Lanes<T, width>;
  constexpr int chunk = chunk_v<T>;
  static_assert(chunk == 4 || chunk == 2, "floats or doubles");
  L r[static_cast<std::size_t>(chunk)];
  for (int i = 0; i < chunk; ++i) {
    r[i] = load_chunks<T, width>(columns + std::size_t(i) * height, chunk * height);
  }
  if constexpr (chunk == 2) {
    L::template shuffle<Interleaved<T, width, 1, false>>(r[0], r[1]).store(rows);
    L::template shuffle<Interleaved<T, width, 1, true>>(r[0], r[1]).store(rows + row_stride);
  } else {
    using Low1 = Interleaved<T, width, 1, false>;
    using High1 = Interleaved<T, width, 1, true>;
    using Low2 = Interleaved<T, width, 2, false>;
    using High2 = Interleaved<T, width, 2, true>;
    const L a = L::template shuffle<Low1>(r[0], r[1]), b = L::template shuffle<High1>(r[0], r[1]);
    const L c = L::template shuffle<Low1>(r[2], r[3]), d = L::template shuffle<High1>(r[2], r[3]);
    L::template shuffle<Low2>(a, c).store(rows);
    L::template shuffle<High2>(a, c).store(rows + row_stride);
    L::template shuffle<Low2>(b, d).store(rows + 2 * row_stride);
    L::template shuffle<High2>(b, d).store(rows + 3 * row_stride);
  }
}

// In each chunk of four floats: two of a, then two of b.
template <int width, int first, int second, int third, int fourth>
struct TwoAndTwo {
  static constexpr int at(int lane) {
    constexpr int from[] = {first, second, width + third, width + fourth};
    return lane / 4 * 4 + from[lane % 4];
  }
};

// The x, y and z of `width` triples, by shuffles within chunks: a = x0 y0 z0 x1, b = y1 z1 x2 y2, c = z2 x3 y3 z3.
template <int width>
ZONAL_INLINE inline void load_triples(const float* triples, Lanes<float, width> (&v)[3]) {
  using L = Lanes<float, width>;
  const L a = load_chunks<float, width>(triples, 12), b = load_chunks<float, width>(triples + 4, 12);
  const L c = load_chunks<float, width>(triples + 8, 12);
  const L xy = L::template shuffle<TwoAndTwo<width, 2, 3, 1, 2>>(b, c);
  const L yz = L::template shuffle<TwoAndTwo<width, 1, 2, 0, 1>>(a, b);
  v[0] = L::template shuffle<TwoAndTwo<width, 0, 3, 0, 2>>(a, xy);
  v[1] = L::template shuffle<TwoAndTwo<width, 0, 2, 1, 3>>(yz, xy);
  v[2] = L::template shuffle<TwoAndTwo<width, 1, 3, 0, 3>>(yz, c);
}

// Chunks to places `stride` numbers apart.
template <class T, int width>
ZONAL_INLINE inline void store_chunks(const Lanes<T, width>& lanes, T* target, std::size_t stride) {
  constexpr int chunk = chunk_v<T>;
  T numbers[static_cast<std::size_t>(width)];
  lanes.store(numbers);
  for (int i = 0; i < width / chunk; ++i) {
    Lanes<T, chunk>::load(numbers + i * chunk).store(target + std::size_t(i) * stride);
  }
}
// load_triples the other way.
template <int width>
ZONAL_INLINE inline void store_triples(const Lanes<float, width> (&v)[3], float* triples) {
  using L = Lanes<float, width>;
  using Even = TwoAndTwo<width, 0, 2, 0, 2>;
  const L x0_x1_y0_y1 = L::template shuffle<TwoAndTwo<width, 0, 1, 0, 1>>(v[0], v[1]);
  const L z0_z1_x1_x3 = L::template shuffle<TwoAndTwo<width, 0, 1, 1, 3>>(v[2], v[0]);
  const L y1_y3_z1_z2 = L::template shuffle<TwoAndTwo<width, 1, 3, 1, 2>>(v[1], v[2]);
  const L x2_x3_y2_y3 = L::template shuffle<TwoAndTwo<width, 2, 3, 2, 3>>(v[0], v[1]);
  const L z2_z3_x3_x3 = L::template shuffle<TwoAndTwo<width, 2, 3, 3, 3>>(v[2], v[0]);
  const L y3_y3_z3_z3 = L::template shuffle<TwoAndTwo<width, 3, 3, 3, 3>>(v[1], v[2]);
  store_chunks(L::template shuffle<Even>(x0_x1_y0_y1, z0_z1_x1_x3), triples, 12);
  store_chunks(L::template shuffle<Even>(y1_y3_z1_z2, x2_x3_y2_y3), triples + 4, 12);
  store_chunks(L::template shuffle<Even>(z2_z3_x3_x3, y3_y3_z3_z3), triples + 8, 12);
}

// The widest registers, up to `width` numbers, that `Size` numbers fill.
template <int Size>
constexpr int widest_within(int width) {
  return width <= Size ? width : widest_within<Size>(width / 2);
}

// `Size` columns of `width` numbers to `width` rows of `Size` numbers, in registers of w. The last registers of a row
// overlap those before.
template <int Size, int width, class T, int w = widest_within<Size>(native_lanes_v<T>)>
ZONAL_INLINE inline void transpose(const T* columns, T* rows) {
  constexpr int chunk = chunk_v<T>, native = native_lanes_v<T>;
  if constexpr (Size == 1 && width == native) {
    Lanes<T, native>::load(columns).store(rows);
  } else if constexpr (w < chunk || width % chunk != 0) {
    for (int lane = 0; lane < width; ++lane) {
      for (int i = 0; i < Size; ++i) rows[lane * Size + i] = columns[i * width + lane];
    }
  } else {
    for (int i = 0; i < Size; i += w) {
      const int begin = i < Size - w ? i : Size - w;
      for (int lane = 0; lane < width; lane += chunk) {
        transpose_chunk<T, w>(columns + begin * width + lane, std::size_t(width), rows + lane * Size + begin,
                              std::size_t(Size));
      }
    }
  }
}

template <class T>
inline void copy(const T* source, std::size_t size, T* target) {
  constexpr std::size_t width = native_lanes_v<T>;
  std::size_t i = 0;
  for (; i + width <= size; i += width) Lanes<T, int(width)>::load(source + i).store(target + i);
  for (; i < size; ++i) target[i] = source[i];
}
// The same past the caches, but for the few before and after whole registers of the target. Then finish_streams().
template <class T>
inline void copy_past_caches(const T* source, std::size_t size, T* target) {
  constexpr std::size_t width = native_lanes_v<T>;
  std::size_t i = 0;
  for (; i < size && reinterpret_cast<std::uintptr_t>(target + i) % (width * sizeof(T)) != 0; ++i)
    target[i] = source[i];
  for (; i + width <= size; i += width) stream(Lanes<T, int(width)>::load(source + i), target + i);
  for (; i < size; ++i) target[i] = source[i];
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
