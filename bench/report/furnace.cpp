// A closed white sphere whose walls send out a radiance of 1, by virtual lights: what a patch of a material on the wall
// reflects by each gather, over what it reflects of uniform light.
#include <array>
#include <random>
#include <string>
#include <vector>

#include <zonal/gather/hvl.hpp>
#include <zonal/gather/hvl_zonal.hpp>
#include <zonal/gather/vpl.hpp>
#include <zonal/gather/vsgl.hpp>
#include <zonal/gather/vsl.hpp>

#include "../built_bands.hpp"
#include "gather/furnace.hpp"
#include "materials.hpp"
#include "report.hpp"

namespace zonal_report {
namespace {

using zonal::Receiver;

struct Material {
  std::string name;
  zonal::Brdf brdf;
  zonal::MaterialTable table;
  zonal::ZonalTable zonal_table;

  Material(std::string name_, zonal::Brdf brdf_)
      : name(std::move(name_)),
        brdf(std::move(brdf_)),
        table(zonal::project_material(brdf, zonal::MaterialTable::max_bands)),
        zonal_table(zonal::project_zonal(brdf, zonal::ZonalTable::max_bands)) {}
};

class Furnace {
 public:
  Furnace(int side, const Material& white, int receivers)
      : lights_(gather_test::furnace(side * side, white.brdf, white.table)),
        cache_(lights_),
        harmonics_(lights_),
        gaussians_(zonal::make_gaussian_lights(lights_.data(), side, 1)),
        gaussians_2024_(zonal::make_gaussian_lights<zonal::Vsgl::of_2024>(lights_.data(), side, 1)),
        receivers_(receivers) {}

  void print_all(const Material& material, double degrees) const {
    const zonal::Brdf& brdf = material.brdf;
    const auto print = [&](const char* method, int bands, const auto& gather) {
      print_row(method, material.name, degrees, bands, lights_.size(),
                gather_test::furnace_energy(material.table, degrees, receivers_, gather));
    };
    std::mt19937 engine(6);
    const auto uniform = [&engine] { return float(engine() >> 8) * 0x1p-24F; };
    print("vpl", 0, [&](const Receiver& r) { return zonal::gather_vpl(cache_, r, brdf); });
    print("vpl clamped at 1 r", 0, [&](const Receiver& r) { return zonal::gather_vpl(cache_, r, brdf, 1); });
    print("vsl of 16 samples", 0, [&](const Receiver& r) { return zonal::gather_vsl(cache_, r, brdf, 16, uniform); });
    print("vsgl", 0, [&](const Receiver& r) { return zonal::gather_vsgl(gaussians_, r, brdf); });
    print("vsgl-2024", 0,
          [&](const Receiver& r) { return zonal::gather_vsgl<zonal::Vsgl::of_2024>(gaussians_2024_, r, brdf); });
    zonal_bench::for_bands(FurnaceBands{}, [&](auto n) {
      print("hvl", n, [&](const Receiver& r) { return zonal::gather<n>(harmonics_, r, material.table); });
      print("hvl-zonal", n,
            [&](const Receiver& r) { return zonal::gather_hvl_zonal<n>(cache_, r, material.zonal_table); });
    });
  }

 private:
  using FurnaceBands =
      zonal_bench::Built<zonal_bench::Bands<1, 2, 3, 4, 5, 7, 9, 11, 15, 21>, zonal_bench::Bands<1, 5>>;

  std::vector<zonal::VirtualLight> lights_;
  zonal::LightCache cache_;
  zonal::HvlCache<1> harmonics_;
  zonal::GaussianCache gaussians_, gaussians_2024_;
  int receivers_;
};

}  // namespace

void print_furnace(Effort effort) {
  print_row("method", "material", "degrees", "bands", "lights", "relative_energy");
  std::vector<Material> materials;
  materials.reserve(4);
  materials.emplace_back("Lambert", matte(glm::vec3(1)));
  for (const float roughness : {0.6F, 0.25F, 0.1F}) {
    materials.emplace_back("GGX " + std::to_string(roughness).substr(0, roughness == 0.25F ? 4 : 3),
                           white_ggx(roughness));
  }
  const auto sides = choose<std::vector<int>>(effort, {10}, {10, 20, 40}, {10, 20, 40, 80});
  for (const int side : sides) {
    const Furnace furnace(side, materials.front(), choose(effort, 20, 200, 1000));
    for (const Material& material : materials) {
      for (const double degrees : {0.0, 60.0}) furnace.print_all(material, degrees);
    }
  }
}

}  // namespace zonal_report
