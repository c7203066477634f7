// The basis at many directions at once, in the lanes of the target's registers: numbers in, numbers out, nothing
// allocated, no Eigen. Values at many directions: transform/reconstruct_batch.hpp.
//
// Where the results stand, with Size numbers a direction (N*N coefficients, or 4 N*N with gradients):
//   CoefficientRows     direction by direction, as an array of Sh: number i of direction k at data[k * Size + i]
//   CoefficientPlanes   number by number: number i of direction k at data[i * stride + k]
//
// Each lane is computed as the others are, so a direction's results do not depend on its place or on how many there
// are, to the bit. Against evaluate() of that direction alone they differ by what fused multiplications round
// otherwise; the greatest error is the same: docs/accuracy.md. Pointers may have any alignment. Nothing but the results
// is written, nothing but the directions read. The stack holds what is under way: 25 kB at 5 bands, 60 at 10, 130 at
// 20, four times as much with gradients.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "../scalar/lane_blocks.hpp"
#include "evaluate.hpp"
#include "gradient.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// `count` unit vectors where they stand: vector k is (x[k * stride], y[k * stride], z[k * stride]).
template <class T>
struct DirectionSpan {
  const T *x, *y, *z;
  std::size_t stride, count;

  /// x, y, z of one after those of the other: 3 * count numbers.
  static DirectionSpan triples(const T* xyz, std::size_t count) { return {xyz, xyz + 1, xyz + 2, 3, count}; }
  /// `count` x, y and z each.
  static DirectionSpan planes(const T* x, const T* y, const T* z, std::size_t count) { return {x, y, z, 1, count}; }
};

/// Of an array of anything with v[0], v[1], v[2], or v.x, v.y, v.z: glm::vec3, Eigen::Vector3f, std::array<double, 3>.
template <class V>
DirectionSpan<component_t<V>> direction_span(const V* vectors, std::size_t count) {
  using T = component_t<V>;
  static_assert(is_builtin_scalar_v<T> && sizeof(V) % sizeof(T) == 0, "vectors of floats or doubles, and nothing else");
  if (count == 0) return {};
  const auto [x, y, z] = detail::component_addresses(*vectors, 0);
  return {x, y, z, sizeof(V) / sizeof(T), count};
}

/// count * Size numbers.
template <class T>
struct CoefficientRows {
  T* data;
};

/// Size planes of `count` numbers each, which begin `stride` >= count numbers apart. Stores go past the caches only
/// where `stride` is whole cache lines: a multiple of 16 floats or 8 doubles.
template <class T>
struct CoefficientPlanes {
  T* data;
  std::size_t stride;
};

/// How results reach memory. Past the caches what was in them stays there, and a third of the time is saved; in their
/// size it takes twice the time, and whoever reads the results next waits for memory.
enum class Stores { by_size, cached, past_caches };

namespace detail {

// By size, results are stored past the caches from this on: what a large cache holds today.
inline constexpr std::size_t cached_bytes = std::size_t{32} << 20;
inline constexpr std::size_t cache_line = 64;

inline bool is_past_caches(Stores stores, std::size_t bytes) {
  return stores == Stores::past_caches || (stores == Stores::by_size && bytes > cached_bytes);
}

// x, y and z of `width` directions from the first on.
template <class T, int width>
ZONAL_INLINE inline void load_directions(const DirectionSpan<T>& directions, std::size_t first,
                                         Lanes<T, width> (&v)[3]) {
  const T* const components[] = {directions.x, directions.y, directions.z};
  if (directions.stride == 1) {
    for (int i = 0; i < 3; ++i) v[i] = Lanes<T, width>::load(components[i] + first);
    return;
  }
  if constexpr (std::is_same_v<T, float>) {
    if (directions.stride == 3 && directions.y == directions.x + 1 && directions.z == directions.x + 2) {
      return load_triples(directions.x + 3 * first, v);
    }
  }
  for (int i = 0; i < 3; ++i) {
    alignas(Lanes<T, width>) T numbers[static_cast<std::size_t>(width)];
    for (std::size_t lane = 0; lane < std::size_t{width}; ++lane) {
      numbers[lane] = components[i][(first + lane) * directions.stride];
    }
    v[i] = Lanes<T, width>::load(numbers);
  }
}

// A copy of the directions from `first` on, as many as fill the lanes: those beyond the last repeat it.
template <class T, int width>
class FilledDirections {
 public:
  FilledDirections(const DirectionSpan<T>& directions, std::size_t first) {
    const std::size_t last = directions.count - 1;
    for (std::size_t lane = 0; lane < std::size_t{width}; ++lane) {
      const std::size_t i = (first + lane < last ? first + lane : last) * directions.stride;
      x_[lane] = directions.x[i];
      y_[lane] = directions.y[i];
      z_[lane] = directions.z[i];
    }
  }
  DirectionSpan<T> span() const { return DirectionSpan<T>::planes(x_, y_, z_, width); }

