// Scenes from Wavefront OBJ files.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <zonal/material/energy.hpp>

#include "image_file.hpp"
#include "input_error.hpp"
#include "materials.hpp"
#include "obj_file.hpp"
#include "scene_view.hpp"
#include "statements.hpp"
#include "tangents.hpp"
#include "text_table.hpp"

namespace example {
namespace {

constexpr float least_roughness = 0.03f;
// Without normals, faces that meet at less than 60 degrees are one smooth surface.
constexpr float cos_crease = 0.5f;

// ---- Materials ------------------------------------------------------------------------------------------------------

constexpr float default_exponent = 10.0f;
constexpr glm::vec3 grey(0.7f);      // where a file says nothing
constexpr float dielectric = 0.04f;  // the reflectance of what is no metal

/// What a surface that reflects by illumination model 2 sends back of light along its normal. Ks is how bright the
/// highlight is, not what is reflected: by the model's own formula a lobe Ks (n.h)^Ns / pi, of which
/// Ks / pi times the integral of (n.h)^Ns 4 dh remains.
float highlight_share(float exponent) { return std::min(1.0f, 8.0f / (exponent + 2.0f)); }

/// A glossy lobe, and a body that sends back `diffuse` of light along the normal; from wherever it is seen, no more
/// than the lobe leaves. diffuse: at most 1 - f0.
zonal::Brdf varnished(const glm::vec3& diffuse, const zonal::GgxBrdf& gloss) {
  const glm::vec3 f0 = std::get<zonal::SchlickFresnel>(gloss.fresnel).f0;
  if (f0 == glm::vec3(0.0f)) return matte(diffuse);
  if (diffuse == glm::vec3(0.0f)) return {{gloss}};
  return zonal::coated(gloss, glm::clamp(diffuse / glm::max(1.0f - f0, 1e-6f), 0.0f, 1.0f));
}

/// Kd, and white or grey where there is none: a picture multiplies it. Black beside a picture is what some programs
/// write for the picture alone, and stands for none.
glm::vec3 diffuse_of(const MtlMaterial& source, bool has_picture) {
  const bool is_meant = source.diffuse && !(source.colour && *source.diffuse == glm::vec3(0.0f));
  return is_meant ? *source.diffuse : has_picture ? glm::vec3(1.0f) : grey;
}

/// The material, but for its pictures. tint: what the colour of a metal is multiplied by; a body's picture multiplies
/// what this returns.
Material make_material(const MtlMaterial& source, const glm::vec3& given_diffuse, const glm::vec3& tint) {
  const auto share = [](const glm::vec3& colour) { return glm::clamp(colour, 0.0f, 1.0f); };
  const float exponent = std::max(source.exponent.value_or(default_exponent), 0.0f);
  // GGX alpha: of the width of the exponent's lobe, or the PBR extension's roughness squared.
  float roughness = std::sqrt(2.0f / (exponent + 2.0f));
  glm::vec3 specular = share(source.specular), diffuse = share(given_diffuse);
  if (source.roughness || source.metallic) {
    const float metallic = std::clamp(source.metallic.value_or(0.0f), 0.0f, 1.0f);
    specular = glm::mix(glm::vec3(dielectric), diffuse * tint, metallic);
    diffuse *= 1.0f - metallic;
    if (source.roughness) roughness = *source.roughness * *source.roughness;
  } else if (source.illumination < 2) {
    specular = glm::vec3(0.0f);
  } else if (source.illumination == 2) {
    specular *= highlight_share(exponent);
  }
  // Many files reflect more than they receive.
  diffuse = glm::min(diffuse, 1.0f - specular);
  Material material{source.name, {}, {}, glm::max(source.emission, 0.0f)};
  const float alpha = std::clamp(roughness, least_roughness, 1.0f);
  material.brdf = varnished(diffuse, {alpha, zonal::SchlickFresnel{specular}});
  return material;
}

// ---- Pictures -------------------------------------------------------------------------------------------------------

/// Reads the materials' pictures, each file once for each use.
class Pictures {
 public:
  explicit Pictures(const std::string& obj) : obj_(obj) {}

