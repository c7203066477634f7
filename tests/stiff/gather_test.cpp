// Gathers of a million virtual lights, and of lights whose powers span 1e12: against sums in double.
#include <zonal/gather/hvl.hpp>
#include <zonal/many_lights/hvl_tree.hpp>
#include <zonal/screen/incident.hpp>

#include <cmath>
#include <random>
#include <vector>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "../gather/support.hpp"

namespace {

using gather_test::materials;
constexpr double unit = 0x1p-24;
constexpr int lanes = zonal::kNativeLanes;
// Blocks of 64 packets, the lanes at the end, and each term's rounding to its own place: long_sum.hpp.
const double sum_bound = (65 + std::log2(double(lanes))) * unit;

std::vector<zonal::VirtualLight> lights_above(std::size_t count, bool alike) {
  std::mt19937 random(181);
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::vector<zonal::VirtualLight> lights(count);
  for (zonal::VirtualLight& light : lights) {
    light.position = alike ? glm::vec3(0.3F, 0.2F, 2) : glm::vec3(uniform(random), uniform(random), 2);
    light.normal = light.to_primary = {0, 0, -1};
    light.flux = alike ? glm::vec3(1 / 3.0F) : glm::vec3(std::pow(10.0F, 6 * uniform(random)));
    light.radius = 0.01F;
    gather_test::set_material(light, materials().white);
  }
  return lights;
}

}  // namespace

TEST_CASE("stiff gathers: the sum of a million lights is as exact as that of a thousand") {
  Met met("gather", "gather, a million lights");
  const zonal::Receiver receiver{{0, 0, 0}, {0, 0, 1}, {0.6F, 0, 0.8F}};
  const auto material = materials().red.table.with_cosine<2>(0.8F);
  const auto gather = [&](const std::vector<zonal::VirtualLight>& lights, const zonal::Visibility& visible) {
    return zonal::gather<2, 1>(zonal::HvlCache<1>(lights), receiver, material, visible);
  };
  for (const bool alike : {true, false}) {
    const auto lights = lights_above(1000000, alike);
    glm::dvec3 exact(0);  // packet by packet, where there is nothing to sum up but lanes
    if (alike) {
      exact = glm::dvec3(gather({lights[0]}, {})) * double(lights.size());
    } else {
      for (auto first = lights.begin(); first < lights.end(); first += lanes) {
        exact += glm::dvec3(gather({first, first + lanes}, {}));
      }
    }
    const auto seen = [](const glm::vec3&, const glm::vec3&) { return true; };
    const glm::vec3 sums[] = {gather(lights, {}), gather(lights, seen)};
    for (int c = 0; c < 3; ++c) {
      CAPTURE(alike, c, sums[0][c], sums[1][c], exact[c]);
      CHECK(met.meet(std::abs(double(sums[0][c]) / exact[c] - 1)));
      CHECK(sums[1][c] == sums[0][c]);
    }
  }
  CHECK_WORST_MET(met);
}

TEST_CASE("stiff gathers: incident radiance of a million samples") {
  zonal::LightSet set;
  for (int i = 0; i < 1000000; ++i) set.append(zonal::directional_sample({0, 0.6F, 0.8F}, glm::vec3(1 / 3.0F)));
  zonal::LightSet one;
  one.append(zonal::directional_sample({0, 0.6F, 0.8F}, glm::vec3(1 / 3.0F)));
  const auto sum = zonal::incident_radiance<2>(set, {0, 0, 0}, {0, 0, 1}, 0.01F);
  const auto single = zonal::incident_radiance<2>(one, {0, 0, 0}, {0, 0, 1}, 0.01F);
  for (int i = 0; i < 4; ++i) {
    CAPTURE(i, sum[i].x, single[i].x);
    CHECK(std::abs(double(sum[i].x) - 1e6 * double(single[i].x)) <= sum_bound * 1e6 * std::abs(double(single[i].x)));
  }
}

TEST_CASE("stiff gathers: thousands of virtual lights at one place are one cluster of the tree, and counted whole") {
  const auto lights = lights_above(5000, true);
  const zonal::HvlCache<1> all(lights);
  const zonal::HvlTree<1> tree(all);
  const zonal::Receiver receiver{{0, 0, 0}, {0, 0, 1}, {0.6F, 0, 0.8F}};
  const auto material = materials().red.table.with_cosine<2>(0.8F);
  zonal::BoundedReceiver<2, float> eight[zonal::cut_receivers];
  for (auto& one : eight) one = zonal::bounded_receiver(receiver, material);
  zonal::LightCut<2, 1> cut(tree.tree());
  cut.find(zonal::as_packet(eight), {0.001F});
  CHECK(cut.size() == 1);
  zonal::ReceiverBox box;
  box.add(receiver.position, receiver.normal);
  std::vector<zonal::DrawnLights<1>> draws(1);
  tree.draw(cut, box, 1, draws);
  const glm::vec3 drawn = zonal::gather<2, 1>(draws[0], receiver, material),
                  full = zonal::gather<2, 1>(all, receiver, material);
  for (int c = 0; c < 3; ++c) CHECK(std::abs(drawn[c] / full[c] - 1) <= 1e-5F);
}
