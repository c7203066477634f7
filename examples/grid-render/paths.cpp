#include "paths.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include <glm/gtc/constants.hpp>
#include <zonal/grid/interpolate_visible.hpp>
#include <zonal/grid/measure_visibility.hpp>

#include "band_list.hpp"
#include "lighting_bands.hpp"
#include "shared/frame.hpp"
#include "shared/input_error.hpp"
#include "shared/spotlight.hpp"

namespace example::grid_render {
namespace {

/// A direction to the sphere, uniform in the cone of those that meet it, the way to it, and the cone's solid angle.
struct LampSample {
  glm::vec3 direction;
  float distance, solid_angle;
};
LampSample sample_lamp(const zonal::SphereLight<float>& lamp, const glm::vec3& from, const glm::vec2& u) {
  const glm::vec3 to = lamp.center - from;
  const float distance = glm::length(to), sine = std::min(lamp.radius / distance, 1.0f);
  const float cone = 1.0f - std::sqrt(1.0f - sine * sine), z = 1.0f - u.x * cone, r2 = std::max(1.0f - z * z, 0.0f);
  const float phi = glm::two_pi<float>() * u.y, r = std::sqrt(r2);
  const glm::vec3 direction = Frame(to / distance).to_world({r * std::cos(phi), r * std::sin(phi), z});
  const float depth = std::sqrt(std::max(lamp.radius * lamp.radius - distance * distance * r2, 0.0f));
  return {direction, distance * z - depth, glm::two_pi<float>() * cone};
}

/// Random numbers of a place: the same whoever asks.
Pcg32 random_at(const glm::vec3& position) {
  std::uint32_t words[3];
  std::memcpy(words, &position, sizeof words);
  return Pcg32(hash64(words[0] ^ hash64(words[1] ^ hash64(words[2]))));
}

/// Number i of n directions spread evenly over the sphere.
glm::vec3 spread_direction(int i, int n) {
  const float z = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(n), r = std::sqrt(1.0f - z * z);
  const float phi = glm::two_pi<float>() * std::fmod(static_cast<float>(i) * 0.61803399f, 1.0f);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

class PathField final : public LightField {
 public:
  PathField(const Paths& paths, int count) : paths_(paths), count_(count) {}

  glm::vec3 reflected(const Hit& hit, const glm::vec3& outgoing, const Reflector&) const override {
    Pcg32 random = random_at(hit.position);
    glm::vec3 sum(0.0f);
    for (int i = 0; i < count_; ++i) sum += paths_.outgoing(hit, outgoing, random);
    return sum / static_cast<float>(count_);
  }

 private:
  const Paths& paths_;
  int count_;
};

template <int N>
class VisibleField final : public LightField {
 public:
  using Grid = zonal::CoefficientGrid<N, GridContent::values>;
  VisibleField(const Grid& grid, const zonal::GridVisibility& visibility) : grid_(grid), visibility_(visibility) {}

  glm::vec3 reflected(const Hit& hit, const glm::vec3& outgoing, const Reflector& reflector) const override {
    const auto radiance =
        zonal::interpolate<zonal::Interpolation::trilinear>(grid_, visibility_, hit.position, hit.geometric_normal);
    return reflect(radiance, hit, outgoing, reflector);
  }

 private:
  const Grid& grid_;
  const zonal::GridVisibility& visibility_;
};

/// What arrives at a point in free space.
template <int N>
zonal::Sh<N, glm::vec3> arriving(const Paths& paths, const glm::vec3& position, int count) {
  Pcg32 random = random_at(position);
  zonal::Sh<N, glm::vec3> sum{};
  for (int i = 0; i < count; ++i) {
    const glm::vec3 direction = spread_direction(i, count);
    const auto hit = paths.caster().closest(position, direction);
    if (!hit || hit->from_behind) continue;
    const glm::vec3 radiance = paths.outgoing(*hit, -direction, random);
    sum += zonal::evaluate<N>(direction) * (radiance * (2.0f * glm::two_pi<float>() / static_cast<float>(count)));
  }
  const auto lamps = static_cast<int>(paths.lights().size());
  const int rays = std::max(1, count / lamps);
  for (const auto& [lamp, colour] : paths.lights()) {
    const float share = paths.seen_share(position, lamp, rays, random);
    if (share > 0.0f) sum += zonal::project<N>(lamp, position) * (share * colour);
  }
  return sum;
}

template <int N>
class PathGrid final : public LightGrid {
 public:
  using Grid = zonal::CoefficientGrid<N, GridContent::values>;

  PathGrid(const Paths& paths, const Bounds& box, const glm::ivec3& resolution, int count)
      : grid_(box.lower, box.upper, resolution) {
    const auto in_parallel = [](int calls, const auto& body) { for_each_in_parallel(calls, body); };
    const auto trace = [&](const glm::vec3& origin, const glm::vec3& direction) {
      const auto hit = paths.caster().closest(origin, direction);
      return hit ? zonal::RayHit{hit->distance, hit->from_behind} : zonal::RayHit{};
    };
    visibility_ = zonal::measure_visibility(grid_, trace, in_parallel);
    in_parallel(resolution.x * resolution.y * resolution.z, [&](int i) {
      const glm::ivec3 vertex(i % resolution.x, i / resolution.x % resolution.y, i / resolution.x / resolution.y);
      const glm::vec3 offset = visibility_.offset(grid_.vertex_index(vertex));
      grid_.set(vertex, arriving<N>(paths, grid_.position(vertex) + offset, count));
    });
  }

  glm::ivec3 resolution() const override { return grid_.resolution(); }
  std::size_t visibility_bytes() const override { return sizeof(float) * visibility_.size(); }
  std::unique_ptr<LightField> interpolated(zonal::Interpolation) const override {
    return std::make_unique<InterpolatedField<zonal::Interpolation::trilinear, Grid>>(grid_);
  }
  std::unique_ptr<LightField> visible() const override { return std::make_unique<VisibleField<N>>(grid_, visibility_); }
  void save(const std::filesystem::path& path) const override { zonal::save_grid(path, grid_); }

 private:
  Grid grid_;
  zonal::GridVisibility visibility_;
};

template <int N>
class PathLighting final : public Lighting {
 public:
  PathLighting(const Paths& paths, int count) : paths_(paths), count_(count) {}

  std::size_t light_count() const override { return paths_.lights().size(); }
  std::unique_ptr<LightField> exact() const override { return std::make_unique<PathField>(paths_, count_); }
  std::unique_ptr<LightGrid> grid(const Bounds& box, const glm::ivec3& resolution, GridContent) const override {
    return std::make_unique<PathGrid<N>>(paths_, box, resolution, count_);
  }

 private:
  Paths paths_;
  int count_;
};

}  // namespace

glm::vec3 Paths::outgoing(Hit hit, glm::vec3 outgoing, Pcg32& random) const {
  glm::vec3 sum(0.0f), weight(1.0f);
  for (int surface = 0; surface < most_surfaces; ++surface) {
    const zonal::Brdf& brdf = brdf_at(scene_, hit);
    sum += weight * direct(hit, brdf, outgoing, random);
    const Frame frame(hit.normal, hit.tangent);
    const glm::vec2 disc = square_to_disc(random.uniform2());
    const glm::vec3 incoming(disc, std::sqrt(std::max(1.0f - glm::dot(disc, disc), 0.0f)));
    weight *= glm::pi<float>() * zonal::evaluate(brdf, incoming, frame.to_local(outgoing));
    const glm::vec3 direction = frame.to_world(incoming);
    if (glm::dot(direction, hit.geometric_normal) <= 0.0f) break;
    const auto next = caster_.closest_from(hit, direction);
    if (!next || next->from_behind) break;
    outgoing = -direction;
    hit = *next;
  }
  return sum;
}

glm::vec3 Paths::direct(const Hit& hit, const zonal::Brdf& brdf, const glm::vec3& outgoing, Pcg32& random) const {
  const auto count = lights_.size();
  const auto chosen = static_cast<std::size_t>(random.uniform() * static_cast<float>(count));
  const auto& [lamp, colour] = lights_[std::min(chosen, count - 1)];
  const LampSample sample = sample_lamp(lamp, hit.position, random.uniform2());
  const Frame frame(hit.normal, hit.tangent);
  const glm::vec3 incoming = frame.to_local(sample.direction);
  if (incoming.z <= 0.0f || !caster_.visible(hit, hit.position + sample.distance * sample.direction)) {
    return glm::vec3(0.0f);
  }
  const glm::vec3 reflected = zonal::evaluate(brdf, incoming, frame.to_local(outgoing));
  return static_cast<float>(count) * sample.solid_angle * incoming.z * reflected * colour;
}

float Paths::seen_share(const glm::vec3& position, const zonal::SphereLight<float>& lamp, int rays,
                        Pcg32& random) const {
  int seen = 0;
  for (int i = 0; i < rays; ++i) {
    const LampSample sample = sample_lamp(lamp, position, random.uniform2());
    const auto hit = caster_.closest(position, sample.direction);
    seen += !hit || hit->distance >= sample.distance;
  }
  return static_cast<float>(seen) / static_cast<float>(rays);
}

std::unique_ptr<Lighting> make_path_lighting(const Scene& scene, const RayCaster& caster, const SphereLights& lights,
                                             int bands, int count) {
  std::unique_ptr<Lighting> made;
  AllBands::dispatch(bands, [&](auto n) {
    if constexpr (is_built<n, Sphere>) {
      made = std::make_unique<PathLighting<n>>(Paths(scene, caster, lights), count);
    }
  });
  if (!made) throw InputError("this number of bands is not compiled in");
  return made;
}

}  // namespace example::grid_render
