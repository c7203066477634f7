// The gather against sums over its definition in double, from the slow references; against closed forms; and where
// nothing may arrive.
#include <zonal/basis/polynomial.hpp>
#include <zonal/gather/hvl.hpp>
#include <zonal/lobe/cap_reference.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "support.hpp"

using namespace gather_test;

namespace {

using zonal::Horizon;
using zonal::VirtualLight;

/// A receiver and what it is made of.
struct Surface : zonal::Receiver {
  const zonal::MaterialTable* material;
};

Surface random_receiver(Random& random) {
  Surface receiver;
  receiver.position = 0.5F * random.direction();
  receiver.normal = random.direction();
  receiver.outgoing = random.direction_above(receiver.normal);
  receiver.material = &random.one_of({&materials().plastic, &materials().metal}).table;
  return receiver;
}

template <int N, int NE, Horizon method = Horizon::smoothstep>
glm::vec3 gather_at(const zonal::HvlCache<NE>& cache, const Surface& surface) {
  return zonal::gather<N, NE, method>(cache, surface, *surface.material);
}

/// The same of lights whose materials are known to be isotropic: at 21 bands the kernel for others takes long to
/// compile.
template <int N, int NE>
glm::vec3 gather_isotropic_at(const zonal::HvlCache<NE>& cache, const Surface& surface) {
  const auto coefficients = surface.material->with_cosine<N>(glm::dot(surface.normal, surface.outgoing));
  const auto frame = zonal::detail::frame_of<typename zonal::HvlCache<NE>::Lanes>(surface);
  return (glm::max)(zonal::detail::gather_from<N, NE, Horizon::smoothstep>(cache, frame, coefficients, {}),
                    glm::vec3(0));
}

/// The formula at the head of hvl.hpp, light by light, in double and with all N^2 coefficients.
template <int N, int NE, Horizon method>
glm::dvec3 gather_by_definition(const std::vector<VirtualLight>& lights, const Surface& receiver) {
  const glm::dvec3 n(receiver.normal), out(receiver.outgoing);
  const auto material = receiver.material->with_cosine<N>(glm::dot(receiver.normal, receiver.outgoing));
  glm::dvec3 total(0);
  for (const VirtualLight& light : lights) {
    const glm::dvec3 to_light = glm::dvec3(light.position) - glm::dvec3(receiver.position), normal(light.normal);
    const double distance = glm::length(to_light);
    const glm::dvec3 w = to_light / distance;
    const double sine = std::min(1.0, double(light.radius) / distance), cosine = std::sqrt(1 - sine * sine);

    const auto emission = light.material->without_cosine<NE>(glm::dot(light.normal, light.to_primary));
    const auto basis_at_light =
        zonal::reference::evaluate_polynomial<NE>(local(-w, normal, glm::dvec3(light.to_primary)));
    glm::dvec3 sent(0);
    for (int l = 0; l < NE; ++l) {
      for (int m = 0; m <= l; ++m) sent += glm::dvec3(emission(l, m)) * basis_at_light(l, m);
    }
    sent = glm::max(sent, glm::dvec3(0)) * glm::dvec3(light.flux) / (pi * double(light.radius) * double(light.radius));
    sent *= std::max(0.0, -glm::dot(w, normal));

    const double visible = zonal::horizon<method>(zonal::SphericalCap<double>{cosine, sine}, glm::dot(w, n));
    const auto cap = zonal::reference::project_cap_legendre<N>(static_cast<long double>(cosine));
    const auto basis = zonal::reference::evaluate_polynomial<N>(local(w, n, out));
    for (int l = 0; l < N; ++l) {
      const double a = std::sqrt(4 * pi / (2 * l + 1)) * static_cast<double>(cap[l]);
      for (int m = 0; m <= l; ++m) total += a * basis(l, m) * glm::dvec3(material(l, m)) * sent * visible;
    }
  }
  return glm::max(total, glm::dvec3(0));
}

template <int N, int NE, Horizon method>
void check_against_definition(Met& met) {
  Random random(5);
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<VirtualLight> lights;
    for (int i = 0; i < trial; ++i) lights.push_back(random_light(random));
    const zonal::HvlCache<NE> cache(lights);
    REQUIRE(cache.size() == trial);
    const Surface receiver = random_receiver(random);
    const glm::dvec3 expected = gather_by_definition<N, NE, method>(lights, receiver);
    const glm::dvec3 got(gather_at<N, NE, method>(cache, receiver));
    for (int c = 0; c < 3; ++c) {
      CAPTURE(N, NE, static_cast<int>(method), trial, c, got[c], expected[c]);
      REQUIRE(met.meet(std::abs(got[c] - expected[c]) / std::max(expected[0] + expected[1] + expected[2], 1e-3)));
    }
  }
}

