#include "triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace example {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Of the square of the polygon's size: areas that no one sees, and that rounded coordinates make.
constexpr double negligible = 1e-9;

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) { return cross(b - a, c - b); }

/// Does b turn left of a? Not where both go the same way, whatever rounding or a fused product leaves there.
bool is_left(const glm::dvec2& a, const glm::dvec2& b) { return cross(a, b) > 1e-12 * glm::length(a) * glm::length(b); }

/// In the polygon's plane, counterclockwise, about its first corner.
std::vector<glm::dvec2> flattened(std::span<const glm::dvec3> corners, const glm::dvec3& normal) {
  const glm::dvec3 other = std::abs(normal.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 u = glm::normalize(glm::cross(other, normal)), v = glm::cross(normal, u);
  std::vector<glm::dvec2> flat;
  flat.reserve(corners.size());
  for (const glm::dvec3& corner : corners) {
    const glm::dvec3 from_first = corner - corners[0];
    flat.emplace_back(glm::dot(from_first, u), glm::dot(from_first, v));
  }
  return flat;
}

/// Cuts off one corner after the other: one that is convex, and whose triangle nothing of the outline enters.
class EarClipper {
 public:
  EarClipper(std::vector<glm::dvec2> points, double tolerance)
      : points_(std::move(points)),
        tolerance_(tolerance),
        size_(points_.size()),
        next_(size_),
        previous_(size_),
        blocks_(size_),
        by_x_(size_) {
    for (std::size_t i = 0; i < size_; ++i) {
      next_[i] = (i + 1) % size_;
      previous_[i] = (i + size_ - 1) % size_;
    }
    std::iota(by_x_.begin(), by_x_.end(), std::size_t{0});
    const auto key = [&](std::size_t i) { return std::pair(points_[i].x, points_[i].y); };
    std::sort(by_x_.begin(), by_x_.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    // What enters a triangle has a reflex corner in it, or passes through a corner where the outline touches itself.
    for (std::size_t i = 0; i < size_; ++i) blocks_[i] = turn_at(i) < 0.0;
    for (std::size_t i = 0; i + 1 < size_; ++i) {
      if (points_[by_x_[i]] == points_[by_x_[i + 1]]) blocks_[by_x_[i]] = blocks_[by_x_[i + 1]] = 2;
    }
    std::erase_if(by_x_, [&](std::size_t i) { return !blocks_[i]; });
  }

  /// False where there was no ear to cut off.
  bool clip(Triangles& triangles) {
    bool clean = true;
    std::size_t at = 0, left = size_, failures = 0;
    while (left > 3) {
      if (is_spike(at)) {
        at = previous_[remove(at)];
        --left, failures = 0;
      } else if (is_ear(at)) {
        add(at, triangles);
        at = next_[remove(at)];  // not its neighbour next: fans make slivers
        --left, failures = 0;
      } else if (++failures <= left) {
        at = next_[at];
      } else {
        const std::size_t worst = flattest(at, left);
        if (std::abs(turn_at(worst)) > tolerance_) {
          clean = false;
          add(worst, triangles);
        }
        at = remove(worst);
        --left, failures = 0;
      }
    }
    clean = clean && turn_at(at) >= -tolerance_;
    if (std::abs(turn_at(at)) > 0.0) add(at, triangles);
    return clean;
  }

 private:
  double turn_at(std::size_t i) const { return turn(points_[previous_[i]], points_[i], points_[next_[i]]); }

  /// The corner after the removed one.
  std::size_t remove(std::size_t i) {
    const std::size_t before = previous_[i], after = next_[i];
    next_[before] = after;
    previous_[after] = before;
    blocks_[i] = 0;
    for (const std::size_t neighbour : {before, after}) {
      if (blocks_[neighbour] == 1) blocks_[neighbour] = turn_at(neighbour) < 0.0;
    }
    return after;
  }

  void add(std::size_t i, Triangles& triangles) const {
    triangles.push_back({static_cast<std::uint32_t>(previous_[i]), static_cast<std::uint32_t>(i),
                         static_cast<std::uint32_t>(next_[i])});
  }

  /// Out and back on the same way.
  bool is_spike(std::size_t i) const {
    const glm::dvec2 &a = points_[previous_[i]], &b = points_[i], &c = points_[next_[i]];
    return std::abs(turn(a, b, c)) <= tolerance_ && glm::dot(a - b, c - b) >= 0.0;
  }

  bool is_ear(std::size_t i) const {
    if (!(turn_at(i) > 0.0)) return false;
    const std::array<std::size_t, 3> ear{previous_[i], i, next_[i]};
    const glm::dvec2 &a = points_[ear[0]], &b = points_[ear[1]], &c = points_[ear[2]];
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    auto found =
        std::lower_bound(by_x_.begin(), by_x_.end(), left, [&](std::size_t k, double x) { return points_[k].x < x; });
    for (; found != by_x_.end() && points_[*found].x <= right; ++found) {
      if (blocks_[*found] && *found != ear[0] && *found != ear[1] && *found != ear[2] && enters(*found, ear)) {
        return false;
      }
    }
    return true;
  }

  /// Does the outline at corner k enter the triangle?
  bool enters(std::size_t k, const std::array<std::size_t, 3>& ear) const {
    const glm::dvec2& p = points_[k];
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec2& corner = points_[ear[i]];
      if (p != corner) continue;
      const glm::dvec2 ahead = points_[ear[(i + 1) % 3]] - corner, behind = points_[ear[(i + 2) % 3]] - corner;
      for (const std::size_t neighbour : {previous_[k], next_[k]}) {
        const glm::dvec2 way = points_[neighbour] - corner;
        if (is_left(ahead, way) && is_left(way, behind)) return true;
      }
      return false;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (turn(points_[ear[i]], points_[ear[(i + 1) % 3]], p) < 0.0) return false;
    }
    return true;
  }

  std::size_t flattest(std::size_t at, std::size_t left) const {
    std::size_t best = at;
    for (std::size_t i = 0; i < left; ++i, at = next_[at]) {
      if (std::abs(turn_at(at)) < std::abs(turn_at(best))) best = at;
    }
    return best;
  }

  std::vector<glm::dvec2> points_;
  double tolerance_;
  std::size_t size_;
  std::vector<std::size_t> next_, previous_;
  std::vector<char> blocks_;       // 1: reflex; 2: where another corner is as well; 0: neither, or cut off
  std::vector<std::size_t> by_x_;  // those that block
};

bool add_quadrilateral(std::span<const glm::dvec3> p, const glm::dvec3& normal, double tolerance,
                       Triangles& triangles) {
  const auto area = [&](std::size_t a, std::size_t b, std::size_t c) {
    return glm::dot(glm::cross(p[b] - p[a], p[c] - p[a]), normal);
  };
  const double first = std::min(area(0, 1, 2), area(0, 2, 3)), second = std::min(area(0, 1, 3), area(1, 2, 3));
  const bool both = std::min(first, second) > tolerance;
  // Rounded coordinates must not choose between equal ones.
  const bool shorter = glm::distance(p[0], p[2]) <= (1.0 + 1e-6) * glm::distance(p[1], p[3]);
  if (both ? shorter : first >= second) {
    triangles.push_back({0, 1, 2});
    triangles.push_back({0, 2, 3});
  } else {
    triangles.push_back({0, 1, 3});
    triangles.push_back({1, 2, 3});
  }
  return std::max(first, second) >= -tolerance;
}

}  // namespace

glm::dvec3 newell_area(std::span<const glm::dvec3> corners) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return sum;
}

bool triangulate(std::span<const glm::dvec3> corners, Triangles& triangles) {
  const std::size_t count = corners.size();
  if (count < 3) return true;
  if (count == 3) {
    triangles.push_back({0, 1, 2});
    return true;
  }
  double size = 0.0, areas = 0.0;
  for (std::size_t i = 1; i < count; ++i) {
    size = std::max(size, glm::distance(corners[i], corners[0]));
    if (i > 1) areas += glm::length(glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]));
  }
  const double tolerance = negligible * size * size;
  const glm::dvec3 area = newell_area(corners);
  if (!(glm::length(area) > tolerance)) {
    // Without a side to look from: a line, or an outline that crosses itself, as a bow tie does.
    for (std::uint32_t i = 1; i + 1 < count; ++i) triangles.push_back({0, i, i + 1});
    return areas <= tolerance;
  }
  const glm::dvec3 normal = glm::normalize(area);
  if (count == 4) return add_quadrilateral(corners, normal, tolerance, triangles);
  return EarClipper(flattened(corners, normal), tolerance).clip(triangles);
}

}  // namespace example
