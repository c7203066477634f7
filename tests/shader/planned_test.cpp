// What zonal-glsl --plan writes, on the driver, against the kernels of C++ that are given zeros for what the plan
// leaves out, and against the gather.
#include <zonal/many_lights/hvl_tree.hpp>
#include <zonal/shader/planned_shells.hpp>

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "../catch.hpp"
#include "compare.hpp"
#include "cpp_functions.hpp"
#include "driver.hpp"
#include "request.hpp"
#include "scenes.hpp"

namespace {

using zonal::CoefficientPlan;
using zonal::Horizon;
using zonal::MaterialTable;
using zonal::Symmetry;
using zonal::shader::PlannedMaterials;

constexpr int most_bands = 6;

/// Of so many bands, but for those named.
CoefficientPlan plan_without(Symmetry symmetry, int bands, const std::vector<std::pair<int, int>>& left_out) {
  CoefficientPlan plan{symmetry, bands, {}, {}};
  for (int l = 0; l < bands; ++l) {
    for (int m = -l; m <= l; ++m) plan.kept.push_back(has_order(symmetry, m));
  }
  for (const auto& [l, m] : left_out) plan.kept[static_cast<std::size_t>(zonal::sh_index(l, m))] = false;
  return plan;
}

/// Zonal and mirror, whole and with holes, of 90 rows and of one; two of a class; and one of which nothing is left.
std::vector<CoefficientPlan> plans() {
  return {plan_without(Symmetry::zonal, 6, {{3, 0}, {5, 0}}),
          plan_without(Symmetry::mirror, 6, {{1, 1}, {4, 0}, {5, 5}}),
          plan_without(Symmetry::zonal, 6, {{3, 0}, {5, 0}}),
          plan_without(Symmetry::mirror, 3, {}),
          plan_without(Symmetry::zonal, 3, {}),
          plan_without(Symmetry::zonal, 1, {{0, 0}})};
}

/// The material as the shader has it: without what the plan leaves out; of half floats where it is so stored.
zonal::EvenSh<most_bands, glm::vec3> kept_of(zonal::EvenSh<most_bands, glm::vec3> f, const CoefficientPlan& plan) {
  for (int l = 0; l < most_bands; ++l) {
    for (int m = 0; m <= l; ++m) {
      if (!plan.keeps(l, m)) f(l, m) = glm::vec3(0);
    }
  }
  return f;
}
MaterialTable in_halves(const MaterialTable& table) {
  std::vector<glm::vec3> rows = table.with_cosine_rows();
  for (glm::vec3& f : rows) {
    for (int c = 0; c < 3; ++c) f[c] = to_float(zonal::to_half(f[c]));
  }
  return {table.bands(), table.angles(), 0.0, rows, zonal::MirroredRows(table.without_cosine_rows())};
}

template <int NE>
struct PlannedScene {
  static constexpr std::size_t light_count = 10, receiver_count = 60;
  std::vector<CoefficientPlan> receiving = plans();
  std::vector<MaterialTable> tables;
  zonal::HvlCache<NE> cache;
  std::vector<zonal::Receiver> receivers;
  std::vector<float> lights, materials, places;

  explicit PlannedScene(bool halves) {
    SceneRandom random(17);
    for (std::size_t i = 0; i < receiving.size(); ++i) {
      tables.push_back(random_material(random, most_bands, i % 3 == 0 ? 1 : MaterialTable::max_angles));
    }
    std::vector<zonal::VirtualLight> virtual_lights(light_count);
    for (zonal::VirtualLight& light : virtual_lights) {
      light.position = random.vector(-1, 1);
      light.normal = random.direction();
      light.to_primary = random.direction_above(light.normal);
      light.radius = random.uniform(0.02F, 1.5F);
      light.flux = random.vector(0.1F, 1) * (light.radius * light.radius);
      light.material = &tables[1];
    }
    cache = zonal::HvlCache<NE>(virtual_lights);
    lights = shader_buffer(cache);
    std::vector<float> begins;
    for (std::size_t i = 0; i < tables.size(); ++i) {
      begins.push_back(static_cast<float>(materials.size()));
      const std::vector<float> floats = shader_buffer(zonal::KeptTable(tables[i], receiving[i], halves ? 16 : 32));
      materials.insert(materials.end(), floats.begin(), floats.end());
      if (halves) tables[i] = in_halves(tables[i]);
    }
    if (halves) {
      const std::vector<std::uint32_t> pairs = zonal::packed_halves(materials);
      materials.resize(pairs.size());
      std::memcpy(materials.data(), pairs.data(), sizeof(float) * pairs.size());
    }
    for (std::size_t i = 0; i < receiver_count; ++i) {
      zonal::Receiver& receiver = receivers.emplace_back();
      receiver.position = random.vector(-1, 1);
      receiver.normal = random.direction();
      receiver.outgoing = random.direction_above(receiver.normal);
      for (const auto& v : {receiver.position, receiver.normal, receiver.outgoing}) SceneRandom::append(places, v);
      places.push_back(static_cast<float>(i % tables.size()));
      places.push_back(begins[i % tables.size()]);
    }
  }

