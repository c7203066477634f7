// Gaussian lights: what they are made of, and their integrals against quadrature.
#include <zonal/gather/vsgl.hpp>

#include <algorithm>

#include "../catch.hpp"
#include "support.hpp"

using namespace gather_test;

namespace {

using Double3 = double[3];

/// visit(w, solid angle) over the sphere about an axis, nodes crowding there.
template <class Visit>
void for_each_direction(const glm::dvec3& axis, const Visit& visit) {
  const int rings = 600, spokes = 600;
  const glm::dvec3 other = std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(axis, other)), y = glm::cross(axis, x);
  for (int i = 0; i < rings; ++i) {
    const double s = (i + 0.5) / rings, theta = pi * s * s, ring = 2 * pi * s / rings * std::sin(theta);
    for (int j = 0; j < spokes; ++j) {
      const double phi = 2 * pi * (j + 0.5) / spokes;
      visit(std::sin(theta) * (std::cos(phi) * x + std::sin(phi) * y) + std::cos(theta) * axis, ring * 2 * pi / spokes);
    }
  }
}

double gaussian(const glm::dvec3& w, const glm::dvec3& axis, double sharpness) {
  return std::exp(sharpness * (glm::dot(w, axis) - 1));
}

zonal::detail::IncomingGaussian<double> incoming(const glm::dvec3& axis, double sharpness) {
  return {{axis.x, axis.y, axis.z}, sharpness, {1, 1, 1}};
}

}  // namespace

TEST_CASE("vsgl: one texel is its own Gaussian, with the power that it reflects") {
  zonal::VirtualLight texel;
  texel.position = {1, 2, 3};
  texel.normal = {0, 0, 1};
  texel.to_primary = glm::normalize(glm::vec3(1, 0, 1));
  texel.flux = {4, 2, 1};
  texel.radius = 0.2F;
  const zonal::Brdf plastic{
      {zonal::LambertBrdf{{0.5F, 0.25F, 0.1F}}, zonal::GgxBrdf{0.1F, zonal::SchlickFresnel{glm::vec3(1)}}}};
  texel.brdf = &plastic;
  const auto lights = zonal::make_gaussian_lights(&texel, 1, 1);
  REQUIRE(lights.size() == 2);
  CHECK(glm::distance(lights[0].axis, texel.normal) < 1e-6F);
  CHECK(lights[0].sharpness == Catch::Approx(2));
  CHECK(glm::distance(lights[1].axis, glm::normalize(glm::vec3(-1, 0, 1))) < 1e-6F);
  CHECK(lights[1].sharpness == Catch::Approx(0.5 / 0.01 / std::sqrt(0.5)).epsilon(1e-3));  // 2 / alpha^2 / (4 cos)
  for (int i = 0; i < 2; ++i) {
    CHECK(glm::distance(lights[std::size_t(i)].position, texel.position) < 1e-6F);
    CHECK(lights[std::size_t(i)].variance == Catch::Approx(0.2 * 0.2 / 4).epsilon(1e-3));  // of a disc, along one axis
    const glm::vec3 reflectance = i == 0 ? glm::vec3(0.5F, 0.25F, 0.1F) : glm::vec3(1);
    double power = 0;
    for_each_direction(glm::dvec3(lights[std::size_t(i)].axis), [&](const glm::dvec3& w, double solid_angle) {
      power +=
          solid_angle * gaussian(w, glm::dvec3(lights[std::size_t(i)].axis), double(lights[std::size_t(i)].sharpness));
    });
    for (int c = 0; c < 3; ++c) {
      CHECK(power * double(lights[std::size_t(i)].coefficient[c]) ==
            Catch::Approx(double(texel.flux[c] * reflectance[c])).epsilon(1e-3));
    }
  }
}

