// Two rooms, open in front, and a wall of two centimetres between; what lights them hangs in the left one.
#include <glm/gtc/constants.hpp>

#include "materials.hpp"
#include "mesh_builder.hpp"

namespace example {
namespace {

// Metres.
constexpr float width = 4.4f, height = 2.5f, depth = 3.2f;
constexpr float wall_left = 2.21f, wall_right = 2.23f;

enum : std::uint32_t { plaster, terracotta, teal, wood };

void add_shell(MeshBuilder& builder) {
  builder.begin_mesh().use(wood).quad({0, 0, depth}, {width, 0, depth}, {width, 0, 0}, {0, 0, 0});
  builder.begin_mesh().use(plaster).quad({0, height, 0}, {width, height, 0}, {width, height, depth},
                                         {0, height, depth});
  builder.quad({0, 0, 0}, {width, 0, 0}, {width, height, 0}, {0, height, 0});
  builder.begin_mesh().use(terracotta).quad({0, 0, depth}, {0, 0, 0}, {0, height, 0}, {0, height, depth});
  builder.begin_mesh().use(teal).quad({width, 0, 0}, {width, 0, depth}, {width, height, depth}, {width, height, 0});
}

}  // namespace

Scene make_rooms() {
  Scene scene;
  scene.name = "rooms";
  scene.materials = {{"plaster", matte({0.82f, 0.80f, 0.76f})},
                     {"terracotta", matte({0.80f, 0.36f, 0.20f})},
                     {"teal", matte({0.16f, 0.54f, 0.56f})},
                     {"wood", matte({0.58f, 0.42f, 0.28f})}};
  MeshBuilder builder(scene.mesh);
  add_shell(builder);
  builder.begin_mesh().use(plaster).box({wall_left, 0.0f, 0.0f}, {wall_right, height, depth});
  builder.begin_mesh().use(wood).box({0.6f, 0.0f, 0.7f}, {1.3f, 0.8f, 1.5f});
  builder.begin_mesh().box({3.1f, 0.0f, 1.4f}, {3.7f, 0.9f, 2.2f});
  scene.camera = {{2.22f, 1.45f, 7.9f}, {2.22f, 1.2f, 1.6f}, glm::radians(30.0f)};
  scene.light.position = {1.1f, 2.3f, 1.6f};
  scene.light.half_angle = glm::radians(75.0f);
  scene.light.intensity = glm::vec3(12.0f, 11.4f, 10.4f);
  scene.panel = {{1.1f, 2.1f, 1.6f}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.0f, -0.5f}, 0.8f};
  return scene;
}

}  // namespace example
