// Gathers of lights and at receivers of which some numbers are none, or beyond all range: what each gives is as
// docs/floating_point.md has it, and the sanitizers of the preset `debug` watch.
#include <zonal/gather/hvl.hpp>
#include <zonal/gather/hvl_zonal.hpp>
#include <zonal/gather/radius.hpp>
#include <zonal/gather/vpl.hpp>
#include <zonal/gather/vsgl.hpp>
#include <zonal/gather/vsl.hpp>
#include <zonal/material/material_table.hpp>
#include <zonal/material/zonal_table.hpp>

#include <functional>
#include <vector>

#include "../catch.hpp"
#include "numbers.hpp"

using zonal::Receiver;
using zonal::VirtualLight;

namespace {

struct Surface {
  zonal::Brdf brdf{{zonal::LambertBrdf{{0.3F, 0.5F, 0.2F}}, zonal::GgxBrdf{0.4F, zonal::DielectricFresnel{1.5F}}}};
  zonal::MaterialTable table = zonal::project_material(brdf, 3);
  zonal::ZonalTable zonal = zonal::project_zonal(brdf, 3);
};
const Surface& surface() {
  static const Surface one;
  return one;
}

struct Gather {
  const char* name;
  std::function<glm::vec3(const std::vector<VirtualLight>&, const Receiver&)> sum;
};

const std::vector<Gather>& gathers() {
  using Lights = std::vector<VirtualLight>;
  const auto half = [] { return 0.5F; };
  static const std::vector<Gather> all{
      {"hvl", [](const Lights& lights,
                 const Receiver& r) { return zonal::gather<3, 3>(zonal::HvlCache<3>(lights), r, surface().table); }},
      {"hvl of a zonal receiver",
       [](const Lights& lights, const Receiver& r) {
         const auto f = about_axis(surface().table.with_cosine<3>(0.8F));
         return zonal::gather<3, 1, zonal::Horizon::none>(zonal::HvlCache<1>(lights), r, f);
       }},
      {"zonal hvl",
       [](const Lights& lights, const Receiver& r) {
         return zonal::gather_hvl_zonal<3>(zonal::LightCache(lights), r, surface().zonal);
       }},
      {"vpl", [](const Lights& lights,
                 const Receiver& r) { return zonal::gather_vpl(zonal::LightCache(lights), r, surface().brdf, 0.5F); }},
      {"vsl",
       [half](const Lights& lights, const Receiver& r) {
         return zonal::gather_vsl(zonal::LightCache(lights), r, surface().brdf, 7, half);
       }},
      {"vsgl",
       [](const Lights& lights, const Receiver& r) {
         const auto pairs = zonal::make_gaussian_lights(lights.data(), 6, 2);
         return zonal::gather_vsgl(zonal::GaussianCache(pairs), r, surface().brdf);
       }},
      {"vsgl of 2024",
       [](const Lights& lights, const Receiver& r) {
         const auto pairs = zonal::make_gaussian_lights<zonal::Vsgl::of_2024>(lights.data(), 6, 2);
         return zonal::gather_vsgl<zonal::Vsgl::of_2024>(zonal::GaussianCache(pairs), r, surface().brdf);
       }},
  };
  return all;
}

/// A map of 6 x 6 texels of a wall before the receiver.
std::vector<VirtualLight> wall() {
  std::vector<VirtualLight> lights(36);
  for (int i = 0; i < 36; ++i) {
    VirtualLight& light = lights[std::size_t(i)];
    light.position = {0.3F * float(i % 6) - 0.7F, 0.3F * float(i / 6) - 0.8F, 2};
    light.normal = {0, 0, -1};
    light.to_primary = {0.6F, 0, -0.8F};
    light.flux = {1, 0.9F, 0.7F};
    light.primary_distance = 3;
    light.radius = 0.2F;
    light.material = &surface().table;
    light.brdf = &surface().brdf;
  }
  return lights;
}
const Receiver floor_point{{0, 0, 0}, {0, 0, 1}, {0.6F, 0, 0.8F}};

void check_same(const glm::vec3& a, const glm::vec3& b) {
  for (int c = 0; c < 3; ++c) CHECK(double(a[c]) == Catch::Approx(double(b[c])).epsilon(2e-6));
}

constexpr std::size_t bad = 13;  // in the middle of a packet

}  // namespace

