// What probes' pictures have for each bucket.
#include <zonal/field/buckets.hpp>
#include <zonal/field/thin.hpp>

#include <limits>
#include <random>
#include <stdexcept>

#include <zonal/basis/evaluate.hpp>

#include "../catch.hpp"

namespace {

using zonal::DeadAngle;
using zonal::DirectionBuckets;
using zonal::Environment;
using zonal::Mapping;
using zonal::RadianceSample;

const glm::quat no_turn(1, 0, 0, 0);

/// A picture of a function of the direction in the positions' axes, by a camera that is turned.
template <class Radiance>
std::vector<float> picture_of(Mapping mapping, int width, int height, const glm::quat& turn, const Radiance& radiance) {
  std::vector<float> numbers(std::size_t(3 * width * height), 0.0F);
  zonal::visit_mapping(mapping, [&](auto tag) {
    const typename decltype(tag)::Type texels(width, height);
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        if (!texels.has_direction(column, row)) continue;
        const auto d = texels.direction(column + 0.5, row + 0.5);
        const auto colour = radiance(glm::dquat(turn) * glm::dvec3(d[0], d[1], d[2]));
        for (int c = 0; c < 3; ++c) numbers[std::size_t(3 * (row * width + column) + c)] = float(colour[c]);
      }
    }
  });
  return numbers;
}

Environment<float> environment_of(const std::vector<float>& numbers, int width, int height, Mapping mapping,
                                  double dead_angle = 0) {
  return {zonal::Picture<const float>(numbers.data(), width, height), mapping, dead_angle};
}

std::vector<RadianceSample> sort(const DirectionBuckets& buckets, const Environment<float>& environment,
                                 const glm::quat& turn, DeadAngle dead, zonal::PictureFaults* faults = nullptr) {
  std::vector<RadianceSample> samples(2 * buckets.size());
  zonal::PictureFaults found;
  buckets.sort(environment, turn, dead, samples.data(), 2, found);
  for (std::size_t b = 0; b < buckets.size(); ++b) samples[b] = samples[2 * b];
  samples.resize(buckets.size());
  if (faults != nullptr) *faults = found;
  return samples;
}

glm::dvec3 smooth(const glm::dvec3& d) { return {2 + d.x, 2 + d.y * d.z, 2 - d.z}; }

}  // namespace

TEST_CASE("buckets cover the sphere, turned as the camera is") {
  const glm::quat turn(0.5F, 0.5F, -0.5F, 0.5F);
  for (int m = 0; m < zonal::kMappingCount; ++m) {
    const auto mapping = static_cast<Mapping>(m);
    int width = 24, height = 24;
    if (mapping == Mapping::equirectangular) height = 12;
    if (mapping == Mapping::vertical_cross) height = 32;
    if (mapping == Mapping::horizontal_cross) width = 32;
    if (mapping == Mapping::vertical_faces) width = 4;
    if (mapping == Mapping::horizontal_faces) height = 4;
    INFO(zonal::mapping_name(mapping));
    const DirectionBuckets buckets(mapping, width, height, turn), plain(mapping, width, height, no_turn);
    double covered = 0;
    for (std::size_t b = 0; b < buckets.size(); ++b) {
      covered += double(buckets[b].solid_angle);
      REQUIRE(glm::distance(buckets[b].direction, turn * plain[b].direction) < 1e-6F);
    }
    REQUIRE(std::abs(covered / (4 * 3.14159265358979323846) - 1) < 1e-6);

    // The texels of a picture of the same kind, as they are.
    const auto numbers = picture_of(mapping, width, height, turn, smooth);
    const auto samples = sort(buckets, environment_of(numbers, width, height, mapping), turn, DeadAngle::black);
    for (std::size_t b = 0; b < buckets.size(); ++b) {
      const auto expected = smooth(glm::dvec3(buckets[b].direction));
      for (int c = 0; c < 3; ++c) REQUIRE(std::abs(double(samples[b][c]) - expected[c]) < 1e-6);
    }
  }
  REQUIRE_THROWS_AS(DirectionBuckets(Mapping::mirror_sphere, 3, 4, no_turn), std::invalid_argument);
  REQUIRE_THROWS_AS(DirectionBuckets(Mapping::octahedral, 0, 0, no_turn), std::invalid_argument);
  REQUIRE_THROWS_AS(DirectionBuckets(Mapping::octahedral, -1, -1, no_turn), std::invalid_argument);
}

