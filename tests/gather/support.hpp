// Materials, random lights and receivers, for the tests of this room.
#pragma once

#include <zonal/gather/virtual_light.hpp>
#include <zonal/material/anisotropic_table.hpp>
#include <zonal/material/material_table.hpp>

#include <cmath>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

namespace gather_test {

inline constexpr double pi = 3.14159265358979323846;

struct Material {
  zonal::Brdf brdf;
  zonal::MaterialTable table;

  explicit Material(zonal::Brdf lobes, int bands = 10)
      : brdf(std::move(lobes)), table(zonal::project_material(brdf, bands)) {}
};

struct Materials {
  Material white{{{zonal::LambertBrdf{glm::vec3(1)}}}, 21};
  Material red{{{zonal::LambertBrdf{{0.8F, 0.2F, 0.1F}}}}};
  Material plastic{{{zonal::LambertBrdf{{0.3F, 0.5F, 0.2F}}, zonal::GgxBrdf{0.3F, zonal::DielectricFresnel{1.5F}}}}};
  Material metal{{{zonal::GgxBrdf{0.4F, zonal::ConductorFresnel{{0.2F, 0.9F, 1.1F}, {3.9F, 2.5F, 2.4F}}}}}};
  Material black{{{zonal::LambertBrdf{glm::vec3(0)}}}};
};

inline const Materials& materials() {
  static const Materials all;
  return all;
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  float uniform(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
  /// In [0, 1), never 1.
  float operator()() { return float(engine_() >> 8) * 0x1p-24F; }
  glm::vec3 direction() {
    std::normal_distribution<float> normal;
    const float x = normal(engine_), y = normal(engine_);
    return glm::normalize(glm::vec3(x, y, normal(engine_)));
  }
  glm::vec3 direction_above(const glm::vec3& normal) {
    const glm::vec3 d = direction();
    return glm::dot(d, normal) > 0 ? d : -d;
  }
  glm::vec3 colour() {
    const float r = uniform(0, 2), g = uniform(0, 2);
    return {r, g, uniform(0, 2)};
  }
  const Material& one_of(std::initializer_list<const Material*> list) {
    return **(list.begin() + int(uniform(0, 1) * 0.999F * float(list.size())));
  }

 private:
  std::mt19937 engine_;
};

inline void set_material(zonal::VirtualLight& light, const Material& material) {
  light.material = &material.table;
  light.brdf = &material.brdf;
}

inline zonal::VirtualLight random_light(Random& random) {
  zonal::VirtualLight light;
  light.position = 3.0F * random.direction();
  light.normal = random.direction_above(-light.position);
  light.to_primary = random.direction_above(light.normal);
  light.flux = random.colour();
  light.radius = random.uniform(0.1F, 1.5F);
  set_material(light, random.one_of({&materials().plastic, &materials().red, &materials().metal, &materials().white}));
  return light;
}

inline std::vector<zonal::VirtualLight> random_lights(Random& random, int count) {
  std::vector<zonal::VirtualLight> lights;
  for (int i = 0; i < count; ++i) lights.push_back(random_light(random));
  return lights;
}

/// Coordinates of w in the frame of z = normal and x = the part of `towards` in its plane.
inline glm::dvec3 local(const glm::dvec3& w, const glm::dvec3& normal, const glm::dvec3& towards) {
  const glm::dvec3 x = glm::normalize(towards - glm::dot(towards, normal) * normal), y = glm::cross(normal, x);
  return {glm::dot(w, x), glm::dot(w, y), glm::dot(w, normal)};
}

/// What a light reflects against the direction w, W/sr, cosine included, in double.
inline glm::dvec3 sent_by(const zonal::VirtualLight& light, const glm::dvec3& w) {
  const glm::dvec3 normal(light.normal), to_primary(light.to_primary);
  return zonal::evaluate(light.brdf[0], local(to_primary, normal, to_primary), local(-w, normal, to_primary)) *
         glm::dvec3(light.flux) * std::max(0.0, -glm::dot(w, normal));
}

}  // namespace gather_test
