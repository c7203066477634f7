// Cuts and draws: whether the few lights give the sum of all, in the mean and within the tolerance; the tree they come
// from; and groups of receivers.
#include <zonal/many_lights/hvl_tree.hpp>
#include <zonal/many_lights/receiver_groups.hpp>
#include <zonal/material/anisotropic_table.hpp>
#include <zonal/material/named.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "patches.hpp"

using namespace many_lights_test;

namespace {

constexpr zonal::Horizon rule = zonal::Horizon::smoothstep;
template <int NE>
using Cut = zonal::LightCut<5, NE, rule>;

/// Lights on the six walls of a room about the origin.
std::vector<zonal::VirtualLight> room_lights(Random& random, int count) {
  std::vector<zonal::VirtualLight> lights;
  for (int i = 0; i < count; ++i) {
    zonal::VirtualLight light;
    const int axis = i % 3;
    const float side = i % 2 == 0 ? 1.0F : -1.0F;
    for (int k = 0; k < 3; ++k) light.position[k] = k == axis ? 2 * side : random.uniform(-2, 2);
    light.normal = glm::vec3(0);
    light.normal[axis] = -side;
    light.to_primary = glm::normalize(light.normal + 0.3F * random.direction());
    light.flux = glm::vec3(1, 0.9F, 0.7F) / float(count);
    light.radius = 2.0F / std::sqrt(float(count));
    gather_test::set_material(light, axis == 0 ? materials().plastic : materials().white);
    lights.push_back(light);
  }
  return lights;
}

struct Scene {
  zonal::HvlCache<3> lights;
  zonal::HvlTree<3> tree;
  std::vector<zonal::Receiver> receivers;
  std::vector<zonal::EvenSh<5, glm::vec3>> coefficients;
  zonal::CutReceivers<5> packet;
  zonal::ReceiverBox box;

  Scene(unsigned seed, int count) {
    Random random(seed);
    lights = zonal::HvlCache<3>(room_lights(random, count));
    tree = zonal::HvlTree<3>(lights);
    zonal::BoundedReceiver<5, float> bounded[zonal::cut_receivers];
    for (auto& one : bounded) {
      const zonal::Receiver receiver{{random.uniform(-0.2F, 0.2F), random.uniform(-0.2F, 0.2F), -1.9F},
                                     {0, 0, 1},
                                     random.direction_above({0, 0, 1})};
      receivers.push_back(receiver);
      box.add(receiver.position, receiver.normal);
      coefficients.push_back(reflected_by<5>(materials().plastic, receiver));
      one = zonal::bounded_receiver(receiver, coefficients.back());
    }
    packet = zonal::as_packet(bounded);
  }
  template <class Lights>
  glm::dvec3 gather(const Lights& from, std::size_t i) const {
    return glm::dvec3(zonal::gather<5, 3, rule>(from, receivers[i], coefficients[i]));
  }
};

double square(const glm::dvec3& v) { return glm::dot(v, v); }

}  // namespace

TEST_CASE("light tree: holds each light once, and of each cluster the means and how far its lights reach") {
  Random random(21);
  for (const int count : {1, 2, 3, 5, 64, 1000, 70000}) {
    const zonal::HvlCache<1> lights(room_lights(random, count));
    const zonal::HvlTree<1> hvl(lights);
    const zonal::LightTree<1>& tree = hvl.tree();
    std::vector<int> order(static_cast<std::size_t>(count));
    for (int place = 0; place < count; ++place) order[std::size_t(place)] = tree.light_at(place);
    std::vector<int> sorted = order;
    std::sort(sorted.begin(), sorted.end());
    std::vector<int> all(static_cast<std::size_t>(count));
    std::iota(all.begin(), all.end(), 0);
    REQUIRE(sorted == all);
    for (std::size_t n = 0; n < tree.nodes().size(); n += tree.nodes().size() / 200 + 1) {
      const auto& node = tree.nodes()[n];
      glm::dvec3 mean(0), normal(0);
      double weight = 0;
      for (int place = node.first; place < node.last; ++place) {
        const auto light = zonal::tree_light(lights.isotropic().record(tree.light_at(place)));
        const double own = double(tree.weight_of(light));
        mean += own * glm::dvec3(light.position), normal += own * glm::dvec3(light.normal), weight += own;
        for (int i = 0; i < 3; ++i) {
          REQUIRE(std::abs(light.position[i] - node.position[i]) <= node.reach[i]);
        }
        REQUIRE(glm::distance(light.normal, node.normal) <= node.normal_reach + 1e-6F);
      }
      CAPTURE(count, n, node.first, node.last);
      REQUIRE(double(node.weight) == Catch::Approx(weight).epsilon(1e-4));
      REQUIRE(glm::distance(mean / weight, glm::dvec3(node.position)) <= 1e-4);
      REQUIRE(glm::distance(normal / weight, glm::dvec3(node.normal)) <= 1e-4);
      double variance = 0;
      for (int place = node.first; place < node.last; ++place) {
        const auto light = zonal::tree_light(lights.isotropic().record(tree.light_at(place)));
        variance += double(tree.weight_of(light)) / weight * square(glm::dvec3(light.position) - mean / weight);
      }
      const double kept = double(node.covariance[0]) + double(node.covariance[3]) + double(node.covariance[5]);
      REQUIRE(kept == Catch::Approx(variance).epsilon(1e-3).margin(1e-9));
    }
  }
  CHECK(zonal::HvlTree<1>(zonal::HvlCache<1>()).size() == 0);
}