TEST_CASE("hostile: of a light that is no number a gather is none, or what it is without that light") {
  using Field = glm::vec3 VirtualLight::*;
  for (const Gather& gather : gathers()) {
    auto without = wall();
    without[bad].flux = glm::vec3(0);
    const glm::vec3 rest = gather.sum(without, floor_point);
    REQUIRE((rest.x > 0 && rest.y > 0 && rest.z > 0));
    const auto check = [&](const std::vector<VirtualLight>& lights) {
      const glm::vec3 rgb = gather.sum(lights, floor_point);
      CAPTURE(rgb.x, rgb.y, rgb.z);
      for (int c = 0; c < 3; ++c) {
        CHECK((std::isnan(rgb[c]) || double(rgb[c]) == Catch::Approx(double(rest[c])).epsilon(2e-6)));
      }
    };
    for (const Field field : {&VirtualLight::position, &VirtualLight::normal, &VirtualLight::to_primary}) {
      for (const glm::vec3& v : hostile::vectors()) {
        CAPTURE(gather.name, field == &VirtualLight::position, field == &VirtualLight::normal, v.x, v.y, v.z);
        auto lights = wall();
        lights[bad].*field = v;
        if (!hostile::is_number(v)) {
          check(lights);
        } else {
          gather.sum(lights, floor_point);
        }
      }
      // No direction at all: it sends nothing.
      if (field == &VirtualLight::position) continue;
      auto lights = wall();
      lights[bad].*field = glm::vec3(0);
      check_same(gather.sum(lights, floor_point), rest);
    }
    for (const float x : hostile::numbers<float>()) {
      CAPTURE(gather.name, x);
      auto lights = wall();
      lights[bad].flux.y = x;
      const glm::vec3 rgb = gather.sum(lights, floor_point);
      CHECK((std::isfinite(rgb.y) || !(std::abs(x) < 1e30F)));
      lights = wall();
      lights[bad].radius = x;
      const float lit = gather.sum(lights, floor_point).x;  // not all ask for it
      CHECK((std::isfinite(lit) || !(std::abs(x) <= 1e18F)));
    }
  }
}

TEST_CASE("hostile: at a receiver that is no number a gather is none or black") {
  using Field = glm::vec3 Receiver::*;
  const auto lights = wall();
  for (const Gather& gather : gathers()) {
    const glm::vec3 usual = gather.sum(lights, floor_point);
    for (const Field field : {&Receiver::position, &Receiver::normal, &Receiver::outgoing, &Receiver::tangent}) {
      for (const glm::vec3& v : hostile::vectors()) {
        Receiver receiver = floor_point;
        receiver.*field = v;
        const glm::vec3 rgb = gather.sum(lights, receiver);
        CAPTURE(gather.name, field == &Receiver::position, field == &Receiver::normal, v.x, v.y, v.z, rgb.x, rgb.y,
                rgb.z);
        if (field == &Receiver::tangent) check_same(rgb, usual);
        if (hostile::is_number(v) || field == &Receiver::outgoing || field == &Receiver::tangent) continue;
        for (int c = 0; c < 3; ++c) CHECK((std::isnan(rgb[c]) || !(rgb[c] < 0 || 0 < rgb[c])));
      }
    }
    // What is denormal is a number like any other.
    Receiver receiver = floor_point;
    receiver.position = glm::vec3(std::numeric_limits<float>::denorm_min());
    check_same(gather.sum(lights, receiver), usual);
  }
}

TEST_CASE("hostile: radii of maps, and samples by any numbers, which are finite by those from 0 to 1") {
  for (const float x : hostile::numbers<float>()) {
    auto lights = wall();
    lights[bad].primary_distance = x;
    zonal::set_neighbour_radii(lights.data(), 6, 6, 0.5F);
    lights[bad].position.x = x;
    zonal::set_neighbour_radii(lights.data(), 6, 6, x, x);
    zonal::set_field_of_view_radii(lights.data(), 36, x, x);
    const zonal::LightCache cache(wall());
    for (const int samples : {-1, 0, 1, 5000}) {
      const glm::vec3 rgb = zonal::gather_vsl(cache, floor_point, surface().brdf, samples, [x] { return x; });
      CAPTURE(x, samples, rgb.x);
      CHECK((std::isfinite(rgb.x) || !(0 <= x && x <= 1)));
    }
  }
}
