#include "view.hpp"

#include <algorithm>

#include "input_error.hpp"
#include "names.hpp"

namespace example {

Scene open_scene(const CommonOptions& options) {
  for (const auto& [name, finish] : atrium_names) {
    if (options.scene == name) return make_atrium(finish);
  }
  if (options.scene == "furnace") return make_furnace();
  if (options.scene == "rooms") return make_rooms();
  return load_obj(options.scene, options.obj);
}

bool is_same_point(const glm::vec3& a, const glm::vec3& b) {
  const double size = std::max({glm::length(glm::dvec3(a)), glm::length(glm::dvec3(b)), 1e-6});
  return glm::distance(glm::dvec3(a), glm::dvec3(b)) <= 1e-6 * size;
}

void apply(const CameraOverrides& overrides, Camera& camera) {
  camera.position = overrides.position.value_or(camera.position);
  camera.target = overrides.target.value_or(camera.target);
  camera.vertical_field_of_view = overrides.vertical_field_of_view.value_or(camera.vertical_field_of_view);
  if (is_same_point(camera.position, camera.target)) throw InputError("--camera and --target are the same point");
}

}  // namespace example
