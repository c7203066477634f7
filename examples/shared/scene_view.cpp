#include "scene_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "materials.hpp"
#include "mesh_builder.hpp"
#include "ray_caster.hpp"
#include "tangents.hpp"

namespace example {
namespace {

constexpr glm::vec3 up(0.0f, 1.0f, 0.0f);

// A cone that falls off nearly as the cosine, as a flat lamp's light does.
constexpr float lamp_half_angle = 88.0f, lamp_edge = 0.97f;

/// White surfaces that face the light at its distance reflect a radiance of about 1.
glm::vec3 intensity_for(float distance) { return glm::vec3(glm::pi<float>() * distance * distance); }

// ---- From outside ---------------------------------------------------------------------------------------------------

void view_from_outside(Scene& scene, const Bounds& bounds) {
  const float radius = bounds.radius();
  const glm::vec3 centre = bounds.centre();
  scene.camera.target = centre;
  scene.camera.vertical_field_of_view = glm::radians(40.0f);
  scene.camera.position = centre + 3.3f * radius * glm::normalize(glm::vec3(0.35f, 0.30f, 1.0f));
  scene.light.position = centre + 3.2f * radius * glm::normalize(glm::vec3(-0.75f, 0.85f, 0.65f));
  scene.light.axis = glm::normalize(centre - scene.light.position);
  scene.light.half_angle = glm::radians(54.0f);
  scene.light.edge = 0.5f;
  const glm::vec3 across = glm::normalize(glm::cross(scene.light.axis, up));
  const float distance = glm::distance(centre, scene.light.position);
  scene.panel = {scene.light.position, radius * across, radius * glm::cross(across, scene.light.axis), distance};
  scene.light.intensity = intensity_for(distance);
}

/// A floor under the object, a wall behind it, and a coloured wall on the side away from the light.
void add_stage(Scene& scene, const Bounds& bounds) {
  const auto floor = static_cast<std::uint32_t>(scene.materials.size());
  scene.materials.push_back({"stage floor", matte({0.72f, 0.70f, 0.66f})});
  scene.materials.push_back({"stage back wall", matte({0.30f, 0.45f, 0.66f})});
  scene.materials.push_back({"stage side wall", matte({0.74f, 0.30f, 0.14f})});
  const float radius = bounds.radius();
  const float size = 5.0f * radius;
  // Not in the plane of the object's own underside.
  const float ground = bounds.lower.y - 2e-3f * radius;
  const float back = bounds.lower.z - 0.5f * radius;
  // Beyond the camera, also of what is narrow.
  const float side = std::max(bounds.upper.x + 0.9f * radius, scene.camera.position.x + 0.3f * radius);
  const float front = bounds.upper.z + size;
  const float left = bounds.lower.x - size;
  MeshBuilder builder(scene.mesh);
  builder.use(floor).quad({left, ground, front}, {side, ground, front}, {side, ground, back}, {left, ground, back});
  builder.begin_mesh().use(floor + 1).quad({left, ground, back}, {side, ground, back}, {side, ground + size, back},
                                           {left, ground + size, back});
  builder.begin_mesh().use(floor + 2).quad({side, ground, back}, {side, ground, front}, {side, ground + size, front},
                                           {side, ground + size, back});
  set_tangents(scene.mesh);
}

// ---- From inside ----------------------------------------------------------------------------------------------------

/// A ray's free way, and whether it ends at the front of a face.
struct Way {
  float length = std::numeric_limits<float>::infinity();
  bool to_front = false;
};

Way way(const RayCaster& caster, const glm::vec3& from, const glm::vec3& direction) {
  const std::optional<Hit> hit = caster.closest(from, direction);
  return hit ? Way{hit->distance, !hit->from_behind} : Way{};
}

glm::vec3 at_share(const Bounds& bounds, const glm::vec3& share) { return glm::mix(bounds.lower, bounds.upper, share); }

/// Directions spread evenly over the sphere.
std::vector<glm::vec3> even_directions() {
  constexpr int count = 96;
  std::vector<glm::vec3> directions;
  for (int i = 0; i < count; ++i) {
    const float y = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / count;
    const float angle = static_cast<float>(i) * glm::pi<float>() * (3.0f - std::sqrt(5.0f));
    const float r = std::sqrt(1.0f - y * y);
    directions.emplace_back(r * std::cos(angle), y, r * std::sin(angle));
  }
  return directions;
}

/// With a floor and a ceiling, and walls but for one: what is open above is a bowl, whose inside is not its point.
bool is_indoors(const RayCaster& caster, const glm::vec3& from) {
  int all = 0, above = 0, below = 0, enclosed = 0, covered = 0, floored = 0;
  for (const glm::vec3& direction : even_directions()) {
    const bool front = way(caster, from, direction).to_front;
    ++all, enclosed += front;
    if (direction.y > 0.8f) ++above, covered += front;
    if (direction.y < -0.8f) ++below, floored += front;
  }
  return 10 * enclosed >= 7 * all && 10 * covered >= 9 * above && 10 * floored >= 9 * below;
}

/// The place indoors next to the middle, if a third of the box is indoors.
std::optional<glm::vec3> find_room(const RayCaster& caster, const Bounds& bounds) {
  constexpr std::array<float, 3> shares{0.5f, 0.25f, 0.75f};
  int indoors = 0;
  std::optional<glm::vec3> nearest;
  for (const float y : shares) {
    for (const float x : shares) {
      for (const float z : shares) {
        const glm::vec3 place = at_share(bounds, {x, y, z});
        if (!is_indoors(caster, place)) continue;
        ++indoors;
        const glm::vec3 centre = bounds.centre();
        if (!nearest || glm::distance(place, centre) < glm::distance(*nearest, centre)) nearest = place;
      }
    }
  }
  return 3 * indoors >= 27 ? nearest : std::nullopt;
}

/// How far one sees, as the mean of logarithms; into the open, or into things from within, is not at all.
float openness(const RayCaster& caster, const Camera& camera, float radius) {
  constexpr int columns = 7, rows = 5;
  const CameraRays rays(camera, columns, rows);
  float sum = 0.0f;
  for (int i = 0; i < columns * rows; ++i) {
    const Way seen =
        way(caster, camera.position,
            rays.direction(static_cast<float>(i % columns) + 0.5f, static_cast<float>(i / columns) + 0.5f));
    sum += std::log(seen.to_front ? std::clamp(seen.length / radius, 1e-3f, 1.0f) : 1e-3f);
  }
  return sum / (columns * rows);
}

/// From one end along an axis, where most is seen; from the middle of that end unless much stands there.
void stand_inside(Scene& scene, const RayCaster& caster, const Bounds& bounds) {
  constexpr std::array<float, 4> from_end{0.02f, 0.1f, 0.2f, 0.35f};
  constexpr std::array<float, 3> beside{0.5f, 0.35f, 0.65f}, heights{0.5f, 0.4f, 0.6f};
  float best = -std::numeric_limits<float>::infinity();
  for (const glm::vec3& forward : {glm::vec3(0, 0, -1), glm::vec3(-1, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 0, 1)}) {
    for (const float behind : from_end) {
      for (const float above : heights) {
        for (const float aside : beside) {
          glm::vec3 share(aside, above, aside);
          const int axis = forward.x != 0.0f ? 0 : 2;
          share[axis] = forward[axis] < 0.0f ? 1.0f - behind : behind;
          Camera camera;
          camera.position = at_share(bounds, share);
          camera.target = camera.position + forward * bounds.radius();
          camera.vertical_field_of_view = glm::radians(70.0f);
          const float off_middle = behind + std::abs(above - 0.5f) + std::abs(aside - 0.5f);
          const float score = openness(caster, camera, 4.0f * bounds.radius()) - 2.0f * off_middle;
          if (score <= best + 1e-4f) continue;
          best = score;
          scene.camera = camera;
        }
      }
    }
  }
  const glm::vec3 forward = glm::normalize(scene.camera.target - scene.camera.position);
  const float free = std::min(way(caster, scene.camera.position, forward).length, 2.0f * bounds.radius());
  scene.camera.target = scene.camera.position + 0.5f * free * forward;
}

/// A free way that a room's side may be missing from.
float free_way(const RayCaster& caster, const glm::vec3& from, const glm::vec3& direction, float most) {
  return std::min(way(caster, from, direction).length, most);
}

/// Under the ceiling, and shines down.
void hang_light(Scene& scene, const RayCaster& caster, const Bounds& bounds, const glm::vec3& indoors) {
  const float most = bounds.radius();
  const glm::vec3 place = indoors + 0.85f * free_way(caster, indoors, up, most) * up;
  const float distance = free_way(caster, place, -up, 2.0f * most);
  scene.light.position = place;
  scene.light.axis = -up;
  scene.light.half_angle = glm::radians(lamp_half_angle);
  scene.light.edge = lamp_edge;
  scene.light.intensity = intensity_for(distance);
  const auto half = [&](const glm::vec3& axis) {
    return 0.6f * std::min(free_way(caster, place, axis, most), free_way(caster, place, -axis, most)) * axis;
  };
  scene.panel = {place, half({1.0f, 0.0f, 0.0f}), half({0.0f, 0.0f, -1.0f}), distance};
}

void view_from_inside(Scene& scene, const RayCaster& caster, const Bounds& bounds, const glm::vec3& indoors) {
  stand_inside(scene, caster, bounds);
  hang_light(scene, caster, bounds, indoors);
}

// ---- What shines ----------------------------------------------------------------------------------------------------

/// All faces of one material.
struct Emitter {
  std::uint32_t material = 0;
  float area = 0.0f;
  glm::vec3 centre{0.0f};
  glm::vec3 normal{0.0f};  // the mean over its area: short for a bulb, of length 1 for a panel
  float reach = 0.0f;      // from its centre to its farthest corner along the normal