TEST_CASE("light cut: each draw gives the sum of all lights in the mean over seeds") {
  const Scene scene(22, 3000);
  Cut<3> cut(scene.tree.tree());
  zonal::CutTolerance tolerance;
  tolerance.relative = 0.2F;
  cut.find(scene.packet, tolerance);
  REQUIRE(cut.size() < 300);
  for (const int count : {1, 5}) {
    std::vector<zonal::DrawnLights<3>> draws(static_cast<std::size_t>(count));
    std::vector<glm::dvec3> sums(draws.size(), glm::dvec3(0)), squares(draws.size(), glm::dvec3(0));
    constexpr int seeds = 600;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      scene.tree.draw(cut, scene.box, seed, draws);
      for (std::size_t d = 0; d < draws.size(); ++d) {
        const glm::dvec3 drawn = scene.gather(draws[d], 0);
        sums[d] += drawn, squares[d] += drawn * drawn;
      }
    }
    const glm::dvec3 full = scene.gather(scene.lights, 0);
    for (std::size_t d = 0; d < draws.size(); ++d) {
      const glm::dvec3 mean = sums[d] / double(seeds),
                       spread = glm::sqrt((squares[d] / double(seeds) - mean * mean) / double(seeds));
      for (int c = 0; c < 3; ++c) {
        CAPTURE(count, d, c, mean[c], full[c], spread[c]);
        CHECK(std::abs(mean[c] - full[c]) <= 4.5 * spread[c]);
      }
    }
  }
}

TEST_CASE("light cut: the error is within the tolerance, and at 1 % within a factor of five of what is proved") {
  const Scene scene(23, 20000);
  Cut<3> cut(scene.tree.tree());
  std::vector<glm::dvec3> full;
  double power = 0;
  for (std::size_t i = 0; i < scene.receivers.size(); ++i) {
    full.push_back(scene.gather(scene.lights, i));
    power += square(full.back());
  }
  int before = 0;
  double error_before = 1;
  for (const float relative : {0.3F, 0.1F, 0.03F, 0.01F}) {
    zonal::CutTolerance tolerance;
    tolerance.relative = relative;
    cut.find(scene.packet, tolerance);
    double error = 0;
    constexpr int seeds = 40;
    std::vector<zonal::DrawnLights<3>> draws(1);
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      scene.tree.draw(cut, scene.box, seed, draws);
      for (std::size_t i = 0; i < full.size(); ++i) error += square(scene.gather(draws[0], i) - full[i]) / seeds;
    }
    const double measured = std::sqrt(error / power), proved = std::sqrt(cut.variance() * double(full.size()) / power);
    CAPTURE(relative, cut.size(), measured, proved);
    CHECK(measured <= double(relative));
    CHECK(proved <= 1.1 * double(relative));                  // the radiance is that of the clusters' means
    CHECK(proved <= (relative < 0.02F ? 5 : 12) * measured);  // coarse clusters are bounded coarsely
    CHECK(measured < error_before);
    CHECK(cut.size() > before);
    before = cut.size(), error_before = measured;
  }
}

TEST_CASE("light cut: one number for what a light may deviate by") {
  const Scene scene(30, 20000);
  Cut<3> cut(scene.tree.tree()), by_radiance(scene.tree.tree());
  by_radiance.find(scene.packet, {0.02F});
  zonal::CutTolerance tolerance;
  tolerance.of_one_light = float(by_radiance.greatest_variance());
  cut.find(scene.packet, tolerance);
  CHECK(cut.size() == by_radiance.size());
  CHECK(cut.variance() == by_radiance.variance());
  int before = cut.size();
  for (int halved = 0; halved < 6; ++halved) {
    tolerance.of_one_light *= 0.5F;
    cut.find(scene.packet, tolerance);
    CHECK(cut.greatest_variance() <= double(tolerance.of_one_light));
    CHECK(cut.size() > before);
    CHECK(cut.size() < 3 * before);
    before = cut.size();
  }
}

