// Textures of OBJ files: where they lie, what they colour, and how they bend normals.
#include "shared/texture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "catch.hpp"
#include "files.hpp"
#include "shared/frame.hpp"
#include "shared/image_file.hpp"
#include "shared/input_error.hpp"
#include "shared/noise.hpp"
#include "shared/ray_caster.hpp"
#include "shared/scene.hpp"

namespace {

using namespace example;
using file_test::contains;
using file_test::Folder;
using Files = std::map<std::string, std::string>;

constexpr double pi = 3.14159265358979323846;

/// As x.obj, beside other files, without a stage.
Scene load(const std::string& obj, const Files& others = {}) {
  const Folder folder;
  for (const auto& [name, bytes] : others) file_test::write(folder.path / name, bytes);
  file_test::write(folder.path / "x.obj", obj);
  ObjView view;
  view.stage = false;
  return load_obj((folder.path / "x.obj").string(), view);
}

std::string all_warnings(const Scene& scene) {
  std::string text;
  for (const std::string& warning : scene.warnings) text += warning + "\n";
  return text;
}

/// A picture whose pixel at the texture coordinates (u, v) is value(u, v).
Image picture(int width, int height, const std::function<glm::dvec3(double u, double v)>& value) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.at(x, y) = value((x + 0.5) / width, 1.0 - (y + 0.5) / height);
  }
  return image;
}

std::string png_of(const glm::vec3& bytes) {
  return png_bytes(picture(2, 2, [&](double, double) { return glm::dvec3(bytes) / 255.0; }));
}

glm::vec3 random_direction(std::mt19937& random) {
  std::normal_distribution<float> normal;
  return glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
}

/// A PNG file of two grey pixels, 0x4001 and 0x4002.
const std::string two_of_16_bits =
    "89504e470d0a1a0a0000000d494844520000000200000001100000000081d9fc150000000d49444154789c63706074600200"
    "018a0084f86616050000000049454e44ae426082";

std::string bytes_of_hex(const std::string& hex) {
  std::string bytes;
  for (std::size_t i = 0; i < hex.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  }
  return bytes;
}

