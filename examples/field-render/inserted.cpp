#include "inserted.hpp"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>
#include <zonal/material/named.hpp>

#include "shared/mesh_builder.hpp"
#include "shared/tangents.hpp"

namespace example::field_render {
namespace {

/// A table about `foot`, its middle; lengths are shares of `side`.
struct Stand {
  glm::vec3 foot;
  float side;

  glm::vec3 at(float x, float y, float z) const { return foot + side * glm::vec3(x, y, z); }
};

std::uint32_t add_material(Scene& scene, const char* name, zonal::Brdf brdf) {
  scene.materials.push_back({name, std::move(brdf)});
  return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

void add_table(const Stand& stand, Scene& scene) {
  MeshBuilder builder(scene.mesh);
  builder.begin_mesh().use(add_material(scene, "table", zonal::matte(glm::vec3(0.8f))));
  builder.quad(stand.at(-0.4f, 0.0f, -0.4f), stand.at(-0.4f, 0.0f, 0.4f), stand.at(0.4f, 0.0f, 0.4f),
               stand.at(0.4f, 0.0f, -0.4f));
}

void add_figures(const Stand& stand, Scene& scene) {
  const auto scaled = [&](float radius, float height) { return stand.side * glm::vec2(radius, height); };
  MeshBuilder builder(scene.mesh);
  builder.begin_mesh().use(add_material(scene, "ball", {{zonal::PhongBrdf{glm::vec3(0.7f), 6.0f}}}));
  builder.sphere(stand.at(-0.2f, 0.12f, 0.05f), 0.12f * stand.side, 96);
  builder.begin_mesh().use(add_material(scene, "knot", zonal::matte({0.75f, 0.72f, 0.65f})));
  builder.closed_tube(
      [&](float t) {
        const float angle = glm::two_pi<float>() * t, ring = 0.1f + 0.04f * std::cos(3.0f * angle);
        return stand.at(0.18f + ring * std::cos(2.0f * angle), 0.17f + ring * std::sin(2.0f * angle),
                        -0.02f + 0.05f * std::sin(3.0f * angle));
      },
      0.028f * stand.side, 240, 24);
  builder.begin_mesh().use(add_material(scene, "vase", zonal::plastic({0.55f, 0.55f, 0.5f}, 0.5f)));
  builder.lathe(stand.at(0.0f, 0.0f, -0.22f),
                {smooth_run({scaled(0.05f, 0.0f), scaled(0.1f, 0.12f), scaled(0.06f, 0.26f), scaled(0.035f, 0.32f),
                             scaled(0.06f, 0.38f)},
                            8)},
                64);
}

/// Of half the table's width at most, standing in its middle.
void fit(const Stand& stand, Scene& scene) {
  const Bounds bounds = bounds_of(scene.mesh);
  const glm::vec3 sides = bounds.upper - bounds.lower;
  const float scale = 0.5f * stand.side / std::max({sides.x, sides.y, sides.z, 1e-12f});
  const glm::vec3 middle(bounds.centre().x, bounds.lower.y, bounds.centre().z);
  for (glm::vec3& position : scene.mesh.positions) position = stand.foot + scale * (position - middle);
}

}  // namespace

Scene make_inserted(const Options& options, const Bounds& box) {
  const glm::vec3 sides = box.upper - box.lower;
  const Stand stand{{box.centre().x, box.lower.y + 0.25f * sides.y, box.centre().z},
                    std::min({sides.x, sides.y, sides.z})};
  Scene scene;
  const bool is_file = options.object != "table" && options.object != "figures";
  if (is_file) {
    scene = load_obj(options.object, {false, options.obj.up, ViewPlace::outside});
    fit(stand, scene);
  }
  add_table(stand, scene);
  if (options.object == "figures") add_figures(stand, scene);
  set_tangents(scene.mesh);
  scene.name = options.object;
  scene.camera = {stand.at(0.15f, 0.75f, 1.25f), stand.at(0.0f, 0.08f, 0.0f), glm::radians(40.0f)};
  apply(options.materials, scene.materials);
  return scene;
}

}  // namespace example::field_render
