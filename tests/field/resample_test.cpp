// Resampled fields against fields that are known, and against the paper's steps.
#include <zonal/field/resample.hpp>
#include <zonal/field/resample_reference.hpp>

#include <cstring>

#include <zonal/grid/interpolate.hpp>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "fields.hpp"

namespace {

using namespace field_test;
using zonal::CoefficientGrid;
using zonal::GridContent;
using zonal::Mapping;
using zonal::Resampling;
using ValueGrid = CoefficientGrid<5, GridContent::values>;
using GradientGrid = CoefficientGrid<5>;
using Sums = zonal::FieldSums<5>;

const glm::quat no_turn(1, 0, 0, 0);
const glm::vec3 low(-1, -0.5F, 2), high(1, 0.5F, 3);

DirectionBuckets mirror_buckets(int size) { return {Mapping::mirror_sphere, size, size, no_turn}; }

/// Against the truth at all points of the grid.
template <class Sums, class Field>
double error_of(const Field& field, const DirectionBuckets& buckets, int probe_count, int resolution,
                const Resampling& resampling) {
  const auto probes = random_probes(probe_count, low, high, 3);
  ValueGrid grid(low, high, {2 * resolution - 1, resolution, resolution});
  REQUIRE(zonal::resample<Sums>(grid, buckets, take_samples(buckets, probes, 0.03F, field), probes, 0.03F, resampling,
                                TwoThreads{}));
  Errors errors;
  zonal::detail::for_each_point(grid.resolution(), [&](int i, int j, int k, std::size_t) {
    errors.add(grid.value({i, j, k}), true_coefficients<5>(buckets, field, grid.position({i, j, k})));
  });
  return errors.relative();
}

template <class Grid>
bool is_same(const Grid& a, const Grid& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

}  // namespace

TEST_CASE("a field of far lights comes back everywhere, by any probes") {
  Met values("field", "resample"), slopes("field", "resample, gradients");
  const DirectionBuckets buckets = mirror_buckets(40);
  const FarLight field{buckets[777].direction};
  const auto truth = true_coefficients<5>(buckets, field, {});
  double rms = 0;
  for (const glm::dvec3& c : truth) rms += glm::dot(c, c);
  rms = std::sqrt(rms);
  std::vector<std::vector<ProbePlace>> cases = {
      random_probes(300, low, high, 1), random_probes(1, low, high, 2),
      random_probes(400, low - 3.0F, high + 3.0F, 3)};       // most outside the box
  cases.push_back(std::vector<ProbePlace>(9, cases[1][0]));  // all at one place
  for (const auto& probes : cases) {
    const auto samples = take_samples(buckets, probes, 0.05F, field);
    for (const Resampling& how : {Resampling{}, Resampling::of_paper(), Resampling{0, zonal::Repair::nearest}}) {
      GradientGrid grid(low, high, {5, 7, 9});  // cells that are no cubes, points that are no whole tiles
      ValueGrid slow(low, high, {5, 7, 9});
      REQUIRE(zonal::resample<zonal::FieldSums<5, GridContent::values_and_gradients>>(grid, buckets, samples, probes,
                                                                                      0.05F, how));
      REQUIRE(zonal::resample<zonal::ReferenceFieldSums<5>>(slow, buckets, samples, probes, 0.05F, how));
      zonal::detail::for_each_point(grid.resolution(), [&](int i, int j, int k, std::size_t) {
        const auto at = grid.value_with_gradient({i, j, k});
        const auto reference = slow.value({i, j, k});
        INFO(probes.size() << " probes, point " << i << ' ' << j << ' ' << k << ", damping " << how.slope_damping);
        for (int n = 0; n < 25; ++n) {
          REQUIRE(values.meet(glm::length(glm::dvec3(at.value[n]) - truth[n]) / rms));
          REQUIRE(glm::length(glm::dvec3(reference[n]) - truth[n]) <= 1e-6 * rms);
          for (int axis = 0; axis < 3; ++axis) {  // of cells 0.125 long and more
            REQUIRE(slopes.meet(double(glm::length(at.gradient[axis][n])) * 0.125 / rms));
          }
        }
      });
    }
  }
  CHECK_MET(values);
  CHECK_MET(slopes);
}

TEST_CASE("a field of one radiance has one coefficient") {
  const DirectionBuckets buckets(Mapping::equirectangular, 32, 16, no_turn);
  const auto probes = random_probes(50, low, high, 1);
  const auto samples = take_samples(buckets, probes, 0, [](const auto&, const auto&) {
    return RadianceSample{2, 3, 4};
  });
  ValueGrid grid(low, high, {3, 4, 5});
  REQUIRE(zonal::resample<Sums>(grid, buckets, samples, probes, 0));
  zonal::detail::for_each_point(grid.resolution(), [&](int i, int j, int k, std::size_t) {
    const auto value = grid.value({i, j, k});
    REQUIRE(glm::length(value[0] - glm::vec3(2, 3, 4) * 3.5449077F) <= 2e-5F);
    for (int n = 1; n < 25; ++n) REQUIRE(glm::length(value[n]) <= 1e-5F);
  });
}

TEST_CASE("a smooth field: error falls with the grid, and the linear fit is nearer than the paper's mean") {
  const DirectionBuckets buckets = mirror_buckets(32);
  const Glow field{{0.2F, 0.1F, 4.5F}, false};
  const double linear5 = error_of<Sums>(field, buckets, 800, 5, {}),
               linear9 = error_of<Sums>(field, buckets, 800, 9, {});
  const double mean5 = error_of<Sums>(field, buckets, 800, 5, Resampling::of_paper());
  const double mean9 = error_of<Sums>(field, buckets, 800, 9, Resampling::of_paper());
  const double paper5 = error_of<zonal::ReferenceFieldSums<5>>(field, buckets, 800, 5, {});
  const double paper9 = error_of<zonal::ReferenceFieldSums<5>>(field, buckets, 800, 9, {});
  INFO("linear " << linear5 << ' ' << linear9 << ", mean " << mean5 << ' ' << mean9 << ", paper's steps " << paper5
                 << ' ' << paper9);
  REQUIRE(linear5 < 0.0125);
  REQUIRE(linear9 < 0.0085);
  REQUIRE(linear5 < 0.4 * paper5);
  REQUIRE(linear9 < 0.6 * paper9);
  // What is left of the plane beside the steps in space: where the kernel is cut off, and an interpolation.
  REQUIRE(std::abs(mean5 - paper5) < 0.1 * paper5);
  REQUIRE(std::abs(mean9 - paper9) < 0.1 * paper9);
}

TEST_CASE("a light of hard edge: the linear fit is nearer than the paper's mean") {
  const DirectionBuckets buckets = mirror_buckets(32);
  const Glow field{{0.2F, 0.1F, 4.5F}, true};
  const double linear = error_of<Sums>(field, buckets, 800, 5, {});
  const double paper = error_of<zonal::ReferenceFieldSums<5>>(field, buckets, 800, 5, {});
  INFO(linear << " linear, paper " << paper);
  REQUIRE(linear < 0.8 * paper);
}

TEST_CASE("the gradients are the field's") {
  const DirectionBuckets buckets = mirror_buckets(32);
  const Glow field{{0.2F, 0.1F, 4.5F}, false};
  const auto probes = random_probes(1600, low, high, 5);
  GradientGrid grid(low, high, {17, 9, 9});
  REQUIRE(zonal::resample<zonal::FieldSums<5, GridContent::values_and_gradients>>(
      grid, buckets, take_samples(buckets, probes, 0.03F, field), probes, 0.03F));
  Errors slopes, trilinear, hermite;
  for (const ProbePlace& place : random_probes(200, low, high, 6)) {
    const auto truth = true_coefficients<5>(buckets, field, place.position);
    trilinear.add(zonal::interpolate<zonal::Interpolation::trilinear>(grid, place.position), truth);
    hermite.add(zonal::interpolate<zonal::Interpolation::hermite>(grid, place.position), truth);
  }
  zonal::detail::for_each_point(grid.resolution(), [&](int i, int j, int k, std::size_t) {
    for (int axis = 0; axis < 3; ++axis) {
      glm::vec3 step(0);
      step[axis] = 0.01F;
      const glm::vec3 at = grid.position({i, j, k});
      const auto ahead = true_coefficients<5>(buckets, field, at + step),
                 behind = true_coefficients<5>(buckets, field, at - step);
      slopes.add(grid.value_with_gradient({i, j, k}).gradient[axis], (ahead - behind) * (1 / 0.02));
    }
  });
  INFO("slopes " << slopes.relative() << ", trilinear " << trilinear.relative() << ", hermite " << hermite.relative());
  REQUIRE(slopes.relative() < 0.175);
  REQUIRE(hermite.relative() < 0.73 * trilinear.relative());
}

TEST_CASE("rays begin on the mirror sphere") {
  const DirectionBuckets buckets = mirror_buckets(32);
  const Glow field{{0, 0, 3.6F}, false};
  const auto probes = random_probes(800, low, high, 7);
  const auto error = [&](float taken_with, float resampled_with) {
    ValueGrid grid(low, high, {17, 9, 9});
    REQUIRE(
        zonal::resample<Sums>(grid, buckets, take_samples(buckets, probes, taken_with, field), probes, resampled_with));
    Errors errors;
    zonal::detail::for_each_point(grid.resolution(), [&](int i, int j, int k, std::size_t) {
      errors.add(grid.value({i, j, k}), true_coefficients<5>(buckets, field, grid.position({i, j, k})));
    });
    return errors.relative();
  };
  const double one_point = error(0, 0), compensated = error(0.2F, 0.2F), not_compensated = error(0.2F, 0);
  INFO("one viewpoint " << one_point << ", sphere " << compensated << ", taken for one viewpoint " << not_compensated);
  REQUIRE(compensated < 1.2 * one_point);
  REQUIRE(not_compensated > 3 * one_point);
}

TEST_CASE("the bits do not depend on the threads") {
  const DirectionBuckets buckets = mirror_buckets(20);
  const auto probes = random_probes(100, low, high, 8);
  const auto samples = take_samples(buckets, probes, 0, Glow{{0, 0, 4}, true});
  GradientGrid one(low, high, {6, 7, 5}), two = one;
  using SlopeSums = zonal::FieldSums<5, GridContent::values_and_gradients>;
  REQUIRE(zonal::resample<SlopeSums>(one, buckets, samples, probes, 0, {}, zonal::SerialForEach{}));
  REQUIRE(zonal::resample<SlopeSums>(two, buckets, samples, probes, 0, {}, TwoThreads{}));
  REQUIRE(is_same(one, two));
}

TEST_CASE("what no probe shows counts as the mean of the rest, a sample that is none as not there") {
  const DirectionBuckets buckets = mirror_buckets(24);
  const auto probes = random_probes(40, low, high, 9);
  auto samples = take_samples(buckets, probes, 0, [](const auto&, const auto&) { return RadianceSample{1, 2, 3}; });
  const auto is_hidden = [&](std::size_t b) { return buckets[b].direction.x > 0.9F; };
  std::mt19937 random(10);
  for (std::size_t n = 0; n < samples.size(); ++n) {
    if (is_hidden(n / probes.size()) || random() % 4 == 0) samples[n] = zonal::kNoSample;
  }
  ValueGrid grid(low, high, {4, 4, 4});
  REQUIRE(zonal::resample<Sums>(grid, buckets, samples, probes, 0));
  for (int n = 0; n < 25; ++n) {
    const glm::vec3 expected = n == 0 ? glm::vec3(1, 2, 3) * 3.5449077F : glm::vec3(0);
    REQUIRE(glm::length(grid.value({1, 2, 3})[n] - expected) <= 1e-4F);  // of 13
  }

  const std::vector<RadianceSample> none(samples.size(), zonal::kNoSample);
  REQUIRE(!zonal::resample<Sums>(grid, buckets, none, probes, 0));
  REQUIRE(grid.value({1, 2, 3})[0] == glm::vec3(0));
  std::vector<ProbePlace> far = probes;  // of which some rays overflow, and none meets the box
  for (ProbePlace& probe : far) probe.position = {3e38F, 3e38F, -3e38F};
  REQUIRE(!zonal::resample<Sums>(grid, buckets, samples, far, 0));
}