/// The definition: tents about the texels' centres, which repeat or go on.
double by_tents(const std::vector<std::uint8_t>& texels, int width, int height, const glm::dvec2& place, bool clamped) {
  const auto tent = [](double t) { return std::max(0.0, 1.0 - std::abs(t)); };
  const double x = place.x * width - 0.5, y = (1.0 - place.y) * height - 0.5;
  double sum = 0.0;
  for (int row = static_cast<int>(std::floor(y)); row <= std::floor(y) + 1; ++row) {
    for (int column = static_cast<int>(std::floor(x)); column <= std::floor(x) + 1; ++column) {
      const auto at = [&](int i, int size) { return clamped ? std::clamp(i, 0, size - 1) : (i % size + size) % size; };
      const int texel = at(row, height) * width + at(column, width);
      sum += tent(x - column) * tent(y - row) * texels[static_cast<std::size_t>(texel)] / 255.0;
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("textures: between the centres of texels by tents, repeated or clamped") {
  std::mt19937 random(3);
  for (const auto& [width, height] : {std::pair(4, 3), std::pair(1, 1), std::pair(1, 5), std::pair(7, 2)}) {
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < width * height; ++i) texels.push_back(static_cast<std::uint8_t>(random() % 256));
    const Texture texture(width, height, 1, texels, TextureUse::values);
    CHECK(texture.bytes() == texels.size());
    std::vector<glm::vec2> places{{0, 0}, {1, 1}, {-1e-9f, 1.0f}, {0.5f, -1e-9f}, {-3, 2}, {0.125f, 0.5f}};
    for (int i = 0; i < 200; ++i) places.push_back(3.0f * glm::vec2(random_direction(random)));
    for (const glm::vec2& place : places) {
      for (const bool clamped : {false, true}) {
        CAPTURE(width, height, place.x, place.y, clamped);
        const glm::vec3 value = texture.at(place, clamped);
        CHECK(std::abs(double(value.r) - by_tents(texels, width, height, place, clamped)) <= 2e-6 * (width + height));
        CHECK((value.g == value.r && value.b == value.r));
      }
    }
    for (const glm::vec2& far : {glm::vec2(1e8f, -1e8f), glm::vec2(3e38f, -3e38f)}) {
      CHECK(texture.at(far, false).r >= 0.0f);
      CHECK(texture.at(far, true).r <= 1.0f);
    }
    constexpr float none = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    for (const glm::vec2& place : {glm::vec2(none), glm::vec2(infinite, -infinite), glm::vec2(none, 0.5f)}) {
      for (const bool clamped : {false, true}) CHECK(texture.at(place, clamped).r >= 0.0f);  // some texel's
    }
  }
}

TEST_CASE("textures: the gradient is that of what the texels are samples of") {
  constexpr int size = 256;
  const auto wave = [](double u, double v) { return std::sin(2.0 * pi * (u + 2.0 * v)); };
  std::vector<float> texels;
  const Image samples = picture(size, size, [&](double u, double v) { return glm::dvec3(wave(u, v)); });
  for (const glm::vec3& pixel : samples.pixels) texels.push_back(pixel.r);
  const Texture texture(size, size, 1, std::move(texels));
  std::mt19937 random(4);
  for (int i = 0; i < 1000; ++i) {
    const glm::vec2 place(random_direction(random));
    const double slope = 2.0 * pi * std::cos(2.0 * pi * (double(place.x) + 2.0 * double(place.y)));
    const glm::vec2 gradient = texture.gradient(place, false);
    CAPTURE(place.x, place.y, slope);
    CHECK(std::abs(double(gradient.x) - slope) <= 4e-3);
    CHECK(std::abs(double(gradient.y) - 2.0 * slope) <= 8e-3);
  }
}

TEST_CASE("textures: files keep their 8 bits, and colours are sRGB where values are not") {
  const Folder folder;
  const auto write = [&](const std::string& name, const std::string& bytes) {
    file_test::write(folder.path / name, bytes);
    return folder.path / name;
  };
  const auto rgb = write("a.png", png_of({255, 128, 0}));
  const Texture colour = read_texture(rgb, TextureUse::colour), values = read_texture(rgb, TextureUse::values);
  CHECK(colour.bytes() == 12);
  CHECK(colour.at({0.3f, 0.3f}, false) == decode_srgb(glm::vec3(255, 128, 0) / 255.0f));
  CHECK(colour.mean() == colour.at({0.3f, 0.3f}, false));
  CHECK(values.at({0.3f, 0.3f}, false) == glm::vec3(255, 128, 0) / 255.0f);
  const auto grey = write("a.pgm", std::string("P5 2 1 255\n") + "\x40\xC0");
  CHECK(read_texture(grey, TextureUse::values).bytes() == 2);
  CHECK(read_texture(grey, TextureUse::values).at({0.25f, 0.5f}, false) == glm::vec3(64.0f / 255.0f));
  const auto deep = write("b.png", bytes_of_hex(two_of_16_bits));
  const Texture sixteen = read_texture(deep, TextureUse::values);
  CHECK(sixteen.bytes() == 8);
  CHECK(double(sixteen.at({0.25f, 0.5f}, false).r) == Approx(0x4001 / 65535.0).epsilon(1e-6));
  CHECK(double(sixteen.at({0.75f, 0.5f}, false).r) == Approx(0x4002 / 65535.0).epsilon(1e-6));
  const auto share = double(read_texture(deep, TextureUse::colour).at({0.25f, 0.5f}, false).r);
  CHECK(share == Approx(double(decode_srgb(glm::vec3(0x4001 / 65535.0f)).r)).epsilon(1e-6));
  const auto exr = write("a.exr", exr_bytes(picture(2, 1, [](double u, double) { return glm::dvec3(7.0 * u); })));
  for (const TextureUse use : {TextureUse::colour, TextureUse::values}) {
    const Texture linear = read_texture(exr, use);
    CHECK(linear.bytes() == 24);
    CHECK(linear.at({0.75f, 0.5f}, false) == glm::vec3(5.25f));
  }
  CHECK_THROWS_AS(read_texture(folder.path / "none.png", TextureUse::colour), InputError);
  CHECK_THROWS_AS(read_texture(write("bad.png", "no picture"), TextureUse::colour), InputError);
}

// ---- In OBJ files ---------------------------------------------------------------------------------------------------

namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n", unit = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
const std::string face = "f 1/1 2/2 3/3 4/4\n";

Scene load_square(const std::string& mtl, const Files& pictures, const std::string& coordinates = unit) {
  Files files = pictures;
  files["m.mtl"] = "newmtl a\n" + mtl;
  return load("mtllib m.mtl\nusemtl a\n" + square + coordinates + face, files);
}

std::optional<Hit> look_at_square(const RayCaster& caster, const glm::vec2& place,
                                  const glm::vec3& direction = {0, 0, -1}) {
  return caster.closest(glm::vec3(place, 0.0f) - direction, direction);
}

glm::vec3 albedo_at(const Scene& scene, const glm::vec2& place = {0.3f, 0.6f}) {
  const RayCaster caster(scene);
  return zonal::diffuse_albedo(brdf_at(scene, *look_at_square(caster, place)), 1.0f);
}

}  // namespace

TEST_CASE("textures: every way to write texture coordinates") {
  int number = 0;
  for (const std::string& text :
       {square + unit + face, square + unit + "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1 4/4/1\n", unit + face + square,
        square + unit + "f -4/-4 -3/-3 -2/-2 -1/-1\n", square + "vt 0 0 0\nvt 1 0 9\nvt 1 1 0 # here\nvt 0 1\n" + face,
        square + "vt 0\nvt 1\nvt 1 1\nvt nan 1\n" + face, face + square + unit,
        square + unit + unit + "f 1/1 2/6 3/3\nf 1/5 3/7 4/8\n"}) {
    CAPTURE(++number, text);
    const Scene scene = load(text);
    CHECK(scene.warnings.empty());
    CHECK(scene.mesh.positions.size() == 4);
    REQUIRE(scene.mesh.texture_coordinates.size() == scene.mesh.positions.size());
    REQUIRE(scene.mesh.tangents.size() == scene.mesh.positions.size());
    for (std::size_t i = 0; i < scene.mesh.positions.size(); ++i) {
      CHECK(scene.mesh.texture_coordinates[i] == glm::vec2(scene.mesh.positions[i]));
      CHECK(scene.mesh.tangents[i] == glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
    }
  }
  // Split where they differ.
  CHECK(load(square + unit + "f 1/1 2/2 3/3\nf 1/2 3/3 4/4\n").mesh.positions.size() == 5);
  // Without any, nothing is kept.
  const Scene plain = load(square + "f 1 2 3 4\n");
  CHECK((plain.mesh.texture_coordinates.empty() && plain.mesh.tangents.empty()));
}

TEST_CASE("textures: indices that name no texture coordinates are told with their line, and are 0") {
  const auto warning = [](const std::string& corner, const std::string& more = "") {
    const Scene scene = load(square + unit + "f 1/1 2/2 " + corner + "\n" + more);
    for (std::size_t i = 0; i < scene.mesh.positions.size(); ++i) {
      if (scene.mesh.positions[i] == glm::vec3(1, 1, 0)) CHECK(scene.mesh.texture_coordinates[i] == glm::vec2(0.0f));
    }
    return all_warnings(scene);
  };
  CHECK(contains(warning("3/9"), "x.obj:9: '9 of 4' names no texture coordinates; there they are 0\n"));
  CHECK(contains(warning("3/0"), "x.obj:9: '3/0' names no texture coordinates; there they are 0\n"));
  CHECK(contains(warning("3/-5"), "x.obj:9: '3/-5' names no"));
  CHECK(contains(warning("3/x/1", "f 1/y 2/2 4/4\n"), "x.obj:9: '3/x/1' names no"));
  CHECK(warning("3//1").empty());
  CHECK(warning("3").empty());
  // Where a material has a picture, also their want is told.
  const Files files{{"m.mtl", "newmtl a\nmap_Kd a.png\n"}, {"a.png", png_of({255, 255, 0})}};
  for (const std::string& text : {square + unit + "usemtl a\nf 1 2/2 3/3\n", square + "usemtl a\nf 1 2 3\n"}) {
    const Scene scene = load("mtllib m.mtl\n" + text, files);
    CHECK(contains(all_warnings(scene), "x.obj: no texture coordinates for some of a; there they are 0\n"));
    CHECK(albedo_at(scene, {0.6f, 0.3f}) == glm::vec3(1, 1, 0));
  }
}

TEST_CASE("textures: objects and groups are meshes of their own") {
  const std::string faces = "f 1 2 3\n";
  const auto meshes = [](const std::string& text) { return load(square + text).mesh.triangle_meshes; };
  using Numbers = std::vector<std::uint32_t>;
  CHECK(meshes(faces + faces) == Numbers{0, 0});
  CHECK(meshes(faces + "o a\n" + faces + "o b\n" + faces + "o a\n" + faces) == Numbers{0, 1, 2, 1});
  CHECK(meshes("o a\ng x\n" + faces + "g y z\n" + faces + "g x\n" + faces) == Numbers{2, 3, 2});
  // The stage's three are three more.
  const Folder folder;
  file_test::write(folder.path / "x.obj", "o a\n" + square + faces);
  const Scene staged = load_obj((folder.path / "x.obj").string(), {});
  CHECK(staged.mesh.triangle_meshes == Numbers{1, 2, 2, 3, 3, 4, 4});
  const RayCaster caster(staged);
  CHECK(look_at_square(caster, {0.6f, 0.3f})->mesh == 1);
  const Scene atrium = make_atrium();
  CHECK(*std::max_element(atrium.mesh.triangle_meshes.begin(), atrium.mesh.triangle_meshes.end()) > 25);
  CHECK(atrium.mesh.triangle_meshes.size() == atrium.mesh.triangles.size());
}

TEST_CASE("textures: map_Kd multiplies Kd, and stands alone where Kd is black or missing") {
  const glm::vec3 colour = decode_srgb(glm::vec3(200, 100, 50) / 255.0f);
  const Files files{{"a b.png", png_of({200, 100, 50})}};
  const auto check = [&](const std::string& mtl, const glm::vec3& expected) {
    const Scene scene = load_square(mtl, files);
    CAPTURE(mtl, all_warnings(scene));
    CHECK(scene.warnings.empty());
    CHECK(scene.files.size() == 3);
    CHECK(glm::distance(albedo_at(scene), expected) <= 1e-6f);
  };
  check("Kd .5 .5 1\nmap_Kd a b.png\n", glm::vec3(0.5f, 0.5f, 1.0f) * colour);
  check("map_Kd a b.png\n", colour);
  check("Kd 0 0 0\nmap_Kd a b.png\n", colour);
  // Names and options as elsewhere.
  for (const std::string name :
       {"\"a b.png\"", "C:\\pictures\\a b.png", "a b.png # of wood", "-clamp on a b.png", "-blendu off -bm 2 a b.png",
        "-s 1 1 1 -o 0 0 0 -mm 0 1 -texres 512 a b.png", "./a b.png", "-o 1 a b.png"}) {
    check("map_Kd " + std::string(name) + "\n", colour);
  }
  CHECK(load_square("map_Kd\nnorm # none\nbump -bm 2\n", files).warnings.empty());
  // No more than all.
  const Image bright = picture(1, 1, [](double, double) { return glm::dvec3(7.0, -1.0, std::nan("")); });
  const glm::vec3 black = albedo_at(load_square("map_Kd a.exr\n", {{"a.exr", exr_bytes(bright)}}));
  CAPTURE(black.r, black.g, black.b);
  CHECK(black == glm::vec3(0.0f));
  const Image white = picture(1, 1, [](double, double) { return glm::dvec3(7.0, -1.0, 0.5); });
  CHECK(albedo_at(load_square("map_Kd a.exr\n", {{"a.exr", exr_bytes(white)}})) == glm::vec3(1.0f, 0.0f, 0.5f));
  // What is under a coat, too: all but the highlight.
  const Scene coated = load_square("Kd .5 .5 .5\nKs .4 .4 .4\nNs 100\nmap_Kd a b.png\n", files);
  const Scene plain = load_square("Kd .5 .5 .5\nKs .4 .4 .4\nNs 100\n", files);
  CHECK(glm::distance(albedo_at(coated), albedo_at(plain) * colour) <= 1e-6f);
  CHECK(albedo_at(plain).r > 0.4f);
  CHECK(contains(all_warnings(load_square("map_Kd -mm 0 2 -cc on a b.png\n", files)), "left out: -cc, -mm\n"));
  // A name that begins as an option does.
  const Scene dash = load_square("map_Kd -x.png\n", {{"-x.png", png_of({200, 100, 50})}});
  CHECK(glm::distance(albedo_at(dash), colour) <= 1e-6f);
}

TEST_CASE("textures: a picture that cannot be read is told, and the material is as without it") {
  const Files files{{"bad.png", "no picture"}};
  const Scene missing = load_square("Kd .5 .25 1\nmap_Kd no where.png\nnorm n.png\n", files);
  CHECK(contains(all_warnings(missing), "x.obj: no picture n.png, no where.png; what had it is without it\n"));
  CHECK(albedo_at(missing) == glm::vec3(0.5f, 0.25f, 1.0f));
  CHECK(albedo_at(load_square("map_Kd n.png\n", {})) == glm::vec3(0.7f));
  CHECK(albedo_at(load_square("Kd 0 0 0\nmap_Kd n.png\n", {})) == glm::vec3(0.7f));
  const Scene bad = load_square("Kd .5 .25 1\nmap_Kd bad.png\nbump bad.png\n", files);
  CHECK(contains(all_warnings(bad), "bad.png: cannot be read as a picture"));
  CHECK(contains(all_warnings(bad), "; what had it is without it\n"));
  CHECK(bad.warnings.size() == 1);
  CHECK(bad.files.size() == 2);
  CHECK(albedo_at(bad) == glm::vec3(0.5f, 0.25f, 1.0f));
  CHECK(look_at_square(RayCaster(bad), {0.3f, 0.6f})->normal == glm::vec3(0, 0, 1));
}

TEST_CASE("textures: a metal has its picture's mean colour, and says so") {
  const Image stripes =
      picture(2, 1, [](double u, double) { return u < 0.5 ? glm::dvec3(1, 1, 0) : glm::dvec3(1, 0, 0); });
  const Scene scene = load_square("Pm 1\nPr .5\nmap_Kd a.png\n", {{"a.png", png_bytes(stripes)}});
  CHECK(contains(all_warnings(scene), "x.obj: as a metal, 'a' has the mean colour of its map_Kd\n"));
  const auto* ggx = std::get_if<zonal::GgxBrdf>(&scene.materials[0].brdf.lobes.at(0));
  REQUIRE(ggx != nullptr);
  CHECK(glm::distance(zonal::reflectance(ggx->fresnel, 1.0f), glm::vec3(1.0f, 0.5f, 0.0f)) < 1e-6f);
}

TEST_CASE("textures: -s and -o move a picture, -clamp keeps it from repeating") {
  // u grows to the right and v upwards, at hits and in pictures.
  const auto ramp = [](double u, double v) { return glm::dvec3(u, v, 0.25); };
  const Files files{{"a.exr", exr_bytes(picture(64, 64, ramp))}};
  const auto check = [&](const std::string& options, const auto& expected) {
    const Scene scene = load_square("map_Kd " + options + " a.exr\n", files);
    for (const glm::dvec2 place : {glm::dvec2(0.3, 0.65), glm::dvec2(0.55, 0.1), glm::dvec2(0.9, 0.4)}) {
      const glm::dvec3 colour(albedo_at(scene, place)), wanted(expected(place.x, place.y), 0.25);
      CAPTURE(options, place.x, place.y, colour.x, colour.y, wanted.x, wanted.y);
      CHECK(glm::distance(colour, wanted) <= 1e-5);
    }
  };
  const auto repeated = [](double t) { return t - std::floor(t); };
  const auto clamped = [](double t) { return std::clamp(t, 0.5 / 64, 1.0 - 0.5 / 64); };
  check("", [](double u, double v) { return glm::dvec2(u, v); });
  check("-s 2 3 1", [&](double u, double v) { return glm::dvec2(repeated(2 * u), repeated(3 * v)); });
  check("-s 0.5 -o 0.25 0.0625 0",
        [&](double u, double v) { return glm::dvec2(0.5 * u + 0.25, repeated(v + 0.0625)); });
  check("-s 2 3 1 -clamp on", [&](double u, double v) { return glm::dvec2(clamped(2 * u), clamped(3 * v)); });
  check("-o -0.5 -0.5 -clamp on", [&](double u, double v) { return glm::dvec2(clamped(u - 0.5), clamped(v - 0.5)); });
}

// ---- Tangents and reliefs -------------------------------------------------------------------------------------------

TEST_CASE("tangents: along the first coordinate, turned and mirrored with it, apart where sides differ") {
  const auto check = [](const std::string& coordinates, const glm::vec4& expected) {
    for (const glm::vec4& tangent : load(square + coordinates + face).mesh.tangents) {
      CAPTURE(coordinates, tangent.x, tangent.y, tangent.z, tangent.w);
      CHECK(glm::distance(tangent, expected) < 1e-6f);
    }
  };
  check("vt 0 0\nvt 0 -1\nvt 1 -1\nvt 1 0\n", {0, 1, 0, 1});
  check("vt 0 0\nvt -2 0\nvt -2 1\nvt 0 1\n", {-1, 0, 0, -1});
  check("vt 1e7 0\nvt 10000001 0\nvt 10000001 1\nvt 1e7 1\n", {1, 0, 0, 1});
  // u = |x - 1|: the middle is there twice.
  const Scene mirrored = load(
      "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nvt 1 0\nvt 0 0\nvt 1 1\nvt 0 1\n"
      "f 1/1 2/2 5/4 4/3\nf 2/2 3/1 6/3 5/4\n");
  CHECK(mirrored.mesh.positions.size() == 8);
  for (std::size_t t = 0; t < mirrored.mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const float side = t < 2 ? -1.0f : 1.0f;
      CHECK(mirrored.mesh.tangents[mirrored.mesh.triangles[t][k]] == glm::vec4(side, 0, 0, side));
    }
  }
}

namespace {

/// A band of a ball, u around it from the left to the right as seen from outside, v upwards; with the ball's normals.
std::string ball(int columns, int rows) {
  std::string text;
  char line[200];
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const double u = double(i) / columns, v = double(j) / rows, phi = 2.0 * pi * u, theta = 0.3 + (pi - 0.6) * v;
      const double x = std::sin(theta) * std::sin(phi), y = -std::cos(theta), z = std::sin(theta) * std::cos(phi);
      std::snprintf(line, sizeof line, "v %.9f %.9f %.9f\nvn %.9f %.9f %.9f\nvt %.9f %.9f\n", x, y, z, x, y, z, u, v);
      text += line;
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      text += "f";
      for (const int at : {j * (columns + 1) + i, j * (columns + 1) + i + 1, (j + 1) * (columns + 1) + i + 1,
                           (j + 1) * (columns + 1) + i}) {
        const std::string index = std::to_string(at + 1);
        text += " " + index + "/" + index + "/" + index;
      }
      text += "\n";
    }
  }
  return text;
}

