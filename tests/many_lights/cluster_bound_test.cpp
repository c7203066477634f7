// The bound on how far a drawn light strays, against the variance that the lights themselves have.
#include <zonal/many_lights/hvl_tree.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include "../catch.hpp"
#include "patches.hpp"

using namespace many_lights_test;

namespace {

struct Tightness {
  std::vector<double> ratios;  // of bound to truth, of clusters that look small
  int known = 0, unknown = 0;

  double median() {
    std::nth_element(ratios.begin(), ratios.begin() + std::ptrdiff_t(ratios.size() / 2), ratios.end());
    return ratios[ratios.size() / 2];
  }
};

/// What the lights of a cluster add to a receiver, and how far one drawn of them, W / w_j times its part at the
/// probability w_j / W, strays from that.
template <int NE>
void mean_and_deviation(const zonal::LightTree<NE>& tree, const zonal::LightNode<NE>& node,
                        const std::vector<glm::dvec3>& parts, glm::dvec3& mean, glm::dvec3& deviation) {
  const double weight = tree.weight_before(node.last) - tree.weight_before(node.first);
  glm::dvec3 square(0);
  mean = glm::dvec3(0);
  for (int place = node.first; place < node.last; ++place) {
    const double own = tree.weight_before(place + 1) - tree.weight_before(place);
    const glm::dvec3 part = parts[std::size_t(tree.light_at(place))];
    mean += part;
    square += part * part * (weight / own);
  }
  deviation = glm::sqrt((glm::max)(square - mean * mean, glm::dvec3(0)));
}

/// All nodes of trees over random patches, seen from random receivers: the deviation is within the bound.
template <int N, int NE, zonal::Horizon method>
Tightness check_bounds(unsigned seed) {
  Random random(seed);
  Tightness tightness;
  for (int trial = 0; trial < 400; ++trial) {
    const zonal::Receiver receiver = random_receiver(random);
    const float distance = random.uniform(0.2F, 4.0F), size = distance * std::pow(10.0F, random.uniform(-3.0F, 0.2F));
    const zonal::HvlCache<NE> lights(random_patch(random, 40, receiver.position + distance * random.direction(), size));
    const zonal::HvlTree<NE> tree(lights);
    const auto material =
        reflected_by<N>(random.one_of({&materials().plastic, &materials().metal, &materials().red}), receiver);
    const auto parts = parts_of<N, NE, method>(lights, receiver, material);
    const auto bounded = zonal::bounded_receiver(receiver, material);
    for (const auto& node : tree.tree().nodes()) {
      const auto bound = zonal::bound_cluster<N, NE, method>(node, bounded);
      if (bound.deviation[0] >= zonal::detail::unknown_deviation) {
        ++tightness.unknown;
        continue;
      }
      ++tightness.known;
      glm::dvec3 mean, deviations;
      mean_and_deviation(tree.tree(), node, parts, mean, deviations);
      for (int c = 0; c < 3; ++c) {
        const double deviation = deviations[c];
        CAPTURE(N, NE, static_cast<int>(method), trial, c, node.first, node.last, deviation, bound.deviation[c]);
        REQUIRE(deviation <= double(bound.deviation[c]) * (1 + 1e-4) + 1e-5 * std::abs(mean[c]));
        if (node.size() > 4 && deviation > 1e-3 * std::abs(mean[c])) {
          tightness.ratios.push_back(double(bound.deviation[c]) / deviation);
        }
      }
    }
  }
  return tightness;
}

}  // namespace

TEST_CASE("cluster bound: no cluster strays farther than its bound, and half of them a sixth of it or more") {
  Tightness smoothstep = check_bounds<5, 3, zonal::Horizon::smoothstep>(11);
  CHECK(smoothstep.known > 20000);
  CHECK(smoothstep.unknown > 100);
  CHECK(smoothstep.median() < 6);
  Tightness diffuse = check_bounds<5, 1, zonal::Horizon::smoothstep>(12);
  CHECK(diffuse.median() < 6);
  Tightness none = check_bounds<3, 3, zonal::Horizon::none>(13);
  CHECK(none.median() < 6);
}

