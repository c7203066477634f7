#include "light_sets.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/parallel_for.h>
#include <glm/gtc/constants.hpp>

#include "shared/frame.hpp"
#include "shared/image_file.hpp"
#include "shared/input_error.hpp"
#include "shared/interrupt.hpp"
#include "shared/random.hpp"
#include "shared/spread_points.hpp"

namespace example::igi_render {
namespace {

/// Equal areas of the square, equal solid angles of the sphere.
glm::vec3 sphere_direction(const glm::vec2& u) {
  const float z = 1.0f - 2.0f * u.x, radius = std::sqrt(std::max(0.0f, 1.0f - z * z));
  const float phi = glm::two_pi<float>() * u.y;
  return {radius * std::cos(phi), radius * std::sin(phi), z};
}

/// About the normal, in proportion to the cosine.
glm::vec3 cosine_direction(const glm::vec3& normal, const glm::vec2& u) {
  const glm::vec2 disc = square_to_disc(u);
  return Frame(normal).to_world({disc, std::sqrt(std::max(0.0f, 1.0f - glm::dot(disc, disc)))});
}

/// A ray of light that leaves a source, and the watts on it.
struct Emitted {
  glm::vec3 origin, direction, flux;
};

struct ColouredPoint {
  glm::vec3 position, intensity;
};

/// Red, green and blue about where the spotlight is, as bright together.
std::array<ColouredPoint, 3> three_points(const Scene& scene) {
  const LightPanel& panel = scene.panel;
  const float brightness =
      0.15f * std::max({scene.light.intensity.r, scene.light.intensity.g, scene.light.intensity.b});
  return {{{panel.centre + 0.8f * panel.half_u + 0.7f * panel.half_v, brightness * glm::vec3(1.0f, 0.2f, 0.1f)},
           {panel.centre - 0.8f * panel.half_u, brightness * glm::vec3(0.15f, 1.0f, 0.25f)},
           {panel.centre + 0.8f * panel.half_u - 0.7f * panel.half_v, brightness * glm::vec3(0.15f, 0.3f, 1.0f)}}};
}

/// The lights of a scene: samples of them as they are seen, and paths that leave them.
class Sources {
 public:
  Sources(const Scene& scene, const Options& options, const Probe* probe)
      : scene_(scene), lighting_(options.lighting), probe_(probe), bounds_(bounds_of(scene.mesh)) {
    // The panel shines at what it is there to light, as bright on its axis as the spotlight.
    panel_normal_ = glm::normalize(glm::cross(scene.panel.half_u, scene.panel.half_v));
    if (glm::dot(panel_normal_, bounds_.centre() - scene.panel.centre) < 0.0f) panel_normal_ = -panel_normal_;
  }

  /// Of an extended source one of `count` samples, for each u; of others the source itself, for the first.
  void add_direct(const glm::vec2& u, int index, int count, zonal::LightSet& set) const {
    const float share = 1.0f / static_cast<float>(count);
    switch (lighting_) {
      case Lighting::spot: {
        const Spotlight& spot = scene_.light;
        const float cos_inner = std::cos(spot.half_angle * (1.0f - spot.edge));
        if (index == 0)
          set.append(zonal::spot_sample(spot.position, spot.axis, spot.intensity, spot.cos_half_angle(), cos_inner));
        return;
      }
      case Lighting::three:
        for (const ColouredPoint& point : three_points(scene_)) {
          if (index == 0) set.append(zonal::point_sample(point.position, point.intensity));
        }
        return;
      case Lighting::area:
        set.append(zonal::surface_sample(on_panel(u), panel_normal_, scene_.light.intensity * share));
        return;
      case Lighting::probe: {
        const Probe::Sample sample = probe_->sample(u);
        if (sample.pdf > 0.0f)
          set.append(zonal::directional_sample(sample.direction, sample.radiance * (share / sample.pdf)));
        return;
      }
    }
  }

  /// One of `count` rays that together carry all that the source sends. The first two numbers are for its direction.
  Emitted emit(const glm::vec4& numbers, int count) const {
    const glm::vec2 u(numbers.x, numbers.y), v(numbers.z, numbers.w);
    const float share = 1.0f / static_cast<float>(count);
    switch (lighting_) {
      case Lighting::spot: {
        const glm::vec3 direction = cone_direction(scene_.light, u);
        return {scene_.light.position, direction,
                scene_.light.intensity_towards(direction) * (scene_.light.solid_angle() * share)};
      }
      case Lighting::three: {
        const ColouredPoint point = three_points(scene_)[std::min<std::size_t>(std::size_t(3.0f * v.x), 2)];
        return {point.position, sphere_direction(u), point.intensity * (3.0f * 4.0f * glm::pi<float>() * share)};
      }
      case Lighting::area:
        return {on_panel(v), cosine_direction(panel_normal_, u), scene_.light.intensity * (glm::pi<float>() * share)};
      case Lighting::probe: break;
    }
    const Probe::Sample sample = probe_->sample(u);
    const float radius = bounds_.radius();
    const Frame frame(sample.direction);
    const glm::vec3 on_disc = frame.to_world({square_to_disc(v) * radius, radius});
    const float scale = sample.pdf > 0.0f ? glm::pi<float>() * radius * radius * share / sample.pdf : 0.0f;
    return {bounds_.centre() + on_disc, -sample.direction, sample.radiance * scale};
  }

