#include "material_change.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include <zonal/material/measured.hpp>
#include <zonal/material/merl.hpp>
#include <zonal/material/rgl.hpp>

#include "command_line.hpp"
#include "input_error.hpp"
#include "materials.hpp"

namespace example {
namespace {

constexpr float metal_roughness = 0.2f;  // where a spec does not say
constexpr float least_roughness = 0.01f;

bool is_share(float value) { return value >= 0.0f && value <= 1.0f; }
bool is_roughness(float value) { return value >= least_roughness && value <= 1.0f; }

/// matte:R,G,B and its like; nothing where the numbers are wrong, or the model unknown.
std::optional<zonal::Brdf> parse_model(const std::string& model, const std::string& numbers) {
  std::array<float, 4> n{};
  if (model == "matte") {
    std::array<float, 3> rgb{};
    if (!parse_numbers(numbers, ',', rgb) || !std::all_of(rgb.begin(), rgb.end(), is_share)) return std::nullopt;
    return matte({rgb[0], rgb[1], rgb[2]});
  }
  if (model == "plastic" || model == "phong") {
    if (!parse_numbers(numbers, ',', n) || !std::all_of(n.begin(), n.begin() + 3, is_share)) return std::nullopt;
    const glm::vec3 rgb(n[0], n[1], n[2]);
    if (model == "plastic") return is_roughness(n[3]) ? std::optional(plastic(rgb, n[3])) : std::nullopt;
    if (!(n[3] >= 0.0f && n[3] <= 1e4f)) return std::nullopt;
    return zonal::Brdf{{zonal::PhongBrdf{rgb, n[3]}}};
  }
  if (const Metal* found = find_metal(model)) {
    std::array<float, 1> roughness{metal_roughness};
    if (!numbers.empty() && !(parse_numbers(numbers, ',', roughness) && is_roughness(roughness[0]))) {
      return std::nullopt;
    }
    return metal(*found, roughness[0]);
  }
  return std::nullopt;
}

zonal::MeasuredBrdf load_measured(const std::filesystem::path& path) {
  try {
    if (path.extension() == ".binary") return zonal::measured(zonal::load_merl(path));
    return zonal::measured(zonal::load_rgl(path));
  } catch (const zonal::FileError& error) {
    throw InputError(error.what());
  }
}

Material make_material(const std::string& spec) {
  const std::filesystem::path path(spec);
  if (path.extension() == ".binary" || path.extension() == ".bsdf") return {{}, {{load_measured(path)}}, path};
  const std::size_t colon = std::min(spec.find(':'), spec.size());
  const std::string numbers = colon < spec.size() ? spec.substr(colon + 1) : "";
  std::optional<zonal::Brdf> brdf = parse_model(spec.substr(0, colon), numbers);
  if (!brdf) throw InputError("--material: '" + spec + "' is none of " + material_specs());
  return {{}, std::move(*brdf), {}};
}

}  // namespace

std::string material_specs() {
  std::string text = "matte:R,G,B plastic:R,G,B,ROUGHNESS phong:R,G,B,EXPONENT";
  for (const Metal& metal : metals()) text += std::string(" ") + metal.name + "[:ROUGHNESS]";
  return text + " FILE.binary FILE.bsdf";
}

CLI::Option* add_material_option(CLI::App& app, std::vector<MaterialChange>& changes) {
  return app
      .add_option_function<std::vector<std::string>>(
          "--material",
          [&changes](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) changes.push_back(parse_material_change(text));
          },
          "Make the scene's material NAME (* for all) another; may be repeated. SPEC: " + material_specs() +
              "; files are of the MERL and RGL databases; the x axis of anisotropic ones lies along the texture "
              "coordinate u, and horizontally where there is none. The surface keeps its relief, not its colours")
      ->type_name("NAME=SPEC")
      ->allow_extra_args(false)
      ->take_all();
}

MaterialChange parse_material_change(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
    throw InputError("--material: '" + text + "' is not NAME=SPEC");
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

void apply(const std::vector<MaterialChange>& changes, std::vector<Material>& materials) {
  std::map<std::string, Material> made;  // by spec: a file is read once
  for (const MaterialChange& change : changes) {
    const auto known = made.find(change.spec);
    const Material& changed =
        (known != made.end() ? known : made.emplace(change.spec, make_material(change.spec)).first)->second;
    bool found = false;
    for (Material& material : materials) {
      if (change.name != "*" && change.name != material.name) continue;
      // Its relief is the surface's; the picture has the colours of what is replaced.
      material = {material.name, changed.brdf, changed.file, material.emission, {}, material.relief};
      found = true;
    }
    if (found) continue;
    std::string names;
    for (const Material& material : materials) names += (names.empty() ? "" : ", ") + material.name;
    throw InputError("--material: the scene has no '" + change.name + "', but " + names);
  }
}

}  // namespace example