  zonal::EvenSh<most_bands, glm::vec3> material_of(std::size_t i) const {
    const zonal::Receiver& receiver = receivers[i];
    const float cosine = glm::dot(receiver.normal, receiver.outgoing);
    return kept_of(tables[i % tables.size()].template with_cosine<most_bands>(cosine), receiving[i % tables.size()]);
  }
};

std::string shader_of(const PlannedMaterials& plan) {
  zonal_glsl::Request request;
  request.plan = plan;
  request.text.precise = true;
  const bool halves = plan.coefficient_bits == 16;
  return std::string(
             "#version 450\nlayout(local_size_x = 64) in;\n"
             "layout(std430, binding = 0) readonly buffer Lights { float lights[]; };\n"
             "layout(std430, binding = 2) readonly buffer Places { float places[]; };\n"
             "layout(std430, binding = 3) writeonly buffer Results { float results[]; };\n"
             "#define ZONAL_LIGHT(i) lights[i]\n") +
         (plan.is_drawn ? "layout(std430, binding = 4) readonly buffer Draws { uint draws[]; };\n"
                          "#define DRAW (3u * (gl_GlobalInvocationID.x % 4u))\n"
                          "#define LIGHTS draws[DRAW], draws[DRAW + 1u], draws[DRAW + 2u]\n"
                        : "#define LIGHTS 10u\n") +
         (halves ? "layout(std430, binding = 1) readonly buffer Pairs { uint pairs[]; };\n"
                   "#define ZONAL_MATERIAL_PAIR(i) pairs[i]\n"
                 : "layout(std430, binding = 1) readonly buffer Materials { float materials[]; };\n"
                   "#define ZONAL_MATERIAL(i) materials[i]\n") +
         zonal_glsl::shader_file(request, *zonal::shader::find_dialect("glsl450")) + R"(
vec3 place(uint i) { return vec3(places[i], places[i + 1u], places[i + 2u]); }
void main() {
  uint i = 11u * gl_GlobalInvocationID.x;
  if (gl_GlobalInvocationID.x >= 60u) return;
  vec3 seen = zonal_gather_planned(uint(places[i + 9u]), uint(places[i + 10u]), LIGHTS, place(i), place(i + 3u), place(i + 6u));
  for (uint c = 0u; c < 3u; ++c) results[3u * gl_GlobalInvocationID.x + c] = seen[c];
}
)";
}

/// What the kernel of C++ takes of a receiver, of all bands that the plan has, zeros and all.
std::vector<float> floats_of(const zonal::Receiver& receiver, const CoefficientPlan& plan,
                             const zonal::EvenSh<most_bands, glm::vec3>& material) {
  const bool is_zonal = plan.symmetry == Symmetry::zonal;
  std::vector<float> floats;
  SceneRandom::append(floats, receiver.position);
  SceneRandom::append(floats, receiver.normal);
  if (!is_zonal) SceneRandom::append(floats, zonal::detail::tangent_towards(receiver.normal, receiver.outgoing));
  for (int l = 0; l < plan.bands; ++l) {
    for (int m = 0; m <= (is_zonal ? 0 : l); ++m) SceneRandom::append(floats, material(l, m));
  }
  return floats;
}

/// Adds what the kernel makes of lights as the shader has them.
template <int NE>
void add_in_cpp(const std::vector<float>& lights, Horizon horizon, const CoefficientPlan& plan,
                const std::vector<float>& of_receiver, float (&sum)[3]) {
  constexpr std::size_t emission_size = zonal::EvenEmission::size(NE), light_size = 10 + 3 * emission_size;
  const std::string kernel = zonal::kernels::hvl_name("hvl_radiance", NE, horizon, plan.symmetry).text;
  for (std::size_t at = 0; at < lights.size(); at += light_size) {
    const float* const floats = &lights[at];
    std::vector<float> inputs(floats, floats + 10);
    for (std::size_t k = 0; k < emission_size; ++k) {
      for (std::size_t c = 0; c < 3; ++c) inputs.push_back(floats[10 + c * emission_size + k]);
    }
    inputs.insert(inputs.end(), of_receiver.begin(), of_receiver.end());
    const std::vector<float> radiance = run_in_cpp(kernel, plan.bands, zonal::shader::all_orders, inputs);
    for (std::size_t c = 0; c < 3; ++c) sum[c] = sum[c] + radiance[c];
  }
}
std::vector<float> cut_at_zero(const float (&sum)[3]) {
  return {std::max(sum[0], 0.0F), std::max(sum[1], 0.0F), std::max(sum[2], 0.0F)};
}

