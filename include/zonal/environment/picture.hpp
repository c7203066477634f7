// Pictures as their owners hold them: nothing is copied.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>

#include "../scalar/half.hpp"
#include "../scalar/refuse.hpp"
#include "rgb.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// width x height texels of linear radiance, from the upper left one on. `Element` is float or Half; const where the
/// picture is read, as it is by all but fill(). Channels are 1, grey; 3, RGB; or 4, of which the fourth, alpha, is not
/// read. Strides are in elements, from a texel to the next on its right, to the one below, and from a channel to the
/// next; any may be negative, so that pictures upside down, planes, and parts of pictures are pictures.
template <class Element>
struct Picture {
  static_assert(std::is_same_v<std::remove_const_t<Element>, float> ||
                    std::is_same_v<std::remove_const_t<Element>, Half>,
                "a picture is of float or Half");
  using Value = std::remove_const_t<Element>;

  Element* data = nullptr;
  int width = 0, height = 0, channels = 3;
  std::ptrdiff_t column_stride = 0, row_stride = 0, channel_stride = 1;

  constexpr Picture() = default;
  /// Texels side by side, row after row, with no gaps.
  constexpr Picture(Element* elements, int picture_width, int picture_height, int channel_count = 3)
      : data(elements),
        width(picture_width),
        height(picture_height),
        channels(channel_count),
        column_stride(channel_count),
        row_stride(std::ptrdiff_t{channel_count} * picture_width) {}
  constexpr operator Picture<const Element>() const {
    Picture<const Element> r;
    r.data = data;
    r.width = width;
    r.height = height;
    r.channels = channels;
    r.column_stride = column_stride;
    r.row_stride = row_stride;
    r.channel_stride = channel_stride;
    return r;
  }

  constexpr Element* at(int column, int row) const { return data + column * column_stride + row * row_stride; }
  /// Grey is as much of each.
  Rgb<float> rgb(int column, int row) const {
    const Element* texel = at(column, row);
    if (channels == 1) return Rgb<float>{to_float(*texel), to_float(*texel), to_float(*texel)};
    return Rgb<float>{to_float(texel[0]), to_float(texel[channel_stride]), to_float(texel[2 * channel_stride])};
  }

  /// Why this is no picture; empty if it is one. `elements`, where given, is how many there are from `data` on.
  std::string what_is_wrong() const {
    if (width <= 0 || height <= 0) {
      return "an empty picture, " + std::to_string(width) + " x " + std::to_string(height);
    }
    if (data == nullptr) return "a picture without data";
    if (channels != 1 && channels != 3 && channels != 4) {
      return "a picture of " + std::to_string(channels) + " channels, not of 1, 3 or 4";
    }
    if (!(reach(1) - reach(-1) <
          double((std::numeric_limits<std::ptrdiff_t>::max)() / std::ptrdiff_t{sizeof(Value)}))) {
      return "a picture too large for this machine's memory: " + size_text();
    }
    return {};
  }
  std::string what_is_wrong(std::size_t elements) const {
    std::string wrong = what_is_wrong();
    if (wrong.empty() && (reach(-1) < 0 || reach(1) >= double(elements))) {
      wrong = "a picture cut off: " + size_text() + " with " + std::to_string(elements) + " numbers";
    }
    return wrong;
  }

  /// A picture of the numbers of a vector, or anything else with data() and size(). Throws std::invalid_argument if
  /// they are too few; without exceptions it ends the program (refuse.hpp).
  template <class Numbers>
  static Picture of(Numbers& numbers, int width, int height, int channels = 3) {
    const Picture picture(numbers.data(), width, height, channels);
    const std::string wrong = picture.what_is_wrong(numbers.size());
    if (!wrong.empty()) detail::refuse(wrong);
    return picture;
  }

 private:
  std::string size_text() const {
    return std::to_string(width) + " x " + std::to_string(height) + ", " + std::to_string(channels) + " channels";
  }
  // The farthest element from data, forwards (1) or backwards (-1). In double: strides may be anything.
  double reach(int sign) const {
    double farthest = 0;
    const double steps[] = {double(column_stride) * (width - 1.0), double(row_stride) * (height - 1.0),
                            double(channel_stride) * ((channels == 1 ? 1 : 3) - 1.0)};
    for (const double step : steps) farthest += sign * step > 0 ? step : 0;
    return farthest;
  }
};
template <class Element>
Picture(Element*, int, int) -> Picture<Element>;
template <class Element>
Picture(Element*, int, int, int) -> Picture<Element>;

/// What a picture held that is no radiance, in numbers, three a texel (one of a grey one): each of them counts as 0.
/// Texels without a direction are not looked at.
struct PictureFaults {
  std::size_t not_a_number = 0, infinite = 0, negative = 0;

  constexpr std::size_t total() const { return not_a_number + infinite + negative; }
  constexpr PictureFaults& operator+=(const PictureFaults& b) {
    not_a_number += b.not_a_number;
    infinite += b.infinite;
    negative += b.negative;
    return *this;
  }
  constexpr PictureFaults& operator-=(const PictureFaults& b) {
    not_a_number -= b.not_a_number;
    infinite -= b.infinite;
    negative -= b.negative;
    return *this;
  }
};

namespace detail {
// The one rule for what is no radiance.
constexpr bool is_radiance(float number) { return number >= 0 && number <= (std::numeric_limits<float>::max)(); }
inline float as_radiance(float number, PictureFaults& faults) {
  if (is_radiance(number)) return number;
  if (number < 0 && number >= -(std::numeric_limits<float>::max)()) {
    ++faults.negative;
  } else if (number > 0 || number < 0) {
    ++faults.infinite;
  } else {
    ++faults.not_a_number;
  }
  return 0.0F;
}
}  // namespace detail

}  // namespace ZONAL_TARGET
}  // namespace zonal
