#include "materials.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <zonal/material/measured.hpp>
#include <zonal/material/merl.hpp>
#include <zonal/material/rgl.hpp>

namespace zonal_report {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> sorted_files(const char* folder, const char* extension) {
  std::vector<fs::path> files;
  const char* data = std::getenv("ZONAL_DATA");
  const fs::path path = fs::path(data ? data : "") / folder;
  if (data == nullptr || !fs::is_directory(path)) return files;
  for (const auto& entry : fs::directory_iterator(path)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// The projections that the report makes are of isotropic materials.
void add_measured(std::vector<NamedMaterial>& materials) {
  for (const fs::path& file : sorted_files("merl", ".binary")) {
    materials.push_back({file.stem().string(), "MERL", {{zonal::measured(zonal::load_merl(file))}}});
  }
  for (const fs::path& file : sorted_files("rgl", ".bsdf")) {
    zonal::RglBrdf brdf = zonal::load_rgl(file);
    if (brdf.isotropic()) materials.push_back({file.stem().string(), "RGL", {{zonal::measured(std::move(brdf))}}});
  }
}

}  // namespace

zonal::Brdf white_ggx(float roughness) { return {{zonal::GgxBrdf{roughness, zonal::SchlickFresnel{glm::vec3(1)}}}}; }
zonal::Brdf gold(float roughness) { return zonal::metal(*zonal::find_metal("gold"), roughness); }

std::vector<NamedMaterial> all_materials() {
  std::vector<NamedMaterial> materials{
      {"Lambert", "model", matte(glm::vec3(0.8F))},
      {"plastic 0.4", "model", plastic({0.4F, 0.1F, 0.1F}, 0.4F)},
      {"plastic 0.1", "model", plastic({0.4F, 0.1F, 0.1F}, 0.1F)},
      {"Phong 20", "model", {{zonal::PhongBrdf{glm::vec3(0.5F), 20}}}},
      {"Phong 200", "model", {{zonal::PhongBrdf{glm::vec3(0.5F), 200}}}},
      {"gold 0.8", "model", gold(0.8F)},
      {"gold 0.4", "model", gold(0.4F)},
      {"gold 0.2", "model", gold(0.2F)},
      {"gold 0.1", "model", gold(0.1F)},
  };
  add_measured(materials);
  return materials;
}

}  // namespace zonal_report