  /// scale: the file's unit of length in metres.
  Material material(const MtlMaterial& source, double scale) {
    const TextureMap colour = map(source.colour, TextureUse::colour);
    const glm::vec3 mean = colour ? glm::clamp(colour.texture->mean(), 0.0f, 1.0f) : glm::vec3(1.0f);
    Material material = make_material(source, diffuse_of(source, bool(colour)), mean);
    material.relief = relief(source, scale);
    if (!colour) return material;
    if (source.metallic.value_or(0.0f) > 0.0f) metals_.insert(source.name);
    for (const zonal::BrdfLobe& lobe : material.brdf.lobes) {
      if (zonal::is_diffuse(lobe)) material.colour = colour;
    }
    return material;
  }

  const std::vector<std::filesystem::path>& files() const { return files_; }

  std::vector<std::string> warnings() const {
    std::vector<std::string> lines;
    if (!missing_.empty()) lines.push_back(obj_ + ": no picture " + listed(missing_) + "; what had it is without it");
    for (const std::string& error : errors_) lines.push_back(error + "; what had it is without it");
    for (const std::string& name : metals_) {
      lines.push_back(obj_ + ": as a metal, '" + name + "' has the mean colour of its map_Kd");
    }
    return lines;
  }

 private:
  /// Without a texture where the file cannot be read.
  TextureMap map(const std::optional<MtlMap>& source, TextureUse use) {
    if (!source || source->name.empty()) return {};
    if (!source->file) {
      missing_.insert(source->name);
      return {};
    }
    return {texture(*source->file, use), source->scale, source->offset, source->clamped};
  }

  Relief relief(const MtlMaterial& source, double scale) {
    if (TextureMap normals = map(source.normals, TextureUse::values)) {
      return {std::move(normals), Relief::Kind::normals, source.normals->strength};
    }
    TextureMap bump = map(source.bump, TextureUse::values);
    if (!bump) return {};
    const float strength = source.bump->strength;
    if (is_of_normals(*bump.texture)) return {std::move(bump), Relief::Kind::normals, strength};
    return {std::move(bump), Relief::Kind::heights, strength * static_cast<float>(scale)};
  }

  /// Programs name normal maps by map_Bump, too: pictures that are blue, as heights, which are grey, are not.
  static bool is_of_normals(const Texture& texture) {
    const glm::vec3 mean = texture.mean();
    return mean.b > std::max(mean.r, mean.g) + 0.1f;
  }

  std::shared_ptr<const Texture> texture(const std::filesystem::path& path, TextureUse use) {
    const auto [entry, is_new] = read_.try_emplace({path, use});
    if (!is_new) return entry->second;
    try {
      entry->second = std::make_shared<const Texture>(read_texture(path, use));
      files_.push_back(path);
    } catch (const InputError& error) {
      errors_.insert(error.what());
    }
    return entry->second;
  }

  std::string obj_;
  std::map<std::pair<std::filesystem::path, TextureUse>, std::shared_ptr<const Texture>> read_;
  std::vector<std::filesystem::path> files_;
  std::set<std::string> missing_, errors_, metals_;
};

// ---- Where it stands ------------------------------------------------------------------------------------------------

/// From the file's coordinates to the scene's, metres with y up, in double.
struct Placement {
  glm::dvec3 origin{0.0};
  double scale = 1.0;
  UpAxis up = UpAxis::y;

