// What goes to a GPU: the floats of shader_buffer, and materials read from them in compute and fragment shaders.
#include <zonal/material/anisotropic_table.hpp>
#include <zonal/shader/buffers.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "../catch.hpp"
#include "compare.hpp"
#include "driver.hpp"
#include "request.hpp"
#include "scenes.hpp"

namespace {

/// The shader's functions for a material of `bands` bands.
std::string material_functions(int bands, const char* dialect) {
  zonal_glsl::Request request;
  request.functions = {"material_with_cosine", "material_without_cosine"};
  request.bands = bands;
  request.text.precise = std::string(dialect) == "glsl450";  // the other has no such word
  return zonal_glsl::shader_file(request, *zonal::shader::find_dialect(dialect));
}

/// Cosines within the range and at its ends, at rows and between, and a little beyond.
std::vector<float> cosines() {
  std::vector<float> result{1, 1.0000001F, 0.9999999F, 0, -1, -1.0000001F, -0.3F, 0.0174524F, 0.017F};
  SceneRandom random(21);
  for (int i = 0; i < 55; ++i) result.push_back(random.uniform(0, 1));
  return result;
}

/// Two materials in one buffer, each read with four bands: of fewer and one row, of more and 90.
constexpr int N = 4, coefficients = N * (N + 1) / 2;
struct Materials {
  Materials() {
    SceneRandom random(22);
    tables = {random_material(random, 2, 1), random_material(random, 6, 90)};
    floats = shader_buffer(tables[0]);
    const auto second = shader_buffer(tables[1]);
    floats.insert(floats.end(), second.begin(), second.end());
  }
  std::string begin(std::size_t table) const {
    return std::to_string(table == 0 ? 0 : shader_buffer(tables[0]).size()) + "u";
  }
  /// F or F' of C++ at a cosine.
  std::vector<float> expected(std::size_t table, bool has_cosine, float cosine) const {
    const auto sh = has_cosine ? tables[table].with_cosine<N>(cosine) : tables[table].without_cosine<N>(cosine);
    std::vector<float> numbers;
    for (int i = 0; i < coefficients; ++i) SceneRandom::append(numbers, sh[i]);
    return numbers;
  }
  std::vector<zonal::MaterialTable> tables;
  std::vector<float> floats;
};

}  // namespace

TEST_CASE("The buffer of a cache is its lights, one after the other, as the shader's comment says") {
  SceneRandom random(20);
  const zonal::MaterialTable material = random_material(random, 3, 90);
  std::vector<zonal::VirtualLight> lights(37);  // more than a block of the cache, and not whole ones
  for (zonal::VirtualLight& light : lights) {
    light.position = random.vector(-5, 5);
    light.normal = random.direction();
    light.to_primary = random.direction_above(light.normal);
    light.flux = random.vector(0, 2);
    light.radius = random.uniform(0.1F, 1);
    light.material = &material;
  }
  lights[5].flux = glm::vec3(0);  // it does not shine: it is left out
  const auto three = shader_buffer(zonal::HvlCache<3>(lights)), one = shader_buffer(zonal::HvlCache<1>(lights));
  REQUIRE(three.size() == 36 * 22);
  REQUIRE(one.size() == 36 * 13);
  lights.erase(lights.begin() + 5);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const zonal::VirtualLight& light = lights[i];
    const float *of_three = &three[22 * i], *of_one = &one[13 * i];
    const glm::vec3 flat = light.to_primary - glm::dot(light.to_primary, light.normal) * light.normal;
    const glm::vec3 tangent = glm::normalize(flat), scale = light.flux / (light.radius * light.radius);
    const auto sent = material.without_cosine<3>(glm::dot(light.normal, light.to_primary));
    const glm::vec3 emission[4] = {scale * sent(0, 0), scale * sent(1, 1), scale * sent(2, 0), scale * sent(2, 2)};
    CAPTURE(i);
    for (const float* floats : {of_three, of_one}) {
      for (int c = 0; c < 3; ++c) {
        CHECK(floats[c] == light.position[c]);
        CHECK(floats[3 + c] == light.normal[c]);
        CHECK(std::abs(floats[6 + c] - tangent[c]) <= 1e-6F);
      }
      CHECK(floats[9] == light.radius);
    }
    for (int c = 0; c < 3; ++c) {
      CHECK(of_one[10 + c] == of_three[10 + 4 * c]);
      for (int k = 0; k < 4; ++k)
        CHECK(std::abs(of_three[10 + 4 * c + k] - emission[k][c]) <= 1e-6F * std::abs(scale[c]));
    }
  }
}

TEST_CASE("The buffer of a cache is refused where a light is of an anisotropic material, which no shader gathers") {
  SceneRandom random(22);
  const zonal::MaterialTable isotropic = random_material(random, 3, 90);
  const zonal::AnisotropicTable anisotropic([](const auto&, const auto&) { return glm::dvec3(0.3); }, 3, 1e-2, 8);
  std::vector<zonal::VirtualLight> lights(2);
  for (zonal::VirtualLight& light : lights) {
    light.normal = light.to_primary = {0, 0, 1};
    light.tangent = {1, 0, 0};
    light.flux = glm::vec3(1);
    light.radius = 1;
    light.material = &isotropic;
  }
  lights[1].material = nullptr;
  lights[1].anisotropic = &anisotropic;
  CHECK_THROWS_AS(shader_buffer(zonal::HvlCache<3>(lights)), std::invalid_argument);
  CHECK_THROWS_AS(shader_buffer(zonal::HvlCache<1>(lights)), std::invalid_argument);
  lights[1].flux = glm::vec3(0);  // it does not shine: it is left out
  CHECK(shader_buffer(zonal::HvlCache<1>(lights)).size() == 13);
}

