// docs/shaders.md and its examples.
#include <fstream>
#include <sstream>
#include <string>

#include "../catch.hpp"
#include "driver.hpp"
#include "example.hpp"

namespace {

std::string read(const std::string& path) {
  std::ifstream file(path);
  REQUIRE(file);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("docs/shaders.md shows the fragment shader that is compiled here") {
  const std::string fragment = read(ZONAL_DOCUMENTS "/examples/irradiance.frag");
  CHECK(read(ZONAL_DOCUMENTS "/shaders.md").find("```glsl\n" + fragment + "```\n") != std::string::npos);

  Driver* driver = driver_or_skip();
  if (driver == nullptr) return;
  const std::string vertex =
      "#version 300 es\nout vec3 normal;\nvoid main() { normal = vec3(0.0); gl_Position = vec4(0.0); }\n";
  driver->delete_program(driver->compile(vertex, example("irradiance.frag", {"reconstruct_lambert"}, 3, "glsles300")));
}
