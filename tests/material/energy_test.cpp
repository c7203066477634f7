// What coated and rough materials reflect of uniform light, by quadratures that know nothing of how they are made.
#include <zonal/material/energy.hpp>

#include <zonal/material/material_table.hpp>
#include <zonal/material/zonal_table.hpp>
#include <zonal/scalar/packet.hpp>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "support.hpp"

using namespace material_test;

namespace {

const double angles[] = {0.0, 40.0, 60.0, 80.0, 85.0, 89.0, 89.9};
const float roughnesses[] = {0.001F, 0.01F, 0.05F, 0.2F, 0.5F, 1.0F};

/// The integral of f cos of a GGX lobe and of the diffuse lobe beside it.
struct Albedo {
  glm::dvec3 coat, body;
};
Albedo albedo_of(const zonal::Brdf& brdf, const glm::dvec3& wo) {
  REQUIRE(brdf.lobes.size() == 2);
  const auto& coat = std::get<zonal::GgxBrdf>(brdf.lobes[0]);
  Albedo albedo{ggx_albedo(zonal::Brdf{{coat}}, double(coat.roughness), wo), glm::dvec3(0.0)};
  midpoint_hemisphere(400, 4, [&](const glm::dvec3& wi, double solid_angle) {
    albedo.body += evaluate(brdf.lobes[1], wi, wo) * (wi.z * solid_angle);
  });
  return albedo;
}

}  // namespace

TEST_CASE("energy: the albedo of a GGX lobe is its integral, and at roughness 1 the closed form") {
  Met met("material", "ggx_albedo");
  for (const float roughness : {0.01F, 0.1F, 0.5F, 1.0F}) {
    for (const double degrees : angles) {
      const glm::dvec3 wo = outgoing(degrees);
      CAPTURE(roughness, degrees);
      for (const zonal::Fresnel& fresnel : {zonal::Fresnel(white()), zonal::Fresnel(gold())}) {
        const glm::dvec3 got = zonal::ggx_albedo({roughness, fresnel}, wo.z);
        CHECK(largest(got - ggx_albedo(ggx(roughness, fresnel), double(roughness), wo)) < 3e-3);  // theirs is 2e-3
      }
      if (roughness < 1.0F) continue;
      const double exact = 1.0 - wo.z * std::log((1.0 + wo.z) / wo.z);
      CHECK(met.meet(std::abs(zonal::ggx_albedo({roughness, white()}, wo.z).x - exact)));
    }
  }
  CHECK_WORST_MET(met);
}

TEST_CASE("energy: coat and body reflect at most all, and a white body under any coat nearly all") {
  const zonal::Fresnel coats[] = {zonal::DielectricFresnel{1.5F}, zonal::DielectricFresnel{2.4F},
                                  zonal::SchlickFresnel{{0.04F, 0.3F, 0.9F}}};
  const glm::dvec3 colour(0.9, 0.5, 0.1);
  for (const zonal::Fresnel& coat : coats) {
    for (const float roughness : roughnesses) {
      const zonal::Brdf clean = zonal::coated({roughness, coat}, glm::vec3(1.0F));
      const zonal::Brdf coloured = zonal::coated({roughness, coat}, glm::vec3(colour));
      for (const double degrees : angles) {
        const glm::dvec3 wi = outgoing(35.0), wo = outgoing(degrees);
        const Albedo all = albedo_of(clean, wo);
        const glm::dvec3 white_body = evaluate(clean.lobes[1], wi, wo), body = evaluate(coloured.lobes[1], wi, wo);
        for (int c = 0; c < 3; ++c) {
          CAPTURE(coat.index(), roughness, degrees, c, all.coat[c], all.body[c]);
          CHECK(all.coat[c] + all.body[c] <= 1.0003);
          CHECK(all.coat[c] + all.body[c] >= (roughness < 0.005F ? 0.98 : 0.995));
          CHECK(body[c] == Approx(colour[c] * white_body[c]).epsilon(1e-6));
        }
      }
    }
  }
  // What a Lambert lobe under the same coat does.
  const zonal::Brdf sum{{zonal::GgxBrdf{0.2F, coats[0]}, zonal::LambertBrdf{glm::vec3(1.0F)}}};
  CHECK(albedo_of(sum, outgoing(85.0)).coat.x > 0.2);
  CHECK(albedo_of(sum, outgoing(85.0)).body.x == Approx(1.0).epsilon(1e-4));
}

