// Receivers that share what is worked out about lights: those of a block of pixels, by surface.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "../scalar/target.hpp"

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

/// Where the values of an axis leave a quarter of their range empty: the middle of the widest such gap.
struct Gap {
  int axis = -1;
  float middle = 0;
};

template <class Key>
void find_gap(const GroupedReceiver* receivers, int count, int axis, const Key& key, float least_range, int& widest,
              Gap& gap) {
  float low = key(receivers[0]), high = low;
  for (int i = 1; i < count; ++i) {
    low = (std::min)(low, key(receivers[i]));
    high = (std::max)(high, key(receivers[i]));
  }
  if (!(high - low > least_range)) return;
  constexpr int bins = 16;
  bool is_taken[bins] = {};
  const float scale = float(bins) / (high - low);
  for (int i = 0; i < count; ++i) is_taken[(std::min)(int((key(receivers[i]) - low) * scale), bins - 1)] = true;
  for (int i = 0, last = 0; i < bins; ++i) {
    if (!is_taken[i]) continue;
    if (i - last - 1 > widest) {
      widest = i - last - 1;
      gap = {axis, low + float(i + last + 1) / 2 / scale};
    }
    last = i;
  }
}

}  // namespace detail

/// Moves one half of them in front of the other, along the axis on which they lie widest apart; returns how many.
inline int halve_receivers(GroupedReceiver* receivers, int count) {
  Box3 box;
  for (int i = 0; i < count; ++i) box.add(receivers[i].position);
  const glm::vec3 size = box.high - box.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto key = [axis](const GroupedReceiver& r) { return r.position[axis]; };
  std::nth_element(receivers, receivers + count / 2, receivers + count,
                   [&](const GroupedReceiver& a, const GroupedReceiver& b) {
                     return key(a) < key(b) || (!(key(b) < key(a)) && a.index < b.index);
                   });
  std::sort(receivers, receivers + count / 2, [](const auto& a, const auto& b) { return a.index < b.index; });
  std::sort(receivers + count / 2, receivers + count, [](const auto& a, const auto& b) { return a.index < b.index; });
  return count / 2;
}

/// Splits receivers where their positions or normals leave a gap, as at an edge or before a background, and calls
/// visit(first, count) for each group; the array is sorted by groups. What is curved or seen at a slant stays together.
template <class Visit>
void for_each_receiver_group(GroupedReceiver* receivers, int count, const Visit& visit) {
  constexpr int least_size = 16, least_gap = 3;  // of 16 bins
  constexpr float least_turn = 0.1F;             // normals nearer than that are alike
  detail::Gap gap;
  int widest = least_gap;
  if (count > least_size) {
    for (int axis = 0; axis < 3; ++axis) {
      detail::find_gap(
          receivers, count, axis, [axis](const auto& r) { return r.position[axis]; }, 0.0F, widest, gap);
    }
    for (int axis = 0; axis < 3; ++axis) {
      detail::find_gap(
          receivers, count, axis + 3, [axis](const auto& r) { return r.normal[axis]; }, least_turn, widest, gap);
    }
  }
  if (gap.axis < 0) {
    if (count > 0) visit(receivers, count);
    return;
  }
  const int axis = gap.axis;
  GroupedReceiver* middle = std::stable_partition(receivers, receivers + count, [&](const GroupedReceiver& r) {
    return (axis < 3 ? r.position[axis] : r.normal[axis - 3]) < gap.middle;
  });
  const int first_count = int(middle - receivers);
  for_each_receiver_group(receivers, first_count, visit);
  for_each_receiver_group(middle, count - first_count, visit);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