  float power(const Scene& scene) const {
    const glm::vec3& emission = scene.materials[material].emission;
    return area * (emission.r + emission.g + emission.b);
  }
};

Emitter emitter_of(const Mesh& mesh, std::uint32_t material) {
  Emitter emitter{material};
  const auto for_each = [&](const auto& body) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.triangle_materials[t] == material) body(mesh.triangles[t]);
    }
  };
  for_each([&](const glm::uvec3& corners) {
    const glm::vec3 &a = mesh.positions[corners.x], &b = mesh.positions[corners.y], &c = mesh.positions[corners.z];
    const float area = 0.5f * glm::length(glm::cross(b - a, c - a));
    emitter.area += area;
    emitter.centre += area / 3.0f * (a + b + c);
    emitter.normal += area / 3.0f * (mesh.normals[corners.x] + mesh.normals[corners.y] + mesh.normals[corners.z]);
  });
  if (!(emitter.area > 0.0f)) return emitter;
  emitter.centre /= emitter.area;
  emitter.normal /= emitter.area;
  return emitter;
}

/// Puts the light where what shines most is, in front of it, and gives it its colour. It keeps its brightness: the
/// strengths of files are in as many units as there are programs.
void light_by_emission(Scene& scene, const RayCaster& caster, const Bounds& bounds, std::string_view name) {
  std::optional<Emitter> best;
  for (std::uint32_t material = 0; material < scene.materials.size(); ++material) {
    if (scene.materials[material].emission == glm::vec3(0.0f)) continue;
    const Emitter emitter = emitter_of(scene.mesh, material);
    if (emitter.area > 0.0f && (!best || emitter.power(scene) > best->power(scene))) best = emitter;
  }
  if (!best) return;
  const float radius = bounds.radius();
  // A bulb shines everywhere, and its light into the scene.
  glm::vec3 axis = best->normal;
  if (glm::length(axis) < 0.3f)
    axis = glm::distance(bounds.centre(), best->centre) > 0.05f * radius ? bounds.centre() - best->centre : -up;
  axis = glm::normalize(axis);
  const auto place_before = [&](const glm::vec3& direction) {
    float reach = 0.0f;
    for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t) {
      if (scene.mesh.triangle_materials[t] != best->material) continue;
      for (int k = 0; k < 3; ++k) {
        const glm::vec3& corner = scene.mesh.positions[scene.mesh.triangles[t][k]];
        reach = std::max(reach, glm::dot(corner - best->centre, direction));
      }
    }
    return best->centre + (reach + 2e-3f * radius) * direction;
  };
  // Lamps that are turned into their own ceiling shine out of it all the same.
  const auto room_before = [&](const glm::vec3& direction) {
    return free_way(caster, place_before(direction), direction, 2.0f * radius);
  };
  if (room_before(axis) < 0.05f * radius && room_before(-axis) > room_before(axis)) axis = -axis;
  const glm::vec3 emission = scene.materials[best->material].emission;
  scene.light.position = place_before(axis);
  scene.light.axis = axis;
  scene.light.half_angle = glm::radians(lamp_half_angle);
  scene.light.edge = lamp_edge;
  const float distance = room_before(axis);
  scene.light.intensity = intensity_for(distance) * emission / std::max({emission.r, emission.g, emission.b});
  // As bright to the eye as a panel of its area that shines like that.
  const float brightest = std::max({scene.light.intensity.r, scene.light.intensity.g, scene.light.intensity.b});
  const float scale = brightest / (best->area * std::max({emission.r, emission.g, emission.b}));
  for (Material& material : scene.materials) material.emission *= scale;
  scene.warnings.push_back(std::string(name) + ": emission: the light has the place and colour of '" +
                           scene.materials[best->material].name + "', not its strength");
}

}  // namespace

void place_camera_and_light(Scene& scene, const ObjView& view) {
  const Bounds bounds = bounds_of(scene.mesh);
  bool inside = view.place == ViewPlace::inside;
  {
    const RayCaster caster(scene);
    const std::optional<glm::vec3> room = view.place == ViewPlace::outside ? std::nullopt : find_room(caster, bounds);
    inside = inside || room.has_value();
    if (inside) {
      view_from_inside(scene, caster, bounds, room.value_or(bounds.centre()));
    } else {
      view_from_outside(scene, bounds);
    }
    light_by_emission(scene, caster, bounds, scene.name);
  }
  if (view.stage && !inside) add_stage(scene, bounds);
}

}  // namespace example
