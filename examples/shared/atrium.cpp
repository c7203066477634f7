// The built-in scene: a hall with two arcades, an apse, and glossy things on its floor.
#include <cmath>
#include <memory>
#include <utility>

#include <glm/gtc/constants.hpp>
#include <zonal/material/energy.hpp>

#include "materials.hpp"
#include "mesh_builder.hpp"
#include "names.hpp"
#include "noise.hpp"
#include "tangents.hpp"

namespace example {
namespace {

// Metres.
constexpr float half_width = 4.6f;
constexpr float front = 7.0f;
constexpr float back = -7.0f;
constexpr float ceiling = 6.2f;
constexpr float row_x = 3.35f;  // of the columns' axes
constexpr float column_spacing = 2.8f;
constexpr int columns_per_row = 6;
constexpr float column_height = 3.3f;  // to the top of the capital
constexpr float arcade_height = 5.0f;
constexpr float apse_radius = 2.0f;
constexpr float apse_spring = 2.9f;  // height where its half dome begins

float column_z(int i) { return front - column_spacing * static_cast<float>(i); }

/// A flat wall with a round-headed opening in its middle.
struct ArchedWall {
  glm::vec3 left_foot;
  glm::vec3 across;  // unit, along the wall
  float width;
  float opening_foot;  // height where the opening begins
  float spring;        // height where its round head begins
  float top;
  float opening_radius;
};

glm::vec3 wall_point(const ArchedWall& wall, float along, float height) {
  return wall.left_foot + along * wall.across + glm::vec3(0.0f, height, 0.0f);
}

/// Point of the opening's round head, along and up the wall; t from 0 at the left spring to 1 at the right.
glm::vec2 arch_point(const ArchedWall& wall, float t) {
  const float angle = glm::pi<float>() * (1.0f - t);
  return {0.5f * wall.width + wall.opening_radius * std::cos(angle),
          wall.spring + wall.opening_radius * std::sin(angle)};
}

void add_arched_wall(MeshBuilder& builder, const ArchedWall& wall) {
  constexpr int pieces = 32;
  const float left = 0.5f * wall.width - wall.opening_radius;
  const auto rectangle = [&](float along0, float along1, float height0, float height1) {
    builder.quad(wall_point(wall, along0, height0), wall_point(wall, along1, height0),
                 wall_point(wall, along1, height1), wall_point(wall, along0, height1));
  };
  rectangle(0.0f, left, wall.opening_foot, wall.top);
  rectangle(wall.width - left, wall.width, wall.opening_foot, wall.top);
  for (int i = 0; i < pieces; ++i) {
    const glm::vec2 p = arch_point(wall, static_cast<float>(i) / pieces);
    const glm::vec2 q = arch_point(wall, static_cast<float>(i + 1) / pieces);
    builder.quad(wall_point(wall, p.x, p.y), wall_point(wall, q.x, q.y), wall_point(wall, q.x, wall.top),
                 wall_point(wall, p.x, wall.top));
  }
}

/// The underside of the arch, `depth` thick.
void add_soffit(MeshBuilder& builder, const ArchedWall& wall, const glm::vec3& depth) {
  builder.surface({32, 1}, [&](float u, float v) {
    const glm::vec2 p = arch_point(wall, u);
    return wall_point(wall, p.x, p.y) + v * depth;
  });
}

void add_column(MeshBuilder& builder, const glm::vec3& foot) {
  constexpr float top = column_height;
  builder.box(foot + glm::vec3(-0.40f, 0.0f, -0.40f), foot + glm::vec3(0.40f, 0.16f, 0.40f));
  const auto base =
      smooth_run({{0.38f, 0.16f}, {0.40f, 0.22f}, {0.38f, 0.28f}, {0.32f, 0.31f}, {0.33f, 0.36f}, {0.29f, 0.42f}}, 4);
  const auto shaft = smooth_run({{0.285f, 0.42f}, {0.28f, 1.2f}, {0.26f, 2.1f}, {0.235f, top - 0.55f}}, 4);
  const auto ring = smooth_run({{0.27f, top - 0.55f}, {0.28f, top - 0.515f}, {0.27f, top - 0.48f}}, 4);
  const auto bell =
      smooth_run({{0.24f, top - 0.48f}, {0.25f, top - 0.32f}, {0.30f, top - 0.20f}, {0.38f, top - 0.14f}}, 4);
  builder.lathe(foot, {base, shaft, ring, bell}, 48);
  builder.box(foot + glm::vec3(-0.40f, top - 0.14f, -0.40f), foot + glm::vec3(0.40f, top, 0.40f));
}

/// Columns along one side, arches between them, and the wall they carry up to a cornice.
void add_arcade(MeshBuilder& builder, float side) {
  constexpr float half_thickness = 0.28f;
  const float x = side * row_x;
  for (int i = 0; i < columns_per_row; ++i) add_column(builder.begin_mesh(), {x, 0.0f, column_z(i)});
  builder.begin_mesh();
  for (int i = 0; i + 1 < columns_per_row; ++i) {
    const glm::vec3 foot(x - half_thickness, 0.0f, column_z(i));
    ArchedWall wall{foot, {0.0f, 0.0f, -1.0f}, column_spacing, column_height, column_height, arcade_height, 1.08f};
    add_soffit(builder, wall, {2.0f * half_thickness, 0.0f, 0.0f});
    add_arched_wall(builder, wall);
    wall.left_foot.x = x + half_thickness;
    add_arched_wall(builder, wall);
  }
  builder.begin_mesh().box({x - 0.36f, arcade_height, back}, {x + 0.36f, arcade_height + 0.14f, front});
  builder.box({x - 0.42f, arcade_height + 0.14f, back}, {x + 0.42f, arcade_height + 0.26f, front});
}

void add_floor(MeshBuilder& builder, std::uint32_t light_tile, std::uint32_t dark_tile) {
  constexpr int across = 10;
  constexpr int along = 16;
  const glm::vec2 size(2.0f * half_width / across, (front - back) / along);
  for (int i = 0; i < across; ++i) {
    for (int j = 0; j < along; ++j) {
      const float x = -half_width + size.x * static_cast<float>(i);
      const float z = back + size.y * static_cast<float>(j);
      builder.use((i + j) % 2 == 0 ? light_tile : dark_tile);
      builder.quad({x, 0.0f, z}, {x, 0.0f, z + size.y}, {x + size.x, 0.0f, z + size.y}, {x + size.x, 0.0f, z});
    }
  }
}

void add_ceiling(MeshBuilder& builder) {
  builder.quad({-half_width, ceiling, back}, {half_width, ceiling, back}, {half_width, ceiling, front},
               {-half_width, ceiling, front});
  for (int i = 0; i < columns_per_row; ++i) {
    const float z = column_z(i);
    builder.box({-half_width, ceiling - 0.28f, z - 0.17f}, {half_width, ceiling, z + 0.17f});
  }
}

/// The end wall, and behind its arch a half cylinder under a quarter sphere.
void add_apse(MeshBuilder& builder, std::uint32_t wall_material, std::uint32_t niche_material) {
  builder.begin_mesh().use(wall_material);
  add_arched_wall(
      builder,
      {{-half_width, 0.0f, back}, {1.0f, 0.0f, 0.0f}, 2.0f * half_width, 0.0f, apse_spring, ceiling, apse_radius});
  const auto arc = [](float u) {
    const float angle = glm::pi<float>() * u;
    return glm::vec3(-std::cos(angle), 0.0f, -std::sin(angle));
  };
  const glm::vec3 centre(0.0f, 0.0f, back);
  builder.begin_mesh().use(niche_material);
  builder.surface({64, 1}, [&](float u, float v) {
    return centre + apse_radius * arc(u) + glm::vec3(0.0f, apse_spring * v, 0.0f);
  });
  builder.surface({64, 24}, [&](float u, float v) {
    const float rise = glm::half_pi<float>() * v;
    return centre + glm::vec3(0.0f, apse_spring + apse_radius * std::sin(rise), 0.0f) +
           apse_radius * std::cos(rise) * arc(u);
  });
  builder.begin_mesh().use(wall_material);
  builder.surface({64, 1}, [&](float u, float v) { return centre + apse_radius * v * arc(u); });
}

void add_pedestal(MeshBuilder& builder, const glm::vec3& foot, float radius, float height) {
  builder.lathe(
      foot,
      {smooth_run({{radius * 1.25f, 0.0f}, {radius * 1.28f, 0.06f}, {radius * 1.15f, 0.12f}}, 4),
       {{radius * 1.05f, 0.12f}, {radius, height - 0.12f}},
       smooth_run({{radius * 1.1f, height - 0.12f}, {radius * 1.24f, height - 0.06f}, {radius * 1.2f, height}}, 4),
       {{radius * 1.2f, height}, {0.0f, height}}},
      64);
}

/// A trefoil knot, turned about the vertical.
void add_knot(MeshBuilder& builder, const glm::vec3& centre, float scale, float tube_radius, float turn) {
  const auto curve = [=](float t) {
    const float a = glm::two_pi<float>() * t;
    const glm::vec3 p(std::sin(a) + 2.0f * std::sin(2.0f * a), std::cos(a) - 2.0f * std::cos(2.0f * a),
                      -std::sin(3.0f * a));
    const glm::vec3 turned(std::cos(turn) * p.x + std::sin(turn) * p.z, p.y,
                           std::cos(turn) * p.z - std::sin(turn) * p.x);
    return centre + scale * turned;
  };
  builder.closed_tube(curve, tube_radius, 320, 40);
}

void add_vase(MeshBuilder& builder, const glm::vec3& foot) {
  const auto profile = smooth_run({{0.20f, 0.0f},
                                   {0.22f, 0.03f},
                                   {0.16f, 0.10f},
                                   {0.26f, 0.30f},
                                   {0.36f, 0.55f},
                                   {0.33f, 0.80f},
                                   {0.17f, 1.02f},
                                   {0.13f, 1.16f},
                                   {0.21f, 1.28f},
                                   {0.20f, 1.30f},
                                   {0.11f, 1.16f},
                                   {0.14f, 1.00f},
                                   {0.0f, 0.96f}},
                                  8);
  builder.lathe(foot, {profile}, 72);
}

/// Adds materials to a scene; each returns the material's number.
class Palette {
 public:
  Palette(Scene& scene, AtriumFinish finish)
      : scene_(scene),
        is_diffuse_(finish == AtriumFinish::diffuse || finish == AtriumFinish::bumped),
        is_glossy_(finish == AtriumFinish::glossy || finish == AtriumFinish::bumped_glossy),
        is_open_(finish == AtriumFinish::courtyard),
        is_bumped_(finish == AtriumFinish::bumped || finish == AtriumFinish::bumped_glossy || is_open_) {}

