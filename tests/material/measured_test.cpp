// A function wrapped as a measured material: the same values, even in phi; and packets of directions, lane by lane.
#include <zonal/material/material_table.hpp>
#include <zonal/material/measured.hpp>
#include <zonal/scalar/packet.hpp>

#include "../catch.hpp"
#include "support.hpp"

using namespace material_test;

namespace {

/// A material as a plain function, turned into a measured one.
zonal::Brdf as_measured(const zonal::Brdf& brdf) {
  return {{zonal::measured([brdf](const glm::dvec3& wi, const glm::dvec3& wo) { return evaluate(brdf, wi, wo); })}};
}

}  // namespace

TEST_CASE("measured: is the function, and the mean of it and its mirror image where it is not even in phi") {
  Random random(21);
  for (const auto& [name, brdf] : materials()) {
    const zonal::Brdf wrapped = as_measured(brdf);
    for (int i = 0; i < 100; ++i) {
      const glm::dvec3 wi(random.direction()), wo(random.direction());
      const glm::dvec3 expected = evaluate(brdf, wi, wo), got = evaluate(wrapped, wi, wo);
      CAPTURE(name, i);
      for (int c = 0; c < 3; ++c) CHECK(std::abs(got[c] - expected[c]) <= 1e-12 * expected[c]);
    }
  }
  const zonal::Brdf lopsided{{zonal::measured([](const glm::dvec3& wi, const glm::dvec3& wo) {
    const double turn = wi.x * wo.y - wi.y * wo.x;  // odd in phi
    return wi.z > 0 && wo.z > 0 ? glm::dvec3(1 + turn, 2 + turn, 3) : glm::dvec3(0);
  })}};
  const glm::vec3 f =
      evaluate(lopsided, glm::normalize(glm::vec3(0.3F, 0.5F, 0.6F)), glm::normalize(glm::vec3(-0.2F, 0.7F, 0.4F)));
  CHECK(glm::distance(f, glm::vec3(1, 2, 3)) <= 1e-6F);
}

TEST_CASE("measured: the lobes beside it carry its albedo, and sample it without great weights") {
  for (const auto& [name, brdf] : materials()) {
    if (name == "gold 0.010000" || name == "gold 0.020000" || name == "Phong 1000")
      continue;  // finer than 24 roughnesses
    const zonal::Brdf wrapped = as_measured(brdf);
    const auto& measured = std::get<zonal::MeasuredBrdf>(wrapped.lobes[0]);
    for (const double degrees : {0.0, 30.0, 60.0}) {
      const glm::dvec3 wo = outgoing(degrees);
      const glm::dvec3 albedo = ggx_albedo(brdf, 0.2, wo);
      Random random(22);
      constexpr int count = 20000;
      glm::dvec3 sum(0);
      double square = 0;
      for (int i = 0; i < count; ++i) {
        const float u_lobe = random();
        const float ux = random();
        const auto sample = zonal::sample(wrapped, glm::vec3(wo), u_lobe, {ux, random()});
        if (sample.pdf <= 0) continue;
        const glm::dvec3 value =
            glm::dvec3(evaluate(wrapped, sample.direction, glm::vec3(wo))) * double(sample.direction.z / sample.pdf);
        sum += value / double(count);
        square += value.x * value.x / count;
      }
      const double deviation = std::sqrt((square - sum.x * sum.x) / count);
      CAPTURE(name, degrees, sum.x, albedo.x, deviation, measured.roughness, measured.diffuse_albedo.x);
      CHECK(std::abs(sum.x - albedo.x) <= 4 * deviation + 2e-3 * albedo.x);
      CHECK(deviation * std::sqrt(double(count)) <= 2 * albedo.x);  // of one sample
    }
    CHECK(measured.diffuse_albedo.x + measured.specular_albedo.x <= 1.05F);
  }
  const auto gold = std::get<zonal::MeasuredBrdf>(as_measured(ggx(0.25F, material_test::gold())).lobes[0]);
  CHECK(gold.roughness == Catch::Approx(0.25F).epsilon(0.2));
  CHECK(gold.diffuse_albedo.x < 0.2F * gold.specular_albedo.x);
  const auto chalk = std::get<zonal::MeasuredBrdf>(as_measured({{zonal::LambertBrdf{glm::vec3(0.5F)}}}).lobes[0]);
  CHECK(chalk.diffuse_albedo.x + chalk.specular_albedo.x == Catch::Approx(0.5F).epsilon(0.02));
  CHECK(chalk.diffuse_albedo.x > 0.4F);
}

TEST_CASE("measured: its table is the table of the function") {
  const zonal::Brdf plastic{
      {zonal::LambertBrdf{{0.4F, 0.1F, 0.1F}}, zonal::GgxBrdf{0.3F, zonal::DielectricFresnel{1.5F}}}};
  const auto expected = zonal::project_material(plastic, 7), got = zonal::project_material(as_measured(plastic), 7);
  for (const float cosine : {1.0F, 0.7F, 0.2F}) {
    const auto a = expected.with_cosine<7>(cosine), b = got.with_cosine<7>(cosine);
    for (int i = 0; i < a.size(); ++i) CHECK(glm::distance(a[i], b[i]) <= 2e-4F);
  }
}

TEST_CASE("brdf: a packet of directions is its directions one by one, values and densities") {
  using Lanes = zonal::Packet<float, 16>;
  Random random(23);
  auto list = materials();
  list.push_back({"measured plastic", as_measured(list[5].brdf)});
  for (const auto& [name, brdf] : list) {
    for (int trial = 0; trial < 20; ++trial) {
      const glm::vec3 wo = random.direction();
      glm::vec3 wi[16];
      glm::vec<3, Lanes> packet;
      for (int lane = 0; lane < 16; ++lane) {
        wi[lane] = random.direction() * (lane % 5 == 4 ? -1.0F : 1.0F);
        for (int c = 0; c < 3; ++c) packet[c].set(lane, wi[lane][c]);
      }
      const auto value = evaluate(brdf, packet, glm::vec<3, Lanes>(wo));
      const Lanes density = zonal::pdf(brdf, packet, wo);
      for (int lane = 0; lane < 16; ++lane) {
        const glm::vec3 expected = evaluate(brdf, wi[lane], wo);
        CAPTURE(name, trial, lane);
        for (int c = 0; c < 3; ++c) CHECK(std::abs(value[c][lane] - expected[c]) <= 4e-6F * expected[c]);
        const float expected_density = zonal::pdf(brdf, wi[lane], wo);
        CHECK(std::abs(density[lane] - expected_density) <= 4e-6F * expected_density);
      }
    }
  }
}
