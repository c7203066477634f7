// What zonal-glsl --plan writes, on the driver, against the kernels of C++ that are given zeros for what the plan
// leaves out, and against the gather.
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
         (halves ? "layout(std430, binding = 1) readonly buffer Pairs { uint pairs[]; };\n"
                   "#define ZONAL_MATERIAL_PAIR(i) pairs[i]\n"
                 : "layout(std430, binding = 1) readonly buffer Materials { float materials[]; };\n"
                   "#define ZONAL_MATERIAL(i) materials[i]\n") +
         zonal_glsl::shader_file(request, *zonal::shader::find_dialect("glsl450")) + R"(
vec3 place(uint i) { return vec3(places[i], places[i + 1u], places[i + 2u]); }
void main() {
  uint i = 11u * gl_GlobalInvocationID.x;
  if (gl_GlobalInvocationID.x >= 60u) return;
  vec3 seen = zonal_gather_planned(uint(places[i + 9u]), uint(places[i + 10u]), 10u, place(i), place(i + 3u), place(i + 6u));
  for (uint c = 0u; c < 3u; ++c) results[3u * gl_GlobalInvocationID.x + c] = seen[c];
}
)";
}

/// The sum over lights of the kernel of C++, of all bands that the plan has, zeros and all.
template <int NE>
std::vector<float> gathered_in_cpp(const PlannedScene<NE>& scene, Horizon horizon, std::size_t i) {
  const CoefficientPlan& plan = scene.receiving[i % scene.receiving.size()];
  const bool is_zonal = plan.symmetry == Symmetry::zonal;
  const zonal::Receiver& receiver = scene.receivers[i];
  std::vector<float> of_receiver;
  SceneRandom::append(of_receiver, receiver.position);
  SceneRandom::append(of_receiver, receiver.normal);
  if (!is_zonal) {
    SceneRandom::append(of_receiver, zonal::detail::tangent_towards(receiver.normal, receiver.outgoing));
  }
  const auto material = scene.material_of(i);
  for (int l = 0; l < plan.bands; ++l) {
    for (int m = 0; m <= (is_zonal ? 0 : l); ++m) SceneRandom::append(of_receiver, material(l, m));
  }
  constexpr std::size_t emission_size = zonal::EvenEmission::size(NE), light_size = 10 + 3 * emission_size;
  const std::string kernel = zonal::kernels::hvl_name("hvl_radiance", NE, horizon, plan.symmetry).text;
  float sum[3] = {0, 0, 0};
  for (std::size_t light = 0; light < scene.light_count; ++light) {
    const float* const floats = &scene.lights[light * light_size];
    std::vector<float> inputs(floats, floats + 10);
    for (std::size_t k = 0; k < emission_size; ++k) {
      for (std::size_t c = 0; c < 3; ++c) inputs.push_back(floats[10 + c * emission_size + k]);
    }
    inputs.insert(inputs.end(), of_receiver.begin(), of_receiver.end());
    const std::vector<float> radiance = run_in_cpp(kernel, plan.bands, zonal::shader::all_orders, inputs);
    for (std::size_t c = 0; c < 3; ++c) sum[c] = sum[c] + radiance[c];
  }
  return {std::max(sum[0], 0.0F), std::max(sum[1], 0.0F), std::max(sum[2], 0.0F)};
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
