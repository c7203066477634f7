#include <zonal/material/brdf.hpp>

#include <complex>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "support.hpp"

using namespace material_test;

TEST_CASE("brdf: reciprocal, isotropic, even in phi, zero at and below the horizon") {
  Random random(1);
  for (const auto& [name, brdf] : materials()) {
    for (int i = 0; i < 300; ++i) {
      const glm::vec3 wi = random.direction(), wo = random.direction();
      CAPTURE(name, wi.x, wi.y, wi.z, wo.x, wo.y, wo.z);
      const glm::vec3 f = evaluate(brdf, wi, wo);
      const auto same = [&, &brdf = brdf](const glm::vec3& a, const glm::vec3& b, float bound) {
        const glm::vec3 g = evaluate(brdf, a, b);
        for (int c = 0; c < 3; ++c) CHECK(std::abs(f[c] - g[c]) <= bound * (f[c] + 1e-6F));
      };
      same(wo, wi, 2e-6F);
      same({wi.x, -wi.y, wi.z}, {wo.x, -wo.y, wo.z}, 0.0F);
      same({-wi.y, wi.x, wi.z}, {-wo.y, wo.x, wo.z}, 2e-6F);
      for (const float z : {0.0F, -wi.z}) {
        CHECK(evaluate(brdf, glm::vec3(wi.x, wi.y, z), wo) == glm::vec3(0.0F));
        CHECK(evaluate(brdf, wo, glm::vec3(wi.x, wi.y, z)) == glm::vec3(0.0F));
      }
    }
  }
}

TEST_CASE("brdf: float meets long double, the finest roughness and the mirror direction included") {
  Met met("material", "evaluate");
  Random random(2);
  for (const auto& [name, brdf] : materials()) {
    for (int i = 0; i < 2000; ++i) {
      const glm::vec3 wo = random.direction();
      // from everywhere to within 1e-4 of the mirror direction
      const float spread = std::pow(10.0F, -4.0F * random());
      const glm::vec3 mirror(-wo.x, -wo.y, wo.z);
      const glm::vec3 wi = glm::normalize(mirror + spread * random.direction());
      if (wi.z <= 0.0F) continue;
      const glm::vec3 f = evaluate(brdf, wi, wo);
      using Wide = glm::vec<3, long double>;
      const Wide exact = evaluate(brdf, Wide(wi), Wide(wo));
      CAPTURE(name, wi.x, wi.y, wi.z, wo.x, wo.y, wo.z);
      for (int c = 0; c < 3; ++c) {
        // Phong's tail is exp(n log cos): its relative error is eps |log value|
        const long double error = std::abs(static_cast<long double>(f[c]) - exact[c]) - 1e-12L;
        CHECK(met.meet(error > 0 ? static_cast<double>(error / exact[c]) : 0.0));
      }
    }
  }
  CHECK_WORST_MET(met);
}

TEST_CASE("brdf: finite wherever both directions are above the horizon") {
  for (const auto& [name, brdf] : materials()) {
    for (const float zi : {1.0F, 1e-3F, 1e-10F, 1e-20F, 1e-38F}) {
      for (const float zo : {1.0F, 1e-3F, 1e-10F, 1e-20F, 1e-38F}) {
        for (const float side : {-1.0F, 1.0F}) {
          CAPTURE(name, zi, zo, side);
          const glm::vec3 wi(side * std::sqrt((1.0F - zi) * (1.0F + zi)), 0.0F, zi);
          const glm::vec3 wo(std::sqrt((1.0F - zo) * (1.0F + zo)), 0.0F, zo);
          const glm::vec3 f = evaluate(brdf, wi, wo);
          for (int c = 0; c < 3; ++c) CHECK((std::isfinite(f[c]) && f[c] >= 0.0F));
        }
      }
    }
  }
}

