// Anisotropic materials in the gathers: against sums over their BRDF in double, in frames that are turned; and an
// isotropic material, which must not notice.
#include <zonal/gather/hvl.hpp>
#include <zonal/gather/vpl.hpp>
#include <zonal/gather/vsl.hpp>
#include <zonal/material/measured.hpp>

#include <algorithm>
#include <memory>

#include "../catch.hpp"
#include "../material/tensor_writer.hpp"
#include "support.hpp"

using namespace gather_test;

namespace {

using zonal::VirtualLight;

/// Microfacets whose axes are turned by half a radian from the surface's: no plane of symmetry to hide behind.
struct Brushed {
  material_test::Microfacets f{0.35, 0.8};

  static glm::dvec3 turned(const glm::dvec3& v) {
    const double c = std::cos(0.5), s = std::sin(0.5);
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
  }
  bool isotropic() const { return false; }
  glm::dvec3 operator()(const glm::dvec3& wi, const glm::dvec3& wo) const { return f(turned(wi), turned(wo)); }
};

struct Surface {
  zonal::Brdf brdf;
  zonal::AnisotropicTable table;

  explicit Surface(const zonal::Brdf& lobes) : brdf(lobes), table(lobes, 13, 1e-2, 60) {}
};

const Surface& brushed() {
  static const Surface surface({{zonal::measured(Brushed{}), zonal::LambertBrdf{{0.1F, 0.2F, 0.1F}}}});
  return surface;
}

VirtualLight anisotropic_light(Random& random) {
  VirtualLight light = random_light(random);
  light.tangent = random.direction();
  light.material = nullptr;
  light.anisotropic = &brushed().table;
  light.brdf = &brushed().brdf;
  return light;
}

zonal::Receiver random_receiver(Random& random) {
  zonal::Receiver receiver{0.5F * random.direction(), random.direction(), {}, random.direction()};
  receiver.outgoing = random.direction_above(receiver.normal);
  return receiver;
}

/// All lights as points: f cos at the receiver times what each sends, by the BRDF of `brushed`, in double.
glm::dvec3 by_points(const std::vector<VirtualLight>& lights, const zonal::Receiver& receiver) {
  glm::dvec3 sum(0);
  const glm::dvec3 n(receiver.normal), out(receiver.outgoing), tangent(receiver.tangent);
  for (const VirtualLight& light : lights) {
    const glm::dvec3 apart = glm::dvec3(light.position) - glm::dvec3(receiver.position), w = glm::normalize(apart);
    const glm::dvec3 at_light(light.normal), own(light.tangent);
    const glm::dvec3 sent =
        zonal::evaluate(*light.brdf, local(glm::dvec3(light.to_primary), at_light, own), local(-w, at_light, own)) *
        glm::dvec3(light.flux) * std::max(0.0, -glm::dot(w, at_light));
    const glm::dvec3 f = zonal::evaluate(brushed().brdf, local(w, n, tangent), local(out, n, tangent));
    sum += f * sent * (std::max(0.0, glm::dot(w, n)) / glm::dot(apart, apart));
  }
  return sum;
}

double relative(const glm::vec3& got, const glm::dvec3& expected) {
  const glm::dvec3 error = glm::abs(glm::dvec3(got) - expected);
  return std::max({error.x, error.y, error.z}) / std::max({expected.x, expected.y, expected.z, 1e-3});
}

}  // namespace

TEST_CASE("anisotropic: VPL are the sum over the BRDF in the frames of the tangents") {
  Random random(81);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<VirtualLight> lights;
    for (int i = 0; i < 20; ++i) lights.push_back(i % 3 == 0 ? anisotropic_light(random) : random_light(random));
    const zonal::Receiver receiver = random_receiver(random);
    std::vector<VirtualLight> same = lights;
    for (VirtualLight& light : same) {
      if (light.anisotropic == nullptr) light.tangent = light.to_primary;  // any will do
    }
    const double error =
        relative(gather_vpl(zonal::LightCache(lights), receiver, brushed().brdf), by_points(same, receiver));
    CAPTURE(trial, error);
    CHECK(error < 1e-4);
  }
}

TEST_CASE("anisotropic: of small lights VSL are VPL") {
  Random random(82);
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<VirtualLight> lights;
    for (int i = 0; i < 10; ++i) {
      lights.push_back(anisotropic_light(random));
      lights.back().radius = 1e-3F;
    }
    const zonal::Receiver receiver = random_receiver(random);
    const auto uniform = [&random] { return random(); };
    const double error = relative(gather_vsl(zonal::LightCache(lights), receiver, brushed().brdf, 64, uniform),
                                  by_points(lights, receiver));
    CAPTURE(trial, error);
    CHECK(error < 0.02);
  }
}