  bool is_bumped() const { return is_bumped_; }
  bool is_open() const { return is_open_; }

  /// In the glossy atrium a lacquer, which mirrors a quarter of the light in the surface's own colour.
  std::uint32_t matte(const char* name, const glm::vec3& albedo) {
    if (!is_glossy_) return add(name, example::matte(albedo));
    const zonal::SchlickFresnel lacquer{0.05f + 0.25f * albedo};
    return add(name, zonal::coated({0.2f, lacquer}, albedo));
  }

  /// In the glossy atrium the same lacquer.
  std::uint32_t coated(const char* name, const glm::vec3& albedo, float roughness) {
    if (is_diffuse_) return add(name, example::matte(albedo));
    return is_glossy_ ? matte(name, albedo) : add(name, plastic(albedo, roughness));
  }

  /// In the diffuse atrium a paint of its colour.
  std::uint32_t metal(const char* name, float roughness) {
    const Metal& metal = *find_metal(name);
    if (is_diffuse_) return add(name, example::matte(zonal::reflectance(metal.fresnel, 1.0f)));
    return add(name, example::metal(metal, roughness));
  }

  /// In the bumped atria the material's surface gets this relief.
  std::uint32_t bumped(std::uint32_t material, const Relief& relief) {
    if (is_bumped_) scene_.materials[material].relief = relief;
    return material;
  }

