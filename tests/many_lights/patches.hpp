// Patches of virtual lights, and what single lights send by the gather's own kernel.
#pragma once

#include <zonal/many_lights/hvl_tree.hpp>

#include <cmath>
#include <vector>

#include "../gather/support.hpp"

namespace many_lights_test {

using gather_test::materials;
using gather_test::Random;

/// Lights on a piece of a plane or of a ball, about `centre`, of that size; one material or several.
inline std::vector<zonal::VirtualLight> random_patch(Random& random, int count, const glm::vec3& centre, float size) {
  const glm::vec3 normal = random.direction();
  const glm::vec3 x = zonal::detail::tangent_towards(normal, random.direction()), y = glm::cross(normal, x);
  const bool is_flat = random() < 0.5F, is_mixed = random() < 0.5F;
  const float bend = is_flat ? 0.0F : random.uniform(0.1F, 1.0F);
  const float radius = size * std::pow(10.0F, random.uniform(-3.0F, -0.5F));
  const glm::vec3 colour = random.colour(), primary = centre + 5.0F * random.direction_above(normal);
  std::vector<zonal::VirtualLight> lights;
  for (int i = 0; i < count; ++i) {
    zonal::VirtualLight light;
    const float u = random.uniform(-1, 1), v = random.uniform(-1, 1) * 0.5F;
    light.position = centre + size * (u * x + v * y - 0.5F * bend * (u * u + v * v) * normal);
    light.normal = glm::normalize(normal + bend * (u * x + v * y));
    light.to_primary = glm::normalize(primary - light.position);
    light.radius = radius * random.uniform(0.7F, 1.3F);
    light.flux = is_mixed ? random.colour() : colour * random.uniform(0.8F, 1.2F);
    gather_test::set_material(light, is_mixed
                                         ? random.one_of({&materials().plastic, &materials().red, &materials().metal})
                                         : materials().plastic);
    lights.push_back(light);
  }
  return lights;
}

inline zonal::Receiver random_receiver(Random& random) {
  zonal::Receiver receiver;
  receiver.position = random.direction();
  receiver.normal = random.direction();
  receiver.outgoing = random.direction_above(receiver.normal);
  return receiver;
}

template <int N>
zonal::EvenSh<N, glm::vec3> reflected_by(const gather_test::Material& material, const zonal::Receiver& receiver) {
  return material.table.with_cosine<N>(glm::dot(receiver.normal, receiver.outgoing));
}

/// What each light adds to the receiver's radiance.
template <int N, int NE, zonal::Horizon method>
std::vector<glm::dvec3> parts_of(const zonal::HvlCache<NE>& lights, const zonal::Receiver& receiver,
                                 const zonal::EvenSh<N, glm::vec3>& material) {
  const auto frame = zonal::detail::frame_of<float>(receiver);
  std::vector<glm::dvec3> parts;
  for (int i = 0; i < lights.size(); ++i) {
    float rgb[3];
    zonal::hvl_radiance<N, NE, method>(lights.isotropic().record(i), frame, material, rgb);
    parts.emplace_back(rgb[0], rgb[1], rgb[2]);
  }
  return parts;
}

}  // namespace many_lights_test
