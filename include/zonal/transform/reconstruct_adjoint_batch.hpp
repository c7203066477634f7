// Many colours, each of coefficients of its own, with derivatives: what a step of training takes, of splats or probes.
// In the lanes of the target's registers, numbers in, numbers out, nothing allocated; threads take parts of the arrays.
//
// Coefficients stand direction by direction, N*N of them, RGB innermost: as arrays of Sh<N, glm::vec3> do, or those of
// 3D Gaussian splatting, in 32 or 16 bits. Everything is computed in float.
#pragma once

#include <cstddef>
#include <cstring>

#include "../basis/batch.hpp"
#include "../scalar/half_lanes.hpp"
#include "../scalar/packet.hpp"
#include "../scalar/prefetch.hpp"
#include "reconstruct_adjoint.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// `count` directions of any length but 0, 3 floats each, and 3 N*N coefficients each, floats or Halfs. For derivatives
/// also a loss's by the colours, 3 floats each.
template <class Number>
struct ColourBatch {
  const Number* sh;
  const float* directions;
  const float* by_value;
  std::size_t count;
};

/// Where the results go, in the same order and types; null where they are not asked for. By the coefficients they may
/// be in 16 bits: then what is below 6e-8 becomes 0, so scale a loss that is small.
template <class Number>
struct AdjointBatch {
  float* value;
  Number* by_sh;
  float* by_direction;
};

namespace detail {

// `size` numbers of as many directions as there are lanes: in rows, as memory has them, to columns for the lanes, and
// back. Halves are moved in pairs.
template <int size, class Number>
class RowBlock {
 public:
  using P = Packet<float, kNativeLanes>;

  // Lanes beyond the last repeat it.
  void read(const Number* source, std::size_t lanes) {
    const float* rows = in_words(source);
    if (lanes < width || words * per_word != size) {
      for (std::size_t lane = 0; lane < width; ++lane) {
        std::memcpy(rows_ + lane * words, source + (lane < lanes ? lane : lanes - 1) * size, row_bytes);
      }
      rows = rows_;
    }
    if constexpr (per_word == 1) {
      transpose<kNativeLanes, words>(rows, columns_);
    } else {
      transpose<kNativeLanes, words>(rows, pairs_);
      for (int i = 0; i < words; ++i) {
        const SplitPairs numbers = split(HalfPairs::load(pairs_ + i * kNativeLanes));
        numbers.first.store(columns_ + 2 * i * kNativeLanes);
        numbers.second.store(columns_ + (2 * i + 1) * kNativeLanes);
      }
    }
  }
  void write(Number* target, std::size_t lanes) {
    float* const columns = per_word == 1 ? columns_ : pairs_;
    // Registers that fill a row exactly: none is written twice.
    constexpr int w = words % kNativeLanes == 0 ? kNativeLanes : words % 8 == 0 ? 8 : 4;
    if (lanes == width && words * per_word == size) {
      return transpose<words, kNativeLanes, float, w>(columns, in_words(target));
    }
    transpose<words, kNativeLanes, float, w>(columns, rows_);
    for (std::size_t lane = 0; lane < lanes; ++lane) std::memcpy(target + lane * size, rows_ + lane * words, row_bytes);
  }
  P get(int i) const { return P::load(columns_ + i * kNativeLanes); }
  // All of them, in turn: a pair is joined as soon as it is complete.
  template <int i>
  ZONAL_INLINE void set(Index<i>, const P& lanes) {
    if constexpr (per_word == 1) {
      lanes.store(columns_ + i * kNativeLanes);
    } else if constexpr (i % 2 == 0) {
      first_ = lanes.lanes.values[0];
      if constexpr (i + 1 == size) join(first_, first_).store(pairs_ + i / 2 * kNativeLanes);
    } else {
      join(first_, lanes.lanes.values[0]).store(pairs_ + i / 2 * kNativeLanes);
    }
  }

 private:
  static constexpr std::size_t width = kNativeLanes, row_bytes = size * sizeof(Number);
  static constexpr int per_word = static_cast<int>(sizeof(float) / sizeof(Number));
  static constexpr int words = (size + 4 * per_word - 1) / (4 * per_word) * 4;  // of a row: whole chunks

  static const float* in_words(const Number* numbers) {
    return static_cast<const float*>(static_cast<const void*>(numbers));
  }
  static float* in_words(Number* numbers) { return static_cast<float*>(static_cast<void*>(numbers)); }