template <int NE>
std::vector<float> gathered_in_cpp(const PlannedScene<NE>& scene, Horizon horizon, std::size_t i) {
  const CoefficientPlan& plan = scene.receiving[i % scene.receiving.size()];
  float sum[3] = {0, 0, 0};
  add_in_cpp<NE>(scene.lights, horizon, plan, floats_of(scene.receivers[i], plan, scene.material_of(i)), sum);
  return cut_at_zero(sum);
}

template <int NE, Horizon horizon>
void check(Driver& driver, int bits) {
  CAPTURE(NE, int(horizon), bits);
  const PlannedScene<NE> scene(bits == 16);
  const unsigned program = driver.compile(shader_of({scene.receiving, NE, horizon, bits}));
  const std::vector<float> given = detail::run_into(driver, program, {scene.lights, scene.materials, scene.places}, {},
                                                    3 * scene.receiver_count, 1, 1)
                                       .values;
  std::vector<float> gathered;
  for (std::size_t i = 0; i < scene.receiver_count; ++i) {
    require_equal({&given[3 * i], &given[3 * i] + 3}, gathered_in_cpp(scene, horizon, i), driver.is_software(),
                  [&] { return std::vector<float>(&scene.places[11 * i], &scene.places[11 * i] + 11); });
    SceneRandom::append(gathered,
                        zonal::gather<most_bands, NE, horizon>(scene.cache, scene.receivers[i], scene.material_of(i)));
  }
  require_equal(given, gathered, false, [] { return NE; });
}

template <int NE>
void check_all(Driver& driver) {
  check<NE, Horizon::smoothstep>(driver, 32);
  check<NE, Horizon::smoothstep>(driver, 16);
  check<NE, Horizon::exact>(driver, 32);
  check<NE, Horizon::none>(driver, 16);
}

}  // namespace

TEST_CASE("What a plan keeps is gathered on the driver as in C++ with zeros for the rest") {
  Driver* driver = driver_or_skip();
  if (driver == nullptr) return;
  check_all<1>(*driver);
  check_all<3>(*driver);
}