TEST_CASE("energy: GGX with the light between its microfacets: white reflects all, colours no more and not less") {
  for (const float roughness : roughnesses) {
    const zonal::Brdf clean = zonal::with_multiple_scattering({roughness, white()});
    const zonal::Brdf metal = zonal::with_multiple_scattering({roughness, gold()});
    const zonal::Brdf glass = zonal::with_multiple_scattering({roughness, zonal::DielectricFresnel{1.5F}});
    for (const double degrees : angles) {
      CAPTURE(roughness, degrees);
      const Albedo all = albedo_of(clean, outgoing(degrees));
      CHECK(std::abs(all.coat.x + all.body.x - 1.0) <= 0.01);
      for (const zonal::Brdf* brdf : {&metal, &glass}) {
        const Albedo some = albedo_of(*brdf, outgoing(degrees));
        for (int c = 0; c < 3; ++c) {
          CHECK((some.body[c] >= 0.0 && some.body[c] <= all.body[c] + 1e-4));
          CHECK(some.coat[c] + some.body[c] <= 1.0);
        }
      }
    }
  }
  // 69 % of it come from bounces.
  CHECK(albedo_of(zonal::with_multiple_scattering({1.0F, white()}), outgoing(0.0)).body.x ==
        Approx(std::log(2.0)).margin(3e-3));
}

TEST_CASE("energy: the colour that bounces have is a random walk's, between facets that all reflect alike") {
  // Of reflectance F, the k-th bounce carries F^(k + 1); a share `lost` of each stays for the next.
  for (const float f0 : {0.2F, 0.5F, 0.9F, 1.0F}) {
    const zonal::ConductorFresnel fresnel{
        glm::vec3((1.0F + std::sqrt(f0)) / (1.0F - std::sqrt(std::fmin(f0, 0.9999F)))), glm::vec3(0.0F)};
    const auto brdf = zonal::with_multiple_scattering({0.8F, fresnel});
    const auto& bounces = std::get<zonal::ResidualBrdf>(brdf.lobes[1]);
    double mean = 0.0;
    constexpr int nodes = 20000;
    for (int i = 0; i < nodes; ++i) {
      const double cosine = (i + 0.5) / nodes;
      mean += reflectance(fresnel, cosine).x * 2.0 * cosine / nodes;
    }
    double expected = 0.0, carried = mean, staying = 1.0;
    const double lost = double(bounces.mean.x);
    for (int k = 1; k < 2000; ++k) {
      carried *= mean;
      expected += carried * staying * (1.0 - lost);
      staying *= lost;
    }
    CAPTURE(f0, mean, lost);
    CHECK(double(bounces.albedo.x) == Approx(expected).epsilon(1e-3));
  }
}

TEST_CASE("energy: packets, tables and the zonal table have what the lobe has") {
  const zonal::Brdf brdf = zonal::coated({0.3F, zonal::DielectricFresnel{1.5F}}, {0.9F, 0.5F, 0.1F});
  const auto& body = std::get<zonal::ResidualBrdf>(brdf.lobes[1]);
  using Lanes = zonal::Packet<float, 4>;
  Random random(9);
  for (int trial = 0; trial < 300; ++trial) {
    glm::vec<3, Lanes> wi, wo;
    glm::vec3 i[4], o[4];
    for (int lane = 0; lane < 4; ++lane) {
      i[lane] = random.direction();
      o[lane] = random.direction();
      if (trial % 3 == 0) i[lane].z = -i[lane].z;
      for (int c = 0; c < 3; ++c) wi[c].set(lane, i[lane][c]), wo[c].set(lane, o[lane][c]);
    }
    const auto got = evaluate(body, wi, wo);
    for (int lane = 0; lane < 4; ++lane) {
      const glm::vec3 expected = evaluate(body, i[lane], o[lane]);
      for (int c = 0; c < 3; ++c) CHECK(std::abs(got[c][lane] - expected[c]) <= 4e-6F * expected[c]);
    }
  }
  const zonal::MaterialTable table = zonal::project_material(brdf, 3);
  const zonal::ZonalTable zonal_table = zonal::project_zonal(brdf, 3);
  for (const double degrees : {0.0, 40.0, 75.0, 85.0}) {
    const glm::dvec3 wo = outgoing(degrees);
    const Albedo albedo = albedo_of(brdf, wo);
    const auto cosine = float(wo.z);
    CAPTURE(degrees);
    CHECK(largest(glm::dvec3(table.with_cosine<1>(cosine)[0]) * std::sqrt(4.0 * pi) - albedo.coat - albedo.body) <
          2e-3);
    CHECK(largest(glm::dvec3(zonal_table.diffuse_albedo(cosine)) - albedo.body) < 1e-3);
    const zonal::Brdf alone{{body}};
    CHECK(zonal::project_zonal(alone, 3).is_diffuse());
  }
}
