// Projections of pictures against the plain sum over texels.
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
          CHECK(difference(fast, plain) < 2e-6);
        }
      }
    }
  }
}

}  // namespace

TEST_CASE("project: fast equals the plain sum, 3 bands") { check_against_plain_sum<3>(); }
TEST_CASE("project: fast equals the plain sum, 9 bands") { check_against_plain_sum<9>(); }
