#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <zonal/environment/guess.hpp>
#include <zonal/environment/sample.hpp>
#include <zonal/screen/incident.hpp>

#include "options.hpp"
#include "shared/image.hpp"
#include "shared/ray_caster.hpp"
#include "shared/scene.hpp"

namespace example::igi_render {

/// A picture of the surroundings, with directions of the scene, y up.
class Probe {
 public:
  /// Throws InputError.
  explicit Probe(const std::string& path);

  struct Sample {
    glm::vec3 direction;  // unit, to the light
    glm::vec3 radiance;
    float pdf;  // per steradian
  };
  Sample sample(const glm::vec2& u) const;
  glm::vec3 radiance(const glm::vec3& direction) const;

 private:
  bool has_y_up() const;
  glm::vec3 to_scene(const glm::vec3& v) const { return has_y_up() ? v : glm::vec3(v.x, v.z, -v.y); }
  glm::vec3 from_scene(const glm::vec3& v) const { return has_y_up() ? v : glm::vec3(v.x, -v.z, v.y); }

  Image picture_;
  std::optional<zonal::Environment<float>> environment_;
  std::optional<zonal::EnvironmentSampler<float>> sampler_;
};

/// The sets of lights of the pattern, one after the other, each a whole estimate of all light: direct light of the kind
/// that the options name, and a light wherever one of its paths meets a surface. `probe` where there is one.
std::vector<zonal::LightSet> make_light_sets(const Scene& scene, const RayCaster& caster, const Options& options,
                                             const Probe* probe);

}  // namespace example::igi_render