/// A light that shines straight at the origin from `position`, whose emitted radiance there is `radiance`.
VirtualLight facing_light(const glm::vec3& position, float radius, float radiance) {
  VirtualLight light;
  light.position = position;
  light.normal = light.to_primary = -glm::normalize(position);
  light.radius = radius;
  light.flux = glm::vec3(radiance * radius * radius * float(pi * pi));  // f = 1/pi
  light.material = &materials().white.table;
  return light;
}

template <int NE = 1>
glm::vec3 gather_one(const VirtualLight& light, const Surface& receiver) {
  return gather_at<5, NE>(zonal::HvlCache<NE>({light}), receiver);
}

const Surface& receiver_on_the_floor() {
  static const Surface receiver{{{0, 0, 0}, {0, 0, 1}, {0.6F, 0, 0.8F}}, &materials().red.table};
  return receiver;
}

/// Whether two colours differ by no more than that part of the second's sum.
bool is_near(const glm::vec3& got, const glm::vec3& expected, float part) {
  const glm::vec3 difference = glm::abs(got - expected);
  return std::max({difference.x, difference.y, difference.z}) <= part * (expected.x + expected.y + expected.z);
}

template <int N, int NE, Horizon method>
void check_zonal(const zonal::MaterialTable& lambert) {
  Random random(15);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<VirtualLight> lights = random_lights(random, 1 + trial);
    const Surface receiver = random_receiver(random);
    const auto coefficients = lambert.with_cosine<N>(glm::dot(receiver.normal, receiver.outgoing));
    const auto zonal = zonal::about_axis(coefficients);
    const auto at = [&](const auto& f) {
      return zonal::gather<N, NE, method>(zonal::HvlCache<NE>(lights), receiver, f);
    };
    CAPTURE(N, NE, trial);
    REQUIRE(is_near(at(zonal), at(coefficients), 1e-6F));
  }
}

}  // namespace

TEST_CASE("gather: is its definition, at each number of bands and for any number of lights") {
  Met met("gather", "gather");
  check_against_definition<1, 1, Horizon::none>(met);
  check_against_definition<3, 3, Horizon::none>(met);
  check_against_definition<5, 3, Horizon::smoothstep>(met);
  check_against_definition<5, 1, Horizon::exact>(met);
  check_against_definition<9, 5, Horizon::smoothstep>(met);
  check_against_definition<10, 2, Horizon::exact>(met);
  CHECK_WORST_MET(met);
}

TEST_CASE("gather: a white floor under a sphere reflects E / pi = L sin^2 a cos d") {
  for (const float distance : {1.5F, 3.0F, 100.0F}) {
    for (const float elevation : {0.3F, 0.9F, 1.5F}) {
      const float sine = std::min(1 / distance, 0.9F * std::sin(elevation));  // wholly above the horizon
      const glm::vec3 direction(std::cos(elevation), 0, std::sin(elevation));
      const VirtualLight light = facing_light(distance * direction, sine * distance, 5);
      Surface receiver = receiver_on_the_floor();
      receiver.material = &materials().white.table;
      const float expected = 5 * sine * sine * std::sin(elevation);
      const float got = gather_isotropic_at<21, 1>(zonal::HvlCache<1>({light}), receiver).x;
      CAPTURE(distance, elevation, sine);
      CHECK(std::abs(got - expected) <= 5 * sine * sine * 2e-3F);  // 21 bands of the clamped cosine
    }
  }
}

