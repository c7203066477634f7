// docs/shaders.md and its fragment shader. Its compute shaders: loops_test.cpp.
#include <fstream>
#include <sstream>
#include <string>

#include "../catch.hpp"
#include "driver.hpp"

namespace {

std::string read(const std::string& path) {
  std::ifstream file(path);
  REQUIRE(file);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

const std::string fragment_path = ZONAL_DOCUMENTS "/examples/irradiance.frag";
const std::string vertex =
    "#version 300 es\nout vec3 normal;\nvoid main() { normal = vec3(0.0); gl_Position = vec4(0.0); }\n";

}  // namespace

TEST_CASE("docs/shaders.md shows the fragment shader that is compiled here") {
  CHECK(read(ZONAL_DOCUMENTS "/shaders.md").find("```glsl\n" + read(fragment_path) + "```\n") != std::string::npos);
}

TEST_CASE("The fragment shader of docs/shaders.md compiles and links as it stands, on a driver of OpenGL ES 3.0") {
  Driver* driver = driver_or_skip(Driver::Language::glsl_es);
  if (driver == nullptr) return;
  driver->delete_program(driver->compile(vertex, read(fragment_path)));
  // One that the driver does not take, lest it takes all.
  CHECK_THROWS_AS(driver->compile(vertex, "#version 300 es\nout vec4 colour;\nvoid main() { colour = vec4(0.0); }\n"),
                  DriverError);
}
