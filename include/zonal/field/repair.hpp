// Points of a lattice that no sample reached: what they get from the others.
//
// `mip_maps` is the paper's repair [1]: lattices of half the resolution, one over the other, each point the mean of
// those of its up to eight children that have a value; a hole takes what the next lattice has around it, linearly
// interpolated, and that is repaired before in the same way. It is smooth, and blurs: where light ends within a hole,
// it ends as far from there as the hole is wide.
//
// `nearest` gives a hole the value of the nearest point that has one: an edge stays one, in the middle of the hole.
// docs/rooms/field.md compares them.
//
// [1] Loew, Ynnerman, Larsson, Unger, HDR light probe sequence resampling for realtime incident light field rendering,
//     SCCG 2009, section 3.3.
// [2] Felzenszwalb and Huttenlocher, Distance transforms of sampled functions, Theory of Computing 8, 2012.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <glm/vec3.hpp>

#include "../scalar/target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

enum class Repair { mip_maps, nearest };

/// Radiance at a point of a lattice, times `weight`; without any, a hole.
struct alignas(16) LatticePoint {
  float r = 0, g = 0, b = 0, weight = 0;
};

namespace detail {

inline std::size_t lattice_size(const glm::ivec3& size) {
  return std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
}

inline void add_weighted(LatticePoint& sum, const LatticePoint& point, float weight) {
  sum.r += weight * point.r, sum.g += weight * point.g, sum.b += weight * point.b, sum.weight += weight * point.weight;
}
inline void normalise(LatticePoint& sum) {
  if (!(sum.weight > 0)) return;
  sum.r /= sum.weight, sum.g /= sum.weight, sum.b /= sum.weight, sum.weight = 1;
}

// visit(i, j, k, number) for all points, x fastest.
template <class Visit>
void for_each_point(const glm::ivec3& size, const Visit& visit) {
  std::size_t number = 0;
  for (int k = 0; k < size.z; ++k) {
    for (int j = 0; j < size.y; ++j) {
      for (int i = 0; i < size.x; ++i) visit(i, j, k, number++);
    }
  }
}

inline bool has_holes(const LatticePoint* points, std::size_t count) {
  return std::any_of(points, points + count, [](const LatticePoint& point) { return !(point.weight > 0); });
}

// Where a point lies on the axis of a lattice of half the resolution: between which two, and how much of the second.
struct HalfPlace {
  int first, second;
  float share;
  HalfPlace(int i, int half_size)
      : first((i - 1) / 2), second((std::min)((i + 1) / 2, half_size - 1)), share(i % 2 == 0 ? 0.75F : 0.25F) {}
};

// All weights are 0 or 1, and one is 1.
inline void repair_by_mip_maps(LatticePoint* points, const glm::ivec3& size) {
  std::vector<LatticePoint> coarser;  // all levels but the first
  std::vector<glm::ivec3> sizes{size};
  std::vector<std::size_t> begins{0};
  const auto level = [&](std::size_t n) { return n == 0 ? points : coarser.data() + begins[n]; };
  while (has_holes(level(sizes.size() - 1), lattice_size(sizes.back()))) {
    const glm::ivec3 fine = sizes.back(), coarse = (fine + 1) / 2;
    begins.push_back(coarser.size());
    coarser.resize(coarser.size() + lattice_size(coarse));
    const LatticePoint* from = level(sizes.size() - 1);
    sizes.push_back(coarse);
    LatticePoint* to = level(sizes.size() - 1);
    for_each_point(fine, [&](int i, int j, int k, std::size_t number) {
      const int x = i / 2, y = j / 2, z = k / 2;
      add_weighted(
          to[std::size_t(x) + std::size_t(coarse.x) * (std::size_t(y) + std::size_t(coarse.y) * std::size_t(z))],
          from[number], 1);
    });
    for (std::size_t n = 0; n < lattice_size(coarse); ++n) normalise(to[n]);
  }
  for (std::size_t n = sizes.size() - 1; n-- > 0;) {
    const glm::ivec3 half = sizes[n + 1];
    const LatticePoint* from = level(n + 1);
    LatticePoint* to = level(n);
    for_each_point(sizes[n], [&](int i, int j, int k, std::size_t number) {
      if (to[number].weight > 0) return;
      const HalfPlace x(i, half.x), y(j, half.y), z(k, half.z);
      for (int corner = 0; corner < 8; ++corner) {
        const bool far[3] = {(corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0};
        const auto at = [&](int axis, const HalfPlace& place) {
          return std::size_t(far[axis] ? place.second : place.first);
        };
        const auto weight = [&](int axis, const HalfPlace& place) { return far[axis] ? place.share : 1 - place.share; };
        add_weighted(to[number], from[at(0, x) + std::size_t(half.x) * (at(1, y) + std::size_t(half.y) * at(2, z))],
                     weight(0, x) * weight(1, y) * weight(2, z));
      }
      normalise(to[number]);
    });
  }
}

// The nearest point with a value for each of a line, by the lower envelope of parabolas [2]: `height` is the squared
// distance to its own nearest so far, `nearest` which that is.
class NearestOnLine {
 public:
  explicit NearestOnLine(int longest)
      : height_(std::size_t(longest)),
        source_(std::size_t(longest)),
        lowest_(std::size_t(longest)),
        begins_(std::size_t(longest)) {}

  void run(float* height, std::size_t* source, int count, std::size_t stride) {
    const auto at = [&](int i) { return std::size_t(i) * stride; };
    int parabolas = 0;
    for (int i = 0; i < count; ++i) {
      height_[std::size_t(i)] = height[at(i)], source_[std::size_t(i)] = source[at(i)];
      if (!(height[at(i)] < infinite)) continue;
      double begin = -1e30;
      for (; parabolas > 0; --parabolas) {  // those that this one covers
        begin = meets(lowest_[std::size_t(parabolas) - 1], i);
        if (begin > begins_[std::size_t(parabolas) - 1]) break;
        begin = -1e30;
      }
      lowest_[std::size_t(parabolas)] = i, begins_[std::size_t(parabolas)] = begin;
      ++parabolas;
    }
    int n = 0;
    for (int i = 0; parabolas > 0 && i < count; ++i) {
      while (n + 1 < parabolas && begins_[std::size_t(n) + 1] < i) ++n;
      const int from = lowest_[std::size_t(n)];
      height[at(i)] = height_[std::size_t(from)] + float(i - from) * float(i - from);
      source[at(i)] = source_[std::size_t(from)];
    }
  }

  static constexpr float infinite = (std::numeric_limits<float>::max)();

 private:
  // From where on the parabola about `later` is below that about `earlier`.
  double meets(int earlier, int later) const {
    const double a = double(height_[std::size_t(earlier)]), b = double(height_[std::size_t(later)]);
    return ((b + double(later) * later) - (a + double(earlier) * earlier)) / (2.0 * (later - earlier));
  }

  std::vector<float> height_;
  std::vector<std::size_t> source_;
  std::vector<int> lowest_;
  std::vector<double> begins_;
};

inline void repair_by_nearest(LatticePoint* points, const glm::ivec3& size) {
  const std::size_t count = lattice_size(size);
  std::vector<float> height(count);
  std::vector<std::size_t> source(count);
  for (std::size_t n = 0; n < count; ++n) {
    height[n] = points[n].weight > 0 ? 0 : NearestOnLine::infinite;
    source[n] = n;
  }
  NearestOnLine line((std::max)({size.x, size.y, size.z}));
  std::size_t stride = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t length = std::size_t(size[axis]);
    for (std::size_t n = 0; n < count; ++n) {
      if (n / stride % length == 0) line.run(&height[n], &source[n], size[axis], stride);
    }
    stride *= length;
  }
  for (std::size_t n = 0; n < count; ++n) points[n] = points[source[n]];  // a source is its own, so it stays
}

}  // namespace detail

/// Fills the holes of a lattice of size.x * size.y * size.z points, x fastest, all of weight 0 or 1; false where all
/// are holes.
inline bool repair(Repair how, LatticePoint* points, const glm::ivec3& size) {
  const std::size_t count = detail::lattice_size(size);
  if (std::none_of(points, points + count, [](const LatticePoint& point) { return point.weight > 0; })) return false;
  if (!detail::has_holes(points, count)) return true;
  how == Repair::mip_maps ? detail::repair_by_mip_maps(points, size) : detail::repair_by_nearest(points, size);
  return true;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
