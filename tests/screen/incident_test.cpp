// Light samples against their formulas in double, the moments against integrals, shading against quadrature.
#include <zonal/lobe/phong.hpp>
#include <zonal/material/material_table.hpp>
#include <zonal/screen/incident.hpp>
#include <zonal/screen/moments.hpp>
#include <zonal/screen/shade.hpp>
#include <zonal/transform/convolve.hpp>

#include <cmath>
#include <random>
#include <vector>

#include "../accuracy.hpp"
#include "../catch.hpp"

namespace {

class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}
  float uniform(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random_); }
  glm::vec3 vector(float size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }
  glm::vec3 colour() { return {uniform(0, 2), uniform(0, 2), uniform(0, 2)}; }
  glm::vec3 direction() {
    for (;;) {
      const glm::vec3 v = vector(1);
      const float length = glm::length(v);
      if (length > 0.1F && length < 1) return v / length;
    }
  }

 private:
  std::mt19937 random_;
};

enum class Kind { point, spot, surface, directional };

struct Light {
  Kind kind;
  glm::vec3 place, axis, power;
  float cos_outer = 0, cos_inner = 0;

  zonal::LightSample<float> sample() const {
    switch (kind) {
      case Kind::point: return zonal::point_sample(place, power);
      case Kind::spot: return zonal::spot_sample(place, axis, power, cos_outer, cos_inner);
      case Kind::surface: return zonal::surface_sample(place, axis, power);
      default: return zonal::directional_sample(place, power);
    }
  }

  /// The direction to it, and the irradiance across it, by the definitions.
  std::pair<glm::dvec3, glm::dvec3> at(const glm::dvec3& x, double least_distance) const {
    if (kind == Kind::directional) return {glm::dvec3(place), glm::dvec3(power)};
    const glm::dvec3 to = glm::dvec3(place) - x;
    const double d = glm::length(to), cosine = -glm::dot(glm::dvec3(axis), to / d);
    double profile = 1;
    if (kind == Kind::spot) profile = glm::smoothstep(double(cos_outer), double(cos_inner), cosine);
    if (kind == Kind::surface) profile = std::max(cosine, 0.0);
    return {to / d, glm::dvec3(power) * profile / std::pow(std::max(d, least_distance), 2)};
  }
};

std::vector<Light> random_lights(Random& random, int count) {
  std::vector<Light> lights;
  for (int i = 0; i < count; ++i) {
    const Kind kind = Kind(i % 4);
    const glm::vec3 place = kind == Kind::directional ? random.direction() : random.vector(3);
    const float outer = random.uniform(-0.5F, 0.9F);
    lights.push_back({kind, place, random.direction(), random.colour(), outer, outer + 0.08F});
  }
  return lights;
}

zonal::LightSet set_of(const std::vector<Light>& lights) {
  zonal::LightSet set;
  for (const Light& light : lights) set.append(light.sample());
  return set;
}

}  // namespace

TEST_CASE("incident radiance is the sum over lights of Y times their irradiance, of those that are seen and above") {
  Met met("screen", "incident_radiance");
  Random random(1);
  for (int round = 0; round < 100; ++round) {
    const std::vector<Light> lights = random_lights(random, 1 + round % 37);
    const zonal::LightSet set = set_of(lights);
    const glm::vec3 position = random.vector(1), normal = random.direction();
    const float least_distance = round % 3 == 0 ? 1.0F : 1e-3F;
    const auto seen = [](const glm::dvec3& w) { return w.x + 0.3 * w.y < 0.4; };
    const auto visible = [&](const glm::vec3& w, float distance) {
      REQUIRE(distance > 0);
      return seen(glm::dvec3(w));
    };
    zonal::Sh<4, glm::dvec3> expected{};
    glm::dvec3 total(0), vector(0);
    double largest = 0;
    bool is_clear = true;  // of lights next to an edge
    for (const Light& light : lights) {
      const auto [w, irradiance] = light.at(glm::dvec3(position), double(least_distance));
      is_clear = is_clear && std::abs(w.x + 0.3 * w.y - 0.4) > 1e-4 && std::abs(glm::dot(w, glm::dvec3(normal))) > 1e-4;
      if (!seen(w) || glm::dot(w, glm::dvec3(normal)) <= 0) continue;
      expected += zonal::evaluate<4>(w) * irradiance;
      total += irradiance;
      vector += w * glm::dot(irradiance, glm::dvec3(zonal::kLuminance));
      largest += glm::length(irradiance);
    }
    if (!is_clear) continue;
    const auto given = zonal::incident_radiance<4>(set, position, normal, least_distance, visible);
    zonal::MomentSum moments;
    zonal::for_each_arrival(set, position, normal, least_distance, visible,
                            [&](const auto& arrival) { moments(arrival); });
    CAPTURE(round, least_distance);
    for (int i = 0; i < 16; ++i) {
      CAPTURE(i);
      // A spot's edge is steep: 1 / 0.08 times the rounding of the cosine.
      REQUIRE(met.meet(largest > 0 ? glm::distance(glm::dvec3(given[i]), expected[i]) / largest : 0));
    }
    REQUIRE(glm::distance(glm::dvec3(moments.moments().total), total) <= met.row.bound * largest);
    REQUIRE(glm::distance(glm::dvec3(moments.moments().vector), vector) <= met.row.bound * largest);
  }
  CHECK_WORST_MET(met);
}

