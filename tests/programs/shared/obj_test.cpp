// OBJ files as programs write them: each kind by more than one member.
#include "shared/obj_file.hpp"

#include <cmath>
#include <ctime>
#include <initializer_list>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "files.hpp"
#include "shared/input_error.hpp"
#include "shared/ray_caster.hpp"
#include "shared/scene.hpp"

namespace {

using namespace example;
using file_test::contains;
using file_test::Folder;
using Files = std::map<std::string, std::string>;

constexpr double pi = 3.14159265358979323846;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string red = "newmtl red\nKd 0.9 0.1 0.1\n", blue = "newmtl blue\nKd 0.1 0.1 0.9\n";

/// As x.obj, beside other files.
Scene load(const std::string& obj, const Files& others = {}, const ObjView& view = {}) {
  const Folder folder;
  for (const auto& [name, text] : others) file_test::write(folder.path / name, text);
  file_test::write(folder.path / "x.obj", obj);
  return load_obj((folder.path / "x.obj").string(), view);
}

std::string error_of(const std::string& obj) {
  try {
    load(obj);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

ObjView alone() {
  ObjView view;
  view.stage = false;
  return view;
}

std::string all_warnings(const Scene& scene) {
  std::string text;
  for (const std::string& warning : scene.warnings) text += warning + "\n";
  return text;
}

/// Twice the area, along the normal.
glm::vec3 area_of(const Mesh& mesh, std::size_t t) {
  const glm::vec3& a = mesh.positions[mesh.triangles[t].x];
  return glm::cross(mesh.positions[mesh.triangles[t].y] - a, mesh.positions[mesh.triangles[t].z] - a);
}

double whole_area(const Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sum += 0.5 * static_cast<double>(glm::length(area_of(mesh, t)));
  return sum;
}

/// What part of its light along the normal a material sends back as a matte surface does, and by its glossy lobe. At a
/// small roughness: the lobe then leaves all but f0.
glm::vec3 diffuse_of(const Material& material) { return zonal::diffuse_albedo(material.brdf, 1.0f); }
glm::vec3 specular_of(const Material& material) {
  for (const auto& lobe : material.brdf.lobes) {
    if (const auto* ggx = std::get_if<zonal::GgxBrdf>(&lobe)) return zonal::reflectance(ggx->fresnel, 1.0f);
  }
  return glm::vec3(0.0f);
}

/// What the material reflects of uniform light, red, seen at that angle to the normal: by half vectors, whose angle to
/// the normal is (pi / 2) s^2, so that a smooth lobe is met.
double albedo_of(const Material& material, double degrees) {
  constexpr int rings = 600, spokes = 120;
  const double angle = degrees * pi / 180.0;
  const glm::dvec3 wo(std::sin(angle), 0.0, std::cos(angle));
  double sum = 0.0;
  for (int i = 0; i < rings; ++i) {
    const double s = (i + 0.5) / rings, theta = 0.5 * pi * s * s;
    for (int j = 0; j < spokes; ++j) {
      const double phi = 2.0 * pi * (j + 0.5) / spokes;
      const glm::dvec3 h(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
      const glm::dvec3 wi = 2.0 * glm::dot(h, wo) * h - wo;
      if (glm::dot(h, wo) <= 0.0 || wi.z <= 0.0) continue;
      const double solid_angle = 4.0 * glm::dot(h, wo) * std::sin(theta) * (pi * s / rings) * (2.0 * pi / spokes);
      sum += zonal::evaluate(material.brdf, wi, wo).x * wi.z * solid_angle;
    }
  }
  return sum;
}

std::string number(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

// By append, since g++ 12 warns wrongly of a text plus a temporary string.
std::string vertex(const glm::dvec3& p) {
  std::string text = "v";
  for (int axis = 0; axis < 3; ++axis) text.append(" ").append(number(p[axis]));
  return text.append("\n");
}

/// A corner of a face, after a blank.
std::string corner(int index) { return std::string(" ").append(std::to_string(index)); }

}  // namespace

TEST_CASE("obj: every way to write the same square") {
  const std::string mark = "\xEF\xBB\xBF";
  const std::string crlf = "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3 4\r\n";
  std::string cr = crlf;
  std::erase(cr, '\n');
  int number = 0;
  for (const std::string& text : {
           square + "f 1 2 3 4",
           mark + square + "f 1 2 3 4\n",
           mark + "# by hand\n" + square + "f 1 2 3 4\n",
           crlf,
           cr,
           square + "f 1 2 \\\n3 4\n",
           square + "f 1 \\\r\n 2 \\  \r\n3\\\n4\n",
           std::string("v 0 \\\n0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"),
           square + "f 1 2 3 4 \\",
           std::string("# C:\\models\\\nv 0 0 0 # C:\\here\\\nv 1 0 0#\nv 1 1 0\t# there\nv 0 1 0\nf 1 2 3 4 # all\n"),
           std::string("v\t0  0 0\n  v +1 0. 0e0\nv 1 1.0E0 -0 1.0\nv 0 1 .0 0.5 0.5 0.5\n\tf 1 2 3 4\n"),
           square + "f -4 -3 -2 -1\n",
           square + "vt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3//1 4/1\n",
           "f 1 2 3 4\n" + square,
           square + "fo 1 2 3 4\n",
           square + "vn 0 0 nan\nvn 0 0 0\nf 1//1 2//2 3//9 4//x\n",
           square + "f 1 2 3\nf 1 3 4\nf 1 2\nf\nf 1 1 1\n",
       }) {
    CAPTURE(++number, text);
    const Scene scene = load(text, {}, alone());
    CHECK(scene.mesh.triangles.size() == 2);
    CHECK(whole_area(scene.mesh) == Approx(1.0));
    for (const glm::vec3& normal : scene.mesh.normals) CHECK(normal == glm::vec3(0.0f, 0.0f, 1.0f));
  }
}

TEST_CASE("obj: what is wrong is told with its line") {
  CHECK(contains(error_of("v 0 0 0\nv 1 0 x\n"), "x.obj:2: not three finite coordinates"));
  CHECK(contains(error_of("v 0 0 0\nv 1 0 0\nv 1 \\\n1\nf 1 2 3\n"), "x.obj:3: not three"));
  CHECK(contains(error_of("v 0,5 0 0\n"), "x.obj:1: not three"));
  CHECK(contains(error_of(square + "f 1 2 3\nf 1 2 9\n"), "x.obj:6: a face names vertex 9 of 4"));
  CHECK(contains(error_of(square + "f 1 2 0\n"), "x.obj:5: '0' names no vertex"));
  CHECK(contains(error_of(square + "f -5 2 1\n"), "x.obj:5: '-5' names no vertex"));
  CHECK(contains(error_of(square + "f 1 2 a/b\n"), "x.obj:5: 'a/b' names no vertex"));
  CHECK(contains(error_of(square + "f 1 2 99999999999999999999\n"), "x.obj:5: '99999999999999999999' names no vertex"));
  CHECK(contains(error_of("\xFF\xFEv\0 "), "is UTF-16"));
  for (const std::string& text : {std::string(), square, square + "l 1 2\n", std::string("\xEF\xBB\xBF")}) {
    CHECK(contains(error_of(text), "no triangles in it"));
  }
}

TEST_CASE("obj: material files with blanks, several on a line, in quotes, by another system's path, and missing") {
  const std::string faces = square + "usemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\n";
  const Files files{{"my materials.mtl", red}, {"first.mtl", blue}, {"second one.mtl", red}, {"a#b.mtl", red + blue}};
  for (const std::string line : {"mtllib my materials.mtl first.mtl", "mtllib first.mtl my materials.mtl",
                                 "mtllib first.mtl second one.mtl", "mtllib \"my materials.mtl\"\nmtllib first.mtl",
                                 "mtllib first.mtl\nmtllib C:\\Models\\my materials.mtl # there", "mtllib a#b.mtl",
                                 "mtllib ./first.mtl .\\second one.mtl", "mtllib first.mtl \\\nmy materials.mtl"}) {
    CAPTURE(line);
    // Whether before what uses it, or after.
    for (const std::string& text : {line + "\n" + faces, faces + line + "\n"}) {
      const Scene scene = load(text, files, alone());
      CHECK(all_warnings(scene).empty());
      REQUIRE(scene.mesh.triangle_materials.size() == 2);
      CHECK(diffuse_of(scene.materials[scene.mesh.triangle_materials[0]]) == glm::vec3(0.9f, 0.1f, 0.1f));
      CHECK(diffuse_of(scene.materials[scene.mesh.triangle_materials[1]]) == glm::vec3(0.1f, 0.1f, 0.9f));
    }
  }
  const Scene missing = load("mtllib no where.mtl first.mtl x.mtl\n" + faces, files, alone());
  CHECK(contains(all_warnings(missing), "x.obj: no material file no where.mtl, x.mtl; what it had is grey\n"));
  CHECK(missing.warnings.size() == 1);
  CHECK(diffuse_of(missing.materials[missing.mesh.triangle_materials[0]]) == glm::vec3(0.7f));
  CHECK(diffuse_of(missing.materials[missing.mesh.triangle_materials[1]]) == glm::vec3(0.1f, 0.1f, 0.9f));
  CHECK(missing.files.size() == 2);
  const Scene unknown = load("mtllib first.mtl\n" + faces, files, alone());
  CHECK(contains(all_warnings(unknown), "x.obj: no material red; what had it is grey\n"));
}

TEST_CASE("obj: names of materials with blanks, signs and comments") {
  const std::string mtl =
      "\xEF\xBB\xBFnewmtl Material #25\r\nKd .25 .25 .25\r\nnewmtl Material #26\r\nKd .5 .5 .5\r\n"
      "newmtl dark wood  # of a tree\nKd .125 .125 .125\nnewmtl dark\nKd 0.75\nnewmtl 木 \nKd \\\n1 1 1 # w\n";
  for (const auto& [name, expected] : std::vector<std::pair<std::string, float>>{{"Material #25", 0.25f},
                                                                                 {"Material #26\r", 0.5f},
                                                                                 {"Material #26  ", 0.5f},
                                                                                 {"dark wood", 0.125f},
                                                                                 {"dark wood # of a tree", 0.125f},
                                                                                 {"dark # and else", 0.75f},
                                                                                 {"木", 1.0f}}) {
    CAPTURE(name);
    const Scene scene = load("mtllib m.mtl\n" + square + "usemtl " + name + "\nf 1 2 3 4\n", {{"m.mtl", mtl}}, alone());
    CHECK(all_warnings(scene).empty());
    CHECK(diffuse_of(scene.materials[scene.mesh.triangle_materials[0]]) == glm::vec3(expected));
  }
}

TEST_CASE("obj: what is left out is named, each once, and nothing else") {
  const std::string mtl =
      "newmtl a\nKd 1 1 1\nKa 1 1 1\nNi 1.5\nmap_Kd a b.png\nbump a.png\nnorm -bm 2 n.png\nmap_Ks s.png\nd 0.5\nillum "
      "7\n"
      "Tf 0.5 0.5 0.5\nnewmtl b\nmap_Kd c.png\nd 0.25\nd 1\nTr 1\nTf 1 1 1\nillum 2\nPs 0\nnewmtl c\nTr 0.5\n"
      "Ks spectral x.rfl\nmap_Bump x.png\nnewmtl d\nmap_Bump y.png\n";
  const std::string obj = "mtllib m.mtl\no thing\ng a b\ns 1\n" + square +
                          "v 0 0 1 1 0 0\nv 0 0 1 1 0 0\nvt 0 0\nusemtl a\nf 1 2 3\nl 1 2 3\nl 2 3\np 1\ncurv 0 1 1 2\n"
                          "deg 3\nlod 1\nfrobnicate\nfrobnicate\n";
  const Scene scene = load(obj, {{"m.mtl", mtl}}, alone());
  REQUIRE(scene.warnings.size() == 2);
  CHECK(contains(scene.warnings[0],
                 "x.obj: left out: 'frobnicate', Ks that is not RGB, Tf, Tr, d, "
                 "free-form curves and surfaces, illum 7, lines, map_Ks, points, vertex colours"));
  CHECK(contains(scene.warnings[1],
                 "x.obj: no picture a b.png, a.png, c.png, n.png, x.png, y.png; what had it is "
                 "without it"));
  CHECK(
      all_warnings(load("mtllib m.mtl\n" + square + "usemtl b\nf 1 2 3 4\n", {{"m.mtl", red + "Ns 3\nKs 1 1 1\n"}})) ==
      all_warnings(load("usemtl b\n" + square + "f 1 2 3 4\n")));
}

TEST_CASE("obj: materials reflect no more than they receive, and highlights are no mirrors") {
  const auto material = [](const std::string& mtl) {
    return load("mtllib m.mtl\n" + square + "usemtl a\nf 1 2 3 4\n", {{"m.mtl", "newmtl a\n" + mtl}}, alone())
        .materials[0];
  };
  CHECK(diffuse_of(material("")) == glm::vec3(0.7f));
  CHECK(diffuse_of(material("map_Kd a.png\n")) == glm::vec3(0.7f));
  CHECK(diffuse_of(material("Kd 0 0 0\nmap_Kd a.png\n")) == glm::vec3(0.7f));
  CHECK(diffuse_of(material("Kd 0 0 0\n")) == glm::vec3(0.0f));
  CHECK(diffuse_of(material("Kd 0.5\n")) == glm::vec3(0.5f));
  // Blender's default, of this and the older versions; a plastic's four percent, more or less.
  for (const std::string exponent : {"250", "96.078431", "225"}) {
    const Material blender =
        material("Ns " + exponent + "\nKa 1 1 1\nKd .8 .8 .8\nKs .5 .5 .5\nNi 1.45\nd 1\nillum 2\n");
    CAPTURE(exponent, specular_of(blender).x);
    CHECK(specular_of(blender).x > 0.01f);
    CHECK(specular_of(blender).x < 0.05f);
    CHECK(diffuse_of(blender).x == Approx(0.8f).margin(2e-3));
  }
  CHECK(specular_of(material("Kd 0 0 0\nKs .9 .9 .9\nNs 1000\nillum 5\n")).x == Approx(0.9f));
  CHECK(specular_of(material("Ks 1 1 1\nNs 10\nillum 1\n")) == glm::vec3(0.0f));
  CHECK(specular_of(material("Kd 1 .5 .25\nPr .5\nPm 1\n")) == glm::vec3(1.0f, 0.5f, 0.25f));
  CHECK(specular_of(material("Kd 1 .5 .25\nPr .5\nPm 0\n")).x == Approx(0.04f));
  for (const std::string text :
       {"Kd 1 1 1\nKs 1 1 1\nNs 0\n", "Kd 9 9 9\nKs 9 9 9\nillum 3\n", "Kd 1 1 1\nKs .6 .6 .6\nNs 2\n",
        "Kd -1 -1 -1\nKs 1 1 1\n", "Kd 1 1 1\nPr 1\nPm 0.5\n"}) {
    const Material full = material(text);
    CAPTURE(text);
    CHECK(diffuse_of(full).x >= 0.0f);
    // The furnace: uniform light, by a quadrature that knows nothing of lobes.
    for (const double degrees : {0.0, 50.0, 75.0, 85.0, 89.0}) {
      CAPTURE(degrees);
      const double albedo = albedo_of(full, degrees);
      CHECK(albedo <= 1.001);
      CHECK(albedo > 0.0);
    }
  }
  // As it was with both lobes side by side: more than all at grazing angles.
  const Material side_by_side{
      "", {{zonal::LambertBrdf{glm::vec3(0.96f)}, zonal::GgxBrdf{0.2f, zonal::SchlickFresnel{glm::vec3(0.04f)}}}}, {}};
  CHECK(albedo_of(side_by_side, 85.0) > 1.1);
  CHECK(albedo_of(material("Kd 1 1 1\nPr .4472136\nPm 0\n"), 85.0) == Approx(0.999).margin(3e-3));
}

TEST_CASE("obj: concave faces have Newell's area, in all of a file's forms") {
  const auto area = [](const std::string& text) { return whole_area(load(text, {}, alone()).mesh); };
  const std::string l = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n";
  for (const std::string face : {"1 2 3 4 5 6", "4 5 6 1 2 3", "6 5 4 3 2 1", "-3 -2 -1 -6 -5 -4"}) {
    CHECK(area(l + "f " + face + "\n") == Approx(3.0));
  }
  // More corners than fit into a byte.
  for (const int corners : {255, 256, 257, 1000}) {
    std::string text, face = "f";
    for (int i = 0; i < corners; ++i) {
      const double angle = 2.0 * pi * i / corners, r = i % 2 == 0 ? 1.0 : 0.5;
      text += vertex({r * std::cos(angle), 3.0, r * std::sin(angle)});
      face += corner(i + 1);
    }
    const double expected = 0.5 * corners * std::sin(2.0 * pi / corners) * 0.5;
    CAPTURE(corners);
    if (corners % 2 == 0) CHECK(area(text + face + "\n") == Approx(expected).epsilon(1e-5));
    CHECK(load(text + face + "\n", {}, alone()).mesh.triangles.size() == static_cast<std::size_t>(corners - 2));
  }
  const Scene crossing = load("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n", {}, alone());
  CHECK(contains(all_warnings(crossing), "x.obj: 1 face crosses itself, and may be filled wrongly\n"));
}

TEST_CASE("obj: far from the origin, tiny or huge is the same scene elsewhere") {
  // A ball without its poles.
  const auto text = [](const glm::dvec3& origin, double scale) {
    std::string obj;
    for (int i = 0; i <= 8; ++i) {
      for (int j = 0; j < 16; ++j) {
        const double theta = 0.2 + (pi - 0.4) * i / 8, phi = 2.0 * pi * j / 16;
        const glm::dvec3 unit(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
        obj += vertex(origin + scale * unit);
      }
    }
    for (int i = 0; i < 8; ++i) {
      for (int j = 0; j < 16; ++j) {
        const auto at = [&](int a, int b) { return corner(16 * a + b % 16 + 1); };
        obj.append("f")
            .append(at(i, j))
            .append(at(i, j + 1))
            .append(at(i + 1, j + 1))
            .append(at(i + 1, j))
            .append("\n");
      }
    }
    return obj;
  };
  const Scene near = load(text(glm::dvec3(0.0), 1.0));
  CHECK(near.warnings.empty());
  for (const auto& [origin, scale] : std::vector<std::pair<glm::dvec3, double>>{{{701362.56, 4485513.72, 120.5}, 1.0},
                                                                                {{-5e7, 3e6, 9e7}, 1.0},
                                                                                {{0.0, 0.0, 1e5}, 1.0},
                                                                                {{500.0, 500.0, 0.0}, 1.0},
                                                                                {{3.0, 0.0, 0.0}, 1.0},
                                                                                {{0.0, 0.0, 0.0}, 1e-6},
                                                                                {{1e-3, 2e-3, 0.0}, 1e-9},
                                                                                {{0.0, 0.0, 0.0}, 4e7},
                                                                                {{1.0, 2.0, 3.0}, 5e-3}}) {
    const Scene scene = load(text(origin, scale));
    CAPTURE(origin.x, scale, all_warnings(scene));
    REQUIRE(scene.mesh.triangles.size() == near.mesh.triangles.size());
    const auto vertex_at = [](const Mesh& mesh, std::size_t i) {
      return mesh.triangles[i / 3][static_cast<int>(i % 3)];
    };
    const double size = static_cast<double>(bounds_of(scene.mesh).radius() / bounds_of(near.mesh).radius());
    const glm::vec3 moved = scene.mesh.positions[vertex_at(scene.mesh, 0)] -
                            static_cast<float>(size) * near.mesh.positions[vertex_at(near.mesh, 0)];
    // What is left of the coordinates' digits: 1e-16 of them, or a float's in the scene.
    const double tolerance = size * (4e-6 + 1e-15 * glm::length(origin) / scale);
    for (std::size_t i = 0; i < 3 * near.mesh.triangles.size(); ++i) {
      const std::uint32_t here = vertex_at(scene.mesh, i), there = vertex_at(near.mesh, i);
      const glm::vec3 expected = static_cast<float>(size) * near.mesh.positions[there] + moved;
      REQUIRE(static_cast<double>(glm::distance(scene.mesh.positions[here], expected)) <= tolerance);
      REQUIRE(glm::distance(scene.mesh.normals[here], near.mesh.normals[there]) < 1e-4f);
    }
    const bool far = glm::length(origin) > 16.0 * scale;
    CHECK(scene.warnings.size() == (far ? 1u : 0u) + (scale < 1e-4 || scale > 1e6 ? 1u : 0u));
    if (far) CHECK(glm::length(bounds_of(scene.mesh).centre()) <= 10.0f * bounds_of(scene.mesh).radius());
  }
}

TEST_CASE("obj: z that points up becomes y") {
  ObjView view = alone();
  view.up = UpAxis::z;
  const Scene scene = load("v 0 0 0\nv 1 0 0\nv 0 0 1\nvn 0 -1 0\nf 1//1 2//1 3//1\n", {}, view);
  const Bounds bounds = bounds_of(scene.mesh);
  CHECK(bounds.upper == glm::vec3(1.0f, 1.0f, 0.0f));
  for (const glm::vec3& normal : scene.mesh.normals) CHECK(normal == glm::vec3(0.0f, 0.0f, 1.0f));
  CHECK(area_of(scene.mesh, 0).z > 0.0f);
}

namespace {

/// A cone or disc of many faces about one vertex.
std::string pole(int faces, double height) {
  std::string text = vertex({0.0, height, 0.0});
  for (int i = 0; i < faces; ++i) text += vertex({std::cos(2.0 * pi * i / faces), 0.0, std::sin(2.0 * pi * i / faces)});
  for (int i = 0; i < faces; ++i) {
    text.append("f 1").append(corner((i + 1) % faces + 2)).append(corner(i + 2)).append("\n");
  }
  return text;
}

double processor_seconds(const std::string& text) {
  const std::clock_t start = std::clock();
  load(text, {}, alone());
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// The definition: for each corner, all faces about its vertex that turn by less than 60 degrees, by their areas. Faces
/// near 60 degrees may count or not.
void check_creases(const std::string& text) {
  const Scene scene = load(text, {}, alone());
  const Mesh& mesh = scene.mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::vec3 flat = glm::normalize(area_of(mesh, t));
    for (int k = 0; k < 3; ++k) {
      const glm::vec3& position = mesh.positions[mesh.triangles[t][k]];
      glm::vec3 sum(0.0f);
      bool clear = true;
      for (std::size_t other = 0; other < mesh.triangles.size(); ++other) {
        for (int j = 0; j < 3; ++j) {
          if (mesh.positions[mesh.triangles[other][j]] != position) continue;
          const float cosine = glm::dot(flat, glm::normalize(area_of(mesh, other)));
          if (cosine > 0.5f) sum += area_of(mesh, other);
          clear = clear && std::abs(cosine - 0.5f) > 0.25f;
        }
      }
      CAPTURE(t, k, clear);
      const glm::vec3& normal = mesh.normals[mesh.triangles[t][k]];
      if (clear) CHECK(glm::distance(normal, glm::normalize(sum)) < 1e-5f);
      CHECK(glm::dot(normal, flat) > 0.5f);
    }
  }
}

}  // namespace

TEST_CASE("obj: normals are creased at 60 degrees, and a pole of many faces takes no longer for each") {
  check_creases(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 4 3 2 1\nf 5 6 7 8\n"
      "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  for (const double height : {0.0, 0.3, 1.0, 5.0}) check_creases(pole(24, height));
  for (const double height : {0.2, 3.0}) {
    const double few = processor_seconds(pole(12500, height)), many = processor_seconds(pole(100000, height));
    CAPTURE(height, few, many);
    CHECK(many < 24.0 * few + 0.1);  // 8 times the faces; 64 times the time if it were quadratic
  }
  // Each face of a smoothing group of its own is flat; so are all that are in none.
  for (const bool off : {false, true}) {
    std::string text = pole(5000, 0.2), grouped;
    int group = 0;
    for (const char c : text) {
      if (c == 'f') grouped.append("s").append(off ? " off" : corner(++group)).append("\n");
      grouped += c;
    }
    const Scene scene = load(grouped, {}, alone());
    for (std::size_t t = 0; t < scene.mesh.triangles.size(); t += 97) {
      const glm::vec3 flat = glm::normalize(area_of(scene.mesh, t));
      for (int k = 0; k < 3; ++k) CHECK(glm::distance(scene.mesh.normals[scene.mesh.triangles[t][k]], flat) < 1e-4f);
    }
  }
}

namespace {

/// A box from -1 to 1 without some of its sides, its faces turned inwards or outwards; stretched.
std::string box(const glm::dvec3& size, bool inwards, const std::string& without = "") {
  std::string text;
  for (int i = 0; i < 8; ++i) text += vertex(size * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  const std::vector<std::pair<std::string, std::vector<int>>> sides{{"b", {1, 3, 4, 2}}, {"f", {5, 6, 8, 7}},
                                                                    {"d", {1, 2, 6, 5}}, {"u", {3, 7, 8, 4}},
                                                                    {"l", {1, 5, 7, 3}}, {"r", {2, 4, 8, 6}}};
  for (auto [name, corners] : sides) {
    if (contains(without, name)) continue;
    if (inwards) std::reverse(corners.begin(), corners.end());
    text += "f";
    for (const int index : corners) text += corner(index);
    text += "\n";
  }
  return text;
}

bool within(const Bounds& bounds, const glm::vec3& p) {
  return glm::all(glm::greaterThanEqual(p, bounds.lower)) && glm::all(glm::lessThanEqual(p, bounds.upper));
}

bool is_seen_from_inside(const glm::dvec3& size, bool inwards, const std::string& without = "") {
  const Bounds room{glm::vec3(-size), glm::vec3(size)};
  const Scene scene = load(box(size, inwards, without));
  const RayCaster caster(scene);
  for (int i = 0; i < 9; ++i) {
    const glm::vec3 ahead = scene.camera.target - scene.camera.position;
    const glm::vec3 towards = ahead + 0.2f * glm::length(ahead) * glm::vec3(i % 3 - 1, i / 3 - 1, 0);
    CHECK(caster.closest(scene.camera.position, glm::normalize(towards)).has_value());
  }
  CHECK(caster.closest(scene.light.position, scene.light.axis).has_value());
  const bool inside = within(room, scene.camera.position);
  CHECK(inside == within(room, scene.light.position));
  CHECK(inside == (scene.materials.size() == 1));  // else there is a stage
  return inside;
}

}  // namespace

TEST_CASE("obj: rooms are seen from inside, and all else from outside") {
  for (const glm::dvec3& size : {glm::dvec3(1, 1, 1), glm::dvec3(8, 3, 5), glm::dvec3(100, 150, 400)}) {
    CAPTURE(size.x);
    CHECK(is_seen_from_inside(size, true));
    CHECK(is_seen_from_inside(size, true, "f"));
    CHECK(is_seen_from_inside(size, true, "l"));
    ObjView outside;
    outside.place = ViewPlace::outside;
    CHECK(!load(box(size, true), {}, outside).mesh.positions.empty());
    CHECK(!within({glm::vec3(-size), glm::vec3(size)}, load(box(size, true), {}, outside).camera.position));
    CHECK(!is_seen_from_inside(size, false));
    // Open above: a bowl, or a tray.
    for (const std::string without : {"u", "uf", "ud"}) {
      CAPTURE(without);
      CHECK(!within({glm::vec3(-size), glm::vec3(size)}, load(box(size, true, without)).camera.position));
    }
  }
  ObjView inside;
  inside.place = ViewPlace::inside;
  CHECK(within({glm::vec3(-1.0f), glm::vec3(1.0f)}, load(box(glm::dvec3(1.0), false), {}, inside).camera.position));
}

TEST_CASE("obj: on the stage nothing hides the object, be it narrow, thin or flat") {
  for (const glm::dvec3& size :
       {glm::dvec3(1, 1, 1), glm::dvec3(0.01, 1, 0.01), glm::dvec3(1, 0.01, 0.01), glm::dvec3(0.01, 0.01, 1),
        glm::dvec3(1e-4, 1, 1), glm::dvec3(1, 1e-4, 1), glm::dvec3(1, 1, 1e-4), glm::dvec3(1, 0, 1),
        glm::dvec3(0, 1, 1), glm::dvec3(1, 1, 0), glm::dvec3(300, 2, 1)}) {
    const Scene scene = load(box(size, false));
    const RayCaster caster(scene);
    int seen = 0, lit = 0;
    // On the way to points within it nothing else is met.
    for (const glm::dvec3& share : {glm::dvec3(0, 0, 0), glm::dvec3(0.8, 0.8, 0.8), glm::dvec3(-0.8, 0.5, 0.5)}) {
      const glm::vec3 point(size * share);
      const auto of_object = [&](const glm::vec3& from) {
        const auto hit = caster.closest(from, glm::normalize(point - from));
        return hit && hit->material == 0;
      };
      seen += of_object(scene.camera.position), lit += of_object(scene.light.position);
    }
    CAPTURE(size.x, size.y, size.z, seen, lit);
    CHECK(seen == 3);
    CHECK(lit == 3);
    // Its underside is not in the floor.
    for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t) {
      if (scene.materials[scene.mesh.triangle_materials[t]].name != "stage floor") continue;
      const float floor = scene.mesh.positions[scene.mesh.triangles[t].x].y;
      CHECK(static_cast<float>(-size.y) - floor > 1e-3f * static_cast<float>(glm::length(size)));
    }
  }
}

TEST_CASE("obj: what shines has the light's place and colour, whichever way it is turned") {
  const std::string lamp = "v -.3 .99 -.3\nv .3 .99 -.3\nv .3 .99 .3\nv -.3 .99 .3\nusemtl lamp\n";
  const Files files{{"m.mtl", "newmtl lamp\nKd 0 0 0\nKe 20 10 5\nnewmtl dim\nKe 1 1 1\n"}};
  for (const std::string face : {"f 9 10 11 12\n", "f 12 11 10 9\n"}) {
    const Scene scene = load("mtllib m.mtl\n" + box(glm::dvec3(1.0), true) + lamp + face, files);
    CAPTURE(face);
    CHECK(glm::distance(scene.light.position, glm::vec3(0.0f, 0.99f, 0.0f)) < 0.02f);
    CHECK(scene.light.position.y < 0.99f);
    CHECK(glm::distance(scene.light.axis, glm::vec3(0.0f, -1.0f, 0.0f)) < 1e-5f);
    CHECK(scene.light.intensity.g / scene.light.intensity.r == Approx(0.5f));
    CHECK(scene.materials[0].emission.r > 1.0f);
    CHECK(scene.materials[0].emission.b / scene.materials[0].emission.r == Approx(0.25f));
    CHECK(contains(all_warnings(scene), "emission: the light has the place and colour of 'lamp'"));
  }
  // A bulb among other things: out of it, towards them.
  std::string bulb = box(glm::dvec3(0.1), false);
  std::string things = "mtllib m.mtl\nusemtl lamp\n" + bulb + "usemtl none\nv 3 -1 3\nv 5 -1 3\nv 5 -1 5\nf 9 10 11\n";
  const Scene scene = load(things, files);
  CHECK(glm::dot(scene.light.axis, glm::normalize(bounds_of(scene.mesh).centre() - scene.light.position)) > 0.0f);
  const auto hit = RayCaster(scene).closest(scene.light.position, scene.light.axis);
  CHECK((!hit || hit->material != 0));
}