TEST_CASE("gather: of a material that is the same about the normal N coefficients are all") {
  check_zonal<1, 1, Horizon::none>(materials().red.table);
  check_zonal<2, 1, Horizon::exact>(materials().red.table);
  check_zonal<5, 1, Horizon::smoothstep>(materials().red.table);
  check_zonal<5, 3, Horizon::smoothstep>(materials().red.table);
}

TEST_CASE("gather: what N coefficients about the normal give is the mean over all directions to the eye of one tilt") {
  Random random(16);
  for (int trial = 0; trial < 10; ++trial) {
    const zonal::HvlCache<3> cache(random_lights(random, 7));
    Surface receiver = random_receiver(random);
    const auto f = receiver.material->with_cosine<5>(glm::dot(receiver.normal, receiver.outgoing));
    const auto frame = [&](const Surface& r) { return zonal::detail::frame_of<zonal::HvlCache<3>::Lanes>(r); };
    const auto at = [&](const Surface& r, const auto& c) {  // before negative sums are cut
      return zonal::detail::gather_from<5, 3, Horizon::none>(cache, frame(r), c, {});
    };
    const glm::vec3 expected = at(receiver, zonal::about_axis(f));
    glm::vec3 sum(0);
    const int turns = 9;  // exact up to |m| = 8
    for (int i = 0; i < turns; ++i) {
      Surface turned = receiver;
      turned.outgoing =
          glm::mat3(glm::rotate(glm::mat4(1), 2 * float(pi) / turns * float(i), receiver.normal)) * receiver.outgoing;
      sum += at(turned, f) / float(turns);
    }
    CAPTURE(trial);
    CHECK(is_near(sum, expected, 1e-5F));
  }
}

TEST_CASE("gather: emission bands beyond the first change nothing for diffuse lights") {
  Random random(6);
  for (int i = 0; i < 100; ++i) {
    VirtualLight light = random_light(random);
    light.material = &materials().red.table;
    const Surface receiver = random_receiver(random);
    const glm::vec3 one = gather_one<1>(light, receiver), five = gather_one<5>(light, receiver);
    CAPTURE(i);
    for (int c = 0; c < 3; ++c) CHECK(std::abs(one[c] - five[c]) <= 1e-5F * one[c]);
  }
}

TEST_CASE("gather: lights without power or material, and lights that are not lit, are exactly nothing") {
  const VirtualLight good = facing_light({0, 0, 2}, 0.5F, 3);
  REQUIRE(gather_one(good, receiver_on_the_floor()).x > 0);
  const auto is_nothing = [&](auto change) {
    VirtualLight light = good;
    change(light);
    const zonal::HvlCache<1> cache({light, light, light});
    return cache.size() == 0 && gather_at<5, 1>(cache, receiver_on_the_floor()) == glm::vec3(0);
  };
  CHECK(is_nothing([](VirtualLight& light) { light.flux = glm::vec3(0); }));
  CHECK(is_nothing([](VirtualLight& light) { light.material = nullptr; }));
  CHECK(is_nothing([](VirtualLight& light) { light.to_primary = -light.normal; }));
  CHECK(gather_at<5, 3>(zonal::HvlCache<3>(), receiver_on_the_floor()) == glm::vec3(0));

  VirtualLight black = good;
  black.material = &materials().black.table;
  CHECK(gather_one<3>(black, receiver_on_the_floor()) == glm::vec3(0));
}

TEST_CASE("gather: lights below the receiver's horizon, or facing away, are exactly nothing") {
  const auto below = facing_light({0.1F, 0, -2}, 0.5F, 3);
  CHECK(gather_one(below, receiver_on_the_floor()) == glm::vec3(0));
  CHECK(gather_at<5, 1, Horizon::exact>(zonal::HvlCache<1>({below}), receiver_on_the_floor()) == glm::vec3(0));
  VirtualLight turned = facing_light({0, 0, 2}, 0.5F, 3);
  turned.normal = turned.to_primary = glm::vec3(0, 0, 1);
  CHECK(gather_one(turned, receiver_on_the_floor()) == glm::vec3(0));
}