TEST_CASE("light that no ray is asked for: below the horizon, behind a surface, out of the cone") {
  zonal::LightSet set;
  set.append(zonal::point_sample({0, -1, 0}, {1, 1, 1}));
  set.append(zonal::surface_sample({0, 2, 0}, {0, 1, 0}, {1, 1, 1}));
  set.append(zonal::spot_sample({0, 2, 0}, {0, 1, 0}, {1, 1, 1}, 0.5F, 0.6F));
  set.append(zonal::directional_sample({0, -1, 0}, {1, 1, 1}));
  set.append(zonal::point_sample({0, 1, 0}, {0, 0, 0}));
  int rays = 0;
  const auto sh = zonal::incident_radiance<3>(set, {0, 0, 0}, {0, 1, 0}, 1e-3F, [&](const glm::vec3&, float) {
    ++rays;
    return true;
  });
  REQUIRE(rays == 0);
  for (const glm::vec3& coefficient : sh) REQUIRE(coefficient == glm::vec3(0));
}

TEST_CASE("six floats give back their moments, read either way") {
  Random random(2);
  for (int round = 0; round < 200; ++round) {
    const glm::vec3 total = random.colour() + 0.01F;
    const float luminance = glm::dot(total, zonal::kLuminance), share = random.uniform(0, 0.97F);
    const glm::vec3 axis = random.direction();
    const zonal::RadianceMoments moments{total, axis * luminance * share};
    const auto check = [&](const auto& sh, float tolerance) {
      CAPTURE(round, share);
      // Integrals of f and of f times x, y, z, from the coefficients.
      const float y0 = float(zonal::detail::zonal_normalisation<0>), y1 = float(zonal::detail::zonal_normalisation<1>);
      REQUIRE(glm::distance(sh[0] / y0, total) <= 1e-6F * glm::length(total));
      const glm::vec3 vector(-glm::dot(sh[3], zonal::kLuminance), -glm::dot(sh[1], zonal::kLuminance),
                             glm::dot(sh[2], zonal::kLuminance));
      REQUIRE(glm::distance(vector / y1, moments.vector) <= tolerance * luminance);
    };
    check(moments.as_first_degree(), 1e-6F);
    check(moments.as_gaussian<2>(), 0.013F);  // by the sharpness, which is approximate
  }
  for (const glm::vec3& coefficient : zonal::RadianceMoments{}.as_gaussian<3>()) REQUIRE(coefficient == glm::vec3(0));
  // All light from one direction, and, by rounding, more than all of it.
  const zonal::RadianceMoments sharp{{1, 1, 1}, {0, 0, 1.00001F}};
  for (const glm::vec3& coefficient : sharp.as_gaussian<3>()) REQUIRE(std::isfinite(coefficient.x));
}

TEST_CASE("a table's reflection of coefficients is Lambert's in closed form") {
  Met met("screen", "reflected_radiance");
  Random random(3);
  const zonal::MaterialTable white(zonal::project_material({{zonal::LambertBrdf{glm::vec3(1)}}}, 5));
  for (int round = 0; round < 50; ++round) {
    zonal::Sh<5, glm::vec3> radiance;
    for (glm::vec3& coefficient : radiance) coefficient = random.vector(1);
    radiance[0] = glm::vec3(20);  // nothing negative
    const glm::vec3 normal = random.direction();
    glm::vec3 outgoing = random.direction();
    if (glm::dot(normal, outgoing) < 0) outgoing = -outgoing;
    const glm::vec3 expected = zonal::reconstruct_convolved(radiance, zonal::LambertLobe{}, normal);
    const glm::vec3 given = zonal::reflected_radiance(radiance, white, normal, outgoing);
    CAPTURE(round);
    REQUIRE(met.meet(double(glm::distance(given, expected) / glm::length(expected))));  // the table's tolerance
  }
  CHECK_WORST_MET(met);
}

