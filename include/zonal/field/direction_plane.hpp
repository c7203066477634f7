// Radiance from one direction, on the plane across it.
//
// Nothing within the volume stands in the way, so radiance is the same along a ray, and all rays of a bucket are
// parallel: what the paper carries through the volume in three dimensions [1] is a function of two. A sample is added
// where its ray meets the plane, once, not along its way; a grid point looks up the place where its own ray does.
//
// Between scattered samples the paper takes the mean, weighted by a Gaussian of the distance. That is wrong to first
// order where radiance changes and samples are not the same on all sides, as few ever are. Here a linear function is
// fitted to them by the same weights, at each point of the plane [2]: value = mean - slope . (mean place - point). The
// slope's normal equations have `slope_damping` deviations^2 of the kernel added to their diagonal, as if samples lay
// about a little, so that one sample, or several on a line, are no trouble; infinite, it is the paper's mean. Error
// against the paper's, of the field's RMS, mirror spheres of 64 x 64 in 2 x 1 x 1:
//
//                                grid         5^3     9^3     17^3    33^3   (twice that along x)
//   smooth light, 1600 probes    mean       0.0320  0.0111  0.0071  0.0045
//                                linear     0.0109  0.0047  0.0048  0.0039
//   a disc of hard edge          mean       0.1217  0.0572  0.0456  0.0376
//                                linear     0.0620  0.0434  0.0400  0.0368
//
// Lengths are in cells of the grid, along each axis its own: cells are cubes then, and rays stay straight.
//
// [1] Loew, Ynnerman, Larsson, Unger, HDR light probe sequence resampling for realtime incident light field rendering,
//     SCCG 2009, section 3.2.
// [2] Cleveland, Robust locally weighted regression and smoothing scatterplots, JASA 74, 1979.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "../scalar/index.hpp"
#include "../scalar/lanes.hpp"
#include "../scalar/vector3.hpp"
#include "buckets.hpp"
#include "repair.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The kernel by which samples count: a Gaussian of the distance in cells, cut off three cells wide [1]. How wide the
/// Gaussian is the paper does not say; here its deviation is a third of the radius.
inline constexpr float kKernelRadius = 1.5F;
inline constexpr float kKernelDeviation = kKernelRadius / 3;
inline float kernel_weight(float squared_distance) {
  return std::exp(squared_distance * (-0.5F / (kKernelDeviation * kKernelDeviation)));
}

inline constexpr float kLeastSlopeDamping = 0.1F;  // below, rounding decides on a slope across samples on a line

/// From so many samples a square cell on, a plane has two points a cell along its axes: interpolation between them then
/// blurs less than samples are apart.
inline constexpr float kDense = 1;

/// How samples become a field: `slope_damping` from kLeastSlopeDamping, which all that is less counts as, to infinity,
/// the mean; and what happens to holes.
struct Resampling {
  float slope_damping = kLeastSlopeDamping;
  Repair repair = Repair::mip_maps;

  /// As the paper has it.
  static constexpr Resampling of_paper() { return {std::numeric_limits<float>::infinity(), Repair::mip_maps}; }
};

class DirectionPlane {
 public:
  /// Of rays along `direction`, of any length, through a box of resolution - 1 cells. visit(add) calls add(position,
  /// sample) for all samples, positions anywhere on their rays. False where none came near the box, or where the
  /// direction is none: its square is 0, or more than a float holds, or no number.
  template <class Visit>
  bool make(const glm::vec3& direction, const glm::ivec3& resolution, const Resampling& resampling,
            const Visit& visit) {
    const float length2 = glm::dot(direction, direction);
    if (!(length2 > 0 && length2 <= (std::numeric_limits<float>::max)())) return false;
    set_plane(direction, resolution, 1);
    float samples = 0;
    visit([&](const glm::vec3& position, const RadianceSample&) { samples += is_near(place(position)) ? 1.0F : 0.0F; });
    if (samples >= kDense * float(size_.x) * float(size_.y)) set_plane(direction, resolution, 2);
    std::vector<Sums> sums(detail::lattice_size(size_));
    visit([&](const glm::vec3& position, const RadianceSample& sample) { add(position, sample, sums.data()); });
    points_.resize(sums.size());
    for (std::size_t n = 0; n < sums.size(); ++n) points_[n] = sums[n].fit(resampling.slope_damping);
    return repair(resampling.repair, points_.data(), size_);
  }

  /// Where a position's ray meets the plane, in points of it. Of positions in the box, and one point beside them, there
  /// is radiance.
  struct Place {
    float x, y;
  };
  Place place(const glm::vec3& position) const {
    return {glm::dot(position, slope_[0]) + offset_[0], glm::dot(position, slope_[1]) + offset_[1]};
  }
  /// How x (axis 0) and y (axis 1) of the place change with the position.
  const glm::vec3& slope(int axis) const { return slope_[axis]; }

