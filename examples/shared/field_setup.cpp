#include "field_setup.hpp"

#include <algorithm>

#include "input_error.hpp"
#include "materials.hpp"
#include "mesh_builder.hpp"
#include "tangents.hpp"

namespace example {
namespace {

/// Places by the box: metres in a box of a metre.
struct Places {
  explicit Places(const Bounds& box) : centre(box.centre()) {
    const glm::vec3 sides = box.upper - box.lower;
    side = std::max({sides.x, sides.y, sides.z});
  }
  glm::vec3 at(float x, float y, float z) const { return centre + side * glm::vec3(x, y, z); }

  /// A rectangle that faces down.
  Emitter panel(const glm::vec3& middle, float half, const glm::vec3& radiance) const {
    return {Emitter::Shape::rectangle, middle, {half * side, 0.0f, 0.0f}, {0.0f, 0.0f, half * side}, radiance};
  }

  glm::vec3 centre;
  float side;
};

// A lamp of a hundredth of the box: what it throws is as sharp as a grid of 64^3 can show.
constexpr float aperture = 0.01f;

std::vector<Emitter> projector_lamps(const Places& places) {
  return {places.panel(places.at(-1.2f, 4.3f, 0.0f), 0.8f, glm::vec3(9.0f, 8.6f, 8.0f)),
          Emitter::projector(places.at(1.6f, 2.9f, 1.9f), places.centre, aperture * places.side, Emitter::Beam::squares,
                             0.13f, glm::vec3(2.2e5f))};
}

std::vector<Emitter> spot_lamps(const Places& places) {
  const float radius = aperture * places.side;
  return {Emitter::projector(places.at(1.9f, 2.6f, 1.5f), places.centre, radius, Emitter::Beam::cone, 0.3f,
                             glm::vec3(1.6e5f, 8e3f, 4e3f)),
          Emitter::projector(places.at(-1.3f, 3.3f, -0.4f), places.centre, radius, Emitter::Beam::cone, 0.075f,
                             glm::vec3(2.4e5f)),
          places.panel(places.at(0.0f, 4.3f, 0.0f), 0.8f, glm::vec3(0.5f, 0.55f, 0.6f))};
}

/// A board on one side of the axis of a lamp.
void add_board(const Places& places, const Emitter& lamp, Scene& scene) {
  const glm::vec3 axis = lamp.normal();
  const glm::vec3 across = glm::normalize(glm::cross(axis, glm::vec3(0.0f, 1.0f, 0.0f)));
  const glm::vec3 width = places.side * across, half = 0.8f * places.side * glm::cross(across, axis);
  const glm::vec3 edge = glm::mix(places.centre, lamp.centre, 0.45f);
  scene.materials.push_back({"board", matte(glm::vec3(0.15f))});
  MeshBuilder builder(scene.mesh);
  builder.begin_mesh().use(static_cast<std::uint32_t>(scene.materials.size() - 1));
  builder.quad(edge - half, edge + width - half, edge + width + half, edge + half);
  if (!scene.mesh.texture_coordinates.empty()) set_tangents(scene.mesh);
}

bool is_box(const Bounds& box) {
  const glm::vec3 sides = box.upper - box.lower;
  return std::min({sides.x, sides.y, sides.z}) > 1e-6f * glm::length(box.upper) &&
         std::max({sides.x, sides.y, sides.z}) < 1e6f;
}

}  // namespace

Bounds field_box(const Scene& scene, const std::optional<Bounds>& box) {
  if (box) {
    if (!is_box(*box)) throw InputError("--box: the low corner must be below the high one on every axis");
    return *box;
  }
  const Bounds bounds = bounds_of(scene.mesh);
  // Of the hall's height, as the hall is: the floor a metre and a half below, the ceiling above the lamps.
  const float side = (bounds.upper.y - bounds.lower.y) / 6.2f;
  glm::vec3 centre = bounds.centre();
  centre.y = bounds.lower.y + 1.5f * side;
  const Bounds cube{centre - 0.5f * side, centre + 0.5f * side};
  if (!is_box(cube)) throw InputError("the scene is flat: name the volume by --box");
  return cube;
}

std::vector<Emitter> set_up_field(FieldSetup setup, const Bounds& box, Scene& scene) {
  const Places places(box);
  if (setup == FieldSetup::projector) return projector_lamps(places);
  std::vector<Emitter> lamps = spot_lamps(places);
  add_board(places, lamps.front(), scene);
  return lamps;
}

}  // namespace example
