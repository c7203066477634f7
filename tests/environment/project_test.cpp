// Projections of pictures against the plain sum over texels.
#include "accuracy.hpp"
#include "catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <glm/vec3.hpp>

#include <zonal/basis/evaluate.hpp>
#include <zonal/environment/irradiance.hpp>
#include <zonal/environment/project.hpp>
#include <zonal/environment/project_reference.hpp>

#include "environment/pictures.hpp"

using zonal::Environment;
using zonal::Mapping;
using zonal::Rgb;

namespace {

/// Numbers of a picture, and the picture.
struct Owned {
  std::vector<float> numbers;
  int width, height;
  zonal::Picture<const float> picture() const { return zonal::Picture<const float>::of(numbers, width, height); }
};

Owned random_picture(Mapping mapping, int size, unsigned seed) {
  const auto [width, height] = picture_size(mapping, size);
  Owned owned{std::vector<float>(std::size_t(3 * width * height)), width, height};
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
  for (float& number : owned.numbers) number = uniform(random);
  return owned;
}

/// A dim sky, and a sun of 1e5 in a few texels, of which none is a neighbour of another, poles and edges among them.
Owned sunny_picture(Mapping mapping, int size, unsigned seed) {
  Owned owned = random_picture(mapping, size, seed);
  for (float& number : owned.numbers) number = 0.1F + 0.01F * number;
  std::mt19937 random(seed + 1);
  for (int i = 0; i < 3; ++i) {
    const std::size_t texel = random() % (owned.numbers.size() / 3);
    for (std::size_t c = 0; c < 3; ++c) owned.numbers[3 * texel + c] = 1e5F * (1.0F - 0.2F * float(c));
  }
  return owned;
}

/// The greatest difference of two projections, in units of the second's first coefficient.
template <int N, class A, class B>
double difference(const zonal::Sh<N, A>& a, const zonal::Sh<N, B>& b) {
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    const double unit = std::abs(double(b[0][c]));
    for (int i = 0; i < N * N; ++i) {
      const double d = std::abs(double(a[i][c]) - double(b[i][c])) / unit;
      worst = d <= worst ? worst : d;  // of NaN too
    }
  }
  return worst;
}

template <int N>
void check_against_plain_sum() {
  Met met("environment", "project");
  for (int i = 0; i < zonal::kMappingCount; ++i) {
    const auto mapping = Mapping(i);
    for (const int size : {1, 2, 3, 8, 37, 70}) {
      for (const bool sunny : {false, true}) {
        const Owned owned = sunny ? sunny_picture(mapping, size, 7) : random_picture(mapping, size, 5);
        const Environment environment(owned.picture(), mapping);
        for (const auto rule : {zonal::TexelRule::constant_exact, zonal::TexelRule::middles}) {
          const auto plain = zonal::project_by_texel<N>(environment, rule);
          if (!(plain[0][0] > 0)) continue;  // all of it was beside the disc
          const auto fast = zonal::project<N>(environment, zonal::SerialForEach{}, nullptr, rule);
          CAPTURE(N, zonal::mapping_name(mapping), owned.width, owned.height, sunny, int(rule));
          CHECK(met.meet(difference(fast, plain)));
        }
      }
    }
  }
  CHECK_MET(met);
}

}  // namespace

TEST_CASE("project: fast equals the plain sum, 3 bands") { check_against_plain_sum<3>(); }
TEST_CASE("project: fast equals the plain sum, 9 bands") { check_against_plain_sum<9>(); }

namespace {

/// A smooth radiance with a bright spot, RGB different.
Rgb<double> smooth(const std::array<double, 3>& d) {
  const double spot = std::exp(8 * (0.6 * d[0] + 0.64 * d[1] + 0.48 * d[2] - 1));
  return {1 + 0.5 * d[2] + 3 * spot, 1 + 0.3 * d[0] * d[1], 0.5 + 0.4 * d[1] * d[2] + 2 * spot};
}

Owned painted(Mapping mapping, int size) {
  const auto [width, height] = picture_size(mapping, size);
  Owned owned{std::vector<float>(std::size_t(3 * width * height)), width, height};
  Environment(owned.picture(), mapping).visit([&](const auto& m) {
    for (int row = 0; row < owned.height; ++row) {
      for (int column = 0; column < owned.width; ++column) {
        if (!m.has_direction(column, row)) continue;
        const Rgb<double> colour = smooth(m.direction(column + 0.5, row + 0.5));
        for (std::size_t c = 0; c < 3; ++c) {
          owned.numbers[3 * std::size_t(row * owned.width + column) + c] = float(colour[int(c)]);
        }
      }
    }
  });
  return owned;
}

}  // namespace

