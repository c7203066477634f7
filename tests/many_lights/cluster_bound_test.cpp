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

/// All nodes of trees over random patches, seen from random receivers: the variance of W / w_j times the light's part,
/// at the probability w_j / W, is within the bound.
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
      const double weight = tree.tree().weight_before(node.last) - tree.tree().weight_before(node.first);
      glm::dvec3 mean(0), square(0);
      for (int place = node.first; place < node.last; ++place) {
        const double own = tree.tree().weight_before(place + 1) - tree.tree().weight_before(place);
        const glm::dvec3 part = parts[std::size_t(tree.tree().light_at(place))];
        mean += part;
        square += part * part * (weight / own);
      }
      for (int c = 0; c < 3; ++c) {
        const double deviation = std::sqrt(std::max(square[c] - mean[c] * mean[c], 0.0));
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
    const double weight = tree.tree().weight_before(root.last);
    for (int hidden = 0; hidden < 8; ++hidden) {
      glm::dvec3 mean(0), square(0);
      for (int place = 0; place < root.last; ++place) {
        if (random() < 0.5F) continue;
        const double own = tree.tree().weight_before(place + 1) - tree.tree().weight_before(place);
        const glm::dvec3 part = parts[std::size_t(tree.tree().light_at(place))];
        mean += part;
        square += part * part * (weight / own);
      }
      for (int c = 0; c < 3; ++c) {
        CAPTURE(trial, hidden, c);
        REQUIRE(std::sqrt(std::max(square[c] - mean[c] * mean[c], 0.0)) <= double(bound.deviation[c]) * (1 + 1e-4));
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