TEST_CASE("gather: a light centred on the horizon is whole without the horizon's factor, and half of it with one") {
  const float half_angle = 1;
  const VirtualLight light = facing_light({3, 0, 0}, 3 * std::sin(half_angle), 5);
  Surface receiver = receiver_on_the_floor();
  receiver.material = &materials().white.table;
  // E / pi of the upper half of the cap
  const float exact = 5 * (half_angle - std::sin(half_angle) * std::cos(half_angle)) / float(pi);
  CHECK(gather_at<3, 3, Horizon::none>(zonal::HvlCache<3>({light}), receiver).x ==
        Catch::Approx(exact).epsilon(0.03));  // 3 bands
  CHECK(gather_at<5, 1>(zonal::HvlCache<1>({light}), receiver).x == Catch::Approx(0.5F * exact).epsilon(0.02));
}

TEST_CASE("gather: inside a light's sphere it is a hemisphere, without a step at the surface") {
  const auto at = [](float distance) {
    return gather_one(facing_light({0, 0, distance}, 1, 3), receiver_on_the_floor()).x;
  };
  CHECK(std::abs(at(1 - 1e-6F) - at(1 + 1e-6F)) <= 5e-3F * at(1));  // of order sqrt(1e-6)
  for (const float distance : {0.9F, 0.5F, 1e-3F, 1e-6F}) {
    CAPTURE(distance);
    CHECK(std::abs(at(distance) - at(1)) <= 1e-6F * at(1));
  }
  VirtualLight centred = facing_light({0, 0, 1}, 1, 3);
  centred.position = receiver_on_the_floor().position;
  CHECK(gather_one(centred, receiver_on_the_floor()) == glm::vec3(0));
}

TEST_CASE("gather: tiny, huge, near and far lights give finite light") {
  for (const float radius : {1e-12F, 1e-6F, 1.0F, 1e6F}) {
    for (const float distance : {1e-12F, 1e-6F, 1.0F, 1e6F, 1e12F}) {
      VirtualLight light = facing_light(glm::vec3(0, 0.6F, 0.8F) * distance, radius, 3);
      light.material = &materials().plastic.table;
      for (const glm::vec3& radiance :
           {gather_one<3>(light, receiver_on_the_floor()),
            gather_at<5, 3, Horizon::exact>(zonal::HvlCache<3>({light}), receiver_on_the_floor())}) {
        CAPTURE(radius, distance, radiance.x);
        CHECK((std::isfinite(radiance.x) && std::isfinite(radiance.y) && std::isfinite(radiance.z)));
      }
    }
  }
}

TEST_CASE("gather: looking along the normal, or lit along it, no frame is missing") {
  VirtualLight light = facing_light({1, 1, 2}, 0.5F, 3);
  light.material = &materials().plastic.table;
  Surface receiver = receiver_on_the_floor();
  receiver.material = &materials().plastic.table;
  receiver.outgoing = {0, 0, 1};
  const glm::vec3 along = gather_one<3>(light, receiver);
  receiver.outgoing = glm::normalize(glm::vec3(1e-4F, 0, 1));
  const glm::vec3 beside = gather_one<3>(light, receiver);
  CHECK(along.x > 0);
  CHECK(std::abs(along.x - beside.x) < 1e-3F * along.x);
}

TEST_CASE("gather: turning everything turns nothing") {
  Random random(8);
  for (int trial = 0; trial < 50; ++trial) {
    const glm::mat3 turn(glm::rotate(glm::mat4(1), random.uniform(0, 6), random.direction()));
    std::vector<VirtualLight> lights;
    for (int i = 0; i < 7; ++i) lights.push_back(random_light(random));
    Surface receiver = random_receiver(random);
    const glm::vec3 before = gather_at<5, 3>(zonal::HvlCache<3>(lights), receiver);
    for (VirtualLight& light : lights) {
      light.position = turn * light.position;
      light.normal = turn * light.normal;
      light.to_primary = turn * light.to_primary;
    }
    receiver.position = turn * receiver.position;
    receiver.normal = turn * receiver.normal;
    receiver.outgoing = turn * receiver.outgoing;
    const glm::vec3 after = gather_at<5, 3>(zonal::HvlCache<3>(lights), receiver);
    CAPTURE(trial);
    for (int c = 0; c < 3; ++c) CHECK(std::abs(after[c] - before[c]) <= 3e-5F * (before.x + before.y + before.z));
  }
}