 private:
  glm::vec3 on_panel(const glm::vec2& u) const {
    return scene_.panel.centre + (2.0f * u.x - 1.0f) * scene_.panel.half_u + (2.0f * u.y - 1.0f) * scene_.panel.half_v;
  }

  const Scene& scene_;
  Lighting lighting_;
  const Probe* probe_;
  Bounds bounds_;
  glm::vec3 panel_normal_{};
};

/// A light where each bounce of the path meets a surface, with what the surface's body reflects.
void add_path(const Scene& scene, const RayCaster& caster, const Emitted& emitted, int bounces, Pcg32& random,
              zonal::LightSet& set) {
  glm::vec3 flux = emitted.flux, direction = emitted.direction;
  std::optional<Hit> hit = caster.closest(emitted.origin, direction);
  for (int bounce = 0; bounce < bounces && hit && flux != glm::vec3(0.0f); ++bounce) {
    const float cosine = std::max(-glm::dot(direction, hit->normal), 0.0f);
    flux *= zonal::diffuse_albedo(brdf_at(scene, *hit), cosine);
    set.append(zonal::surface_sample(hit->position, hit->geometric_normal, flux / glm::pi<float>()));
    if (bounce + 1 == bounces) return;
    direction = cosine_direction(hit->geometric_normal, random.uniform2());
    hit = caster.closest_from(*hit, direction);
  }
}

}  // namespace

Probe::Probe(const std::string& path) : picture_(read_picture(path)) {
  const auto* const numbers = reinterpret_cast<const float*>(picture_.pixels.data());
  try {
    environment_ = zonal::guess_environment(zonal::Picture<const float>(numbers, picture_.width, picture_.height));
  } catch (const std::invalid_argument& error) {
    throw InputError(path + ": " + error.what());
  }
  sampler_.emplace(*environment_, [](int count, const auto& body) { tbb::parallel_for(0, count, body); });
  if (sampler_->is_uniform()) throw InputError(path + ": is black, or too bright, and lights nothing");
}

bool Probe::has_y_up() const {
  const zonal::Mapping mapping = environment_->mapping();
  return mapping == zonal::Mapping::vertical_faces || mapping == zonal::Mapping::horizontal_faces;
}

Probe::Sample Probe::sample(const glm::vec2& u) const {
  const auto drawn = sampler_->sample(static_cast<double>(u.x), static_cast<double>(u.y));
  const glm::vec3 direction = to_scene(glm::vec3(glm::dvec3(drawn.x, drawn.y, drawn.z)));
  return {direction, radiance(direction), static_cast<float>(drawn.pdf)};
}

glm::vec3 Probe::radiance(const glm::vec3& direction) const {
  const glm::dvec3 v(from_scene(direction));
  zonal::PictureFaults faults;
  const auto place = environment_->visit([&](const auto& mapping) { return mapping.texel(v); });
  const auto rgb = environment_->radiance(static_cast<int>(place[0]), static_cast<int>(place[1]), faults);
  return {rgb.r, rgb.g, rgb.b};
}

std::vector<zonal::LightSet> make_light_sets(const Scene& scene, const RayCaster& caster, const Options& options,
                                             const Probe* probe) {
  const Sources sources(scene, options, probe);
  Pcg32 shared(options.seed);
  // Of one well-spread sequence each set takes a run: alone it is spread as well, and all together are the sequence.
  const SpreadPoints direct(shared), rays(shared);
  std::vector<zonal::LightSet> sets(static_cast<std::size_t>(options.pattern.sets()));
  tbb::parallel_for(0, options.pattern.sets(), [&](int index) {
    zonal::LightSet& set = sets[static_cast<std::size_t>(index)];
    for (int i = 0; i < options.samples; ++i) {
      const auto point = static_cast<std::uint32_t>(index * options.samples + i);
      sources.add_direct(glm::vec2(direct.point(point)), i, options.samples, set);
      Pcg32 random(hash64(options.seed) ^ point);
      const Emitted emitted = sources.emit(rays.point(point), options.samples);
      if (!stop_requested()) add_path(scene, caster, emitted, options.bounces, random, set);
    }
  });
  throw_if_interrupted();
  return sets;
}

}  // namespace example::igi_render