TEST_CASE("brdf: Lambert and Phong are their definitions") {
  const zonal::LambertBrdf lambert{{0.7F, 0.5F, 0.2F}};
  const glm::dvec3 up(0.0, 0.0, 1.0), wo = outgoing(40.0);
  for (int c = 0; c < 3; ++c)
    CHECK(evaluate(lambert, up, wo)[c] == Approx(double(lambert.albedo[c]) / pi).epsilon(1e-15));

  const zonal::PhongBrdf phong{glm::vec3(1.0F), 20.0F};
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 wi = glm::normalize(glm::dvec3(random.direction()));
    const double cosine = std::max(0.0, glm::dot(wi, glm::dvec3(-wo.x, -wo.y, wo.z)));
    CAPTURE(wi.x, wi.y, wi.z);
    CHECK(evaluate(phong, wi, wo).x == Approx(22.0 / (2.0 * pi) * std::pow(cosine, 20.0)).epsilon(1e-12));
  }
  // Its albedo from the normal is specular_albedo, whatever the exponent; lower elsewhere.
  for (const float exponent : {0.0F, 1.0F, 30.0F}) {
    const zonal::PhongBrdf brdf{glm::vec3(1.0F), exponent};
    double at_normal = 0.0, aside = 0.0;
    midpoint_hemisphere(400, 200, [&](const glm::dvec3& wi, double solid_angle) {
      at_normal += evaluate(brdf, wi, up).x * wi.z * solid_angle;
      aside += evaluate(brdf, wi, wo).x * wi.z * solid_angle;
    });
    CAPTURE(exponent);
    CHECK(at_normal == Approx(1.0).margin(2e-4));
    CHECK(aside < at_normal);
  }
}

TEST_CASE("brdf: a material is the sum of its lobes") {
  const auto list = materials();
  const glm::dvec3 wi = direction(0.5, 2.0), wo = outgoing(35.0);
  const zonal::Brdf &a = list[0].brdf, &b = list[4].brdf;
  const zonal::Brdf sum{{a.lobes[0], b.lobes[0]}};
  CHECK(largest(evaluate(sum, wi, wo) - evaluate(a, wi, wo) - evaluate(b, wi, wo)) < 1e-16);
  CHECK(evaluate(zonal::Brdf{}, wi, wo) == glm::dvec3(0.0));
}

TEST_CASE("fresnel: conductors at normal and grazing incidence, and between by complex arithmetic") {
  const zonal::ConductorFresnel metal = gold();
  for (int c = 0; c < 3; ++c) {
    const double eta = double(metal.eta[c]), k = double(metal.k[c]);
    const double normal = ((eta - 1.0) * (eta - 1.0) + k * k) / ((eta + 1.0) * (eta + 1.0) + k * k);
    CHECK(reflectance(metal, 1.0)[c] == Approx(normal).epsilon(1e-14));
    CHECK(reflectance(metal, 0.0)[c] == Approx(1.0).margin(1e-4));
    for (int degrees = 1; degrees < 90; ++degrees) {
      CAPTURE(c, degrees);
      const double cosine = std::cos(degrees * pi / 180.0);
      const std::complex<double> index(eta, k);
      const std::complex<double> cos_t = std::sqrt(1.0 - (1.0 - cosine * cosine) / (index * index));
      const double s = std::norm((cosine - index * cos_t) / (cosine + index * cos_t));
      const double p = std::norm((index * cosine - cos_t) / (index * cosine + cos_t));
      CHECK(reflectance(metal, cosine)[c] == Approx(0.5 * (s + p)).epsilon(1e-12));
      CHECK(std::abs(double(reflectance(metal, float(cosine))[c]) - reflectance(metal, double(float(cosine)))[c]) <
            1e-6);
    }
  }
}

TEST_CASE("fresnel: dielectrics by Snell's law, Brewster's angle and total internal reflection") {
  for (const float eta : {1.0F, 1.1F, 1.5F, 2.4F, 0.6666667F}) {
    const double n = double(eta);
    for (int degrees = 0; degrees < 90; ++degrees) {
      CAPTURE(eta, degrees);
      const double cosine = std::cos(degrees * pi / 180.0), sin_t = std::sin(degrees * pi / 180.0) / n;
      double expected = 1.0;
      if (sin_t < 1.0) {
        const double cos_t = std::sqrt(1.0 - sin_t * sin_t);
        const double s = (cosine - n * cos_t) / (cosine + n * cos_t), p = (n * cosine - cos_t) / (n * cosine + cos_t);
        expected = 0.5 * (s * s + p * p);
      }
      const zonal::DielectricFresnel glass{eta};
      CHECK(reflectance(glass, cosine).x == Approx(expected).margin(1e-13));
      CHECK(std::abs(double(reflectance(glass, float(cosine)).x) - reflectance(glass, double(float(cosine))).x) < 1e-6);
      // a metal that does not absorb is a dielectric
      CHECK(reflectance(zonal::ConductorFresnel{glm::vec3(eta), glm::vec3(0.0F)}, cosine) ==
            reflectance(glass, cosine));
    }
  }
  const double brewster = 1.0 / std::sqrt(1.0 + 1.5 * 1.5), cos_t = 1.5 * brewster;
  const double s = (brewster - 1.5 * cos_t) / (brewster + 1.5 * cos_t);
  CHECK(reflectance(zonal::DielectricFresnel{1.5F}, brewster).x == Approx(0.5 * s * s).epsilon(1e-12));
  CHECK(reflectance(zonal::DielectricFresnel{1.5F}, 1.0).x == Approx(0.04).epsilon(1e-12));
  CHECK(reflectance(zonal::SchlickFresnel{{0.04F, 0.5F, 1.0F}}, 0.0) == glm::dvec3(1.0));
  CHECK(reflectance(zonal::SchlickFresnel{{0.25F, 0.5F, 1.0F}}, 1.0) == glm::dvec3(0.25, 0.5, 1.0));
}