TEST_CASE("Phong's lobe stands about the mirror direction") {
  Random random(5);
  constexpr float exponent = 12.5F;
  for (int round = 0; round < 5; ++round) {
    zonal::Sh<4, glm::vec3> radiance;
    for (glm::vec3& coefficient : radiance) coefficient = random.vector(1);
    const glm::vec3 normal = random.direction(), outgoing = random.direction();
    // The mirror direction is as far from the normal, on the other side of it in one plane.
    const glm::vec3 mirror = zonal::mirror_direction(normal, outgoing);
    REQUIRE(std::abs(glm::dot(mirror, normal) - glm::dot(outgoing, normal)) < 1e-6F);
    REQUIRE(glm::length(mirror + outgoing - 2 * glm::dot(outgoing, normal) * normal) < 1e-6F);
    const glm::vec3 given =
        zonal::reconstruct_convolved(radiance, zonal::project<4>(zonal::PhongLobe<float>{exponent}), mirror);
    glm::dvec3 expected(0);
    constexpr int rings = 400, spokes = 200;
    for (int i = 0; i < rings; ++i) {
      const double z = -1 + 2 * (i + 0.5) / rings, r = std::sqrt(1 - z * z);
      for (int j = 0; j < spokes; ++j) {
        const double phi = 2 * double(zonal::kPi) * (j + 0.5) / spokes;
        const glm::dvec3 w(r * std::cos(phi), r * std::sin(phi), z);
        const double cosine = std::max(glm::dot(w, glm::dvec3(mirror)), 0.0);
        expected += glm::dvec3(zonal::reconstruct(radiance, glm::vec3(w))) * std::pow(cosine, double(exponent));
      }
    }
    // (n + 1) / 2 pi of 4 pi / count.
    expected *= 2 * (double(exponent) + 1) / (rings * spokes);
    CAPTURE(round);
    REQUIRE(glm::distance(glm::dvec3(given), expected) <= 1e-3);
  }
}

TEST_CASE("a glossy table's reflection is the integral of the BRDF") {
  Random random(4);
  const zonal::Brdf brdf{{zonal::GgxBrdf{0.5F, zonal::SchlickFresnel{{0.9F, 0.5F, 0.2F}}}}};
  constexpr int bands = 9;
  const zonal::MaterialTable table(zonal::project_material(brdf, bands));
  for (int round = 0; round < 5; ++round) {
    zonal::Sh<3, glm::vec3> light;
    for (glm::vec3& coefficient : light) coefficient = random.vector(1);
    light[0] = glm::vec3(10);
    const glm::vec3 normal = random.direction();
    glm::vec3 outgoing = glm::normalize(normal + 0.8F * random.direction());
    const glm::vec3 tangent = zonal::detail::tangent_towards(normal, outgoing), bitangent = glm::cross(normal, tangent);
    const glm::vec3 wo = zonal::detail::in_frame(outgoing, normal, tangent);
    glm::dvec3 expected(0);
    constexpr int rings = 400, spokes = 400;
    for (int i = 0; i < rings; ++i) {
      const float cosine = (float(i) + 0.5F) / rings, sine = std::sqrt(1 - cosine * cosine);
      for (int j = 0; j < spokes; ++j) {
        const float phi = 2 * float(zonal::kPi) * (float(j) + 0.5F) / spokes;
        const glm::vec3 wi(sine * std::cos(phi), sine * std::sin(phi), cosine);
        const glm::vec3 world = wi.x * tangent + wi.y * bitangent + wi.z * normal;
        expected += glm::dvec3(zonal::evaluate(brdf, wi, wo) * cosine * zonal::reconstruct(light, world));
      }
    }
    expected *= 2 * double(zonal::kPi) / (rings * spokes);
    const glm::vec3 given = zonal::reflected_radiance(light, table, normal, outgoing);
    CAPTURE(round);
    REQUIRE(glm::distance(glm::dvec3(given), expected) <= 3e-3 * glm::length(expected));  // of rows a degree apart
  }
}
