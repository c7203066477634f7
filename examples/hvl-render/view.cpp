#include "view.hpp"

#include "input_error.hpp"

namespace hvl_render {
namespace {

void apply(const ViewOverrides& view, Camera& camera) {
  camera.position = view.camera_position.value_or(camera.position);
  camera.target = view.camera_target.value_or(camera.target);
  camera.vertical_field_of_view = view.vertical_field_of_view.value_or(camera.vertical_field_of_view);
  if (camera.position == camera.target) throw InputError("--camera and --target are the same point");
}

void apply(const ViewOverrides& view, const glm::vec3& default_target, Spotlight& light) {
  light.position = view.light_position.value_or(light.position);
  light.half_angle = view.light_half_angle.value_or(light.half_angle);
  if (view.light_position || view.light_target) {
    const glm::vec3 target = view.light_target.value_or(default_target);
    if (target == light.position) throw InputError("--light and --light-target are the same point");
    light.axis = glm::normalize(target - light.position);
  }
  if (view.light_power) light.intensity = glm::vec3(*view.light_power / light.effective_solid_angle());
}

}  // namespace

Scene load_scene(const Options& options) {
  Scene scene = options.scene == "atrium" ? make_atrium() : load_obj(options.scene, options.stage);
  // Without --light-target a light that is moved points at the middle of the scene's own view.
  const glm::vec3 light_target = scene.camera.target;
  apply(options.view, scene.camera);
  apply(options.view, light_target, scene.light);
  return scene;
}

}  // namespace hvl_render
