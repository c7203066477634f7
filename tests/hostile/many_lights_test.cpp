// Trees, cuts and groups of lights and receivers that are no numbers, or have none between them: each is there once,
// nothing outside the arrays is read, and there is an end.
#include <zonal/many_lights/hvl_tree.hpp>
#include <zonal/many_lights/receiver_groups.hpp>
#include <zonal/material/material_table.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "../catch.hpp"
#include "numbers.hpp"

namespace {

constexpr int N = 2, NE = 1;
using Record = zonal::HvlRecord<NE, float>;

/// Lights about the origin, some of whose numbers are hostile ones.
zonal::HvlCache<NE> lights(std::mt19937& random, int count, double share) {
  std::uniform_real_distribution<float> uniform(-1, 1);
  const auto numbers = hostile::numbers<float>();
  const auto is_hostile = [&] { return std::bernoulli_distribution(share)(random); };
  const auto one = [&](float usual) { return is_hostile() ? numbers[random() % numbers.size()] : usual; };
  zonal::HvlCache<NE> cache;
  for (int i = 0; i < count; ++i) {
    Record light{};
    for (int k = 0; k < 3; ++k) {
      light.position[k] = one(uniform(random));
      light.normal[k] = one(k == 2 ? 1.0F : 0.0F);
      light.tangent[k] = k == 0 ? 1.0F : 0.0F;
      light.emission[k][0] = one(0.5F + 0.4F * uniform(random));
    }
    light.radius = one(0.1F);
    cache.append(light);
  }
  return cache;
}

zonal::Receiver receiver(const glm::vec3& position) { return {position, {0, 0, -1}, {0.6F, 0, -0.8F}}; }

zonal::EvenSh<N, glm::vec3> material() {
  zonal::EvenSh<N, glm::vec3> f{};
  f(0, 0) = glm::vec3(0.9F), f(1, 0) = glm::vec3(1), f(1, 1) = glm::vec3(0.1F);
  return f;
}

/// Draws of the cut whose every place is one of the tree; how many lights they are.
int draw_all(const zonal::HvlTree<NE>& tree, const zonal::LightCut<N, NE>& cut) {
  int count = 0;
  cut.draw(3, 7, [&](int draw, int place, float factor) {
    REQUIRE((0 <= draw && draw < 3 && 0 <= place && place < tree.size()));
    REQUIRE(!(factor < 0));
    ++count;
  });
  std::vector<zonal::DrawnLights<NE>> draws(3);
  zonal::ReceiverBox box;
  box.add({0, 0, 4}, {0, 0, -1});
  tree.draw(cut, box, 7, draws);
  for (const auto& lights : draws) zonal::gather<N, NE>(lights, receiver({0, 0, 4}), material());
  return count;
}

}  // namespace

TEST_CASE("hostile: a tree holds each light once, and its cuts end, whatever the lights and receivers are") {
  std::mt19937 random(41);
  for (const int count : {1, 2, 40, 200}) {
    for (const double share : {0.0, 0.02, 0.5}) {
      CAPTURE(count, share);
      const auto cache = lights(random, count, share);
      zonal::HvlTree<NE> tree(cache);
      std::vector<int> places;
      for (int i = 0; i < count; ++i) places.push_back(tree.tree().place_of(i));
      std::sort(places.begin(), places.end());
      for (int i = 0; i < count; ++i) REQUIRE(places[std::size_t(i)] == i);
      zonal::LightCut<N, NE> cut(tree.tree());
      const auto vectors = hostile::vectors();
      for (std::size_t i = 0; i < vectors.size(); i += 5) {  // each number, on some axis
        const glm::vec3 v = vectors[i];
        const auto bounded = zonal::bounded_receiver(receiver(i % 2 == 0 ? glm::vec3(0, 0, 4) : v), material());
        zonal::BoundedReceiver<N, float> eight[zonal::cut_receivers];
        std::fill_n(eight, zonal::cut_receivers, bounded);
        for (const float tolerance : {0.1F, i % 4 == 0 ? v.x : v.y}) {
          zonal::CutTolerance asked;
          asked.relative = tolerance;
          cut.find(zonal::as_packet(eight), asked);
          REQUIRE((1 <= cut.size() && cut.size() <= count));
        }
      }
      CHECK(draw_all(tree, cut) <= 3 * count);
      tree.update(cache, {0, count / 2});
      cut.find(zonal::CutReceivers<N>{}, {});
      draw_all(tree, cut);
    }
  }
}

TEST_CASE("hostile: at a receiver that is no number a cut holds every light, as one without a bound") {
  std::mt19937 random(42);
  const auto cache = lights(random, 100, 0);
  const zonal::HvlTree<NE> tree(cache);
  zonal::LightCut<N, NE> cut(tree.tree());
  zonal::BoundedReceiver<N, float> eight[zonal::cut_receivers];
  for (auto& one : eight) one = zonal::bounded_receiver(receiver({0, 0, 40}), material());
  zonal::CutTolerance tolerance;
  tolerance.relative = 0.3F;
  cut.find(zonal::as_packet(eight), tolerance);
  CHECK(cut.size() < 50);
  eight[3] = zonal::bounded_receiver(receiver({0, std::nanf(""), 40}), material());
  cut.find(zonal::as_packet(eight), tolerance);
  CHECK(cut.size() == 100);
}

TEST_CASE("hostile: receivers are grouped and halved whatever their numbers are") {
  std::mt19937 random(43);
  const auto numbers = hostile::numbers<float>();
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<zonal::GroupedReceiver> receivers(1 + random() % 100);
    // Few numbers: two or three, on each axis of its own; the first trials of two neighbours.
    float values[6][3];
    for (auto& axis : values) {
      const float x = numbers[random() % numbers.size()];
      axis[0] = trial < 100 ? 1.0F : numbers[random() % numbers.size()];
      axis[1] = trial < 100 ? std::nextafter(axis[0], trial % 2 == 0 ? 0.0F : 2.0F) : x;
      axis[2] = trial % 3 == 0 ? axis[0] : numbers[random() % numbers.size()];
      if (trial < 100) axis[2] = axis[0];
    }
    for (std::size_t i = 0; i < receivers.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        receivers[i].position[k] = values[k][random() % 3];
        receivers[i].normal[k] = values[3 + k][random() % 3];
      }
      receivers[i].index = int(i);
    }
    std::vector<int> met(receivers.size(), 0);
    const auto meet = [&](zonal::GroupedReceiver* first, int count) {
      zonal::ReceiverParts<8> parts;
      parts.add(count);
      parts.halve_all(first, 0.1F);
      REQUIRE(parts.size() == count);
      for (int i = 0; i < count; ++i) {
        REQUIRE((0 <= first[i].index && first[i].index < int(met.size())));
        ++met[std::size_t(first[i].index)];
      }
    };
    CAPTURE(trial, receivers.size(), values[0][0], values[0][1], values[3][0], values[3][1]);
    zonal::for_each_receiver_group(receivers.data(), int(receivers.size()), meet);
    CHECK(std::count(met.begin(), met.end(), 1) == int(met.size()));
  }
}