  glm::dvec3 turned(const glm::dvec3& v) const { return up == UpAxis::y ? v : glm::dvec3(v.x, v.z, -v.y); }
  glm::vec3 operator()(const glm::dvec3& position) const { return turned((position - origin) * scale); }
};

double power_of_ten_above(double value) { return std::pow(10.0, std::ceil(std::log10(value))); }

/// Far from the origin a float is too coarse, and the squares of tiny or huge areas are no floats. Other models stay as
/// they are.
Placement placement_of(const ObjFile& file, UpAxis up) {
  glm::dvec3 lower(std::numeric_limits<double>::infinity()), upper = -lower;
  for (const ObjFile::Triangle& triangle : file.triangles) {
    for (const ObjFile::Corner& corner : triangle.corners) {
      lower = glm::min(lower, file.positions[corner.vertex]);
      upper = glm::max(upper, file.positions[corner.vertex]);
    }
  }
  Placement placement;
  placement.up = up;
  const glm::dvec3 centre = 0.5 * (lower + upper);
  const double radius = 0.5 * glm::distance(lower, upper);
  if (!(radius > 0.0)) return placement;
  // To a round number, so that coordinates can still be told.
  const double step = power_of_ten_above(radius);
  if (glm::length(centre) > 16.0 * radius) placement.origin = glm::round(centre / step) * step;
  if (radius < 1e-3 || radius > 1e6) placement.scale = 1.0 / step;
  return placement;
}

std::vector<std::string> messages(const std::string& path, const Placement& placement) {
  std::vector<std::string> lines;
  const glm::dvec3& origin = placement.origin;
  if (origin != glm::dvec3(0.0)) {
    lines.push_back(
        path + format(": far from the origin, which is now at its %.15g,%.15g,%.15g", origin.x, origin.y, origin.z));
  }
  if (placement.scale != 1.0) lines.push_back(path + format(": now %g times as large as in the file", placement.scale));
  return lines;
}

// ---- Triangles ------------------------------------------------------------------------------------------------------

bool is_textured(const Material& material) { return material.colour || material.relief; }

/// Of a file whose materials are textured: where its faces have no texture coordinates, they are 0.
std::vector<std::string> missing_coordinates(const std::string& path, const ObjFile& file,
                                             const std::vector<Material>& materials) {
  std::set<std::string> names;
  for (const ObjFile::Triangle& triangle : file.triangles) {
    if (triangle.material == ObjFile::none || !is_textured(materials[triangle.material])) continue;
    for (const ObjFile::Corner& corner : triangle.corners) {
      if (corner.coordinates == ObjFile::none) names.insert(materials[triangle.material].name);
    }
  }
  if (names.empty()) return {};
  return {path + ": no texture coordinates for some of " + listed(names) + "; there they are 0"};
}

/// Builds the mesh, vertex by vertex of the file: its normals, and one of the mesh's vertices for each of them and of
/// their texture coordinates.
class MeshMaker {
 public:
  MeshMaker(const ObjFile& file, const Placement& place, std::uint32_t default_material, bool has_coordinates,
            Mesh& mesh)
      : file_(file), place_(place), has_coordinates_(has_coordinates), mesh_(mesh) {
    for (const ObjFile::Triangle& triangle : file.triangles) {
      const glm::vec3 area = area_of(triangle);
      // The mesh has floats, and uses squares of areas.
      if (!(glm::dot(area, area) > 0.0f)) continue;
      sources_.push_back(&triangle);
      areas_.push_back(area);
      mesh.triangle_materials.push_back(triangle.material == ObjFile::none ? default_material : triangle.material);
      mesh.triangle_meshes.push_back(triangle.mesh);
    }
    mesh.triangles.resize(sources_.size());
  }

  void make() {
    // The corners about each vertex, in one list.
    std::vector<std::size_t> first(file_.positions.size() + 1, 0);
    for (const ObjFile::Triangle* triangle : sources_) {
      for (const ObjFile::Corner& corner : triangle->corners) ++first[corner.vertex + 1];
    }
    for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
    std::vector<CornerOf> corners(3 * sources_.size());
    std::vector<std::size_t> next = first;
    for (std::size_t t = 0; t < sources_.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        corners[next[sources_[t]->corners[static_cast<std::size_t>(k)].vertex]++] = {t, k};
      }
    }
    for (std::size_t vertex = 0; vertex + 1 < first.size(); ++vertex) {
      corners_.assign(corners.begin() + static_cast<std::ptrdiff_t>(first[vertex]),
                      corners.begin() + static_cast<std::ptrdiff_t>(first[vertex + 1]));
      if (!corners_.empty()) add_vertex(place_(file_.positions[vertex]));
    }
  }

