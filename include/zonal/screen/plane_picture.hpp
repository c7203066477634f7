// Several numbers for each pixel, as structures of arrays: what the filter reads and writes.
//
// A row of pixels is a row of each plane, one after the other: number `plane` of pixel (x, y) stands at
//
//   data()[(y * planes + plane) * pitch + x]
//
// data() is aligned to a cache line, 64 bytes, and so is every row of a plane: the pitch is whole cache lines, and an
// odd number of them, so that the planes of a pixel do not compete for the same places in a cache. What stands between
// width and pitch is zero to begin with, and nobody's.
#pragma once

#include <cassert>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

#include <glm/vec3.hpp>

#include "../basis/sh.hpp"
#include "../scalar/half.hpp"
#include "../scalar/refuse.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {
inline void store_number(float& target, float number) { target = number; }
inline void store_number(Half& target, float number) { target = to_half(number); }
}  // namespace detail

/// width x height pixels of `planes` numbers, zero to begin with; Element is float, or Half: 16 bits, 11 of them
/// significant, up to 65504.
template <class Element = float>
class PlanePicture {
  static_assert(std::is_same_v<Element, float> || std::is_same_v<Element, Half>, "float or Half");
  static constexpr std::size_t line_size = 64 / sizeof(Element);
  struct alignas(64) Line {
    Element numbers[line_size];
  };

 public:
  PlanePicture() = default;
  /// Throws std::invalid_argument unless all are positive (refuse.hpp).
  PlanePicture(int width, int height, int planes) : width_(width), height_(height), planes_(planes) {
    if (width < 1 || height < 1 || planes < 1) {
      detail::refuse("a picture of " + std::to_string(width) + "x" + std::to_string(height) + " pixels of " +
                     std::to_string(planes) + " numbers");
    }
    const std::size_t lines = (std::size_t(width) + line_size - 1) / line_size;
    pitch_ = (lines | 1U) * line_size;
    lines_.resize(std::size_t(height) * std::size_t(planes) * (pitch_ / line_size), Line{});
  }

  int width() const { return width_; }
  int height() const { return height_; }
  int planes() const { return planes_; }
  /// Numbers from a row of a plane to that row of the next.
  std::size_t pitch() const { return pitch_; }
  /// Memory of all pixels, padding included.
  std::size_t bytes() const { return lines_.size() * sizeof(Line); }

  /// All numbers: height * planes * pitch.
  Element* data() { return reinterpret_cast<Element*>(lines_.data()); }
  const Element* data() const { return reinterpret_cast<const Element*>(lines_.data()); }
  std::size_t size() const { return lines_.size() * line_size; }

  /// A row of one plane, `width` numbers.
  Element* row(int y, int plane) { return data() + offset(y, plane); }
  const Element* row(int y, int plane) const { return data() + offset(y, plane); }

  float get(int x, int y, int plane) const { return to_float(row(y, plane)[x]); }
  void set(int x, int y, int plane, float number) { detail::store_number(row(y, plane)[x], number); }

 private:
  std::size_t offset(int y, int plane) const {
    assert(0 <= y && y < height_ && 0 <= plane && plane < planes_);
    return (std::size_t(y) * std::size_t(planes_) + std::size_t(plane)) * pitch_;
  }

  int width_ = 0, height_ = 0, planes_ = 0;
  std::size_t pitch_ = 0;
  std::vector<Line> lines_;
};

/// Incident radiance, N bands of RGB: coefficient i of channel c is plane 3 i + c.
template <int N, class Element = float>
class RadiancePicture : public PlanePicture<Element> {
 public:
  RadiancePicture() = default;
  RadiancePicture(int width, int height) : PlanePicture<Element>(width, height, 3 * N * N) {}

  Sh<N, glm::vec3> at(int x, int y) const {
    Sh<N, glm::vec3> sh;
    for (int i = 0; i < N * N; ++i) {
      for (int c = 0; c < 3; ++c) sh[i][c] = this->get(x, y, 3 * i + c);
    }
    return sh;
  }
  void set_at(int x, int y, const Sh<N, glm::vec3>& sh) {
    for (int i = 0; i < N * N; ++i) {
      for (int c = 0; c < 3; ++c) this->set(x, y, 3 * i + c, sh[i][c]);
    }
  }
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
