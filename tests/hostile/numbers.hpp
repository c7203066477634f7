// What no function of this library expects, and must bear: docs/floating_point.md says what each gives for it.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>

namespace hostile {

template <class T>
std::vector<T> numbers() {
  using Limits = std::numeric_limits<T>;
  return {Limits::quiet_NaN(),
          Limits::infinity(),
          -Limits::infinity(),
          Limits::max(),
          Limits::lowest(),
          T(-1),
          T(0),
          -T(0),
          Limits::denorm_min(),
          Limits::min(),
          T(0.3),
          T(1)};
}

/// Vectors of such numbers: each with two ordinary ones, and three alike.
inline std::vector<glm::vec3> vectors() {
  std::vector<glm::vec3> all;
  for (const float x : numbers<float>()) {
    all.insert(all.end(), {{x, 0.6F, 0.8F}, {0.6F, x, 0.8F}, {0.6F, 0.8F, x}, {x, x, x}});
  }
  return all;
}

inline bool is_number(const glm::vec3& v) { return !std::isnan(v.x) && !std::isnan(v.y) && !std::isnan(v.z); }

}  // namespace hostile
