// Directions drawn from pictures: their density integrates to one, and they follow it, in every mapping.
#include <zonal/environment/sample.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "../drawn_directions.hpp"

namespace {

using drawn::Direction;

struct Shape {
  zonal::Mapping mapping;
  int width, height;
};

/// Of few and of many texels, odd and even.
constexpr Shape shapes[] = {{zonal::Mapping::equirectangular, 1, 1},    {zonal::Mapping::equirectangular, 7, 4},
                            {zonal::Mapping::equirectangular, 64, 33},  {zonal::Mapping::vertical_cross, 6, 8},
                            {zonal::Mapping::horizontal_cross, 20, 15}, {zonal::Mapping::vertical_faces, 1, 6},
                            {zonal::Mapping::horizontal_faces, 42, 7},  {zonal::Mapping::mirror_sphere, 9, 9},
                            {zonal::Mapping::mirror_sphere, 64, 64},    {zonal::Mapping::angular_map, 10, 10},
                            {zonal::Mapping::angular_map, 65, 65},      {zonal::Mapping::octahedral, 2, 2},
                            {zonal::Mapping::octahedral, 5, 5},         {zonal::Mapping::octahedral, 32, 32}};

/// Radiance from nothing to 10^4, half of the texels black, a few no radiance.
std::vector<float> texels(const Shape& shape) {
  std::mt19937 random(41);
  std::uniform_real_distribution<float> uniform(0, 1);
  std::vector<float> all(std::size_t(3 * shape.width * shape.height));
  for (std::size_t i = 0; i < all.size(); i += 3) {
    const float level = all.size() > 60 && uniform(random) < 0.5F ? 0.0F : std::pow(10.0F, 2 * uniform(random));
    for (std::size_t c = 0; c < 3; ++c) all[i + c] = level * uniform(random);
    if (all.size() > 60 && uniform(random) < 0.02F) {
      all[i] = std::numeric_limits<float>::quiet_NaN();
      all[i + 1] = -1e30F;
      all[i + 2] = std::numeric_limits<float>::infinity();
    }
  }
  all[all.size() / 6 * 3] = 1e4F;
  return all;
}

/// check(sampler, the mapping) of each shape.
template <class Check>
void for_each_sampler(const Check& check) {
  for (const Shape& shape : shapes) {
    zonal::visit_mapping(shape.mapping, [&](auto tag) {
      using Mapping = typename decltype(tag)::Type;
      INFO(Mapping::name << ", " << shape.width << " x " << shape.height);
      const std::vector<float> numbers = texels(shape);
      const auto picture = zonal::Picture<const float>::of(numbers, shape.width, shape.height);
      const Mapping mapping(shape.width, shape.height);
      check(zonal::EnvironmentSampler(zonal::Environment(picture, shape.mapping)), mapping, picture);
    });
  }
}

}  // namespace

TEST_CASE("The density of directions drawn from a picture integrates to one") {
  for_each_sampler([](const auto& sampler, const auto&, const auto&) {
    double sum = 0;
    for (const double share : drawn::shares(24, [&](const Direction& d) { return sampler.pdf(d); })) sum += share;
    CHECK(std::abs(sum - 1) <= 0.01);  // of the midpoint rule over steps
  });
}

TEST_CASE("Directions drawn from a picture follow their density: chi-squared") {
  constexpr int draws = 100000;
  Met met("environment", "EnvironmentSampler");
  for_each_sampler([&met](const auto& sampler, const auto&, const auto&) {
    std::mt19937 random(43);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<double> counts(std::size_t{drawn::cells});
    double worst_length = 0, worst_pdf = 0;
    for (int i = 0; i < draws; ++i) {
      const auto d = sampler.sample(uniform(random), uniform(random));
      ++counts[std::size_t(drawn::cell_of(d.x, d.y, d.z))];
      worst_length = std::max(worst_length, std::abs(d.x * d.x + d.y * d.y + d.z * d.z - 1));
      worst_pdf = std::max(worst_pdf, std::abs(d.pdf / sampler.pdf(Direction{d.x, d.y, d.z}) - 1));
    }
    CHECK(worst_length <= 1e-14);
    CHECK(met.meet(worst_pdf));
    std::vector<double> expected = drawn::shares(24, [&](const Direction& d) { return sampler.pdf(d); });
    for (double& share : expected) share *= draws;
    CHECK(drawn::chi_squared_probability(counts, expected) >= 1e-4);
  });
  CHECK_MET(met);
}

TEST_CASE("The density of a direction drawn from a picture is its texel's luminance over the integral of all") {
  for_each_sampler([](const auto& sampler, const auto& mapping, const auto& picture) {
    CHECK_FALSE(sampler.is_uniform());
    double brightest = 0;
    int column = 0, row = 0;
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        if (!mapping.is_whole(x, y)) continue;
        const auto c = picture.rgb(x, y);
        const double luminance = 0.2126 * double(c.r) + 0.7152 * double(c.g) + 0.0722 * double(c.b);
        if (luminance > brightest && luminance < 1e30) brightest = luminance, column = x, row = y;
      }
    }
    const auto middle = mapping.direction(column + 0.5, row + 0.5);
    CHECK(sampler.pdf(middle) * sampler.integral() == Catch::Approx(brightest).epsilon(1e-12));
  });
}

TEST_CASE("Directions of a picture that is black, or not finite, are uniform") {
  for (const float level : {0.0F, -1.0F, std::numeric_limits<float>::infinity()}) {
    const std::vector<float> numbers(std::size_t{3 * 8 * 4}, level);
    const auto picture = zonal::Picture<const float>::of(numbers, 8, 4);
    const zonal::EnvironmentSampler sampler(zonal::Environment(picture, zonal::Mapping::equirectangular));
    INFO(level);
    CHECK(sampler.is_uniform());
    CHECK(sampler.pdf(Direction{0, 0.6, 0.8}) == Catch::Approx(1 / (4 * drawn::pi)).epsilon(1e-12));
    CHECK(sampler.sample(0.5, 0.5).pdf == Catch::Approx(1 / (4 * drawn::pi)).epsilon(1e-12));
  }
}

TEST_CASE("Directions drawn at the ends of the unit square come of lit texels") {
  for_each_sampler([](const auto& sampler, const auto&, const auto&) {
    for (const double u : {0.0, 0x1p-53, 0.5, 1 - 0x1p-53, 1.0}) {
      for (const double v : {0.0, 0x1p-53, 0.5, 1 - 0x1p-53, 1.0}) {
        const auto d = sampler.sample(u, v);
        INFO("u " << u << ", v " << v << ": " << d.x << ", " << d.y << ", " << d.z);
        CHECK(d.pdf > 0);
        CHECK(std::abs(d.x * d.x + d.y * d.y + d.z * d.z - 1) <= 1e-14);
      }
    }
  });
}