 private:
  T x_[static_cast<std::size_t>(width)], y_[static_cast<std::size_t>(width)], z_[static_cast<std::size_t>(width)];
};

template <class T>
bool are_unit(const DirectionSpan<T>& directions) {
  for (std::size_t k = 0; k < directions.count; ++k) {
    const std::size_t i = k * directions.stride;
    if (!is_unit(directions.x[i], directions.y[i], directions.z[i])) return false;
  }
  return true;
}

// The caches fetch lines that are about to be written. Where rows are no whole lines this saves two fifths of the time;
// where they are the processor sees it coming.
template <class T>
ZONAL_INLINE inline void expect_stores([[maybe_unused]] const T* target, [[maybe_unused]] std::size_t size) {
#if defined(__GNUC__)
  for (std::size_t i = 0; i < size; i += cache_line / sizeof(T)) __builtin_prefetch(target + i, 1);
#endif
}

// kernel(v, sink) gives sink(Index<i>, lanes) for all i < Size, at the directions in the lanes of v[0], v[1], v[2].

// Of `count` directions from `first` on, which fill whole registers, to rows.
template <int Size, class T, class Kernel>
void fill_rows(const DirectionSpan<T>& directions, std::size_t first, std::size_t count, T* rows, bool expects,
               Kernel kernel) {
  constexpr int width = native_lanes_v<T>;
  constexpr std::size_t block = std::size_t{Size} * width;
  alignas(cache_line) T columns[block];
  for (std::size_t k = 0; k < count; k += width, rows += block) {
    if (expects) expect_stores(rows, block);
    Lanes<T, width> v[3];
    load_directions(directions, first + k, v);
    kernel(v, [&](auto i, const Lanes<T, width>& value) ZONAL_INLINE { value.store(columns + i * width); });
    transpose<Size, width>(columns, rows);
  }
}

template <int Size, class T, class Kernel>
void run_batch(const DirectionSpan<T>& directions, const CoefficientRows<T>& rows, Stores stores, Kernel kernel) {
  constexpr int width = native_lanes_v<T>;
  constexpr std::size_t size = Size, block = size * width;
  constexpr std::size_t blocks = 16 * 1024 / sizeof(T) / block + 1;  // that go past the caches together
  assert(are_unit(directions));
  const bool past_caches = is_past_caches(stores, directions.count * size * sizeof(T));
  const std::size_t whole = directions.count / width * width, rest = directions.count - whole;

  alignas(cache_line) T staged[blocks * block];
  if (!past_caches) {
    fill_rows<Size>(directions, 0, whole, rows.data, size * sizeof(T) % cache_line != 0, kernel);
  } else {
    for (std::size_t begin = 0; begin < whole; begin += blocks * width) {
      const std::size_t count = whole - begin < blocks * width ? whole - begin : blocks * width;
      fill_rows<Size>(directions, begin, count, staged, false, kernel);
      copy_past_caches(staged, count * size, rows.data + begin * size);
    }
    finish_streams();
  }
  if (rest > 0) {
    fill_rows<Size>(FilledDirections<T, width>(directions, whole).span(), 0, width, staged, false, kernel);
    copy(staged, rest * size, rows.data + whole * size);
  }
}

// The same to planes that begin `pitch` numbers apart.
template <int Size, class T, class Kernel>
void fill_planes(const DirectionSpan<T>& directions, std::size_t first, std::size_t count, T* planes, std::size_t pitch,
                 Kernel kernel) {
  constexpr int width = native_lanes_v<T>;
  for (std::size_t k = 0; k < count; k += width) {
    Lanes<T, width> v[3];
    load_directions(directions, first + k, v);
    kernel(v, [&](auto i, const Lanes<T, width>& value) ZONAL_INLINE { value.store(planes + i * pitch + k); });
  }
}

// Whether a first-level cache holds a line of each plane, and some more: 8 lines at each of 64 places.
inline bool fits_planes(std::size_t planes, std::size_t bytes_apart) {
  constexpr std::size_t lines = 8, places = 64;
  std::size_t taken = places;  // by planes so far apart
  for (std::size_t period = cache_line; taken > 1 && bytes_apart % (2 * period) == 0; period *= 2) taken /= 2;
  return 4 * planes <= 3 * lines * taken;
}

// Planes that do not fit, or go past the caches, are as many places in memory, each visited for a few lanes: so a run
// of each is staged.
template <int Size, class T, class Kernel>
void run_batch(const DirectionSpan<T>& directions, const CoefficientPlanes<T>& planes, Stores stores, Kernel kernel) {
  constexpr int width = native_lanes_v<T>;
  constexpr std::size_t size = Size, line = cache_line / sizeof(T);
  constexpr std::size_t together = size <= 128 ? 8 * line : 4 * line;
  constexpr std::size_t pitch = together + line;  // an odd number of lines, which do not compete for the same places
  static_assert(together % width == 0, "whole registers");
  assert(are_unit(directions) && planes.stride >= directions.count);
  const bool past_caches = planes.stride % line == 0 && is_past_caches(stores, directions.count * size * sizeof(T));

  std::size_t begin = 0;
  if (!past_caches && fits_planes(size, planes.stride * sizeof(T))) {
    begin = directions.count / width * width;
    fill_planes<Size>(directions, 0, begin, planes.data, planes.stride, kernel);
  }
  alignas(cache_line) T staged[size * pitch];
  // The first run ends where a line of the planes does.
  std::size_t end = begin + together - reinterpret_cast<std::uintptr_t>(planes.data + begin) % cache_line / sizeof(T);
  for (; begin < directions.count; begin = end, end += together) {
    const std::size_t count = (end < directions.count ? end : directions.count) - begin, whole = count / width * width;
    fill_planes<Size>(directions, begin, whole, staged, pitch, kernel);
    if (whole < count) {
      const FilledDirections<T, width> last(directions, begin + whole);
      fill_planes<Size>(last.span(), 0, width, staged + whole, pitch, kernel);
    }
    for (std::size_t i = 0; i < size; ++i) {
      T* const target = planes.data + i * planes.stride + begin;
      past_caches ? copy_past_caches(staged + i * pitch, count, target) : copy(staged + i * pitch, count, target);
    }
  }
  if (past_caches) finish_streams();
}

}  // namespace detail

