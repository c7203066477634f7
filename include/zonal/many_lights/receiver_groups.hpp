// Receivers that share what is worked out about lights: those of a block of pixels, by surface.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "../scalar/index.hpp"
#include "../scalar/target.hpp"
#include "sort_key.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The box of some vectors, component by component.
struct Box3 {
  glm::vec3 low{1e30F}, high{-1e30F};

  void add(const glm::vec3& v) {
    low = (glm::min)(low, v);
    high = (glm::max)(high, v);
  }
};

/// Where receivers are and which way they face.
struct ReceiverBox {
  Box3 positions, normals;

  void add(const glm::vec3& position, const glm::vec3& normal) {
    positions.add(position);
    normals.add(normal);
  }
};

namespace detail {

/// The greatest dot product of any of a box with v.
inline float greatest_dot(const Box3& box, const glm::vec3& v) {
  const glm::vec3 greatest = (glm::max)(box.low * v, box.high * v);
  return greatest.x + greatest.y + greatest.z;
}
/// The greatest of any of one box with any of another.
inline float greatest_dot(const Box3& a, const Box3& b) {
  const glm::vec3 greatest =
      (glm::max)((glm::max)(a.low * b.low, a.low * b.high), (glm::max)(a.high * b.low, a.high * b.high));
  return greatest.x + greatest.y + greatest.z;
}

}  // namespace detail

/// How a sphere light stands to all of some receivers.
enum class Standing {
  dark,    // it faces away from each, or is below the horizon of each: it adds exactly nothing, up to rounding
  clear,   // it is above the horizon of each, wholly
  across,  // neither is sure
};

inline Standing standing_of(const ReceiverBox& receivers, const glm::vec3& position, const glm::vec3& normal,
                            float radius, bool cuts_at_horizon) {
  if (!(detail::greatest_dot(receivers.positions, normal) > glm::dot(position, normal))) return Standing::dark;
  if (!cuts_at_horizon) return Standing::clear;
  const Box3 to_light{position - receivers.positions.high, position - receivers.positions.low};
  if (!(detail::greatest_dot(receivers.normals, to_light) > -radius)) return Standing::dark;
  const Box3 from_light{-to_light.high, -to_light.low};
  return -detail::greatest_dot(receivers.normals, from_light) > radius ? Standing::clear : Standing::across;
}

/// A receiver and its number.
struct GroupedReceiver {
  glm::vec3 position, normal;
  int index;
};

namespace detail {

/// Where to split the values of an axis.
struct Split {
  int axis = -1;
  float middle = 0;
};

struct Range {
  float low, high;
  float size() const { return high - low; }
};
template <class Key>
Range range_of(const GroupedReceiver* receivers, int count, const Key& key) {
  Range range{key(receivers[0]), key(receivers[0])};
  for (int i = 1; i < count; ++i) {
    range.low = (std::min)(range.low, key(receivers[i]));
    range.high = (std::max)(range.high, key(receivers[i]));
  }
  return range;
}

/// Where they leave more than `widest` of 16 parts of their range empty: the middle of the widest such gap.
template <class Key>
void find_gap(const GroupedReceiver* receivers, int count, int axis, const Key& key, const Range& range, int& widest,
              Split& split) {
  constexpr int bins = 16;
  bool is_taken[bins] = {};
  const float scale = float(bins) / range.size();
  for (int i = 0; i < count; ++i) {
    is_taken[index_below((key(receivers[i]) - range.low) * scale, bins - 1)] = true;
  }
  for (int i = 0, last = 0; i < bins; ++i) {
    if (!is_taken[i]) continue;
    if (i - last - 1 > widest) {
      widest = i - last - 1;
      split = {axis, range.low + float(i + last + 1) / 2 / scale};
    }
    last = i;
  }
}

}  // namespace detail