TEST_CASE("light cut: receivers count by their weight") {
  const Scene scene(31, 2000);
  zonal::BoundedReceiver<5, float> all[zonal::cut_receivers], weighted[zonal::cut_receivers];
  for (std::size_t i = 0; i < zonal::cut_receivers; ++i) {
    // Two that each stand for four, in place of four that are alike.
    all[i] = zonal::bounded_receiver(scene.receivers[i / 4], scene.coefficients[i / 4]);
    weighted[i] = zonal::weighted(all[i], i % 4 == 0 ? 4.0F : 0.0F);
  }
  Cut<3> a(scene.tree.tree()), b(scene.tree.tree());
  a.find(zonal::as_packet(all), {0.05F}), b.find(zonal::as_packet(weighted), {0.05F});
  CHECK(a.size() == b.size());
  CHECK(a.variance() == Catch::Approx(b.variance()).epsilon(1e-5));
  CHECK(a.power() == Catch::Approx(b.power()).epsilon(1e-5));
}

TEST_CASE("light cut: a tolerance of next to nothing takes every light, once") {
  const Scene scene(24, 500);
  Cut<3> cut(scene.tree.tree());
  zonal::CutTolerance tolerance;
  tolerance.relative = 1e-6F;
  cut.find(scene.packet, tolerance);
  CHECK(cut.size() >= 440);  // those that send nothing may stay together
  std::vector<zonal::DrawnLights<3>> draws(1);
  scene.tree.draw(cut, scene.box, 1, draws);
  for (std::size_t i = 0; i < scene.receivers.size(); ++i) {
    const glm::dvec3 full = scene.gather(scene.lights, i);
    CHECK(glm::distance(scene.gather(draws[0], i), full) <= 1e-5 * glm::length(full));
  }
}

TEST_CASE("light cut: is the same however often and in which order it was found, and the draws too") {
  const Scene scene(25, 2000), other(26, 2000);
  Cut<3> fresh(scene.tree.tree()), used(scene.tree.tree());
  zonal::CutTolerance tolerance;
  used.find(other.packet, tolerance);
  used.find(scene.packet, tolerance);
  fresh.find(scene.packet, tolerance);
  std::vector<std::pair<int, float>> a, b;
  fresh.draw(3, 7, [&](int, int place, float factor) { a.emplace_back(place, factor); });
  used.draw(3, 7, [&](int, int place, float factor) { b.emplace_back(place, factor); });
  CHECK(a == b);
}

TEST_CASE("drawn lights: a material of one colour is gathered as a number, times the colour") {
  Met met("many_lights", "gather");
  const Scene scene(29, 300);
  zonal::DrawnLights<3> lights;
  for (int i = 0; i < 300; ++i) lights.append(scene.lights.isotropic().record(i), scene.box, true);
  REQUIRE(lights.clear.size() > 20);
  REQUIRE(lights.across.size() > 20);
  const glm::vec3 colour(0.8F, 0.2F, 0.1F);
  for (const zonal::Receiver& receiver : scene.receivers) {
    const auto red = about_axis(reflected_by<5>(materials().red, receiver));
    zonal::Zh<5, float> number;
    for (int l = 0; l < 5; ++l) number[l] = red[l].x / colour.x;
    const glm::vec3 one = colour * zonal::gather<5, 3, rule>(lights, receiver, number);
    const glm::vec3 three = zonal::gather<5, 3, rule>(lights, receiver, red);
    const glm::vec3 all = zonal::gather<5, 3, rule>(scene.lights, receiver, reflected_by<5>(materials().red, receiver));
    for (int c = 0; c < 3; ++c) {
      CHECK(std::abs(one[c] - three[c]) <= 2e-6F * three[c]);
      CHECK(met.meet(double(std::abs(three[c] - all[c]) / all[c])));
    }
  }
  CHECK_WORST_MET(met);
}

