// Fields that are known everywhere, and what probes see of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

#include <zonal/field/resample.hpp>

namespace field_test {

using zonal::DirectionBuckets;
using zonal::ProbePlace;
using zonal::RadianceSample;

/// A smooth surrounding, and a light of 0.4 about `light`, with a smooth edge or a hard one: what a ray shows.
struct Glow {
  glm::vec3 light;
  bool is_hard;

  RadianceSample operator()(const glm::vec3& position, const glm::vec3& direction) const {
    const glm::vec3 to_light = light - position;
    const float along = glm::dot(to_light, direction), across2 = (glm::dot(to_light, to_light) - along * along) / 0.16F;
    const float shape = is_hard ? float(across2 < 1) : std::exp(-across2), glow = along > 0 ? 10 * shape : 0;
    return {1 + direction.x + glow, 1 + 0.5F * direction.y * direction.z, 0.1F * glow};
  }
};

/// Radiance by direction alone, with a sun of one bucket.
struct FarLight {
  glm::vec3 sun;

  RadianceSample operator()(const glm::vec3&, const glm::vec3& direction) const {
    const float bright = glm::dot(direction, sun) > 0.9999F ? 1e4F : 0;
    return {1 + direction.x + bright, 2 + bright, 0.5F + direction.y * direction.z};
  }
};

inline std::vector<ProbePlace> random_probes(int count, const glm::vec3& low, const glm::vec3& high, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<ProbePlace> probes;
  for (int i = 0; i < count; ++i) {
    glm::vec3 t;
    for (int a = 0; a < 3; ++a) t[a] = std::uniform_real_distribution<float>(0, 1)(random);
    probes.push_back({low + t * (high - low), {1, 0, 0}});
  }
  return probes;
}

/// Bucket by bucket, probe by probe.
template <class Field>
std::vector<RadianceSample> take_samples(const DirectionBuckets& buckets, const std::vector<ProbePlace>& probes,
                                         float sphere_radius, const Field& field) {
  std::vector<RadianceSample> samples;
  for (std::size_t b = 0; b < buckets.size(); ++b) {
    const glm::vec3 w = buckets[b].direction;
    for (const ProbePlace& probe : probes) samples.push_back(field(zonal::ray_origin(probe, w, sphere_radius), w));
  }
  return samples;
}

/// On two threads, the last first.
struct TwoThreads {
  template <class Body>
  void operator()(int count, const Body& body) const {
    const auto half = [&](int first) {
      for (int i = count - 1 - first; i >= 0; i -= 2) body(i);
    };
    std::thread other([&] { half(1); });
    half(0);
    other.join();
  }
};

/// The field's coefficients at a place, from its radiance in all buckets.
template <int N, class Field>
zonal::Sh<N, glm::dvec3> true_coefficients(const DirectionBuckets& buckets, const Field& field,
                                           const glm::vec3& position) {
  zonal::Sh<N, glm::dvec3> sum{};
  zonal::Sh<N, double> one{};
  for (std::size_t b = 0; b < buckets.size(); ++b) {
    const glm::dvec3 w = glm::normalize(glm::dvec3(buckets[b].direction));
    const zonal::Sh<N, double> y = zonal::evaluate<N>(w) * double(buckets[b].solid_angle);
    const RadianceSample radiance = field(position, buckets[b].direction);
    sum += y * glm::dvec3(radiance.r, radiance.g, radiance.b);
    one += y;
  }
  const glm::dvec3 mean = sum[0] / one[0];
  sum -= one * mean;
  sum[0] = mean * std::sqrt(4 * 3.14159265358979323846);
  return sum;
}

/// The squares of coefficients, and of their errors, over places.
struct Errors {
  double truth2 = 0, error2 = 0;
  double relative() const { return std::sqrt(error2 / truth2); }

  template <int N>
  void add(const zonal::Sh<N, glm::vec3>& value, const zonal::Sh<N, glm::dvec3>& truth) {
    for (int i = 0; i < N * N; ++i) {
      const glm::dvec3 error = glm::dvec3(value[i]) - truth[i];
      truth2 += glm::dot(truth[i], truth[i]), error2 += glm::dot(error, error);
    }
  }
};

}  // namespace field_test