glm::dvec3 on_ball(double u, double v, double radius) {
  const double phi = 2.0 * pi * u, theta = 0.3 + (pi - 0.6) * v;
  return radius * glm::dvec3(std::sin(theta) * std::sin(phi), -std::cos(theta), std::sin(theta) * std::cos(phi));
}

/// The coordinates of a place on the ball.
glm::dvec2 ball_coordinates(const glm::dvec3& place) {
  const double phi = std::atan2(place.x, place.z), theta = std::acos(-place.y / glm::length(place));
  return {(phi < 0.0 ? phi + 2.0 * pi : phi) / (2.0 * pi), (theta - 0.3) / (pi - 0.6)};
}

}  // namespace

TEST_CASE("tangents: of a ball, around it") {
  const Mesh mesh = load(ball(64, 32)).mesh;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::vec3& p = mesh.positions[i];
    const glm::vec4& tangent = mesh.tangents[i];
    CAPTURE(p.x, p.y, p.z, tangent.x, tangent.y, tangent.z);
    // At its seam the mean is over the faces of one side.
    CHECK(glm::distance(glm::vec3(tangent), glm::normalize(glm::vec3(p.z, 0.0f, -p.x))) < 0.06f);
    CHECK(std::abs(glm::dot(glm::vec3(tangent), mesh.normals[i])) < 1e-6f);
    CHECK(tangent.w == 1.0f);
  }
}