  /// Radiance at a place, bilinear: red, green, blue, and 1.
  ZONAL_INLINE Lanes<float, 4> radiance(float x, float y) const {
    using Point = Lanes<float, 4>;
    const int column = detail::index_below(x, size_.x - 2), row = detail::index_below(y, size_.y - 2);
    const float* corner = &points_[index(column, row)].r;
    const float* below = corner + 4 * std::size_t(size_.x);
    const Point right(x - float(column)), down(y - float(row));
    const auto mix = [](const Point& a, const Point& b, const Point& share) { return a + share * (b - a); };
    return mix(mix(Point::load(corner), Point::load(corner + 4), right),
               mix(Point::load(below), Point::load(below + 4), right), down);
  }

 private:
  static constexpr int margin_ = 2;  // points around what the box's rays meet

  // Of a point: weighted sums of 1, u, v, uu, uv, vv, with (u, v) from the point to the sample; of its colour, and of
  // that times u, and v.
  struct alignas(64) Sums {
    float numbers[16] = {};

    LatticePoint fit(float damping) const {
      if (!(numbers[0] > 0)) return {};
      const double weight = double(numbers[0]);
      const auto mean_of = [&](int i) { return double(numbers[i]) / weight; };
      const double u = mean_of(1), v = mean_of(2);
      const double added = double((std::max)(damping, kLeastSlopeDamping) * kKernelDeviation * kKernelDeviation);
      const double uu = mean_of(3) - u * u + added, uv = mean_of(4) - u * v, vv = mean_of(5) - v * v + added;
      const double determinant = uu * vv - uv * uv;
      const bool has_slope = determinant > 0 && determinant <= double((std::numeric_limits<float>::max)());
      // The value here is the mean less slope . (u, v), the slope by Cramer's rule.
      const double by_u = has_slope ? (vv * u - uv * v) / determinant : 0;
      const double by_v = has_slope ? (uu * v - uv * u) / determinant : 0;
      float colour[3];
      for (int c = 0; c < 3; ++c) {
        const double mean = mean_of(6 + c), cu = mean_of(9 + c) - u * mean, cv = mean_of(12 + c) - v * mean;
        colour[c] = float((std::max)(mean - (by_u * cu + by_v * cv), 0.0));  // radiance
      }
      return {colour[0], colour[1], colour[2], 1};
    }
  };

  void set_plane(const glm::vec3& direction, const glm::ivec3& resolution, int points_per_cell) {
    points_per_cell_ = float(points_per_cell);
    const glm::vec3 w = glm::normalize(direction), cells(resolution - 1);
    const float z[3] = {w.x, w.y, w.z};
    float x[3], y[3];
    complete_frame(z, x, y);
    slope_[0] = glm::vec3(x[0], x[1], x[2]) * points_per_cell_;
    slope_[1] = glm::vec3(y[0], y[1], y[2]) * points_per_cell_;
    size_.z = 1;
    for (int a = 0; a < 2; ++a) {
      const glm::vec3 ends = slope_[a] * cells, low = (glm::min)(ends, 0.0F), high = (glm::max)(ends, 0.0F);
      const float first = low.x + low.y + low.z, last = high.x + high.y + high.z;
      offset_[a] = float(margin_) - first;
      size_[a] = int(last - first) + 2 * margin_ + 2;
    }
  }

  // Is it on the plane, or so near that a point may be in its reach?
  bool is_near(const Place& at) const {
    const float reach = kKernelRadius * points_per_cell_;
    return at.x > -reach && at.y > -reach && at.x < float(size_.x) + reach && at.y < float(size_.y) + reach;
  }

  void add(const glm::vec3& position, const RadianceSample& sample, Sums* sums) const {
    const Place at = place(position);
    if (!is_near(at)) return;
    const float reach = kKernelRadius * points_per_cell_, cells = 1 / points_per_cell_;
    const auto first = [&](float x, int size) { return detail::index_below(std::ceil(x - reach), size); };
    const auto last = [&](float x, int size) { return detail::index_below(x + reach, size - 1); };
    for (int y = first(at.y, size_.y); y <= last(at.y, size_.y); ++y) {
      for (int x = first(at.x, size_.x); x <= last(at.x, size_.x); ++x) {
        const float u = (at.x - float(x)) * cells, v = (at.y - float(y)) * cells, distance2 = u * u + v * v;
        if (!(distance2 <= kKernelRadius * kKernelRadius)) continue;
        const auto [r, g, b] = sample;
        const float terms[16] = {1, u, v, u * u, u * v, v * v, r, g, b, u * r, u * g, u * b, v * r, v * g, v * b, 0};
        add_product(kernel_weight(distance2), terms, sums[index(x, y)].numbers);
      }
    }
  }
  ZONAL_INLINE static void add_product(float weight, const float (&terms)[16], float (&sums)[16]) {
    using Part = Lanes<float, kNativeLanes>;
    for (int i = 0; i < 16; i += kNativeLanes) {
      Part sum = Part::load(sums + i);
      sum.add_product(Part(weight), Part::load(terms + i));
      sum.store(sums + i);
    }
  }

  std::size_t index(int x, int y) const { return std::size_t(x) + std::size_t(size_.x) * std::size_t(y); }

  float points_per_cell_ = 1;
  glm::vec3 slope_[2]{};
  float offset_[2]{};
  glm::ivec3 size_{0};
  std::vector<LatticePoint> points_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
