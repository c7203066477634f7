// The discontinuity filter: each pixel gets the mean over one block of the interleaved pattern, of its own surface.
//
// Along a row a pixel looks for one pixel of each of the pattern's columns of sets: of x + d and x + d - n, 0 < d < n,
// which are of the same column, the one in the window
//
//   x - (n - 1) / 2, ..., x + n / 2                              (divisions of whole numbers)
//
// if it shows the same surface (surface.hpp), else the other one if that does, else none. So where the surface goes on
// for n pixels every set counts once, at the edges of the picture and of the surface too: there the window is moved,
// not cut. What is found is averaged. The second pass does the same with rows. Weights are thus 1 / (pixels found), per
// pass; a thin object is filtered along its length, and one of a single pixel not at all. Pixels without a surface
// become 0 and give nothing. A number that is not finite spreads to the pixels that find it.
//
// Both passes run in one sweep over the picture, in bands of rows: nothing is stored between them but some rows of one
// plane. No pixel's result depends on the bands, so results are the same to the bit for any number of threads.
//
// [1] Segovia and Wald, Screen space spherical harmonics filters for instant global illumination, section 3, step 3.
// [2] Keller, Quasi-Monte Carlo methods for realistic image synthesis, 1998: the discontinuity buffer.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "../basis/batch.hpp"
#include "../scalar/for_each.hpp"
#include "../scalar/packet.hpp"
#include "../scalar/refuse.hpp"
#include "pattern.hpp"
#include "plane_picture.hpp"
#include "surface.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

/// The pixels that a pixel averages along one axis, by the pattern's length n on it: bit n - 1 + offset.
struct FilterWindow {
  int length;

  constexpr int reach() const { return length - 1; }
  constexpr int first() const { return -(length - 1) / 2; }
  constexpr int last() const { return length / 2; }
  /// Where the surface goes on.
  constexpr std::uint32_t whole() const { return ((1U << unsigned(length)) - 1U) << unsigned(reach() + first()); }
  /// Bit d of `after` and of `before`, 0 < d < n: whether the pixels at offsets d and d - n are of the same surface;
  /// bit 0 of `after`: whether there is a surface.
  constexpr std::uint32_t chosen(std::uint32_t after, std::uint32_t before) const {
    const std::uint32_t preferred = (2U << unsigned(last())) - 1U;  // of the two, the one after
    const std::uint32_t taken_after = after & (preferred | ~before), taken_before = before & (~preferred | ~after);
    return taken_after << unsigned(reach()) | taken_before >> 1U;
  }
};

/// Lanes of `numbers` where the bit is set in these words, else 0, whatever else the numbers are.
template <int width>
ZONAL_INLINE inline Lanes<float, width> where_bit(const std::uint32_t* words, std::uint32_t bit,
                                                  const Lanes<float, width>& numbers) {
#if defined(ZONAL_COMPILER_VECTORS)
  typedef std::uint32_t Words __attribute__((vector_size(std::size_t(width) * 4)));
  typedef std::uint32_t InMemory __attribute__((vector_size(std::size_t(width) * 4), aligned(4), may_alias));
  const Words given = *reinterpret_cast<const InMemory*>(words);
  const Words mask = reinterpret_cast<Words>((given & bit) != 0);
  return Lanes<float, width>::from(mask & numbers.template as<Words>());
#else
  float values[std::size_t(width)];
  numbers.store(values);
  for (int i = 0; i < width; ++i) values[i] = (words[i] & bit) != 0 ? values[i] : 0.0F;
  return Lanes<float, width>::load(values);
#endif
}

inline constexpr int filter_block = 16;  // pixels at once

constexpr std::size_t padded_to_blocks(int width) {
  return std::size_t((width + filter_block - 1) / filter_block * filter_block);
}

/// What is averaged at the pixels of a row, along one axis: bits of FilterWindow, and one over how many there are. Of
/// blocks where all windows are whole the weights are not set. Beyond the row's end nothing is chosen.
struct FilterRow {
  std::vector<std::uint32_t> chosen;
  std::vector<float> weight;
  std::vector<std::uint8_t> is_whole;

