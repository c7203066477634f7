#include "lit_scene.hpp"

#include "shared/input_error.hpp"
#include "shared/materials.hpp"
#include "shared/program.hpp"
#include "shared/view.hpp"

namespace example::hvl_render {
namespace {

void apply(const LightOverrides& overrides, const glm::vec3& default_target, Spotlight& light) {
  light.position = overrides.position.value_or(light.position);
  light.half_angle = overrides.half_angle.value_or(light.half_angle);
  if (overrides.position || overrides.target) {
    const glm::vec3 target = overrides.target.value_or(default_target);
    if (is_same_point(target, light.position)) throw InputError("--light and --light-target are the same point");
    light.axis = glm::normalize(target - light.position);
  }
  if (overrides.power) light.intensity = glm::vec3(*overrides.power / light.effective_solid_angle());
}

}  // namespace

Scene load_scene(const Options& options) {
  Scene scene = open_scene(options);
  print_warnings("hvl-render", scene);
  // Without --light-target a light that is moved points at the middle of the scene's own view.
  const glm::vec3 light_target = scene.camera.target;
  apply(options.camera, scene.camera);
  apply(options.light, light_target, scene.light);
  apply(options.materials, scene.materials);
  if (options.multiple_scattering) {
    for (Material& material : scene.materials) material.brdf = with_multiple_scattering(material.brdf);
  }
  return scene;
}

}  // namespace example::hvl_render