TEST_CASE("cluster bound: one bound holds for all receivers of a box whose normals are turned up to an angle") {
  Random random(15);
  int known = 0;
  for (int trial = 0; trial < 400; ++trial) {
    zonal::Receiver receiver = random_receiver(random);
    const float distance = random.uniform(0.2F, 4.0F), size = distance * std::pow(10.0F, random.uniform(-2.0F, 0.0F));
    const zonal::HvlCache<3> lights(random_patch(random, 20, receiver.position + distance * random.direction(), size));
    const zonal::HvlTree<3> tree(lights);
    const bool is_clay = trial % 2 == 0;
    const auto material = reflected_by<5>(is_clay ? materials().red : materials().plastic, receiver);
    const float tilt = trial % 3 == 0 ? 0 : random.uniform(0, 0.5F), width = distance * random.uniform(0, 0.4F);
    const glm::vec3 half = width * glm::vec3(random(), random(), random() * random());
    const auto alone =
        is_clay ? zonal::bounded_receiver(receiver, about_axis(material)) : zonal::bounded_receiver(receiver, material);
    const auto all = zonal::spread_over(alone, {receiver.position - half, receiver.position + half}, tilt);
    auto kept = material;
    for (int l = 1; is_clay && l < 5; ++l) {
      for (int m = 1; m <= l; ++m) kept(l, m) = glm::vec3(0);
    }

    for (int other = 0; other < 12; ++other) {
      zonal::Receiver moved = receiver;  // corners of the box, and places within
      const glm::vec3 axis = glm::normalize(glm::cross(receiver.normal, random.direction()));
      const auto turned = [&, angle = tilt * (other < 6 ? 1.0F : random())](const glm::vec3& v) {
        return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
               axis * (glm::dot(axis, v) * (1 - std::cos(angle)));
      };
      for (int c = 0; c < 3; ++c) {
        moved.position[c] += half[c] * (other < 6 ? (random() < 0.5F ? -1.0F : 1.0F) : random.uniform(-1, 1));
      }
      moved.normal = turned(receiver.normal), moved.outgoing = turned(receiver.outgoing);
      const auto parts = parts_of<5, 3, zonal::Horizon::smoothstep>(lights, moved, kept);
      for (const auto& node : tree.tree().nodes()) {
        const auto bound = zonal::bound_cluster<5, 3, zonal::Horizon::smoothstep>(node, all);
        if (bound.deviation[0] >= zonal::detail::unknown_deviation) continue;
        ++known;
        glm::dvec3 mean, deviation;
        mean_and_deviation(tree.tree(), node, parts, mean, deviation);
        for (int c = 0; c < 3; ++c) {
          CAPTURE(trial, other, c, tilt, width / distance, node.first, node.last, deviation[c], bound.deviation[c]);
          REQUIRE(deviation[c] <= double(bound.deviation[c]) * (1 + 1e-4) + 1e-5 * std::abs(mean[c]));
        }
      }
    }
  }
  CHECK(known > 30000);
}

TEST_CASE("cluster bound: the nearest place of a box decides, where lights lie one behind the other") {
  std::vector<zonal::VirtualLight> lights(2);
  for (std::size_t i = 0; i < 2; ++i) {
    lights[i].position = {0, 0, i == 0 ? 1.98F : 2.02F};
    lights[i].normal = lights[i].to_primary = {0, 0, -1};
    lights[i].radius = 1e-3F;
    lights[i].flux = glm::vec3(1);
    gather_test::set_material(lights[i], materials().white);
  }
  const zonal::HvlCache<1> cache(lights);
  const zonal::HvlTree<1> tree(cache);
  zonal::Receiver receiver{{0, 0, 0}, {0, 0, 1}, {0.6F, 0, 0.8F}};
  const auto material = reflected_by<5>(materials().white, receiver);
  const auto bound = zonal::bound_cluster<5, 1, zonal::Horizon::none>(
      tree.tree().node(0),
      zonal::spread_over(zonal::bounded_receiver(receiver, material), {{0, 0, -0.6F}, {0, 0, 0.6F}}, 0));
  receiver.position.z = 0.6F;
  glm::dvec3 mean, deviation;
  const auto parts = parts_of<5, 1, zonal::Horizon::none>(cache, receiver, material);
  mean_and_deviation(tree.tree(), tree.tree().node(0), parts, mean, deviation);
  CHECK(deviation[0] <= double(bound.deviation[0]));
  CHECK(double(bound.deviation[0]) <= 2 * deviation[0]);  // from the middle, the box could lie aside
}

