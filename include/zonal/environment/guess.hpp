// Which mapping a picture may have been made by.
#pragma once

#include "environment.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// Whether all that is beside the disc is of one colour to the bit, as it is in a picture of a disc, and in no other.
template <class Element>
bool is_plain_beside_disc(const Picture<Element>& picture) {
  const Disc disc{picture.width, 1 + 3.0 / picture.width};  // but for a rim, which may be smoothed
  if (disc.has(0, 0)) return false;
  PictureFaults faults;
  const auto at = [&](int column, int row) {
    const Rgb<float> c = picture.rgb(column, row);
    return Rgb<float>{as_radiance(c.r, faults), as_radiance(c.g, faults), as_radiance(c.b, faults)};
  };
  const Rgb<float> background = at(0, 0);
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) {
      if (!disc.has(column, row) && at(column, row) != background) return false;
    }
  }
  return true;
}

}  // namespace detail

/// A guess by the picture's shape: 2:1 equirectangular, 3:4 vertical and 4:3 horizontal cross, 1:6 vertical and 6:1
/// horizontal faces; square, and of one colour beside the disc, an angular map, else octahedral. A mirror sphere, and
/// pictures of other shapes, have to be named. False, and nothing changed, where there is no guess.
template <class Element>
bool guess_mapping(const Picture<Element>& picture, Mapping& mapping) {
  if (!picture.what_is_wrong().empty()) return false;
  const auto is = [&](long long across, long long down) { return picture.width * down == picture.height * across; };
  const auto set = [&](Mapping guess) {
    mapping = guess;
    return true;
  };
  if (is(2, 1)) return set(Mapping::equirectangular);
  if (is(3, 4)) return set(Mapping::vertical_cross);
  if (is(4, 3)) return set(Mapping::horizontal_cross);
  if (is(1, 6)) return set(Mapping::vertical_faces);
  if (is(6, 1)) return set(Mapping::horizontal_faces);
  if (!is(1, 1)) return false;
  return set(detail::is_plain_beside_disc(picture) ? Mapping::angular_map : Mapping::octahedral);
}

/// The environment of the mapping that is guessed. Throws std::invalid_argument where there is none; without exceptions
/// it ends the program (refuse.hpp).
template <class Element>
Environment<std::remove_const_t<Element>> guess_environment(const Picture<Element>& picture) {
  const std::string wrong = picture.what_is_wrong();
  if (!wrong.empty()) detail::refuse(wrong);
  Mapping mapping{};
  if (!guess_mapping(picture, mapping)) {
    detail::refuse("a picture of " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                   ": no mapping has this shape as a rule; name one");
  }
  return Environment<std::remove_const_t<Element>>(picture, mapping);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
