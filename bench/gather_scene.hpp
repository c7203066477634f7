// Lights, receivers and a material of random numbers, for gathers that are timed.
#pragma once

#include <cstddef>
#include <vector>

#include <zonal/gather/receiver.hpp>
#include <zonal/gather/virtual_light.hpp>
#include <zonal/kernels/sampler.hpp>
#include <zonal/material/material_table.hpp>

namespace zonal_bench {

/// Vectors as the registry's kernels take them.
class Random {
 public:
  glm::vec3 unit_vector() { return vector(zonal::kernels::Domain::unit_vector); }
  glm::vec3 point() { return vector(zonal::kernels::Domain::position); }

 private:
  glm::vec3 vector(zonal::kernels::Domain domain) {
    const auto v = sampler_.draw({{"", zonal::kernels::Direction::in, domain, 3, 0}});
    return glm::vec3(glm::dvec3(v[0], v[1], v[2]));
  }
  zonal::kernels::InputSampler sampler_{1, 1, zonal::kernels::Draw::ordinary};
};

// Any numbers will do: nothing branches on them.
inline zonal::MaterialTable random_material(Random& random) {
  std::vector<zonal::BrdfProjection<zonal::MaterialTable::max_bands>> rows(zonal::MaterialTable::max_angles);
  for (auto& row : rows) {
    for (auto* coefficients : {&row.with_cosine, &row.without_cosine}) {
      for (glm::dvec3& c : *coefficients) c = random.point();
    }
  }
  return {rows, zonal::MaterialTable::max_bands};
}

// Lights and receivers in a cube, facing anywhere.
inline std::vector<zonal::VirtualLight> random_lights(Random& random, std::size_t count,
                                                      const zonal::MaterialTable& material) {
  std::vector<zonal::VirtualLight> lights(count);
  for (auto& light : lights) {
    light.position = random.point();
    light.normal = random.unit_vector();
    light.to_primary = glm::normalize(light.normal + 0.9F * random.unit_vector());
    light.flux = glm::vec3(2) + random.point();
    light.radius = 0.2F + 0.1F * random.point().x;
    light.material = &material;
  }
  return lights;
}

inline std::vector<zonal::Receiver> random_receivers(Random& random, std::size_t count) {
  std::vector<zonal::Receiver> receivers(count);
  for (auto& receiver : receivers) {
    receiver.position = random.point();
    receiver.normal = random.unit_vector();
    receiver.outgoing = glm::normalize(receiver.normal + 0.9F * random.unit_vector());
  }
  return receivers;
}

}  // namespace zonal_bench
