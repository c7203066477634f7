// A hundred thousand virtual lights at the price of a few hundred, and how far that is off: proved, and measured. Needs
// GLM:
//
//   g++ -std=c++17 -O2 -march=native -Iinclude examples/pages/many_lights.cpp -o many_lights
#include <zonal/many_lights/hvl_tree.hpp>
#include <zonal/many_lights/receiver_groups.hpp>
#include <zonal/material/material_table.hpp>
#include <zonal/material/named.hpp>

#include <cmath>
#include <cstdio>
#include <vector>

int main() {
  const zonal::MaterialTable clay = zonal::project_material(zonal::matte({0.8F, 0.4F, 0.2F}), 5);

  // A wall that a spotlight falls on, beside a floor: 320 x 320 lights.
  std::vector<zonal::VirtualLight> lights(320 * 320);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    zonal::VirtualLight& light = lights[i];
    light.position = {float(i % 320) / 80 - 2, 3, float(i / 320) / 120 + 0.1F};
    light.normal = {0, -1, 0};
    light.to_primary = glm::normalize(glm::vec3(0, 0, 4) - light.position);
    light.flux = glm::vec3(10) / float(lights.size());
    light.radius = 0.01F;
    light.material = &clay;
  }
  const zonal::HvlCache<1> all(lights);  // one band is all of a diffuse light
  const zonal::HvlTree<1> tree(all);     // once; pass a for_each of yours to spread it over threads

  // Receivers: 64 x 64 points of the floor, one metre across, in eight parts. The bound holds for all of a part: here
  // one receiver tells all but the places, for all have one normal and one material.
  std::vector<zonal::Receiver> floor;
  std::vector<zonal::GroupedReceiver> grouped;
  zonal::ReceiverBox box;
  for (int i = 0; i < 64 * 64; ++i) {
    floor.push_back({{float(i % 64) / 64, 1 + float(i / 64) / 64, 0}, {0, 0, 1}, {0.6F, 0, 0.8F}});
    grouped.push_back({floor.back().position, floor.back().normal, i});
    box.add(floor.back().position, floor.back().normal);
  }
  const auto material = clay.with_cosine<5>(0.8F);
  zonal::ReceiverParts<zonal::cut_receivers> parts;
  parts.add(int(grouped.size()));
  parts.halve_all(grouped.data(), 1);  // 1: a turn by 1 rad would matter as much as to move by a metre
  zonal::BoundedReceiver<5, float> eight[zonal::cut_receivers];
  for (int part = 0; part < zonal::cut_receivers; ++part) {
    zonal::Box3 positions;
    for (int i = parts.first[part]; i < parts.first[part + 1]; ++i) positions.add(grouped[std::size_t(i)].position);
    eight[part] = zonal::spread_over(zonal::bounded_receiver(floor[0], about_axis(material)), positions, 0);
  }

  for (const float tolerance : {0.1F, 0.03F, 0.01F, 0.003F}) {
    zonal::LightCut<5, 1> cut(tree.tree());
    zonal::CutTolerance request;
    request.relative = tolerance;  // root mean square, of that of the radiance
    cut.find(zonal::as_packet(eight), request);

    // Eight draws of a light per cluster: neighbours take different ones, so that their errors differ too.
    std::vector<zonal::DrawnLights<1>> draws(8);
    tree.draw(cut, box, 1, draws);
    double error = 0, power = 0;
    for (std::size_t i = 0; i < floor.size(); i += 31) {
      const float drawn = zonal::gather<5, 1>(draws[i % 8], floor[i], material).r;
      const float full = zonal::gather<5, 1>(all, floor[i], material).r;
      error += double((drawn - full) * (drawn - full)), power += double(full * full);
    }
    std::printf("%5.1f %%: %4d of %d lights, error at most %.4f, measured %.4f\n", 100 * double(tolerance), cut.size(),
                all.size(), std::sqrt(cut.variance() / cut.power()), std::sqrt(error / power));
  }
}

// It prints:
//   10.0 %:  105 of 102400 lights, error at most 0.0990, measured 0.0095
//     3.0 %:  285 of 102400 lights, error at most 0.0300, measured 0.0041
//     1.0 %:  736 of 102400 lights, error at most 0.0100, measured 0.0017
//     0.3 %: 2215 of 102400 lights, error at most 0.0030, measured 0.0004