TEST_CASE("anisotropic: of small lights HVL are VPL but for what the bands leave out") {
  Random random(83);
  constexpr int N = 13, NE = 7;
  double square = 0, turned_square = 0, norm = 0;
  for (int trial = 0; trial < 8; ++trial) {
    std::vector<VirtualLight> lights;
    for (int i = 0; i < 4; ++i) {
      lights.push_back(anisotropic_light(random));
      lights.back().radius = 0.02F;
      lights.back().to_primary = glm::normalize(lights.back().to_primary + lights.back().normal);
    }
    zonal::Receiver receiver = random_receiver(random);
    receiver.outgoing = trial == 0 ? receiver.normal : glm::normalize(receiver.outgoing + receiver.normal);
    const glm::dvec3 expected = by_points(lights, receiver);
    const auto error_of = [&] {
      const zonal::HvlCache<NE> cache(lights);
      CHECK(cache.packet_count() == 0);  // all are of anisotropic materials
      const glm::vec3 got = zonal::gather<N, NE, zonal::Horizon::none>(cache, receiver, brushed().table);
      return glm::dot(glm::dvec3(got) - expected, glm::dvec3(got) - expected);
    };
    square += error_of();
    norm += glm::dot(expected, expected);
    // and the tangents matter
    receiver.tangent = glm::cross(receiver.normal, receiver.tangent);
    for (VirtualLight& light : lights) light.tangent = glm::cross(light.normal, light.tangent);
    turned_square += error_of();
  }
  CAPTURE(std::sqrt(square / norm), std::sqrt(turned_square / norm));
  CHECK(square < 0.05 * 0.05 * norm);
  CHECK(turned_square > 0.2 * 0.2 * norm);
}

TEST_CASE("anisotropic: an isotropic material does not notice, at the receiver and at the light") {
  Random random(84);
  const auto& plastic = materials().plastic;
  const zonal::AnisotropicTable table(plastic.brdf, 10, 1e-4, 8);
  for (int trial = 0; trial < 5; ++trial) {
    std::vector<VirtualLight> lights = random_lights(random, 9), same;
    for (VirtualLight light : lights) {
      set_material(light, plastic);
      same.push_back(light);
    }
    std::vector<VirtualLight> anisotropic = same;
    for (std::size_t i = 0; i < anisotropic.size(); ++i) {
      anisotropic[i].tangent = random.direction();
      if (i % 4 != 0) anisotropic[i].anisotropic = &table;
    }
    const zonal::Receiver receiver = random_receiver(random);
    const glm::vec3 expected = zonal::gather<5, 3>(zonal::HvlCache<3>(same), receiver, plastic.table);
    const zonal::HvlCache<3> cache(anisotropic);
    const glm::vec3 at_lights = zonal::gather<5, 3>(cache, receiver, plastic.table);
    const glm::vec3 at_both = zonal::gather<5, 3>(cache, receiver, table);
    CAPTURE(trial);
    CHECK(cache.size() == 9);
    CHECK(relative(at_lights, expected) < 2e-5);
    CHECK(relative(at_both, expected) < 2e-5);
    // where the eye stands above the surface, and where the tangent says nothing
    const zonal::Receiver above{receiver.position, receiver.normal, receiver.normal};
    CHECK(relative(zonal::gather<5, 3>(cache, above, table), zonal::gather<5, 3>(cache, above, plastic.table)) < 2e-5);
  }
}

TEST_CASE("anisotropic: a receiver that is the same about its normal takes light of any material") {
  Random random(85);
  for (int trial = 0; trial < 5; ++trial) {
    std::vector<VirtualLight> lights;
    for (int i = 0; i < 19; ++i) lights.push_back(i % 3 == 0 ? anisotropic_light(random) : random_light(random));
    const zonal::HvlCache<3> cache(lights);
    const zonal::Receiver receiver = random_receiver(random);
    const auto lambert = materials().red.table.with_cosine<5>(1);
    CAPTURE(trial);
    CHECK(relative(zonal::gather<5, 3>(cache, receiver, zonal::about_axis(lambert)),
                   zonal::gather<5, 3>(cache, receiver, lambert)) < 2e-6);
  }
}