  FilterRow() = default;
  explicit FilterRow(int width)
      : chosen(padded_to_blocks(width), 0U), weight(chosen.size()), is_whole(chosen.size() / filter_block) {}

  /// From the words that FilterWindow::chosen takes.
  void choose(const FilterWindow& window, const std::uint32_t* after, const std::uint32_t* before, int width) {
    for (int x = 0; x < width; ++x) chosen[std::size_t(x)] = window.chosen(after[x], before[x]);
    const std::uint32_t whole = window.whole();
    for (std::size_t block = 0; block < is_whole.size(); ++block) {
      const std::uint32_t* const words = chosen.data() + block * filter_block;
      std::uint32_t other = 0;
      for (int i = 0; i < filter_block; ++i) other |= words[i] ^ whole;
      is_whole[block] = other == 0;
      if (other == 0) continue;
      float* const weights = weight.data() + block * filter_block;
      for (int i = 0; i < filter_block; ++i) {
        int count = 0;
        for (std::uint32_t bits = words[i]; bits != 0; bits &= bits - 1) ++count;
        weights[i] = count > 0 ? 1.0F / float(count) : 0.0F;
      }
    }
  }
};

/// The fields of surfaces side by side: field k of number x at data[k * stride + x].
struct SurfaceRow {
  const float* data;
  std::size_t stride;

  template <class T>
  ZONAL_INLINE ScreenSurface<T> load(int x) const {
    ScreenSurface<T> surface;
    const float* source = data + x;
    for_each_field(surface, [&](T& field) ZONAL_INLINE {
      field = T::load(source);
      source += stride;
    });
    return surface;
  }
};

/// Filters some rows of a picture, plane by plane.
template <class Element>
class FilterBand {
 public:
  FilterBand(const SurfacePicture& surfaces, InterleavedPattern pattern, const SurfaceTests& tests, int begin, int end)
      : surfaces_(surfaces),
        tests_(tests),
        across_{pattern.columns},
        down_{pattern.rows},
        width_(surfaces.width()),
        begin_(begin),
        end_(end),
        first_((std::max)(begin - down_.reach(), 0)),
        last_((std::min)(end + down_.reach(), surfaces.height())) {
    choose();
    line_.resize(2 * margin + padded_to_blocks(width_));
    averages_.assign(std::size_t(2 * down_.length - 1), std::vector<float>(padded_to_blocks(width_)));
  }

  /// source(y): where the planes of row y stand, which are pitch numbers apart.
  template <class Source>
  void run(const Source& source, PlanePicture<Element>& out) {
    past_caches_ = is_past_caches(Stores::by_size, out.bytes());
    for (int plane = 0; plane < out.planes(); ++plane) {
      int next = first_;
      for (int y = begin_; y < end_; ++y) {
        for (; next < (std::min)(y + down_.length, last_); ++next) {
          average_across(next, source(next) + std::size_t(plane) * out.pitch());
        }
        average_down(y, out.row(y, plane));
      }
    }
    if (past_caches_) finish_streams();
  }

 private:
  static constexpr int margin = InterleavedPattern::longest_side;
  using Words = std::vector<std::uint32_t>;
  using Block = Lanes<float, kNativeLanes>;
  using SurfaceLanes = Packet<float, kNativeLanes>;

  /// Bit d: whether the pixel at x of row a, and that at other(d, x), d < count, show the same surface.
  template <class Other>
  void compare(const SurfaceRow& a, int count, const Other& other, std::uint32_t* words) const {
    using T = SurfaceLanes;
    for (int x = 0; x < width_; x += T::width) {
      const auto surface = a.load<T>(x);
      // Words of up to 16 bits are numbers that floats hold.
      T bits = select(T(0) <= surface.mesh, T(1), T(0));
      for (int d = 1; d < count; ++d) {
        const auto same = is_same_surface(surface, other(d, x), T(tests_.cos_normal), T(tests_.plane_distance));
        bits = bits + select(same, T(float(1U << unsigned(d))), T(0));
      }
      float numbers[std::size_t(T::width)];
      bits.store(numbers);
      for (int i = 0; i < T::width; ++i) words[x + i] = std::uint32_t(std::int32_t(numbers[i]));
    }
  }