 private:
  struct CornerOf {
    std::size_t triangle;
    int corner;
  };

  /// Corners at the vertex at hand that have one normal.
  struct Group {
    std::uint64_t key;
    std::size_t first, last;  // of corners_
    std::int32_t smoothing;
    glm::vec3 area;
  };

  glm::vec3 area_of(const ObjFile::Triangle& triangle) const {
    const auto at = [&](int k) {
      return place_(file_.positions[triangle.corners[static_cast<std::size_t>(k)].vertex]);
    };
    const glm::vec3 origin = at(0);
    return glm::cross(at(1) - origin, at(2) - origin);
  }

  /// The file's normal of a corner, if it has a usable one.
  bool given_normal(const CornerOf& at, glm::vec3& normal) const {
    const std::uint32_t index = sources_[at.triangle]->corners[static_cast<std::size_t>(at.corner)].normal;
    if (index == ObjFile::none) return false;
    const glm::vec3 given = place_.turned(file_.normals[index]);
    const float length = glm::length(given);
    if (!(length > 1e-6f) || !std::isfinite(length)) return false;
    normal = given / length;
    return true;
  }

  /// What sorts corners into groups: the number of their normal; without one, their smoothing group, and the cell of
  /// all directions in which their triangle's normal lies. Cells keep a pole of many faces from being compared face by
  /// face; the faces of one cell, some 10 degrees wide, count as one.
  std::uint64_t key_of(const CornerOf& at) const {
    constexpr float cells = 6.0f;
    const ObjFile::Triangle& source = *sources_[at.triangle];
    glm::vec3 normal;
    if (given_normal(at, normal)) return source.corners[static_cast<std::size_t>(at.corner)].normal;
    if (source.smoothing == 0) return flat_bit | at.triangle;
    const glm::uvec3 cell(glm::round(cells * (glm::normalize(areas_[at.triangle]) + 1.0f)));
    return creased_bit | static_cast<std::uint64_t>(source.smoothing & 0x7FFFFFFF) << cell_bits | cell.x << 8 |
           cell.y << 4 | cell.z;
  }