namespace {

/// A height field in the plane of a picture, one metre wide, and its slopes.
constexpr double amplitude = 0.02;
double height(double u, double v) {
  return amplitude * (std::sin(2.0 * pi * u) + std::cos(4.0 * pi * v + 2.0 * pi * u));
}
glm::dvec2 slopes(double u, double v) {
  const double s = std::sin(4.0 * pi * v + 2.0 * pi * u);
  return amplitude * 2.0 * pi * glm::dvec2(std::cos(2.0 * pi * u) - s, -2.0 * s);
}

/// As floats, for bounds that are those of the programs.
Files relief_pictures() {
  const Image normals =
      picture(512, 512, [](double u, double v) { return 0.5 * glm::normalize(glm::dvec3(-slopes(u, v), 1.0)) + 0.5; });
  const Image heights = picture(512, 512, [](double u, double v) { return glm::dvec3(0.5 + height(u, v)); });
  return {{"n.exr", exr_bytes(normals)}, {"h.exr", exr_bytes(heights)}};
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

TEST_CASE("reliefs: normal maps and heights give the normals of the surface they stand for") {
  const Files files = relief_pictures();
  // Texture coordinates as maps of the square: turned, mirrored, shrunk. Normals of a picture are slopes where it is
  // one metre wide; what is laid on smaller squares is as much lower.
  struct Layout {
    glm::dmat2 matrix;
    glm::dvec2 offset;
  };
  const double c = std::cos(0.5), s = std::sin(0.5);
  for (const Layout& layout :
       {Layout{glm::dmat2(1.0), {0, 0}}, Layout{{c, s, -s, c}, {0.3, 7.0}}, Layout{{-1, 0, 0, 1}, {0, 0}},
        Layout{{c, s, s, -c}, {-2.0, 0.1}}, Layout{2.0 * glm::dmat2(c, s, -s, c), {0.1, 0.2}}}) {
    const double shrunk = std::sqrt(std::abs(glm::determinant(layout.matrix)));
    std::string coordinates;
    for (const glm::dvec2 place : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(1, 1), glm::dvec2(0, 1)}) {
      const glm::dvec2 at = layout.matrix * place + layout.offset;
      char line[100];
      std::snprintf(line, sizeof line, "vt %.12g %.12g\n", at.x, at.y);
      coordinates += line;
    }
    for (const std::string& kind :
         {std::string("norm n.exr\n"), "map_Bump -bm " + std::to_string(1.0 / shrunk) + " h.exr\n",
          std::string("norm -bm 0.5 n.exr\n"), "bump -bm " + std::to_string(-0.5 / shrunk) + " h.exr\n"}) {
      const Scene scene = load_square(kind, files, coordinates);
      CHECK(scene.warnings.empty());
      const RayCaster caster(scene);
      const double strength = contains(kind, "-0.") ? -0.5 : contains(kind, "0.5 n") ? 0.5 : 1.0;
      std::mt19937 random(5);
      std::uniform_real_distribution<float> uniform(0.01f, 0.99f);
      double worst = 0.0, greatest = 0.0;
      for (int i = 0; i < 300; ++i) {
        const glm::vec2 place(uniform(random), uniform(random));
        const auto front = look_at_square(caster, place), back = look_at_square(caster, place, {0, 0, 1});
        REQUIRE((front && back));
        const glm::dvec2 at = layout.matrix * glm::dvec2(place) + layout.offset;
        const glm::dvec2 slope = strength / shrunk * glm::transpose(layout.matrix) * slopes(at.x, at.y);
        worst = std::max(worst, angle_between(front->normal, glm::dvec3(-slope, 1.0)));
        greatest = std::max(greatest, angle_between(front->normal, {0, 0, 1}));
        CHECK(front->geometric_normal == glm::vec3(0, 0, 1));
        CHECK(back->geometric_normal == glm::vec3(0, 0, -1));
        CHECK(glm::distance(back->normal, -front->normal) < 1e-6f);
      }
      CAPTURE(kind, layout.matrix[0].x, layout.matrix[1].x, worst, greatest);
      CHECK(worst <= 2e-4);
      CHECK(greatest > 0.1);
    }
  }
}

TEST_CASE("reliefs: heights on a ball have the normals of the ball that is displaced") {
  const Files files = relief_pictures();
  Files with_mtl = files;
  with_mtl["m.mtl"] = "newmtl a\nbump -bm 1.5 h.exr\n";
  const Scene scene = load("mtllib m.mtl\nusemtl a\n" + ball(256, 128), with_mtl);
  const RayCaster caster(scene);
  const auto displaced = [](double u, double v) { return on_ball(u, v, 1.0 + 1.5 * height(u, v)); };
  std::mt19937 random(6);
  double worst = 0.0, greatest = 0.0;
  for (int i = 0; i < 500; ++i) {
    const glm::vec3 direction = random_direction(random);
    const auto hit = caster.closest(-3.0f * direction, direction);
    if (!hit || std::abs(hit->position.y) > 0.9f) continue;
    const glm::dvec2 at = ball_coordinates(hit->position);
    const double h = 1e-5;
    const glm::dvec3 along_u = displaced(at.x + h, at.y) - displaced(at.x - h, at.y);
    const glm::dvec3 along_v = displaced(at.x, at.y + h) - displaced(at.x, at.y - h);
    const glm::dvec3 normal = glm::cross(along_u, along_v);
    worst = std::max(worst, angle_between(hit->normal, normal));
    greatest = std::max(greatest, angle_between(hit->normal, hit->position));
  }
  CAPTURE(worst, greatest);
  // The model is one of low heights: it forgets that the ball grows with them, by up to 6 %.
  CHECK(worst <= 0.06 * greatest);
  CHECK(greatest > 0.15);
}

TEST_CASE("reliefs: normals that programs name as bumps are normals") {
  Files files = relief_pictures();
  files["n.png"] = png_bytes(
      picture(64, 64, [](double u, double v) { return 0.5 * glm::normalize(glm::dvec3(-slopes(u, v), 1.0)) + 0.5; }));
  for (const std::string name : {"n.exr", "n.png"}) {
    const Scene scene = load_square("map_Bump -bm 1 " + name + "\n", files);
    CHECK(scene.materials[0].relief.kind == Relief::Kind::normals);
  }
  CHECK(load_square("map_Bump h.exr\n", files).materials[0].relief.kind == Relief::Kind::heights);
  CHECK(load_square("norm h.exr\n", files).materials[0].relief.kind == Relief::Kind::normals);
  // Of both the normals.
  CHECK(load_square("bump h.exr\nnorm n.exr\n", files).materials[0].relief.kind == Relief::Kind::normals);
}

TEST_CASE("reliefs: heights are lengths of the file, also of one that is scaled") {
  const Files files = relief_pictures();
  std::string small = "v 0 0 0\nv 1e-6 0 0\nv 1e-6 1e-6 0\nv 0 1e-6 0\n";
  Files with_mtl = files;
  with_mtl["m.mtl"] = "newmtl a\nbump -bm 1e-6 h.exr\n";
  const Scene scene = load("mtllib m.mtl\nusemtl a\n" + small + unit + face, with_mtl);
  const RayCaster caster(scene);
  const float size = bounds_of(scene.mesh).upper.x;
  CHECK(size > 0.05f);
  const auto hit = look_at_square(caster, glm::vec2(0.3f, 0.6f) * size);
  REQUIRE(hit);
  CHECK(angle_between(hit->normal, glm::dvec3(-slopes(0.3, 0.6), 1.0)) < 1e-3);
}

TEST_CASE("reliefs: whatever the coordinates, normals are unit, seen, and those of a surface") {
  Files files = relief_pictures();
  const Scene plain = load_square("Kd 1 1 1\n", files);
  const RayCaster plain_caster(plain);
  for (const std::string& coordinates :
       {unit, std::string("vt 0 0\nvt 0 0\nvt 0 0\nvt 0 0\n"), std::string("vt 0 0\nvt 1 1\nvt 2 2\nvt 3 3\n"),
        std::string("vt 1e8 1e8\nvt -1e8 1e8\nvt 1e30 0\nvt nan inf\n"),
        std::string("vt 0 0\nvt 1e-9 0\nvt 1e-9 1e-9\nvt 0 1e-9\n"), std::string("vt 0 0\nvt 1 0\nvt 1 1\nvt 1 0\n")}) {
    for (const std::string& kind :
         {std::string("norm n.exr\n"), std::string("norm -bm 100 n.exr\n"), std::string("bump -bm 100 h.exr\n"),
          std::string("bump -s 1e9 1e9 -bm 1e6 h.exr\n")}) {
      const Scene scene = load_square(kind, files, coordinates);
      for (const glm::vec4& tangent : scene.mesh.tangents) CHECK(glm::length(glm::vec3(tangent)) == Approx(1.0f));
      const RayCaster caster(scene);
      std::mt19937 random(7);
      for (int i = 0; i < 500; ++i) {
        const glm::vec3 direction = random_direction(random);
        const glm::vec2 place = glm::vec2(0.5f) + 0.4f * glm::vec2(random_direction(random));
        const auto hit = look_at_square(caster, place, direction),
                   other = look_at_square(plain_caster, place, direction);
        REQUIRE(hit.has_value() == other.has_value());
        if (!hit) continue;
        CAPTURE(coordinates, kind, place.x, place.y, hit->normal.x, hit->normal.y, hit->normal.z);
        CHECK(std::abs(glm::length(hit->normal) - 1.0f) < 1e-5f);
        CHECK(glm::dot(hit->normal, -direction) > 0.0f);
        CHECK(hit->geometric_normal == other->geometric_normal);
        const glm::vec3 x = Frame(hit->normal, hit->tangent).to_world({1, 0, 0});
        CHECK(std::abs(glm::length(x) - 1.0f) < 1e-4f);
      }
    }
  }
  // Where coordinates say nothing, the tangent is the horizontal one.
  const Scene wall = load("v 0 0 0\nv 0 0 1\nv 0 1 1\nvt 0.5 0.5\nf 1/1 2/1 3/1\n");
  for (const glm::vec4& tangent : wall.mesh.tangents) {
    CHECK(std::abs(tangent.y) < 1e-6f);
    CHECK(tangent.w == 1.0f);
  }
}

TEST_CASE("the bumped atria: rough floor, walls and flat stones, and the rest as it was") {
  for (const auto& [bumped_finish, finish] : {std::pair(AtriumFinish::bumped, AtriumFinish::diffuse),
                                              std::pair(AtriumFinish::bumped_glossy, AtriumFinish::glossy)}) {
    const Scene plain = make_atrium(finish), bumped = make_atrium(bumped_finish);
    CHECK(plain.mesh.texture_coordinates.empty());
    CHECK(plain.mesh.triangles.size() == bumped.mesh.triangles.size());
    const RayCaster plain_caster(plain), caster(bumped);
    std::mt19937 random(8);
    std::map<std::string, std::pair<double, int>> angles;
    for (int i = 0; i < 4000; ++i) {
      const glm::vec3 direction = random_direction(random);
      const auto hit = caster.closest(bumped.camera.position, direction);
      const auto other = plain_caster.closest(bumped.camera.position, direction);
      REQUIRE((hit && other));
      CHECK(hit->mesh == other->mesh);
      CHECK(hit->geometric_normal == other->geometric_normal);
      auto& [sum, count] = angles[bumped.materials[hit->material].name];
      sum += angle_between(hit->normal, other->normal), ++count;
    }
    for (const std::string name : {"light tile", "dark tile", "terracotta", "teal", "plaster"}) {
      const auto& [sum, count] = angles[name];
      CAPTURE(name, count, sum / count);
      CHECK(count > 50);
      CHECK(sum / count > 0.2);
    }
    CHECK(angles["sandstone"].first > 1);  // of its flat faces
    for (const std::string name : {"red plastic", "niche"}) CHECK(angles[name].first <= 1e-6);
  }
}

TEST_CASE("noise: heights between 0 and 1, that repeat without a seam") {
  const Texture noise = noise_heights(64, 4, 3, 9);
  CHECK(noise.bytes() == 64 * 64 * 4);
  float least = 1.0f, greatest = 0.0f, step = 0.0f, seam = 0.0f;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const auto at = [&](int x, int y) { return noise.at((glm::vec2(x, y) + 0.5f) / 64.0f, false).r; };
      least = std::min(least, at(i, j)), greatest = std::max(greatest, at(i, j));
      const float d = std::max(std::abs(at(i, j) - at(i + 1, j)), std::abs(at(i, j) - at(i, j + 1)));
      (i == 63 || j == 63 ? seam : step) = std::max(i == 63 || j == 63 ? seam : step, d);
    }
  }
  CAPTURE(least, greatest, step, seam);
  CHECK((least >= 0.0f && greatest <= 1.0f));
  CHECK(greatest - least > 0.5f);
  CHECK(seam <= 1.2f * step);
}

