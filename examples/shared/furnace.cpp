// A closed white sphere, lit from its centre.
#include <glm/gtc/constants.hpp>

#include "materials.hpp"
#include "mesh_builder.hpp"

namespace example {

Scene make_furnace() {
  constexpr float radius = 2.0f;
  Scene scene;
  scene.name = "furnace";
  scene.materials = {{"white", matte(glm::vec3(0.8f))}};
  MeshBuilder(scene.mesh).use(0).sphere(glm::vec3(0.0f), radius, 256);
  // The light reaches one half of the sphere, the camera sees both.
  scene.camera = {{0.0f, 0.0f, 1.8f}, {0.0f, 0.0f, 0.0f}, glm::radians(80.0f)};
  scene.light.half_angle = glm::radians(89.0f);
  scene.light.edge = 0.1f;
  scene.light.intensity = glm::vec3(6.0f);
  scene.panel = {glm::vec3(0.0f), {0.5f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.5f}, radius};
  return scene;
}

}  // namespace example