TEST_CASE("Lights that a cut has drawn are gathered on the driver as in C++, each pixel by its draw") {
  Driver* driver = driver_or_skip();
  if (driver == nullptr) return;
  constexpr int NE = 3;
  PlannedScene<NE> scene(false);
  SceneRandom random(18);
  // A wall of lights over receivers, some of which it stands beside.
  std::vector<zonal::VirtualLight> lights(900);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    zonal::VirtualLight& light = lights[i];
    light.position = {float(i % 30) / 10 - 1.5F, 1.2F, float(i / 30) / 10 - 0.4F};
    light.normal = {0, -1, 0};
    light.to_primary = random.direction_above(light.normal);
    light.radius = 0.1F;
    light.flux = random.vector(0.1F, 1) * 0.01F;
    light.material = &scene.tables[1];
  }
  const zonal::HvlTree<NE> tree{zonal::HvlCache<NE>(lights)};
  zonal::ReceiverBox box;
  scene.places.clear();
  for (std::size_t i = 0; i < scene.receiver_count; ++i) {
    zonal::Receiver& receiver = scene.receivers[i];
    receiver.position = random.vector(-0.3F, 0.3F) * glm::vec3(1, 1, 0);
    receiver.normal = {0, 0, 1};
    receiver.outgoing = random.direction_above(receiver.normal);
    box.add(receiver.position, receiver.normal);
  }
  zonal::BoundedReceiver<most_bands, float> eight[zonal::cut_receivers];
  for (std::size_t i = 0; i < zonal::cut_receivers; ++i) {
    eight[i] = zonal::bounded_receiver(scene.receivers[i * 7], scene.material_of(i * 7));
  }
  zonal::LightCut<most_bands, NE> cut(tree.tree());
  zonal::CutTolerance tolerance;
  tolerance.relative = 0.2F;
  cut.find(zonal::as_packet(eight), tolerance);
  std::vector<zonal::DrawnLights<NE>> draws(4);
  tree.draw(cut, box, 1, draws);
  CAPTURE(cut.size(), draws[0].clear.size(), draws[0].across.size());
  REQUIRE(draws[0].clear.size() > 0);
  REQUIRE(draws[0].across.size() > 0);
  REQUIRE(draws[0].size() < 900);

  const zonal::DrawnBuffer buffer = shader_buffer(draws);
  std::vector<float> numbers(buffer.draws.size());
  std::memcpy(numbers.data(), buffer.draws.data(), sizeof(float) * numbers.size());
  std::vector<float> begins;
  for (std::size_t i = 0, at = 0; i < scene.tables.size(); ++i) {
    begins.push_back(static_cast<float>(at));
    at += shader_buffer(zonal::KeptTable(scene.tables[i], scene.receiving[i])).size();
  }
  for (std::size_t i = 0; i < scene.receiver_count; ++i) {
    const zonal::Receiver& receiver = scene.receivers[i];
    for (const auto& v : {receiver.position, receiver.normal, receiver.outgoing}) SceneRandom::append(scene.places, v);
    scene.places.push_back(static_cast<float>(i % scene.tables.size()));
    scene.places.push_back(begins[i % scene.tables.size()]);
  }
  const unsigned program = driver->compile(shader_of({scene.receiving, NE, Horizon::smoothstep, 32, true}));
  std::vector<unsigned> buffers;
  for (const auto& floats : {buffer.lights, scene.materials, scene.places})
    buffers.push_back(driver->make_buffer(floats));
  buffers.push_back(driver->make_buffer(std::vector<float>(3 * scene.receiver_count)));
  buffers.push_back(driver->make_buffer(numbers));
  driver->run(program, buffers, 1);
  const std::vector<float> given = driver->read_buffer(buffers[3], 3 * scene.receiver_count);
  for (const unsigned it : buffers) driver->delete_buffer(it);
  driver->delete_program(program);

  std::vector<float> gathered;
  for (std::size_t i = 0; i < scene.receiver_count; ++i) {
    const CoefficientPlan& plan = scene.receiving[i % scene.receiving.size()];
    const std::vector<float> of_receiver = floats_of(scene.receivers[i], plan, scene.material_of(i));
    const zonal::DrawnLights<NE>& drawn = draws[i % 4];
    float sum[3] = {0, 0, 0};
    add_in_cpp<NE>(shader_buffer(drawn.clear), Horizon::none, plan, of_receiver, sum);
    add_in_cpp<NE>(shader_buffer(drawn.across), Horizon::smoothstep, plan, of_receiver, sum);
    require_equal({&given[3 * i], &given[3 * i] + 3}, cut_at_zero(sum), driver->is_software(), [&] { return i; });
    SceneRandom::append(gathered, zonal::gather<most_bands, NE>(drawn, scene.receivers[i], scene.material_of(i)));
  }
  require_equal(given, gathered, false, [] { return NE; });
}

TEST_CASE("A planned function has the coefficients that the plan keeps, and no operations for others") {
  const auto& glsl = *zonal::shader::find_dialect("glsl450");
  const auto kernel_of = [&](const CoefficientPlan& plan, int emission_bands) {
    zonal_glsl::Request request;
    request.plan = PlannedMaterials{{plan}, emission_bands, Horizon::smoothstep, 32};
    auto functions = zonal_glsl::select(request, glsl).functions;
    return std::move(functions.back());
  };
  const auto lambert = kernel_of(plan_without(Symmetry::zonal, 5, {{3, 0}}), 1);
  CHECK(lambert.name == "zonal_hvl_radiance_zonal_diffuse_5_kept_17");
  CHECK(lambert.parameters.at(lambert.parameters.size() - 2).count == 4);
  const auto zonal = kernel_of(plan_without(Symmetry::zonal, 5, {}), 1);
  const auto mirror = kernel_of(plan_without(Symmetry::mirror, 5, {}), 1);
  const auto mirror_part = kernel_of(plan_without(Symmetry::mirror, 5, {{4, 1}, {4, 2}, {4, 3}, {4, 4}}), 1);
  CHECK(mirror.name == "zonal_hvl_radiance_diffuse_5");
  CHECK(mirror_part.name == "zonal_hvl_radiance_diffuse_5_kept_07ff");
  CHECK(lambert.count().total() < zonal.count().total());
  CHECK(zonal.count().total() < mirror_part.count().total());
  CHECK(mirror_part.count().total() < mirror.count().total());
}