TEST_CASE("cluster bound: a material that is the same all about the normal has the bound that it has with all orders") {
  Random random(16);
  for (int trial = 0; trial < 200; ++trial) {
    const zonal::Receiver receiver = random_receiver(random);
    const zonal::HvlCache<1> lights(random_patch(random, 8, receiver.position + 2.0F * random.direction(), 0.2F));
    const zonal::HvlTree<1> tree(lights);
    const auto material = about_axis(reflected_by<5>(materials().red, receiver));
    auto zonal_receiver = zonal::bounded_receiver(receiver, material), any = zonal_receiver;
    any.is_zonal = false;
    const auto a = zonal::bound_cluster<5, 1, zonal::Horizon::smoothstep>(tree.tree().node(0), zonal_receiver);
    const auto b = zonal::bound_cluster<5, 1, zonal::Horizon::smoothstep>(tree.tree().node(0), any);
    for (int c = 0; c < 3; ++c) {
      CHECK(a.deviation[c] == Catch::Approx(b.deviation[c]).epsilon(1e-4).margin(1e-7));
      CHECK(a.radiance[c] == Catch::Approx(b.radiance[c]).epsilon(1e-4).margin(1e-7));
    }
  }
}

TEST_CASE("cluster bound: a cluster whose lights may be hidden strays by no more, whichever are") {
  Random random(14);
  for (int trial = 0; trial < 200; ++trial) {
    const zonal::Receiver receiver = random_receiver(random);
    const float distance = random.uniform(0.5F, 4.0F);
    const zonal::HvlCache<1> lights(
        random_patch(random, 16, receiver.position + distance * random.direction(), 0.2F * distance));
    const zonal::HvlTree<1> tree(lights);
    const auto material = reflected_by<5>(materials().plastic, receiver);
    const auto parts = parts_of<5, 1, zonal::Horizon::smoothstep>(lights, receiver, material);
    const auto& root = tree.tree().nodes()[0];
    const auto bound =
        zonal::bound_cluster<5, 1, zonal::Horizon::smoothstep>(root, zonal::bounded_receiver(receiver, material), true);
    for (int hidden = 0; hidden < 8; ++hidden) {
      std::vector<glm::dvec3> seen = parts;
      for (glm::dvec3& part : seen) part *= random() < 0.5F ? 0.0 : 1.0;
      glm::dvec3 mean, deviation;
      mean_and_deviation(tree.tree(), root, seen, mean, deviation);
      for (int c = 0; c < 3; ++c) {
        CAPTURE(trial, hidden, c);
        REQUIRE(deviation[c] <= double(bound.deviation[c]) * (1 + 1e-4));
      }
    }
  }
}

TEST_CASE("cluster bound: a wall sends nothing along itself, and that is known of all of it at once") {
  std::vector<zonal::VirtualLight> lights(64);
  for (int i = 0; i < 64; ++i) {
    lights[std::size_t(i)].position = {float(i % 8), float(i / 8), 0};
    lights[std::size_t(i)].radius = 0.1F;
    lights[std::size_t(i)].flux = glm::vec3(1);
    gather_test::set_material(lights[std::size_t(i)], materials().white);
  }
  const zonal::HvlCache<1> cache(lights);
  const zonal::HvlTree<1> tree(cache);
  const zonal::Receiver receiver{{40, 3, 0}, {0, 0, 1}, {0.6F, 0, 0.8F}};
  const auto bound = zonal::bound_cluster<5, 1, zonal::Horizon::smoothstep>(
      tree.tree().nodes()[0], zonal::bounded_receiver(receiver, reflected_by<5>(materials().white, receiver)));
  CHECK(bound.deviation[0] <= 1e-6F * tree.tree().nodes()[0].weight);
}