  /// Bit n - d of each word from bit d of the one d before.
  static void add_before(const FilterWindow& window, int d, const std::uint32_t* after, int count,
                         std::uint32_t* words) {
    for (int x = 0; x < count; ++x) words[x] |= (after[x] >> unsigned(d) & 1U) << unsigned(window.length - d);
  }

  /// For all rows that take part, whose surfaces are thus read from memory once.
  void choose() {
    const std::size_t padded = padded_to_blocks(width_);
    std::vector<float> fields(SurfacePicture::field_count * (padded + margin), -1.0F);  // beyond the end: mesh is -1
    std::vector<Words> after(std::size_t(end_ - first_), Words(padded));
    Words before(padded);
    for (int y = first_; y < last_; ++y) {
      if (y < end_) choose_down(y, after, before);
      choose_across(y, fields, before);
    }
  }

  void choose_across(int y, std::vector<float>& fields, Words& before) {
    const std::size_t stride = fields.size() / SurfacePicture::field_count;
    for (int k = 0; k < SurfacePicture::field_count; ++k) {
      std::copy_n(surfaces_.row(y, k), width_, fields.data() + std::size_t(k) * stride);
    }
    const SurfaceRow row{fields.data(), stride};
    Words after(before.size());
    compare(
        row, across_.length, [&](int d, int x) { return row.template load<SurfaceLanes>(x + d); }, after.data());
    std::fill(before.begin(), before.end(), 0U);
    for (int d = 1; d < across_.length; ++d) add_before(across_, d, after.data(), width_ - d, before.data() + d);
    rows_.emplace_back(width_).choose(across_, after.data(), before.data(), width_);
  }

  void choose_down(int y, std::vector<Words>& after, Words& before) {
    const auto row = [&](int at) { return SurfaceRow{surfaces_.row(at, 0), surfaces_.pitch()}; };
    Words& words = after[std::size_t(y - first_)];
    compare(
        row(y), (std::min)(down_.length, last_ - y),
        [&](int d, int x) { return row(y + d).template load<SurfaceLanes>(x); }, words.data());
    if (y < begin_) return;
    std::fill(before.begin(), before.end(), 0U);
    for (int d = 1; d <= (std::min)(down_.reach(), y - first_); ++d) {
      add_before(down_, d, after[std::size_t(y - d - first_)].data(), width_, before.data());
    }
    columns_.emplace_back(width_).choose(down_, words.data(), before.data(), width_);
  }

  /// Averages a row; sources[reach + offset]: where the numbers at that offset from its first pixel stand.
  static void average(const FilterWindow& window, const FilterRow& row, const float* const* sources, float* target) {
    const float* const* const whole = sources + window.reach() + window.first();
    const Block whole_weight(1.0F / float(window.length));
    for (std::size_t block = 0; block < row.is_whole.size(); ++block) {
      const std::size_t end = (block + 1) * filter_block;
      for (std::size_t x = block * filter_block; x < end; x += kNativeLanes) {
        if (row.is_whole[block] != 0) {
          Block sum = Block::load(whole[0] + x);
          for (int i = 1; i < window.length; ++i) sum = sum + Block::load(whole[i] + x);
          (sum * whole_weight).store(target + x);
        } else {
          Block sum(0);
          for (int i = 0; i < 2 * window.length - 1; ++i) {
            sum = sum + where_bit(row.chosen.data() + x, 1U << unsigned(i), Block::load(sources[i] + x));
          }
          (sum * Block::load(row.weight.data() + x)).store(target + x);
        }
      }
    }
  }

  void average_across(int y, const Element* source) {
    float* const line = line_.data() + margin;
    for (int x = 0; x < width_; ++x) line[x] = to_float(source[x]);
    const float* sources[2 * margin];
    for (int i = 0; i < 2 * across_.length - 1; ++i) sources[i] = line + i - across_.reach();
    average(across_, rows_[std::size_t(y - first_)], sources, average_of(y));
  }