TEST_CASE("project: a picture of one radiance has one coefficient, in every mapping and size") {
  for (int i = 0; i < zonal::kMappingCount; ++i) {
    for (const int size : {1, 2, 3, 5, 64, 100}) {
      const auto [width, height] = picture_size(Mapping(i), size);
      std::vector<float> numbers(std::size_t(3 * width * height));
      for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = k % 3 == 0 ? 0.7F : k % 3 == 1 ? 3.1F : 1e-3F;
      const auto picture = zonal::Picture<const float>::of(numbers, width, height);
      const auto sh = zonal::project<9, Rgb<double>>(Environment(picture, Mapping(i)));
      CAPTURE(zonal::mapping_name(Mapping(i)), width, height);
      for (int c = 0; c < 3; ++c) {
        CHECK(sh[0][c] == Approx(double(numbers[std::size_t(c)]) * std::sqrt(4 * double(zonal::kPi))).epsilon(1e-7));
        double worst = 0;
        for (int k = 1; k < 81; ++k) worst = std::max(worst, std::abs(sh[k][c]));
        CHECK(worst < 1e-7 * sh[0][c]);
      }
    }
  }
}

TEST_CASE("project: the same radiance in every mapping has the same coefficients, as exact as texels are small") {
  // Against a picture four times as fine.
  const auto exact = [] {
    const Owned owned = painted(Mapping::equirectangular, 512);
    return zonal::project<9, Rgb<double>>(Environment(owned.picture(), Mapping::equirectangular));
  }();
  for (int i = 0; i < zonal::kMappingCount; ++i) {
    const auto mapping = Mapping(i);
    const Owned owned = painted(mapping, 128);
    const auto sh = zonal::project<9, Rgb<double>>(Environment(owned.picture(), mapping));
    CAPTURE(zonal::mapping_name(mapping));
    // A mirror sphere's last texels stand for all that is behind the ball.
    CHECK(difference(sh, exact) < (mapping == Mapping::mirror_sphere ? 1e-3 : 1e-4));
  }
}

TEST_CASE("project: each octant of the sphere where the picture has it") {
  // A picture that is lit where the signs of x, y and z are given: the first moments tell them.
  for (int i = 0; i < zonal::kMappingCount; ++i) {
    const auto mapping = Mapping(i);
    for (int octant = 0; octant < 8; ++octant) {
      Owned owned = random_picture(mapping, 24, 1);
      Environment(owned.picture(), mapping).visit([&](const auto& m) {
        for (int row = 0; row < owned.height; ++row) {
          for (int column = 0; column < owned.width; ++column) {
            const auto d = m.direction(column + 0.5, row + 0.5);
            const int at = (d[0] < 0 ? 1 : 0) + (d[1] < 0 ? 2 : 0) + (d[2] < 0 ? 4 : 0);
            for (std::size_t c = 0; c < 3; ++c) {
              owned.numbers[3 * std::size_t(row * owned.width + column) + c] = at == octant ? 1.0F : 0.0F;
            }
          }
        }
      });
      const auto sh = zonal::project<2>(Environment(owned.picture(), mapping));
      CAPTURE(zonal::mapping_name(mapping), octant);
      // the integral of x over an octant is pi/4, times sqrt(3/4pi)
      const float k = 0.48860251F * 0.78539816F;
      CHECK(sh(1, 1).r == Approx((octant & 1) != 0 ? k : -k).epsilon(0.15));
      CHECK(sh(1, -1).r == Approx((octant & 2) != 0 ? k : -k).epsilon(0.15));
      CHECK(sh(1, 0).r == Approx((octant & 4) != 0 ? -k : k).epsilon(0.15));
    }
  }
}

TEST_CASE("project: as many threads as there are") {
  const Owned owned = random_picture(Mapping::equirectangular, 200, 3);
  const Owned cross = random_picture(Mapping::vertical_cross, 65, 3);
  const auto backwards = [](int count, const auto& body) {
    for (int i = count; i-- > 0;) body(i);
  };
  const auto same = [&](const auto& environment) {
    CHECK(zonal::project<3>(environment) == zonal::project<3>(environment, backwards));
  };
  same(Environment(owned.picture(), Mapping::equirectangular));
  same(Environment(cross.picture(), Mapping::vertical_cross));
}

TEST_CASE("project: irradiance is radiance seen by a cosine") {
  const Owned owned = painted(Mapping::octahedral, 96);
  const Environment environment(owned.picture(), Mapping::octahedral);
  const auto radiance = zonal::project<9, Rgb<double>>(environment);
  const auto over_pi = zonal::irradiance_over_pi(radiance), irradiance = zonal::irradiance(radiance);
  for (const std::array<double, 3> normal : {unit({0.3, -0.5, 0.8}), unit({-1, 0, 0}), unit({0.6, 0.64, 0.48})}) {
    Rgb<double> sum{};  // texel by texel
    environment.visit([&](const auto& m) {
      for (int row = 0; row < 96; ++row) {
        for (int column = 0; column < 96; ++column) {
          const auto d = m.direction(column + 0.5, row + 0.5);
          const double cosine = d[0] * normal[0] + d[1] * normal[1] + d[2] * normal[2];
          if (cosine > 0) sum += Rgb<double>(environment.rgb(column, row)) * (cosine * m.solid_angle(column, row));
        }
      }
    });
    for (int c = 0; c < 3; ++c) {
      CHECK(zonal::reconstruct(irradiance, normal)[c] == Approx(sum[c]).epsilon(1e-3));
      CHECK(zonal::reconstruct(over_pi, normal)[c] * double(zonal::kPi) == Approx(sum[c]).epsilon(1e-3));
    }
  }
}