TEST_CASE(
    "fresnel: float is within its bound near index 1, near the critical angle, and where a metal hardly absorbs") {
  // By complex arithmetic from the index itself: a + i b = sqrt((n - 1) (n + 1) + c^2), which cancels nowhere.
  const auto exact = [](float c, float eta, float k) {
    using Complex = std::complex<long double>;
    const Complex n(eta, k);
    const long double cosine = c;
    const Complex t = std::sqrt((n - 1.0L) * (n + 1.0L) + cosine * cosine);
    return double(0.5L *
                  (std::norm((cosine - t) / (cosine + t)) + std::norm((n * n * cosine - t) / (n * n * cosine + t))));
  };
  const auto check = [&](float eta, float k, float cosine) {
    if (!(cosine > 0.0F && cosine <= 1.0F)) return;
    const zonal::ConductorFresnel fresnel{glm::vec3(eta), glm::vec3(k)};
    const double expected = exact(cosine, eta, k);
    const float in_float = reflectance(fresnel, cosine).x;
    if (std::abs(double(in_float) - expected) <= 1e-6) return;
    CAPTURE(eta, k, cosine, in_float, expected);
    FAIL_CHECK("beyond 1e-6");
  };
  for (const float eta :
       {1.0F, 1.0000001F, 1.00001F, 1.001F, 1.5F, 0.99999994F, 0.9999F, 0.99F, 0.9F, 0.6666667F, 0.1F, 0.001F}) {
    for (const float k : {0.0F, 1e-6F, 1e-4F, 1e-2F, 0.1F, 1.0F, 1.4F, 10.0F}) {
      for (int i = 0; i < 1000; ++i) {
        check(eta, k, float(i) / 1000.0F);
        check(eta, k, std::pow(10.0F, -float(i) / 50.0F));
      }
      const double critical = std::sqrt(std::fmax(1.0 + double(k) * double(k) - double(eta) * double(eta), 0.0));
      for (int i = -300; i <= 300; ++i) {
        check(eta, k, float(critical) * (1.0F + float(i) * 0x1p-24F));
        check(eta, k, float(critical * (1.0 + std::copysign(std::pow(10.0, -std::abs(i) / 40.0), i))));
      }
    }
  }
  Random random(8);
  for (int i = 0; i < 1000; ++i) {  // index 1 is no surface
    const float cosine = i == 0 ? 0.0F : std::pow(10.0F, -10.0F * random());
    CAPTURE(cosine);
    CHECK(reflectance(zonal::DielectricFresnel{1.0F}, cosine).x == 0.0F);
    CHECK(reflectance(zonal::DielectricFresnel{1.0F}, double(cosine)).x == 0.0);
  }
}

TEST_CASE("ggx: no half vector, and roughness out of range, give finite numbers") {
  using Vec3 = glm::vec<3, float>;
  for (const Vec3& wo : {Vec3(0, 0, 1), Vec3(0.6F, 0, 0.8F), Vec3(1, 0, 1e-20F)}) {
    const auto none = zonal::detail::half_vector(-wo, wo);
    CHECK((none.squared_length == 0.0F && none.squared_sine == 0.0F && none.squared_cosine == 1.0F));
    for (const float roughness : {0.0F, 1e-30F, 1e-3F, 1.0F, 1e30F}) {
      const zonal::Brdf brdf = ggx(roughness, zonal::DielectricFresnel{1.5F});
      for (const Vec3& wi : {wo, -wo, Vec3(-wo.x, 0, wo.z), Vec3(-wo.x, 0, -wo.z)}) {
        CAPTURE(roughness, wo.z, wi.x, wi.z);
        CHECK(std::isfinite(evaluate(brdf, wi, wo).x));
        CHECK(std::isfinite(pdf(brdf, wi, wo)));
      }
    }
  }
}

