// Models that the library's variant does not know: its own Oren-Nayar and sheen, and one of a user's, with evaluate()
// alone. That directions are distributed as their densities say: sampling_test.cpp.
#include <zonal/material/material_table.hpp>
#include <zonal/material/oren_nayar.hpp>
#include <zonal/material/sampling.hpp>
#include <zonal/material/sheen.hpp>
#include <zonal/material/zonal_table.hpp>
#include <zonal/scalar/packet.hpp>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "support.hpp"

namespace mine {

/// Minnaert's moon.
struct Moon {
  double power;
};

template <class T>
glm::vec<3, T> evaluate(const Moon& moon, const glm::vec<3, T>& wi, const glm::vec<3, T>& wo) {
  if (!(wi.z > T(0) && wo.z > T(0))) return glm::vec<3, T>(T(0));
  return glm::vec<3, T>(T(0.3), T(0.2), T(0.1)) * std::pow(wi.z * wo.z, T(moon.power));
}

}  // namespace mine

using namespace material_test;

namespace {

zonal::Brdf oren_nayar(const glm::vec3& albedo, float roughness) {
  return {{zonal::custom(zonal::OrenNayarBrdf{albedo, roughness})}};
}
zonal::Brdf sheen(float roughness) { return {{zonal::custom(zonal::SheenBrdf{glm::vec3(1.0F), roughness})}}; }

std::vector<Named> models() {
  return {{"Oren-Nayar 0", oren_nayar({0.9F, 0.5F, 0.0F}, 0.0F)},
          {"Oren-Nayar 0.4", oren_nayar({0.9F, 0.5F, 0.0F}, 0.4F)},
          {"Oren-Nayar 1, white", oren_nayar(glm::vec3(1.0F), 1.0F)},
          {"sheen 0, which is 0.1", sheen(0.0F)},
          {"sheen 0.3", sheen(0.3F)},
          {"sheen 1", sheen(1.0F)},
          {"moon", {{zonal::custom(mine::Moon{0.5})}}}};
}

/// The integral of f cos: nodes crowd at the horizon, where sheen is.
glm::dvec3 albedo_of(const zonal::Brdf& brdf, const glm::dvec3& wo) {
  constexpr int rings = 300, spokes = 300;
  glm::dvec3 sum(0.0);
  for (int i = 0; i < rings; ++i) {
    const double x = (i + 0.5) / rings, z = x * x, sine = std::sqrt(1.0 - z * z);
    for (int j = 0; j < spokes; ++j) {
      const double phi = pi * (j + 0.5) / spokes;
      const glm::dvec3 wi(sine * std::cos(phi), sine * std::sin(phi), z);
      sum += evaluate(brdf, wi, wo) * (z * 2.0 * x / rings * 2.0 * pi / spokes);
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("models: reciprocal, not negative, black from below") {
  Random random(11);
  for (const auto& [name, brdf] : models()) {
    for (int trial = 0; trial < 1000; ++trial) {
      glm::dvec3 wi(glm::normalize(glm::dvec3(random.direction()))), wo(glm::normalize(glm::dvec3(random.direction())));
      const glm::dvec3 f = evaluate(brdf, wi, wo), g = evaluate(brdf, wo, wi);
      const glm::vec3 in_float = evaluate(brdf, glm::vec3(wi), glm::vec3(wo));
      CAPTURE(name, wi.x, wi.y, wi.z, wo.x, wo.y, wo.z, f.x, g.x);
      CHECK(largest(f - g) <= 1e-12 * largest(f));
      CHECK(f.x >= 0.0);
      CHECK(largest(glm::dvec3(in_float) - f) <= 1e-4 * largest(f));
      wi.z = -wi.z;
      CHECK((evaluate(brdf, wi, wo) == glm::dvec3(0.0) && evaluate(brdf, wo, wi) == glm::dvec3(0.0)));
    }
  }
}

TEST_CASE("models: at most all of uniform light is reflected, and what their albedos say") {
  Met met("material", "sheen_albedo");
  for (const double degrees : {0.0, 40.0, 70.0, 85.0, 89.0, 89.9}) {
    const glm::dvec3 wo = outgoing(degrees);
    for (const auto& [name, brdf] : models()) {
      const glm::dvec3 albedo = albedo_of(brdf, wo);
      CAPTURE(name, degrees, albedo.x, albedo.y);
      CHECK(albedo.x <= 1.001);
      if (name == "moon") continue;
      const auto cosine = float(wo.z);
      if (name[0] == 'O') CHECK(largest(glm::dvec3(diffuse_albedo(brdf, cosine)) - albedo) < 1e-3);
      if (name == "Oren-Nayar 1, white") CHECK(albedo.y >= 0.999);
    }
    for (const float roughness : {0.1F, 0.3F, 1.0F}) {
      const double albedo = albedo_of(sheen(roughness), wo).x;
      CAPTURE(degrees, roughness, albedo, zonal::sheen_albedo(roughness, wo.z));
      CHECK(met.meet(std::abs(zonal::sheen_albedo(roughness, wo.z) - albedo)));
      CHECK(albedo < 0.95);
    }
  }
  CHECK_WORST_MET(met);
  // Lambert's at roughness 0.
  const glm::dvec3 wi = outgoing(30.0), wo = outgoing(60.0);
  CHECK(evaluate(models()[0].brdf, wi, wo).y == Approx(0.5 / pi).epsilon(1e-6));
}

TEST_CASE("models: a struct with evaluate() alone is projected, sampled by the cosine, and diffuse for Gaussians") {
  const zonal::Brdf moon{{zonal::custom(mine::Moon{0.5})}};
  const zonal::MaterialTable table = zonal::project_material(moon, 3);
  for (const double degrees : {0.0, 50.0, 80.0}) {
    const glm::dvec3 wo = outgoing(degrees), albedo = albedo_of(moon, wo);
    const glm::vec3 first = table.with_cosine<1>(float(wo.z))[0];
    CHECK(largest(glm::dvec3(first) * std::sqrt(4.0 * pi) - albedo) < 1e-3);
    CHECK(albedo.x == Approx(0.3 * 2.0 * pi / 2.5 * std::sqrt(wo.z)).epsilon(1e-4));
    const zonal::BrdfSample drawn = sample(moon, glm::vec3(wo), 0.3F, {0.36F, 0.1F});
    CHECK(drawn.direction.z == Approx(0.8));
    CHECK(drawn.pdf == Approx(0.8 / pi));
  }
  CHECK(is_isotropic(moon));
  CHECK(zonal::project_zonal(oren_nayar(glm::vec3(0.5F), 0.5F), 3).is_diffuse());
  // Packets are lanes of it.
  using Lanes = zonal::Packet<float, 4>;
  Random random(12);
  for (const auto& [name, brdf] : models()) {
    glm::vec<3, Lanes> wi, wo;
    glm::vec3 i[4], o[4];
    for (int lane = 0; lane < 4; ++lane) {
      i[lane] = random.direction();
      o[lane] = random.direction();
      for (int c = 0; c < 3; ++c) wi[c].set(lane, i[lane][c]), wo[c].set(lane, o[lane][c]);
    }
    const auto got = evaluate(brdf, wi, wo);
    const auto density = pdf(brdf, wi, o[0]);
    for (int lane = 0; lane < 4; ++lane) {
      CHECK(got.y[lane] == evaluate(brdf, i[lane], o[lane]).y);
      CHECK(density[lane] == Approx(pdf(brdf, i[lane], o[0])));
    }
  }
}