TEST_CASE("light tree: a light that changed is drawn as the new one, and the bounds hold on") {
  Random random(27);
  Scene scene(27, 400);
  zonal::LightTree<3> tree(scene.lights.size(),
                           [&](int i) { return zonal::tree_light(scene.lights.isotropic().record(i)); });
  std::vector<zonal::TreeLight<3>> lights;
  for (int i = 0; i < tree.size(); ++i) lights.push_back(zonal::tree_light(scene.lights.isotropic().record(i)));
  for (int time = 0; time < 6; ++time) {
    std::vector<int> changed;
    for (int moved = 0; moved < 5; ++moved) {
      changed.push_back(int(random() * 400));  // one may be among them twice
      auto& light = lights[std::size_t(changed.back())];
      light.position += 0.5F * random.direction();
      light.normal = random.direction();
      if (moved % 2 == 0) light.emission = light.emission * 2.0F;
    }
    tree.update(changed, [&](int i) -> const zonal::TreeLight<3>& { return lights[std::size_t(i)]; });
  }
  double before = 0;
  for (int place = 0; place < tree.size(); ++place) {
    const auto& light = lights[std::size_t(tree.light_at(place))];
    REQUIRE(tree.weight_before(place) == Catch::Approx(before).epsilon(1e-6));
    before += double(tree.weight_of(light));
  }
  for (const auto& node : tree.nodes()) {
    glm::vec3 mean(0);
    for (int place = node.first; place < node.last; ++place) {
      const auto& light = lights[std::size_t(tree.light_at(place))];
      mean += tree.weight_of(light) / node.weight * light.position;
      for (int i = 0; i < 3; ++i) {
        REQUIRE(std::abs(light.position[i] - node.position[i]) <= node.reach[i] * 1.00001F + 1e-6F);
      }
      REQUIRE(glm::distance(light.normal, node.normal) <= node.normal_reach * 1.00001F + 1e-6F);
    }
    REQUIRE(glm::distance(mean, node.position) <= 1e-4F);
  }
}

TEST_CASE("light tree: lights that moved, in their cache and the tree, are gathered where they are now") {
  Random random(32);
  auto lights = room_lights(random, 500);
  zonal::HvlCache<3> cache(lights);
  zonal::HvlTree<3> tree(cache);
  const auto others = room_lights(random, 500);
  std::vector<int> changed;
  for (int i = 0; i < 500; i += 7) {
    lights[std::size_t(i)] = others[std::size_t(i)];
    REQUIRE(cache.replace(i, lights[std::size_t(i)]));
    changed.push_back(i);
  }
  zonal::VirtualLight black = lights[14];
  black.flux = glm::vec3(0);
  REQUIRE(cache.replace(14, black));
  tree.update(cache, changed);
  lights[14].flux = glm::vec3(1e-30F);  // a fresh cache would leave a black one out, and number the others anew
  const zonal::HvlCache<3> fresh(lights);

  const Scene scene(33, 1);  // its receivers
  Cut<3> cut(tree.tree());
  zonal::CutTolerance tolerance;
  tolerance.relative = 1e-6F;
  cut.find(scene.packet, tolerance);
  std::vector<zonal::DrawnLights<3>> draws(1);
  tree.draw(cut, scene.box, 1, draws);
  for (std::size_t i = 0; i < scene.receivers.size(); ++i) {
    const glm::dvec3 full = scene.gather(fresh, i);
    CHECK(scene.gather(cache, i) == full);
    CHECK(glm::distance(scene.gather(draws[0], i), full) <= 1e-5 * glm::length(full));
  }

  zonal::VirtualLight other_kind = lights[0];
  const zonal::AnisotropicTable anisotropic(zonal::matte({0.8F, 0.4F, 0.2F}), 3);
  other_kind.anisotropic = &anisotropic;
  CHECK(!cache.replace(0, other_kind));
  CHECK(!cache.replace(-1, lights[0]));
  CHECK(!cache.replace(500, lights[0]));
}

TEST_CASE("receiver groups: a floor stays whole, a wall and an object before it do not") {
  std::vector<zonal::GroupedReceiver> receivers;
  const auto add = [&](const glm::vec3& position, const glm::vec3& normal) {
    receivers.push_back({position, normal, int(receivers.size())});
  };
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      const float depth = 200.0F / float(60 - y);  // as a floor is seen
      add({depth * float(x - 16) * 0.01F, 0, depth}, {0, 1, 0});
    }
  }
  const auto groups = [&] {
    std::vector<int> counts;
    std::vector<bool> seen(receivers.size(), false);
    zonal::for_each_receiver_group(receivers.data(), int(receivers.size()),
                                   [&](const zonal::GroupedReceiver* group, int count) {
                                     counts.push_back(count);
                                     for (int i = 0; i < count; ++i) {
                                       REQUIRE(!seen[std::size_t(group[i].index)]);
                                       seen[std::size_t(group[i].index)] = true;
                                     }
                                   });
    REQUIRE(std::count(seen.begin(), seen.end(), true) == std::ptrdiff_t(receivers.size()));
    return counts;
  };
  CHECK(groups() == std::vector<int>{1024});
  for (int i = 0; i < 1024; ++i) {
    if (i % 32 < 9)
      receivers[std::size_t(i)] = {{0.1F * float(i % 32), 1 + 0.05F * float(i / 32), 1.5F}, {0, 0, -1}, i};
  }
  std::vector<int> counts = groups();
  std::sort(counts.begin(), counts.end());
  CHECK(counts == std::vector<int>{9 * 32, 23 * 32});
}