TEST_CASE("pictures of other kinds and turns show the same in every bucket") {
  const DirectionBuckets buckets(Mapping::mirror_sphere, 24, 24, no_turn);
  std::mt19937 random(3);
  for (int i = 0; i < 12; ++i) {
    glm::vec4 q;
    for (int c = 0; c < 4; ++c) q[c] = std::normal_distribution<float>()(random);
    q = glm::normalize(q);
    const glm::quat turn(q.w, q.x, q.y, q.z);
    const Mapping mapping = i % 3 == 0   ? Mapping::mirror_sphere
                            : i % 3 == 1 ? Mapping::octahedral
                                         : Mapping::angular_map;
    const auto numbers = picture_of(mapping, 160, 160, turn, smooth);
    const auto samples = sort(buckets, environment_of(numbers, 160, 160, mapping), turn, DeadAngle::missing);
    for (std::size_t b = 0; b < buckets.size(); ++b) {
      INFO(zonal::mapping_name(mapping) << ", bucket " << b);
      // A bucket is 0.15 wide, more at the mirror's rim, where its texels are long; within it the mean differs from
      // the middle.
      if (buckets[b].direction.x > 0.8F) continue;
      const auto expected = smooth(glm::dvec3(buckets[b].direction));
      for (int c = 0; c < 3; ++c) REQUIRE(std::abs(double(samples[b][c]) - expected[c]) < 0.05);
    }
  }
}

TEST_CASE("a dead angle is black or missing, and what is no radiance is missing and counted") {
  const DirectionBuckets buckets(Mapping::mirror_sphere, 48, 48, no_turn);
  const double dead_angle = 0.5;
  auto numbers = picture_of(Mapping::mirror_sphere, 48, 48, no_turn, smooth);
  const auto environment = environment_of(numbers, 48, 48, Mapping::mirror_sphere, dead_angle);
  const auto black = sort(buckets, environment, no_turn, DeadAngle::black);
  const auto missing = sort(buckets, environment, no_turn, DeadAngle::missing);
  int dead = 0;
  for (std::size_t b = 0; b < buckets.size(); ++b) {
    const bool is_dead = double(buckets[b].direction.x) >= std::cos(dead_angle);
    dead += is_dead;
    REQUIRE(is_sample(missing[b]) == !is_dead);
    REQUIRE(is_sample(black[b]));
    REQUIRE((black[b] == RadianceSample{0, 0, 0}) == is_dead);
  }
  REQUIRE(dead > 50);
  // A camera that looks elsewhere has its dead angle there.
  const glm::quat turn = glm::angleAxis(1.2F, glm::vec3(0, 0, 1));
  const auto turned = sort(buckets, environment, turn, DeadAngle::missing);
  for (std::size_t b = 0; b < buckets.size(); ++b) {
    const double cosine = double(glm::dot(buckets[b].direction, turn * glm::vec3(1, 0, 0)));
    if (std::abs(std::acos(cosine) - dead_angle) < 0.2) continue;  // a bucket's width
    if (buckets[b].direction.x > 0.9F) continue;                   // long ones
    REQUIRE(is_sample(turned[b]) == (cosine < std::cos(dead_angle)));
  }

  const float bad[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1.0F};
  for (int i = 0; i < 3; ++i) numbers[std::size_t(3 * (24 * 48 + 20 + i) + i)] = bad[i];
  zonal::PictureFaults faults;
  const auto samples = sort(buckets, environment, no_turn, DeadAngle::black, &faults);
  REQUIRE((faults.not_a_number == 1 && faults.infinite == 1 && faults.negative == 1));
  for (std::size_t b = 0; b < buckets.size(); ++b) {
    const bool is_bad = buckets[b].row == 24 && buckets[b].column >= 20 && buckets[b].column < 23;
    REQUIRE(is_sample(samples[b]) == !is_bad);
  }
}

TEST_CASE("probes that tell nothing new go") {
  const DirectionBuckets buckets(Mapping::octahedral, 8, 8, no_turn);
  zonal::ProbeSequence sequence;
  // Brightness by place: constant, then a step, then a ramp of 1 % a step, then constant and far apart.
  std::vector<float> brightness;
  for (int i = 0; i < 100; ++i) {
    brightness.push_back(i < 40 ? 1.0F : i < 60 ? 2.0F : i < 80 ? 2 * std::pow(1.01F, float(i - 59)) : 4.0F);
    zonal::SequenceProbe probe;
    probe.position.x = i < 90 ? 0.01F * float(i) : float(i);
    sequence.probes.push_back(probe);
  }
  const auto load = [&](const zonal::SequenceProbe& probe, const auto& use) {
    const float bright = brightness[std::size_t(&probe - sequence.probes.data())];
    const std::vector<float> numbers(3 * 64, bright);
    use(environment_of(numbers, 8, 8, Mapping::octahedral));
  };
  const std::vector<std::size_t> expected = [] {
    std::vector<std::size_t> kept{0, 39, 40};
    // On the ramp each differs from the next by 1 %, and from the last kept by 5 % when it is six steps away.
    for (std::size_t n = 65; n < 79; n += 6) kept.push_back(n);
    for (const std::size_t n : {std::size_t{79}, std::size_t{80}}) {
      if (kept.back() != n) kept.push_back(n);
    }
    for (std::size_t n = 89; n < 100; ++n) kept.push_back(n);
    return kept;
  }();
  for (const int together : {1, 2, 7, 32, 200}) {
    const auto kept = thin(sequence, buckets, {0.05F, 0.5F}, load, zonal::SerialForEach{}, std::size_t(together));
    INFO(together);
    REQUIRE(kept == expected);
  }
  const auto all = thin(sequence, buckets, {-1, 1e9F}, load);
  REQUIRE(all.size() == 100);
}