TEST_CASE("ggx: D is normalised, and so are the normals visible from anywhere") {
  for (const double alpha : {0.001, 0.01, 0.1, 0.5, 1.0}) {
    // tan(theta) = alpha tan(psi) makes the integrand smooth for every roughness
    constexpr int count = 1000;
    double projected_area = 0.0;
    for (int i = 0; i < count; ++i) {
      const double psi = (i + 0.5) * 0.5 * pi / count, theta = std::atan(alpha * std::tan(psi));
      const double dtheta = 0.5 * pi / count * std::cos(theta) * std::cos(theta) * alpha / std::pow(std::cos(psi), 2);
      const glm::dvec3 h = direction(theta, 0.3);
      projected_area += zonal::detail::ggx_distribution(zonal::detail::half_vector(h, h), alpha) * std::cos(theta) *
                        2.0 * pi * std::sin(theta) * dtheta;
    }
    CAPTURE(alpha);
    CHECK(projected_area == Approx(1.0).margin(1e-5));

    // integral of G1(wo) max(wo . h, 0) D(h) = cos_o
    for (const double degrees : {0.0, 30.0, 60.0, 85.0}) {
      const glm::dvec3 wo = outgoing(degrees);
      const double g1 = 2.0 * wo.z / (wo.z + zonal::detail::ggx_projected_length(wo.z, alpha));
      double visible = 0.0;
      for (int i = 0; i < count; ++i) {
        const double psi = (i + 0.5) * 0.5 * pi / count, theta = std::atan(alpha * std::tan(psi));
        const double dtheta = 0.5 * pi / count * std::cos(theta) * std::cos(theta) * alpha / std::pow(std::cos(psi), 2);
        for (int j = 0; j < 400; ++j) {
          const glm::dvec3 h = direction(theta, (j + 0.5) * 2.0 * pi / 400);
          visible += g1 * std::max(glm::dot(wo, h), 0.0) *
                     zonal::detail::ggx_distribution(zonal::detail::half_vector(h, h), alpha) * 2.0 * pi / 400 *
                     std::sin(theta) * dtheta;
        }
      }
      CAPTURE(degrees);
      CHECK(visible == Approx(wo.z).epsilon(1e-4));
    }
  }
}

TEST_CASE("ggx: the albedo of roughness 1 has a closed form") {
  // D = 1 / pi, f = 1 / (2 pi (cos_i + cos_o)), hence the albedo 1 - cos_o log((1 + cos_o) / cos_o).
  for (const double degrees : {0.0, 30.0, 60.0, 80.0, 89.0}) {
    const glm::dvec3 wo = outgoing(degrees);
    double albedo = 0.0;
    midpoint_hemisphere(2000, 8, [&](const glm::dvec3& wi, double solid_angle) {
      albedo += evaluate(zonal::GgxBrdf{1.0F, white()}, wi, wo).x * wi.z * solid_angle;
    });
    CAPTURE(degrees);
    CHECK(albedo == Approx(1.0 - wo.z * std::log((1.0 + wo.z) / wo.z)).margin(1e-5));
    CHECK(ggx_albedo(ggx(1.0F, white()), 1.0, wo).x == Approx(albedo).margin(2e-3));
  }
}

TEST_CASE("ggx: a white metal reflects at most all, and all of it when nearly smooth") {
  for (const float roughness : {0.01F, 0.02F, 0.1F, 0.3F, 0.6F, 1.0F}) {
    for (const double degrees : {0.0, 20.0, 45.0, 70.0, 85.0, 89.0}) {
      CAPTURE(roughness, degrees);
      const double albedo = ggx_albedo(ggx(roughness, white()), double(roughness), outgoing(degrees)).x;
      CHECK(albedo <= 1.0 + 1e-4);
      CHECK(albedo > 0.3);
      if (roughness <= 0.02F && degrees <= 70.0) CHECK(albedo > 0.995);
    }
  }
}