// ---- A real file ----------------------------------------------------------------------------------------------------

TEST_CASE("textures: Spot, the cow, has its picture's colours where another reader finds them") {
  namespace fs = std::filesystem;
  const char* data = std::getenv("ZONAL_DATA");
  fs::path folder;
  for (const char* place : {"", "obj"}) {
    if (data != nullptr && fs::is_regular_file(fs::path(data) / place / "spot_triangulated.obj"))
      folder = fs::path(data) / place;
  }
  if (folder.empty()) {
    WARN("skipped: ZONAL_DATA names no folder with spot_triangulated.obj, or with obj/ and that in it");
    return;
  }
  const std::string text = file_test::bytes_of(folder / "spot_triangulated.obj");
  const Files files{{"m.mtl", "newmtl spot\nmap_Kd spot_texture.png\n"},
                    {"spot_texture.png", file_test::bytes_of(folder / "spot_texture.png")}};
  const Scene scene = load("mtllib m.mtl\nusemtl spot\n" + text, files);
  CHECK(scene.warnings.empty());
  const RayCaster caster(scene);

  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec2> coordinates;
  std::vector<std::array<std::pair<std::size_t, std::size_t>, 3>> triangles;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword, corner;
    words >> keyword;
    if (keyword == "v") words >> positions.emplace_back().x >> positions.back().y >> positions.back().z;
    if (keyword == "vt") words >> coordinates.emplace_back().x >> coordinates.back().y;
    if (keyword != "f") continue;
    for (auto& [v, vt] : triangles.emplace_back()) {
      words >> corner;
      v = std::stoul(corner) - 1, vt = std::stoul(corner.substr(corner.find('/') + 1)) - 1;
    }
  }
  REQUIRE(triangles.size() > 5000);
  const Image pixels = read_picture(folder / "spot_texture.png");
  const auto texel = [&](int x, int y) {
    return glm::dvec3(pixels.at((x % pixels.width + pixels.width) % pixels.width,
                                (y % pixels.height + pixels.height) % pixels.height));
  };
  std::mt19937 random(10);
  int hits = 0;
  std::map<int, int> shades;
  for (int i = 0; i < 300; ++i) {
    const glm::vec3 direction = random_direction(random), origin = -4.0f * direction + 0.3f * random_direction(random);
    const auto hit = caster.closest(origin, direction);
    double nearest = 1e9;
    glm::dvec2 place(0.0);
    for (const auto& corners : triangles) {  // Moeller and Trumbore's
      const glm::dvec3 a = positions[corners[0].first], ab = positions[corners[1].first] - a;
      const glm::dvec3 ac = positions[corners[2].first] - a, p = glm::cross(glm::dvec3(direction), ac);
      const double determinant = glm::dot(ab, p);
      if (determinant == 0.0) continue;
      const glm::dvec3 t = glm::dvec3(origin) - a, q = glm::cross(t, ab);
      const double u = glm::dot(t, p) / determinant, v = glm::dot(glm::dvec3(direction), q) / determinant;
      const double distance = glm::dot(ac, q) / determinant;
      if (u < 0.0 || v < 0.0 || u + v > 1.0 || distance <= 0.0 || distance >= nearest) continue;
      nearest = distance;
      place = (1.0 - u - v) * coordinates[corners[0].second] + u * coordinates[corners[1].second] +
              v * coordinates[corners[2].second];
    }
    REQUIRE(hit.has_value() == (nearest < 1e9));
    if (!hit) continue;
    ++hits;
    const double x = place.x * pixels.width - 0.5, y = (1.0 - place.y) * pixels.height - 0.5;
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    const glm::dvec3 expected = glm::mix(glm::mix(texel(left, top), texel(left + 1, top), x - left),
                                         glm::mix(texel(left, top + 1), texel(left + 1, top + 1), x - left), y - top);
    CAPTURE(place.x, place.y, hit->colour.x, hit->colour.y, hit->colour.z, expected.x, expected.y, expected.z);
    CHECK(glm::distance(glm::dvec3(hit->colour), expected) <= 2e-3);
    ++shades[static_cast<int>(4.0 * expected.x)];
  }
  CHECK(hits > 100);
  CHECK(shades.size() > 1);
}