  void average_down(int y, Element* target) {
    const float* sources[2 * margin];
    for (int i = 0; i < 2 * down_.length - 1; ++i) {
      // Beyond the rows that take part nothing is chosen.
      sources[i] = average_of((std::min)((std::max)(y + i - down_.reach(), first_), last_ - 1));
    }
    average(down_, columns_[std::size_t(y - begin_)], sources, line_.data());
    if constexpr (std::is_same_v<Element, float>) {
      if (past_caches_) return copy_past_caches(line_.data(), std::size_t(width_), target);
    }
    for (int x = 0; x < width_; ++x) store_number(target[x], line_[std::size_t(x)]);
  }

  float* average_of(int y) { return averages_[std::size_t(y) % averages_.size()].data(); }

  const SurfacePicture& surfaces_;
  SurfaceTests tests_;
  FilterWindow across_, down_;
  int width_, begin_, end_;
  int first_, last_;          // the rows that take part
  bool past_caches_ = false;  // stores that the caches need not hold
  std::vector<FilterRow> rows_, columns_;
  std::vector<float> line_;
  std::vector<std::vector<float>> averages_;  // of the rows about the one at hand
};

}  // namespace detail

/// Filters all planes of `in` into `out`, which may be the same picture. All three are of one size, `in` and `out` of
/// as many planes, the pattern is no larger: throws std::invalid_argument else (refuse.hpp). for_each:
/// scalar/for_each.hpp.
///
/// Where n x m pixels of one surface hold a value each, the result is their mean within (n + m) 2^-24 of the largest,
/// with halves 2^-11 more. Memory beside the pictures: some rows a thread; in place also 2 (m - 1) rows of all planes
/// for every 64.
template <class Element, class ForEach = SerialForEach>
void filter(const PlanePicture<Element>& in, PlanePicture<Element>& out, const SurfacePicture& surfaces,
            InterleavedPattern pattern, const SurfaceTests& tests = {}, ForEach&& for_each = {}) {
  const int width = in.width(), height = in.height();
  const std::string wrong = pattern.what_is_wrong(width, height);
  if (!wrong.empty()) detail::refuse(wrong);
  const auto has_size = [&](const auto& picture) { return picture.width() == width && picture.height() == height; };
  if (!has_size(surfaces) || !has_size(out) || in.planes() != out.planes()) {
    detail::refuse("pictures of different sizes to filter");
  }

  constexpr int band_rows = 64;
  static_assert(band_rows >= InterleavedPattern::longest_side, "a band reads no further than its neighbours");
  const int bands = (height + band_rows - 1) / band_rows, reach = pattern.rows - 1;
  const std::size_t row_size = std::size_t(in.planes()) * in.pitch();

  // In place: the rows on both sides of each border between bands, as they were.
  const bool is_in_place = in.data() == out.data();
  std::vector<std::vector<Element>> borders(is_in_place ? std::size_t(bands) : 0);
  const auto border_begin = [&](int border) { return border * band_rows - reach; };
  if (is_in_place && reach > 0) {
    for_each(bands - 1, [&](int before) {
      const int border = before + 1, begin = border_begin(border), end = (std::min)(begin + 2 * reach, height);
      borders[std::size_t(border)].assign(in.row(begin, 0), in.row(begin, 0) + std::size_t(end - begin) * row_size);
    });
  }
  for_each(bands, [&](int band) {
    const int begin = band * band_rows, end = (std::min)(begin + band_rows, height);
    const auto source = [&](int y) -> const Element* {
      if (!is_in_place || (begin <= y && y < end)) return in.row(y, 0);
      const int border = y < begin ? band : band + 1;
      return borders[std::size_t(border)].data() + std::size_t(y - border_begin(border)) * row_size;
    };
    detail::FilterBand<Element>(surfaces, pattern, tests, begin, end).run(source, out);
  });
}

/// In place.
template <class Element, class ForEach = SerialForEach>
void filter(PlanePicture<Element>& picture, const SurfacePicture& surfaces, InterleavedPattern pattern,
            const SurfaceTests& tests = {}, ForEach&& for_each = {}) {
  filter(picture, picture, surfaces, pattern, tests, for_each);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