  alignas(cache_line) float rows_[width * words] = {};
  alignas(cache_line) float pairs_[per_word == 1 ? 1 : width * words] = {};
  HalfPairs first_{0};  // of a pair
  alignas(cache_line) float columns_[width * words * per_word] = {};
};

// The cache line of numbers[i], if it begins there, will soon be read. The processor by itself sees that too late: what
// is computed on a block takes as long as memory does to bring the next one.
template <std::size_t i, class Number>
ZONAL_INLINE inline void expect_line(const Number* numbers) {
  if constexpr (i * sizeof(Number) % cache_line == 0) prefetch(numbers + i);
}

// Three numbers each.
class TripleLanes {
 public:
  using P = Packet<float, kNativeLanes>;

  TripleLanes(const float* triples, std::size_t lanes) {
    const auto span = DirectionSpan<float>::triples(triples, lanes);
    if (lanes == kNativeLanes) {
      load_directions(span, 0, lanes_);
    } else {
      load_directions(FilledDirections<float, kNativeLanes>(span, 0).span(), 0, lanes_);
    }
  }
  explicit TripleLanes(const P (&packets)[3]) {
    for (int k = 0; k < 3; ++k) lanes_[k] = packets[k].lanes.values[0];
  }
  void write(float* target, std::size_t lanes) const {
    if (lanes == kNativeLanes) return store_triples(lanes_, target);
    float triples[3 * kNativeLanes];
    store_triples(lanes_, triples);
    for (std::size_t i = 0; i < 3 * lanes; ++i) target[i] = triples[i];
  }
  P operator[](int k) const { return P(typename P::Registers{{lanes_[k]}}); }

 private:
  Lanes<float, kNativeLanes> lanes_[3];
};

}  // namespace detail

/// reconstruct_with_adjoint of each, as colours of three channels. A direction's results do not depend on its place, to
/// the bit. (Stores past the caches take longer here: what is computed meanwhile waits for them.)
template <int N, ColourRule rule = ColourRule::plain, class In, class Out>
void reconstruct_with_adjoint(const ColourBatch<In>& batch, const AdjointBatch<Out>& results) {
  using P = Packet<float, kNativeLanes>;
  constexpr std::size_t width = kNativeLanes, size = 3 * N * N;
  detail::RowBlock<3 * N * N, In> sh;
  detail::RowBlock<3 * N * N, Out> by_sh;
  for (std::size_t first = 0; first < batch.count; first += width) {
    const std::size_t left = batch.count - first, lanes = left < width ? left : width;
    const In* const next = batch.sh + (left > width ? first + width : first) * size;
    sh.read(batch.sh + first * size, lanes);
    const detail::TripleLanes direction(batch.directions + 3 * first, lanes);
    const detail::TripleLanes by_value(batch.by_value + 3 * first, lanes);
    P value[3], by_direction[3];
    detail::reconstruct_with_adjoint<N, rule, 3, P>(
        {direction[0], direction[1], direction[2]}, [&](auto i, auto c) ZONAL_INLINE { return sh.get(3 * i + c); },
        {by_value[0], by_value[1], by_value[2]}, value, by_direction,
        [&](auto i, auto c, const P& derivative) ZONAL_INLINE {
          constexpr Index<3 * i + c> number;
          by_sh.set(number, derivative);
          detail::expect_line<number * width>(next);
        });
    if (results.by_sh != nullptr) by_sh.write(results.by_sh + first * size, lanes);
    if (results.value != nullptr) detail::TripleLanes(value).write(results.value + 3 * first, lanes);
    if (results.by_direction != nullptr) {
      detail::TripleLanes(by_direction).write(results.by_direction + 3 * first, lanes);
    }
  }
}

/// reconstruct_along of each: the colours alone, 3 floats each.
template <int N, ColourRule rule = ColourRule::plain, class In>
void reconstruct_along(const ColourBatch<In>& batch, float* values) {
  using P = Packet<float, kNativeLanes>;
  constexpr std::size_t width = kNativeLanes, size = 3 * N * N;
  detail::RowBlock<3 * N * N, In> sh;
  for (std::size_t first = 0; first < batch.count; first += width) {
    const std::size_t lanes = batch.count - first < width ? batch.count - first : width;
    sh.read(batch.sh + first * size, lanes);
    const detail::TripleLanes direction(batch.directions + 3 * first, lanes);
    const detail::UnitVector3<P> unit(direction[0], direction[1], direction[2]);
    detail::Accumulator<N * N, P> total[3];
    evaluate<N>(unit.x, unit.y, unit.z, [&](auto l, auto m, const P& y) ZONAL_INLINE {
      constexpr Index<sh_index(l, m)> i;
      unroll<0, 3>([&](auto c) ZONAL_INLINE { total[c].add(i, sh.get(3 * i + c) * y); });
    });
    P value[3];
    for (int c = 0; c < 3; ++c) value[c] = detail::apply_rule<rule>(total[c].sum());
    detail::TripleLanes(value).write(values + 3 * first, lanes);
  }
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
