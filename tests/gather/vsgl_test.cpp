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
void for_each_direction(const glm::dvec3& axis, const Visit& visit, int rings = 600) {
  const int spokes = rings;
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
      const double got = zonal::detail::diffuse_integral<zonal::Vsgl::of_2015>(incoming(axis, sharpness), n);
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
        for_each_direction(mirror, [&, &brdf = brdf](const glm::dvec3& w, double solid_angle) {
          if (w.z <= 0) return;
          expected += solid_angle * gaussian(w, mirror, sharpness) * zonal::evaluate(brdf, w, glm::dvec3(wo)).x * w.z;
        });
        const double got = std::visit(
            [&](const auto& model) {
              return zonal::detail::glossy_integral<zonal::Vsgl::of_2015>(model, incoming(mirror, sharpness), frame, wo)
                  .x;
            },
            brdf);
        CAPTURE(degrees, brdf.index(), sharpness, got, expected);
        CHECK(std::abs(got - expected) <= (sharpness > 1000 ? narrow : wide) * expected);
      }
    }
  }
}

namespace {

/// The reflection towards wo of light exp(sharpness (cos - 1)) about axis, its first channel, by quadrature of f cos.
double reflection_by_quadrature(const zonal::BrdfLobe& brdf, const glm::dvec3& axis, double sharpness,
                                const glm::dvec3& wo) {
  double sum = 0;
  for_each_direction(
      axis,
      [&](const glm::dvec3& w, double solid_angle) {
        if (w.z > 0) sum += solid_angle * gaussian(w, axis, sharpness) * zonal::evaluate(brdf, w, wo).x * w.z;
      },
      300);
  return sum;
}

/// Directions about the mirror direction of wo, in the plane of incidence and across, and the light's own horizon.
std::vector<glm::dvec3> axes_about_mirror(double theta) {
  std::vector<glm::dvec3> axes;
  for (const double turn : {0.0, 0.15, -0.15, 0.4, -0.4, 0.8, -0.8}) {
    axes.emplace_back(-std::sin(theta + turn), 0, std::cos(theta + turn));
    if (turn > 0) {
      axes.emplace_back(-std::sin(theta) * std::cos(turn), std::sin(turn), std::cos(theta) * std::cos(turn));
    }
  }
  return axes;
}

struct Errors {
  double greatest = 0, mean = 0;  // of the greatest reflection at that angle and sharpness
};

template <zonal::Vsgl formulas>
Errors reflection_errors(const zonal::BrdfLobe& brdf, double degrees, double sharpness) {
  const double theta = degrees / 180 * pi;
  const glm::dvec3 wo(std::sin(theta), 0, std::cos(theta));
  const zonal::ReceiverFrame<double> frame{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
  const auto axes = axes_about_mirror(theta);
  double largest = 0;
  Errors errors;
  for (const glm::dvec3& axis : axes) {
    const double exact = reflection_by_quadrature(brdf, axis, sharpness, wo);
    const double got = std::visit(
        [&](const auto& model) {
          return zonal::detail::glossy_integral<formulas>(model, incoming(axis, sharpness), frame, glm::vec3(wo)).x;
        },
        brdf);
    largest = std::max(largest, exact);
    errors.greatest = std::max(errors.greatest, std::abs(got - exact));
    errors.mean += std::abs(got - exact) / double(axes.size());
  }
  return {errors.greatest / largest, errors.mean / largest};
}

}  // namespace

TEST_CASE("vsgl of 2024: an SG against a glossy lobe is the integral to the errors stated, half those of 2015") {
  const zonal::SchlickFresnel white{glm::vec3(1)};
  struct Lobe {
    zonal::BrdfLobe brdf;
    bool is_ggx;
    double bound;  // of Phong's
  };
  struct Light {
    double sharpness, bound;  // of GGX
  };
  double sum = 0, sum_of_2015 = 0;
  for (const auto& [brdf, is_ggx, phong_bound] :
       {Lobe{zonal::GgxBrdf{0.1F, white}, true, 0},
        Lobe{zonal::GgxBrdf{0.25F, zonal::ConductorFresnel{{0.2F, 0.9F, 1.1F}, {3.9F, 2.5F, 2.4F}}}, true, 0},
        Lobe{zonal::GgxBrdf{0.6F, white}, true, 0}, Lobe{zonal::GgxBrdf{1.0F, white}, true, 0},
        Lobe{zonal::PhongBrdf{glm::vec3(0.7F), 60}, false, 0.007},
        Lobe{zonal::PhongBrdf{glm::vec3(0.7F), 5}, false, 0.065}}) {
    for (const double degrees : {0.0, 30.0, 60.0, 75.0}) {
      for (const auto& [sharpness, ggx_bound] :
           {Light{1e-3, 0.21}, Light{1, 0.4}, Light{10, 0.22}, Light{100, 0.17}, Light{10000, 0.018}}) {
        const Errors errors = reflection_errors<zonal::Vsgl::of_2024>(brdf, degrees, sharpness);
        CAPTURE(brdf.index(), degrees, sharpness, errors.greatest, errors.mean);
        CHECK(errors.greatest <= (is_ggx ? ggx_bound : phong_bound));
        sum += errors.mean;
        sum_of_2015 += reflection_errors<zonal::Vsgl::of_2015>(brdf, degrees, sharpness).mean;
      }
    }
  }
  CAPTURE(sum, sum_of_2015);
  CHECK(sum < 0.4 * sum_of_2015);
}

TEST_CASE("vsgl of 2024: a mirror reflects the light's axis as bright as it is, and a point light as the BRDF has it") {
  const zonal::GgxBrdf mirror{0.001F, zonal::SchlickFresnel{glm::vec3(1)}};
  const glm::vec3 wo(0.6F, 0, 0.8F);
  const glm::dvec3 axis(-0.6, 0, 0.8);
  for (const double sharpness : {0.01, 0.3, 1.0, 3.0, 30.0}) {
    const double got = zonal::gaussian_reflection(mirror, axis, sharpness, wo).x;
    CAPTURE(sharpness, got);
    CHECK(got == Catch::Approx(1).epsilon(0.01));
  }
  Random random(44);
  for (const float roughness : {0.2F, 0.5F, 1.0F}) {
    const zonal::GgxBrdf ggx{roughness, zonal::SchlickFresnel{glm::vec3(0.3F, 0.6F, 0.9F)}};
    for (int trial = 0; trial < 20; ++trial) {
      const float sine = random.uniform(0, 0.95F);
      const glm::vec3 eye(sine, 0, std::sqrt(1 - sine * sine));
      const glm::dvec3 light(glm::normalize(random.direction_above({0, 0, 1}) + glm::vec3(0, 0, 0.2F)));
      const glm::dvec3 exact = zonal::evaluate(ggx, light, glm::dvec3(eye)) * light.z * 2.0 * pi / 1e6;
      const glm::dvec3 got = zonal::gaussian_reflection(ggx, light, 1e6, eye);
      CAPTURE(roughness, trial, exact.x, got.x, exact.z, got.z);
      CHECK(glm::length(got - exact) <= 0.005 * glm::length(exact));
    }
  }
}

TEST_CASE("vsgl of 2024: an SG against a diffuse surface is its integral with the clamped cosine") {
  Random random(42);
  for (const double sharpness : {1e-3, 0.5, 2.0, 4.0, 30.0, 2000.0}) {
    for (int trial = 0; trial < 4; ++trial) {
      const glm::dvec3 axis(random.direction()), normal(random.direction());
      double expected = 0, whole = 0;
      for_each_direction(axis, [&](const glm::dvec3& w, double solid_angle) {
        whole += solid_angle * gaussian(w, axis, sharpness);
        expected += solid_angle * gaussian(w, axis, sharpness) * std::max(glm::dot(w, normal), 0.0) / pi;
      });
      const Double3 n{normal.x, normal.y, normal.z};
      const double got = zonal::detail::diffuse_integral<zonal::Vsgl::of_2024>(incoming(axis, sharpness), n);
      CAPTURE(sharpness, trial, got, expected, whole);
      CHECK(std::abs(got - expected) <= 0.0024 / pi * whole);
    }
  }
}

TEST_CASE("vsgl of 2024: one texel sends above its surface what it reflects, about where it reflects it") {
  zonal::VirtualLight texel;
  texel.normal = {0, 0, 1};
  texel.to_primary = glm::normalize(glm::vec3(1, 0, 1));
  texel.flux = {4, 2, 1};
  texel.radius = 0.2F;
  struct Part {
    zonal::BrdfLobe lobe;
    double power, direction;  // greatest errors: a GGX lobe is as much too bright as it reflects light from everywhere
  };
  const zonal::SchlickFresnel white{glm::vec3(1)};
  for (const auto& [lobe, power, direction] :
       {Part{zonal::LambertBrdf{{0.5F, 0.25F, 0.1F}}, 1e-3, 1e-3}, Part{zonal::GgxBrdf{0.3F, white}, 0.13, 0.1},
        Part{zonal::GgxBrdf{0.8F, white}, 0.13, 0.15}, Part{zonal::PhongBrdf{glm::vec3(0.6F), 10}, 0.02, 0.09}}) {
    const zonal::Brdf brdf{{lobe}};
    texel.brdf = &brdf;
    const auto lights = zonal::make_gaussian_lights<zonal::Vsgl::of_2024>(&texel, 1, 1);
    REQUIRE(lights.size() == 1);
    glm::dvec3 sent(0), sent_towards(0), reflected(0), reflected_towards(0);
    for_each_direction({0, 0, 1}, [&, &lobe = lobe](const glm::dvec3& w, double solid_angle) {
      if (w.z <= 0) return;
      const double weight = solid_angle * gaussian(w, glm::dvec3(lights[0].axis), double(lights[0].sharpness));
      sent += weight * glm::dvec3(lights[0].coefficient);
      sent_towards += weight * double(lights[0].coefficient.x) * w;
      const glm::dvec3 f = zonal::evaluate(lobe, w, glm::dvec3(texel.to_primary)) * w.z * solid_angle;
      reflected += f * glm::dvec3(texel.flux);
      reflected_towards += f.x * double(texel.flux.x) * w;
    });
    CAPTURE(lobe.index(), sent.x, reflected.x, lights[0].sharpness);
    for (int c = 0; c < 3; ++c) CHECK(sent[c] == Catch::Approx(reflected[c]).epsilon(power));
    CHECK(glm::distance(sent_towards / sent.x, reflected_towards / reflected.x) < direction);
  }
}

TEST_CASE("vsgl of 2024: texels that face apart make a light of their mean direction") {
  zonal::VirtualLight map[4];
  glm::dvec3 mean(0);
  for (int i = 0; i < 4; ++i) {
    map[i].normal = map[i].to_primary = glm::normalize(glm::vec3(float(i % 2) - 0.5F, float(i / 2) - 0.3F, 0.4F));
    map[i].flux = glm::vec3(1);
    map[i].brdf = &materials().white.brdf;
    // A diffuse texel's SG, of sharpness 2.1491, has the mean direction 0.5628 of its normal.
    mean += 0.25 * (1 / std::tanh(2.1491258) - 1 / 2.1491258) * glm::dvec3(map[i].normal);
  }
  const auto lights = zonal::make_gaussian_lights<zonal::Vsgl::of_2024>(map, 2, 2);
  REQUIRE(lights.size() == 1);
  glm::dvec3 got(0);
  double whole = 0;
  for_each_direction(glm::dvec3(lights[0].axis), [&](const glm::dvec3& w, double solid_angle) {
    const double weight = solid_angle * gaussian(w, glm::dvec3(lights[0].axis), double(lights[0].sharpness));
    got += weight * w;
    whole += weight;
  });
  CHECK(glm::distance(got / whole, mean) < 1e-3);
}