TEST_CASE("vsgl: a square of texels has the variance of a square, and blocks cover the map") {
  std::vector<zonal::VirtualLight> map(20 * 20);
  for (int i = 0; i < 400; ++i) {
    map[std::size_t(i)].position = {0.1F * float(i % 20), 0.1F * float(i / 20), 100};
    map[std::size_t(i)].flux = glm::vec3(1);
    map[std::size_t(i)].brdf = &materials().white.brdf;
  }
  const auto all = zonal::make_gaussian_lights(map.data(), 20, 20);
  REQUIRE(all.size() == 1);
  CHECK(glm::distance(all[0].position, glm::vec3(0.95F, 0.95F, 100)) < 1e-5F);
  CHECK(all[0].variance == Catch::Approx(0.01 * (20 * 20 - 1) / 12.0).epsilon(1e-4));
  for (const int block : {1, 3, 7, 1000}) {
    const auto lights = zonal::make_gaussian_lights(map.data(), 20, block);
    const int along = (20 + block - 1) / block;
    CHECK(int(lights.size()) == along * along);
    float power = 0;
    for (const auto& light : lights) power += light.coefficient.x;
    CHECK(power == Catch::Approx(all[0].coefficient.x).epsilon(1e-5));
  }
  CHECK(zonal::make_gaussian_lights(nullptr, 0, 4).empty());
}

TEST_CASE("vsgl: an SG against a diffuse surface is the integral of the product of two SGs") {
  Random random(41);
  for (const double sharpness : {1e-3, 0.5, 2.0, 30.0, 2000.0}) {
    for (int trial = 0; trial < 4; ++trial) {
      const glm::dvec3 axis(random.direction()), normal(random.direction());
      double expected = 0, whole = 0;
      for_each_direction(axis, [&](const glm::dvec3& w, double solid_angle) {
        expected += solid_angle * gaussian(w, axis, sharpness) * gaussian(w, normal, 2);
      });
      for_each_direction(
          normal, [&](const glm::dvec3& w, double solid_angle) { whole += solid_angle * gaussian(w, normal, 2); });
      const Double3 n{normal.x, normal.y, normal.z};
      const double got = zonal::detail::diffuse_integral(incoming(axis, sharpness), n);
      CAPTURE(sharpness, trial, got, expected / whole);
      CHECK(std::abs(got - expected / whole) <= 1e-3 * std::max(expected / whole, 1e-3));
    }
  }
}

TEST_CASE(
    "vsgl: an SG against a glossy lobe is about the integral, and is it for a narrow SG at the mirror direction") {
  const zonal::Receiver at{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
  for (const float degrees : {0.0F, 30.0F, 60.0F}) {
    const float theta = degrees * float(pi) / 180;
    const glm::vec3 wo(std::sin(theta), 0, std::cos(theta));
    zonal::Receiver receiver = at;
    receiver.outgoing = wo;
    zonal::ReceiverFrame<double> frame{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    const glm::dvec3 mirror(-double(wo.x), 0, double(wo.z));
    struct Lobe {
      zonal::BrdfLobe brdf;
      double narrow, wide;  // greatest relative errors
    };
    for (const auto& [brdf, narrow, wide] :
         {Lobe{zonal::GgxBrdf{0.1F, zonal::SchlickFresnel{glm::vec3(0.8F)}}, 0.02, 0.6},
          Lobe{zonal::GgxBrdf{0.3F, zonal::ConductorFresnel{{0.2F, 0.9F, 1.1F}, {3.9F, 2.5F, 2.4F}}}, 0.02, 0.6},
          Lobe{zonal::PhongBrdf{glm::vec3(0.7F), 60}, 0.02, 0.25}}) {
      for (const double sharpness : {20000.0, 50.0}) {
        double expected = 0;
        for_each_direction(mirror, [&](const glm::dvec3& w, double solid_angle) {
          if (w.z <= 0) return;
          expected += solid_angle * gaussian(w, mirror, sharpness) * zonal::evaluate(brdf, w, glm::dvec3(wo)).x * w.z;
        });
        const double got = std::visit(
            [&](const auto& model) {
              return zonal::detail::glossy_integral(model, incoming(mirror, sharpness), frame, wo).x;
            },
            brdf);
        CAPTURE(degrees, brdf.index(), sharpness, got, expected);
        CHECK(std::abs(got - expected) <= (sharpness > 1000 ? narrow : wide) * expected);
      }
    }
  }
}