TEST_CASE("receiver groups: no group holds normals that are turned far from one another") {
  Random random(32);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<zonal::GroupedReceiver> receivers;
    const int count = 1 + int(random() * 600);
    for (int i = 0; i < count; ++i) receivers.push_back({random.direction(), random.direction(), i});
    int seen = 0;
    zonal::for_each_receiver_group(receivers.data(), count, [&](const zonal::GroupedReceiver* group, int size) {
      zonal::Box3 normals;
      for (int i = 0; i < size; ++i) normals.add(group[i].normal);
      for (int c = 0; c < 3; ++c) REQUIRE(normals.high[c] - normals.low[c] <= 0.45F);
      seen += size;
    });
    REQUIRE(seen == count);
  }
}

TEST_CASE("receiver parts: the largest are halved where they lie widest apart, until there are eight") {
  std::vector<zonal::GroupedReceiver> receivers;
  for (int i = 0; i < 64; ++i) receivers.push_back({{float((i * 27) % 64), 0, 0}, {0, 0, 1}, i});
  zonal::ReceiverParts<8> parts;
  parts.add(64);
  parts.halve_all(receivers.data(), 1);
  REQUIRE(parts.parts == 8);
  for (int part = 0; part < 8; ++part) {
    REQUIRE(parts.size(part) == 8);
    for (int i = parts.first[part]; i < parts.first[part + 1]; ++i) {
      CHECK(int(receivers[std::size_t(i)].position.x) / 8 == part);
    }
  }
  // By normals, where a turn by 1 rad is as wide as 100.
  for (auto& receiver : receivers) receiver.normal.x = receiver.index < 32 ? -0.4F : 0.4F;
  parts = {};
  parts.add(64);
  parts.halve_all(receivers.data(), 100);
  for (int part = 0; part < 8; ++part) {
    for (int i = parts.first[part]; i < parts.first[part + 1]; ++i) {
      CHECK((receivers[std::size_t(i)].index < 32) == (part < 4));
    }
  }
  // Of few, each by itself; parts that are there remain.
  parts = {};
  parts.add(1), parts.add(2);
  parts.halve_all(receivers.data(), 1);
  CHECK(parts.parts == 3);
  CHECK(parts.size() == 3);
}

TEST_CASE("receiver box: dark lights send nothing, and the horizon takes nothing of clear ones") {
  Random random(28);
  int dark = 0, clear = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    zonal::ReceiverBox box;
    std::vector<zonal::Receiver> receivers;
    const glm::vec3 normal = random.direction();
    for (int i = 0; i < 6; ++i) {
      receivers.push_back(random_receiver(random));
      receivers.back().position *= 0.3F;
      receivers.back().normal = glm::normalize(normal + 0.1F * random.direction());
      box.add(receivers.back().position, receivers.back().normal);
    }
    zonal::VirtualLight light = gather_test::random_light(random);
    light.radius = random.uniform(0.01F, 0.6F);
    const zonal::Standing standing = zonal::standing_of(box, light.position, light.normal, light.radius, true);
    if (standing == zonal::Standing::across) continue;
    const bool is_dark = standing == zonal::Standing::dark;
    ++(is_dark ? dark : clear);
    for (const auto& receiver : receivers) {
      const zonal::HvlCache<3> cache({light});
      const auto material = reflected_by<5>(materials().plastic, receiver);
      const glm::dvec3 whole = parts_of<5, 3, rule>(cache, receiver, material)[0];
      CAPTURE(trial, is_dark);
      REQUIRE(whole == (is_dark ? glm::dvec3(0) : parts_of<5, 3, zonal::Horizon::none>(cache, receiver, material)[0]));
    }
  }
  CHECK(dark > 800);
  CHECK(clear > 100);
}