 private:
  std::uint32_t add(const char* name, zonal::Brdf brdf) {
    scene_.materials.push_back({name, std::move(brdf)});
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
  }

  Scene& scene_;
  bool is_diffuse_, is_glossy_, is_open_, is_bumped_;
};

/// Rough plaster and hewn tiles: octaves of noise, that repeat every metre and a half. Their slopes are 25 degrees and
/// more in most places.
Relief rough_relief() {
  constexpr int size = 512;
  constexpr float metres = 1.5f;
  static const auto heights = std::make_shared<const Texture>(noise_heights(size, 8, 4, 1));
  Relief relief;
  relief.map.texture = heights;
  relief.map.scale = glm::vec2(1.0f / metres);
  relief.strength = 0.12f;
  return relief;
}

void add_hall(MeshBuilder& builder, Palette& palette, const Relief& rough) {
  const std::uint32_t plaster = palette.bumped(palette.matte("plaster", {0.86f, 0.83f, 0.77f}), rough);
  const std::uint32_t terracotta = palette.bumped(palette.matte("terracotta", {0.82f, 0.29f, 0.12f}), rough);
  const std::uint32_t teal = palette.bumped(palette.matte("teal", {0.12f, 0.54f, 0.56f}), rough);
  const std::uint32_t niche = palette.matte("niche", {0.34f, 0.50f, 0.76f});
  const std::uint32_t light_tile = palette.bumped(palette.coated("light tile", {0.70f, 0.65f, 0.56f}, 0.30f), rough);
  const std::uint32_t dark_tile = palette.bumped(palette.coated("dark tile", {0.44f, 0.33f, 0.25f}, 0.30f), rough);
  add_floor(builder, light_tile, dark_tile);
  builder.begin_mesh().use(plaster);
  if (!palette.is_open()) add_ceiling(builder);
  builder.begin_mesh().quad({-half_width, 0.0f, front}, {half_width, 0.0f, front}, {half_width, ceiling, front},
                            {-half_width, ceiling, front});
  builder.begin_mesh()
      .use(terracotta)
      .quad({-half_width, 0.0f, front}, {-half_width, 0.0f, back}, {-half_width, ceiling, back},
            {-half_width, ceiling, front});
  builder.begin_mesh().use(teal).quad({half_width, 0.0f, back}, {half_width, 0.0f, front}, {half_width, ceiling, front},
                                      {half_width, ceiling, back});
  add_apse(builder, plaster, niche);
}

void add_furniture(MeshBuilder& builder, Palette& palette, std::uint32_t stone) {
  const std::uint32_t gold = palette.metal("gold", 0.25f);
  const std::uint32_t red_plastic = palette.coated("red plastic", {0.60f, 0.045f, 0.04f}, 0.22f);
  const std::uint32_t porcelain = palette.coated("porcelain", {0.78f, 0.78f, 0.76f}, 0.18f);
  add_pedestal(builder.begin_mesh().use(stone), {0.0f, 0.0f, -5.9f}, 0.55f, 0.9f);
  builder.begin_mesh().use(gold).sphere({0.0f, 0.9f + 0.8f, -5.9f}, 0.8f, 128);
  add_knot(builder.begin_mesh().use(red_plastic), {-1.35f, 0.98f, -0.6f}, 0.30f, 0.17f, 0.5f);
  builder.begin_mesh().use(stone).box({1.15f, 0.0f, -1.75f}, {1.95f, 0.5f, -0.95f});
  add_vase(builder.begin_mesh().use(porcelain), {1.55f, 0.5f, -1.35f});
}

}  // namespace

Scene make_atrium(AtriumFinish finish) {
  Scene scene;
  scene.name = name_of(atrium_names, finish);
  Palette palette(scene, finish);
  MeshBuilder builder(scene.mesh);
  if (palette.is_bumped()) builder.with_texture_coordinates();
  const Relief rough = palette.is_bumped() ? rough_relief() : Relief();
  add_hall(builder, palette, rough);
  const std::uint32_t stone = palette.bumped(palette.matte("sandstone", {0.80f, 0.71f, 0.58f}), rough);
  builder.use(stone);
  add_arcade(builder, -1.0f);
  add_arcade(builder, 1.0f);
  add_furniture(builder, palette, stone);
  set_tangents(scene.mesh);

  scene.camera = {{0.45f, 1.75f, 6.3f}, {-0.15f, 2.05f, -4.0f}, glm::radians(58.0f)};
  scene.light.position = {1.8f, 4.6f, 2.8f};
  scene.light.axis = glm::normalize(glm::vec3(-1.5f, 0.0f, -0.4f) - scene.light.position);
  scene.light.half_angle = glm::radians(65.0f);
  scene.light.edge = 0.45f;
  // Half-way up the nave: two metres or more from all but the capitals of the columns.
  scene.panel = {{0.0f, 4.0f, -0.6f}, {1.1f, 0.0f, 0.0f}, {0.0f, 0.0f, -4.4f}, 3.0f};
  scene.light.intensity = 150.0f * glm::vec3(1.0f, 0.95f, 0.87f);
  return scene;
}

}  // namespace example