  void add_vertex(const glm::vec3& position) {
    std::vector<std::pair<std::uint64_t, CornerOf>> keyed;
    keyed.reserve(corners_.size());
    for (const CornerOf& corner : corners_) keyed.emplace_back(key_of(corner), corner);
    std::stable_sort(keyed.begin(), keyed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    groups_.clear();
    for (std::size_t i = 0; i < keyed.size(); ++i) {
      corners_[i] = keyed[i].second;
      const std::size_t triangle = corners_[i].triangle;
      if (groups_.empty() || groups_.back().key != keyed[i].first) {
        groups_.push_back({keyed[i].first, i, i, sources_[triangle]->smoothing, glm::vec3(0.0f)});
      }
      groups_.back().last = i + 1;
      groups_.back().area += areas_[triangle];
    }
    for (const Group& group : groups_) {
      const auto begin = corners_.begin() + static_cast<std::ptrdiff_t>(group.first);
      const auto end = corners_.begin() + static_cast<std::ptrdiff_t>(group.last);
      const glm::vec3 normal = normal_of(group);
      if (has_coordinates_) {
        add_by_coordinates(position, normal, begin, end);
      } else {
        add_corners(position, normal, begin, end);
      }
    }
  }

  using Corners = std::vector<CornerOf>::iterator;

  /// One vertex of the mesh for all of them.
  void add_corners(const glm::vec3& position, const glm::vec3& normal, Corners begin, Corners end) {
    const auto vertex = static_cast<std::uint32_t>(mesh_.positions.size());
    mesh_.positions.push_back(position);
    mesh_.normals.push_back(normal);
    for (Corners at = begin; at != end; ++at) mesh_.triangles[at->triangle][at->corner] = vertex;
  }

  glm::vec2 coordinates_of(const CornerOf& at) const {
    const std::uint32_t index = sources_[at.triangle]->corners[static_cast<std::size_t>(at.corner)].coordinates;
    return index == ObjFile::none ? glm::vec2(0.0f) : file_.texture_coordinates[index];
  }

  /// One for those that have the same texture coordinates.
  void add_by_coordinates(const glm::vec3& position, const glm::vec3& normal, Corners begin, Corners end) {
    const auto order = [&](const CornerOf& a, const CornerOf& b) {
      const glm::vec2 p = coordinates_of(a), q = coordinates_of(b);
      return p.x < q.x || (p.x == q.x && p.y < q.y);
    };
    std::stable_sort(begin, end, order);
    while (begin != end) {
      const Corners next = std::find_if(begin, end, [&](const CornerOf& at) { return order(*begin, at); });
      mesh_.texture_coordinates.push_back(coordinates_of(*begin));
      add_corners(position, normal, begin, next);
      begin = next;
    }
  }

  /// The area-weighted mean over the faces about the vertex that go on smoothly from those at hand.
  glm::vec3 normal_of(const Group& group) const {
    glm::vec3 normal;
    if (given_normal(corners_[group.first], normal)) return normal;
    const glm::vec3 flat = glm::normalize(group.area);
    if (group.smoothing == 0) return flat;
    glm::vec3 sum(0.0f);
    const auto joins = [&](const Group& other) { return other.key >> cell_bits == group.key >> cell_bits; };
    const auto add = [&](const Group& other) {
      if (glm::dot(flat, glm::normalize(other.area)) > cos_crease) sum += other.area;
    };
    // Those of one smoothing group are neighbours in the list.
    for (const Group* other = &group; other <= &groups_.back() && joins(*other); ++other) add(*other);
    for (const Group* other = &group; other-- > &groups_.front() && joins(*other);) add(*other);
    return glm::normalize(sum);
  }

  static constexpr int cell_bits = 12;
  static constexpr std::uint64_t flat_bit = std::uint64_t{1} << 62, creased_bit = std::uint64_t{1} << 63;

  const ObjFile& file_;
  const Placement& place_;
  bool has_coordinates_;
  Mesh& mesh_;
  std::vector<const ObjFile::Triangle*> sources_;
  std::vector<glm::vec3> areas_;  // along the normals, twice as long as the triangles are large
  std::vector<CornerOf> corners_;
  std::vector<Group> groups_;
};

}  // namespace

Scene load_obj(const std::string& path, const ObjView& view) {
  const ObjFile file = read_obj(path);
  Scene scene;
  scene.name = std::filesystem::path(path).filename().string();
  scene.files = {path};
  scene.files.insert(scene.files.end(), file.material_files.begin(), file.material_files.end());
  const Placement placement = placement_of(file, view.up);
  Pictures pictures(path);
  for (const MtlMaterial& source : file.materials) {
    scene.materials.push_back(pictures.material(source, placement.scale));
  }
  scene.files.insert(scene.files.end(), pictures.files().begin(), pictures.files().end());
  const auto default_material = static_cast<std::uint32_t>(scene.materials.size());
  scene.materials.push_back({"default", matte(grey)});
  const bool is_any_textured = std::any_of(scene.materials.begin(), scene.materials.end(), is_textured);
  const bool has_coordinates = is_any_textured || !file.texture_coordinates.empty();
  MeshMaker(file, placement, default_material, has_coordinates, scene.mesh).make();
  set_tangents(scene.mesh);
  if (scene.mesh.triangles.empty()) throw InputError(path + ": no triangles in it");
  scene.warnings = file.warnings;
  for (std::string& line : pictures.warnings()) scene.warnings.push_back(std::move(line));
  for (std::string& line : missing_coordinates(path, file, scene.materials)) scene.warnings.push_back(std::move(line));
  for (std::string& line : messages(path, placement)) scene.warnings.push_back(std::move(line));
  place_camera_and_light(scene, view);
  return scene;
}

}  // namespace example
