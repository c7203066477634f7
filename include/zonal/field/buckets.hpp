// The directions by which samples are sorted, and what a light probe's picture has for each of them.
//
// A bucket is a texel of a picture of all directions, turned to the positions' axes. Where a probe's picture is of the
// same mapping, size and orientation, as all are that one camera on a stage took, its texel is the bucket's sample as
// it stands. Otherwise the sample is the mean of what the probe shows at 4 x 4 places of the bucket.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "../environment/environment.hpp"
#include "sequence.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Radiance that a probe receives from a bucket's direction; NaN where it does not know.
using RadianceSample = Rgb<float>;
inline constexpr RadianceSample kNoSample{std::numeric_limits<float>::quiet_NaN(),
                                          std::numeric_limits<float>::quiet_NaN(),
                                          std::numeric_limits<float>::quiet_NaN()};
inline bool is_sample(const RadianceSample& sample) { return sample.r >= 0; }

struct Bucket {
  glm::vec3 direction;  // unit, to the light, in the positions' axes
  float solid_angle;    // sr; of all together 4 pi
  int column, row;      // the texel
};

class DirectionBuckets {
  // visit_it(m), m being the mapping itself.
  template <class Visit>
  decltype(auto) visit(Visit&& visit_it) const {
    return visit_mapping(
        mapping_, [&](auto tag) -> decltype(auto) { return visit_it(typename decltype(tag)::Type(width_, height_)); });
  }

 public:
  /// A bucket for each texel that is a direction. Throws std::invalid_argument where there are no such pictures
  /// (refuse.hpp).
  DirectionBuckets(Mapping mapping, int width, int height, const glm::quat& orientation)
      : mapping_(mapping), width_(width), height_(height), orientation_(orientation) {
    constexpr int max_side = Environment<float>::max_side;
    const bool is_size = width >= 1 && height >= 1 && width <= max_side && height <= max_side;
    const std::string wrong =
        is_size ? visit_mapping(mapping, [&](auto tag) { return decltype(tag)::Type::what_is_wrong(width, height); })
                : "it is no size of a picture";
    if (!wrong.empty()) {
      detail::refuse(std::string("no buckets by a ") + mapping_name(mapping) + ", " + std::to_string(width) + " x " +
                     std::to_string(height) + ": " + wrong);
    }
    visit([&](const auto& texels) {
      for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
          if (!texels.has_direction(column, row)) continue;
          const auto d = texels.direction(column + 0.5, row + 0.5);
          const glm::dvec3 direction = glm::normalize(glm::dquat(orientation)) * glm::dvec3(d[0], d[1], d[2]);
          buckets_.push_back({glm::vec3(direction), float(texels.solid_angle(column, row)), column, row});
        }
      }
    });
  }

  std::size_t size() const { return buckets_.size(); }
  const Bucket& operator[](std::size_t i) const { return buckets_[i]; }
  Mapping mapping() const { return mapping_; }
  int width() const { return width_; }
  int height() const { return height_; }
  const glm::quat& orientation() const { return orientation_; }

  /// What a probe shows in every bucket: sample b goes to samples[b * stride]. Texels that are no radiance are no
  /// samples, and are counted in `faults`; so are not those of a dead angle, which are black or no samples.
  template <class Element>
  void sort(const Environment<Element>& environment, const glm::quat& orientation, DeadAngle dead,
            RadianceSample* samples, std::size_t stride, PictureFaults& faults) const {
    const RadianceSample dead_sample = dead == DeadAngle::black ? RadianceSample{0, 0, 0} : kNoSample;
    const auto radiance = [&](int column, int row) {
      PictureFaults found;
      const RadianceSample sample = environment.radiance(column, row, found);
      faults += found;
      return found.total() == 0 ? sample : kNoSample;
    };
    environment.visit([&](const auto& texels) {
      if (environment.mapping() == mapping_ && environment.width() == width_ && environment.height() == height_ &&
          orientation == orientation_) {
        for (std::size_t b = 0; b < size(); ++b) {
          const Bucket& bucket = buckets_[b];
          const bool is_seen = texels.has_direction(bucket.column, bucket.row);
          samples[b * stride] = is_seen ? radiance(bucket.column, bucket.row) : dead_sample;
        }
      } else {
        const glm::dquat to_picture = glm::conjugate(glm::dquat(orientation)) * glm::dquat(orientation_);
        for (std::size_t b = 0; b < size(); ++b) {
          samples[b * stride] = mean_of(buckets_[b], texels, to_picture, dead_sample, radiance);
        }
      }
    });
  }

 private:
  static constexpr int places_ = 4;  // of a bucket's texel, in each direction

  // Of what the probe shows in the bucket.
  template <class Texels, class Radiance>
  RadianceSample mean_of(const Bucket& bucket, const Texels& texels, const glm::dquat& to_picture,
                         const RadianceSample& dead_sample, const Radiance& radiance) const {
    RadianceSample sum{0, 0, 0};
    float count = 0;
    const auto add = [&](const RadianceSample& sample) {
      if (is_sample(sample)) sum += sample, count += 1;
    };
    for (int i = 0; i < places_ * places_; ++i) {
      const double column = bucket.column + (i % places_ + 0.5) / places_,
                   row = bucket.row + (i / places_ + 0.5) / places_;
      const auto d = visit([&](const auto& own) { return own.direction(column, row); });
      const glm::dvec3 direction = to_picture * glm::dvec3(d[0], d[1], d[2]);
      if (!(glm::dot(direction, direction) > 0.5)) continue;  // beside the bucket's disc
      if (is_dead(texels, direction)) {
        add(dead_sample);
        continue;
      }
      const auto place = texels.texel(direction);
      const int texel_column = int(place[0]), texel_row = int(place[1]);
      if (texels.has_direction(texel_column, texel_row)) add(radiance(texel_column, texel_row));
    }
    return count > 0 ? sum / count : kNoSample;
  }

  template <class Texels>
  static bool is_dead(const Texels& texels, const glm::dvec3& direction) {
    if constexpr (std::is_same_v<Texels, MirrorSphere>) return direction.x > std::cos(texels.dead_angle);
    return false;
  }

  Mapping mapping_;
  int width_, height_;
  glm::quat orientation_;
  std::vector<Bucket> buckets_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