/// Moves one half of them in front of the other, along the axis of position or normal on which they lie widest apart,
/// where a turn by 1 rad is as wide as `length`; returns how many.
inline int halve_receivers(GroupedReceiver* receivers, int count, float length) {
  ReceiverBox box;
  for (int i = 0; i < count; ++i) box.add(receivers[i].position, receivers[i].normal);
  const glm::vec3 size = box.positions.high - box.positions.low;
  const glm::vec3 turn = length * (box.normals.high - box.normals.low);
  const float extent[6] = {size.x, size.y, size.z, turn.x, turn.y, turn.z};
  const int axis = int(std::max_element(extent, extent + 6) - extent);
  const auto key = [axis](const GroupedReceiver& r) {
    return detail::sort_key(axis < 3 ? r.position[axis] : r.normal[axis - 3]);
  };
  std::nth_element(receivers, receivers + count / 2, receivers + count,
                   [&](const GroupedReceiver& a, const GroupedReceiver& b) {
                     return key(a) < key(b) || (!(key(b) < key(a)) && a.index < b.index);
                   });
  return count / 2;
}

/// Receivers in parts of neighbours: part i are those from first[i] up to first[i + 1].
template <int Parts>
struct ReceiverParts {
  int first[std::size_t{Parts} + 1] = {};
  int parts = 0;

  int size(int part) const { return first[part + 1] - first[part]; }
  int size() const { return first[parts]; }
  void add(int count) {
    first[parts + 1] = first[parts] + count;
    ++parts;
  }

  /// Halves the largest until there are as many as there may be, or each is of one.
  void halve_all(GroupedReceiver* receivers, float length) {
    while (parts > 0 && parts < Parts) {
      int largest = 0;
      for (int i = 1; i < parts; ++i) largest = size(i) > size(largest) ? i : largest;
      if (size(largest) < 2) return;
      const int middle = first[largest] + halve_receivers(receivers + first[largest], size(largest), length);
      for (int i = parts; i > largest; --i) first[i + 1] = first[i];
      first[largest + 1] = middle;
      ++parts;
    }
  }
};

/// Splits receivers where their positions or normals leave a gap, as at an edge or before a background, or where they
/// are turned far from one another, and calls visit(first, count) for each group; the array is sorted by groups. What
/// is curved a little or seen at a slant stays together.
template <class Visit>
void for_each_receiver_group(GroupedReceiver* receivers, int count, const Visit& visit) {
  constexpr int least_size = 16, least_gap = 3;          // of 16 bins
  constexpr float least_turn = 0.1F, most_turn = 0.45F;  // of normals that are alike, and of those that are not
  if (count == 0) return;
  detail::Split split;
  int widest = least_gap;
  float farthest = most_turn;
  for (int axis = 0; axis < 3; ++axis) {
    const auto position = [axis](const GroupedReceiver& r) { return r.position[axis]; };
    const auto normal = [axis](const GroupedReceiver& r) { return r.normal[axis]; };
    const detail::Range turn = detail::range_of(receivers, count, normal);
    if (count > least_size && farthest <= most_turn) {
      const detail::Range places = detail::range_of(receivers, count, position);
      if (places.size() > 0) detail::find_gap(receivers, count, axis, position, places, widest, split);
      if (turn.size() > least_turn) detail::find_gap(receivers, count, axis + 3, normal, turn, widest, split);
    }
    if (turn.size() > farthest) {
      farthest = turn.size();
      split = {axis + 3, 0.5F * (turn.low + turn.high)};
    }
  }
  if (split.axis < 0) return visit(receivers, count);
  const int axis = split.axis;
  GroupedReceiver* middle = std::stable_partition(receivers, receivers + count, [&](const GroupedReceiver& r) {
    return (axis < 3 ? r.position[axis] : r.normal[axis - 3]) < split.middle;
  });
  const int first_count = int(middle - receivers);
  // Where no number lies between, as of neighbouring floats, or infinities stand.
  if (first_count == 0 || first_count == count) return visit(receivers, count);
  for_each_receiver_group(receivers, first_count, visit);
  for_each_receiver_group(middle, count - first_count, visit);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
