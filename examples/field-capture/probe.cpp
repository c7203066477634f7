#include "probe.hpp"

#include <array>
#include <cmath>

#include <tbb/parallel_for.h>

#include "mirror_ball.hpp"
#include "shared/interrupt.hpp"
#include "shared/spread_points.hpp"

namespace example::field_capture {
namespace {

constexpr int disc_samples = 256;

glm::dvec3 as_vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

template <class Mapping>
class Capture {
 public:
  Capture(const Mapping& mapping, const ProbeCamera& camera, const IncidentRadiance& light, const glm::vec3& position)
      : mapping_(mapping),
        light_(light),
        position_(position),
        to_scene_(glm::mat3_cast(glm::dquat(picture_orientation()))),
        picture_(camera.width, camera.height) {
    ball_.radius = camera.sphere_radius;
  }

  Image take(int samples, std::uint64_t seed) {
    tbb::parallel_for(0, picture_.height, [&](int row) {
      for (int column = 0; column < picture_.width && !stop_requested(); ++column) {
        if (!mapping_.has_direction(column, row)) continue;
        Pcg32 random(hash64(seed) ^ picture_.index(column, row));
        picture_.at(column, row) = along_rays(column, row, samples, random);
      }
    });
    Pcg32 random(hash64(seed) + 1);
    for (const Emitter& emitter : light_.emitters()) {
      if (emitter.shape == Emitter::Shape::disc) add(emitter, random);
    }
    return std::move(picture_);
  }

 private:
  glm::vec3 along_rays(int column, int row, int samples, Pcg32& random) const {
    const SpreadPoints points(random);
    glm::vec3 sum(0.0f);
    for (int sample = 0; sample < samples; ++sample) {
      const glm::dvec2 place(glm::vec2(points.point(static_cast<std::uint32_t>(sample))));
      glm::dvec3 direction = as_vector(mapping_.direction(column + place.x, row + place.y));
      // At the rim of a disc some places have none.
      if (direction == glm::dvec3(0.0)) direction = as_vector(mapping_.direction(column + 0.5, row + 0.5));
      const glm::vec3 start = position_ + glm::vec3(to_scene_ * ball_.start(direction));
      sum += light_.along_ray(start, glm::vec3(to_scene_ * direction), random);
    }
    return sum / static_cast<float>(samples);
  }

  void add(const Emitter& emitter, Pcg32& random) {
    const SpreadPoints points(random);
    for (std::uint32_t i = 0; i < disc_samples; ++i) {
      const glm::vec2 square(points.point(i));
      const auto view = ball_.view(glm::transpose(to_scene_) * glm::dvec3(emitter.point(square) - position_));
      if (!view) continue;
      const std::array<double, 2> texel =
          mapping_.texel(std::array<double, 3>{view->direction.x, view->direction.y, view->direction.z});
      const int column = static_cast<int>(texel[0]), row = static_cast<int>(texel[1]);
      if (!mapping_.has_direction(column, row)) continue;
      const glm::vec3 start = position_ + glm::vec3(to_scene_ * view->start);
      const IncidentRadiance::Arrival arrival = light_.arrival(emitter, start, square, disc_samples);
      if (arrival.irradiance == glm::vec3(0.0f) || !light_.visible(start, arrival.point)) continue;
      picture_.at(column, row) +=
          arrival.irradiance * static_cast<float>(view->stretch / mapping_.solid_angle(column, row));
    }
  }

  const Mapping& mapping_;
  const IncidentRadiance& light_;
  glm::vec3 position_;
  glm::dmat3 to_scene_;
  MirrorBall ball_;
  Image picture_;
};

}  // namespace

ProbeCamera ProbeCamera::of_side(zonal::Mapping mapping, int side) {
  const int face = std::max(side / 2, 1);
  switch (mapping) {
    case zonal::Mapping::equirectangular: return {mapping, 2 * side, side};
    case zonal::Mapping::vertical_cross: return {mapping, 3 * face, 4 * face};
    case zonal::Mapping::horizontal_cross: return {mapping, 4 * face, 3 * face};
    case zonal::Mapping::vertical_faces: return {mapping, face, 6 * face};
    case zonal::Mapping::horizontal_faces: return {mapping, 6 * face, face};
    default: return {mapping, side, side};
  }
}

glm::quat picture_orientation() {
  return glm::quat_cast(glm::mat3({0.0f, 0.0f, -1.0f}, {-1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}));
}

Image capture_probe(const ProbeCamera& camera, const IncidentRadiance& light, const glm::vec3& position, int samples,
                    std::uint64_t seed) {
  return zonal::visit_mapping(camera.mapping, [&](auto tag) {
    using Mapping = typename decltype(tag)::Type;
    if constexpr (std::is_same_v<Mapping, zonal::MirrorSphere>) {
      const Mapping mapping(camera.width, camera.height, camera.dead_angle);
      return Capture(mapping, camera, light, position).take(samples, seed);
    } else {
      const Mapping mapping(camera.width, camera.height);
      return Capture(mapping, camera, light, position).take(samples, seed);
    }
  });
}

}  // namespace example::field_capture