TEST_CASE("The buffer of a material is its size and its rows") {
  const Materials materials;
  const std::vector<float>& floats = materials.floats;
  const zonal::MaterialTable &one_row = materials.tables[0], &all_rows = materials.tables[1];
  REQUIRE(floats.size() == 2 + 6 * 3 + 2 + 6 * 90 * 21);
  CHECK((floats[0] == 1 && floats[1] == 3));
  CHECK((floats[2] == one_row.with_cosine_rows()[0].r && floats[10] == one_row.with_cosine_rows()[2].b));
  CHECK((floats[11] == one_row.without_cosine_rows()[0].r && floats[19] == one_row.without_cosine_rows()[2].b));
  const float* second = &floats[20];
  CHECK((second[0] == 90 && second[1] == 21));
  CHECK(second[2 + 3 * (21 * 40 + 7) + 1] == all_rows.with_cosine_rows()[21 * 40 + 7].g);
  CHECK(second[2 + 3 * 90 * 21 + 3 * (21 * 40 + 7) + 1] == all_rows.without_cosine_rows()[21 * 40 + 7].g);
}

TEST_CASE("A compute shader reads a material as its table does, to the bit on a software driver") {
  Driver* driver = driver_or_skip();
  if (driver == nullptr) return;
  const Materials materials;
  const std::vector<float> at = cosines();
  const std::string count = std::to_string(3 * coefficients) + "u";
  for (std::size_t table = 0; table < 2; ++table) {
    for (const bool has_cosine : {true, false}) {
      const std::string call = has_cosine ? "zonal_material_with_cosine_4" : "zonal_material_without_cosine_4";
      const unsigned program = driver->compile(
          "#version 450\nlayout(local_size_x = 64) in;\n"
          "layout(std430, binding = 0) readonly buffer Materials { float materials[]; };\n"
          "layout(std430, binding = 1) readonly buffer Cosines { float cosines[]; };\n"
          "layout(std430, binding = 2) writeonly buffer Results { float results[]; };\n"
          "#define ZONAL_MATERIAL(i) materials[i]\n" +
          material_functions(N, "glsl450") + "void main() {\n  uint i = gl_GlobalInvocationID.x;\n  vec3 f[" +
          std::to_string(coefficients) + "];\n  " + call + "(" + materials.begin(table) + ", cosines[i], f);\n" +
          "  for (uint k = 0u; k < " + count + "; ++k) results[i * " + count + " + k] = f[k / 3u][k % 3u];\n}\n");
      const unsigned in = driver->make_buffer(materials.floats), where = driver->make_buffer(at);
      const std::size_t size = at.size() * 3 * coefficients;
      const unsigned out = driver->make_buffer(std::vector<float>(size, std::numeric_limits<float>::quiet_NaN()));
      REQUIRE(at.size() == 64);
      driver->run(program, {in, where, out}, 1);
      const std::vector<float> given = driver->read_buffer(out, size);
      for (std::size_t i = 0; i < at.size(); ++i) {
        CAPTURE(table, has_cosine);
        const auto begin = given.begin() + static_cast<std::ptrdiff_t>(i * 3 * coefficients);
        require_equal({begin, begin + 3 * coefficients}, materials.expected(table, has_cosine, at[i]),
                      driver->is_software(), [&] { return at[i]; });
      }
      for (const unsigned buffer : {in, where, out}) driver->delete_buffer(buffer);
      driver->delete_program(program);
    }
  }
}

// A pixel for each coefficient, to the right, and each cosine, up; the table in a texture of 256 columns, as in
// WebGL 2.
TEST_CASE("A fragment shader of OpenGL ES 3.0 reads a material as its table does, to rounding") {
  Driver* driver = driver_or_skip(Driver::Language::glsl_es);
  if (driver == nullptr) return;
  const Materials materials;
  const std::vector<float> at = cosines();
  std::vector<float> texels = materials.floats;
  texels.insert(texels.end(), at.begin(), at.end());
  texels.resize((texels.size() + 255) / 256 * 256);
  const std::string vertex =
      "#version 300 es\nvoid main() {\n"
      "  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);\n}\n";
  for (std::size_t table = 0; table < 2; ++table) {
    for (const bool has_cosine : {true, false}) {
      const std::string call = has_cosine ? "zonal_material_with_cosine_4" : "zonal_material_without_cosine_4";
      const unsigned program = driver->compile(
          vertex,
          "#version 300 es\nprecision mediump float;\nuniform highp sampler2D numbers;\nout highp vec4 colour;\n"
          "#define ZONAL_MATERIAL(i) texelFetch(numbers, ivec2(int((i) & 255u), int((i) >> 8u)), 0).r\n" +
              material_functions(N, "glsles300") + "void main() {\n  highp vec3 f[" + std::to_string(coefficients) +
              "];\n  highp uint at = " + std::to_string(materials.floats.size()) + "u + uint(gl_FragCoord.y);\n  " +
              call + "(" + materials.begin(table) +
              ", ZONAL_MATERIAL(at), f);\n  colour = vec4(f[int(gl_FragCoord.x)], 1.0);\n}\n");
      const std::vector<float> pixels = driver->draw(program, texels, 256, coefficients, static_cast<int>(at.size()));
      driver->delete_program(program);
      for (std::size_t i = 0; i < at.size(); ++i) {
        CAPTURE(table, has_cosine);
        std::vector<float> given;
        for (std::size_t k = i * coefficients; k < (i + 1) * coefficients; ++k) {
          REQUIRE(pixels[4 * k + 3] == 1);
          given.insert(given.end(), {pixels[4 * k], pixels[4 * k + 1], pixels[4 * k + 2]});
        }
        require_equal(given, materials.expected(table, has_cosine, at[i]), false, [&] { return at[i]; });
      }
    }
  }
}