/// Y_l^m at every direction: N*N numbers each, in the order l(l+1)+m, without a unit. `Results` is CoefficientRows<T>
/// or CoefficientPlanes<T>, T float or double.
template <int N, class T, class Results>
void evaluate(const DirectionSpan<T>& directions, const Results& results, Stores stores = Stores::by_size) {
  static_assert(N >= 1, "bands out of range: N >= 1");
  detail::run_batch<N * N>(directions, results, stores, [](const auto& v, auto sink) ZONAL_INLINE {
    evaluate<N>(v[0], v[1], v[2],
                [&](auto l, auto m, const auto& value) ZONAL_INLINE { sink(Index<sh_index(l, m)>{}, value); });
  });
}

/// The same, and the gradient of Y_l^m(v/|v|): 4 N*N numbers each, as an ShGradient<N, T> has them: the values, then
/// the derivatives by x, by y and by z.
template <int N, class T, class Results>
void evaluate_with_gradient(const DirectionSpan<T>& directions, const Results& results,
                            Stores stores = Stores::by_size) {
  static_assert(N >= 1, "bands out of range: N >= 1");
  detail::run_batch<4 * N * N>(directions, results, stores, [](const auto& v, auto sink) ZONAL_INLINE {
    evaluate_with_gradient<N>(v[0], v[1], v[2],
                              [&](auto l, auto m, const auto& value, const auto& gx, const auto& gy, const auto& gz)
                                  ZONAL_INLINE {
                                    constexpr int i = sh_index(l, m);
                                    sink(Index<i>{}, value);
                                    sink(Index<N * N + i>{}, gx);
                                    sink(Index<2 * N * N + i>{}, gy);
                                    sink(Index<3 * N * N + i>{}, gz);
                                  });
  });
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
