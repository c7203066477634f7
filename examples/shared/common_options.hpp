#pragma once

#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "image.hpp"
#include "scene.hpp"

namespace example {

/// What --camera and its like replace in a scene.
struct CameraOverrides {
  std::optional<glm::vec3> position;
  std::optional<glm::vec3> target;
  std::optional<float> vertical_field_of_view;  // radians
};

/// What all programs that render offer.
struct CommonOptions {
  std::string scene = "atrium";
  ObjView obj;
  CameraOverrides camera;

  int width = 640;
  int height = 512;
  int antialias = 2;
  Display display;

  std::string out;
  std::string compare_directory;  // empty: render one picture
  std::string report;
  int threads = 0;  // 0: all
  bool quiet = false;

  bool comparing() const { return !compare_directory.empty(); }
};

template <class Options>
struct CommandLine {
  Options options;
  std::optional<int> exit_status;  // set where --help has said all
};

}  // namespace example
