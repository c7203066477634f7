#pragma once

// Everything that depends on the number of bands; each has a source file of its own.

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include <tbb/parallel_for.h>
#include <glm/gtc/constants.hpp>
#include <zonal/grid/add_lights.hpp>
#include <zonal/grid/interpolate.hpp>
#include <zonal/lobe/lambert.hpp>
#include <zonal/transform/convolve.hpp>
#include <zonal/transform/dot.hpp>

#include "lighting.hpp"
#include "shared/interrupt.hpp"

namespace example::grid_render {

/// body(0), ..., body(count - 1) on all threads; throws Interrupted soon after Ctrl-C.
template <class Body>
void for_each_in_parallel(int count, const Body& body) {
  tbb::parallel_for(0, count, [&](int i) {
    if (!stop_requested()) body(i);
  });
  throw_if_interrupted();
}

template <int N>
glm::vec3 reflect(const zonal::Sh<N, glm::vec3>& radiance, const Hit& hit, const glm::vec3& outgoing,
                  const Reflector& reflector) {
  constexpr auto lambert = zonal::project<N, float>(zonal::LambertLobe{});
  glm::vec3 sum(0.0f);
  if (reflector.diffuse_albedo != glm::vec3(0.0f)) {
    sum = reflector.diffuse_albedo * zonal::reconstruct(zonal::convolve(radiance, lambert), hit.normal);
  }
  const float cos_outgoing = glm::dot(hit.normal, outgoing);
  for (const GlossyLobe& lobe : reflector.glossy) {
    zonal::Zh<N, float> kernel{};
    std::copy_n(lobe.kernel.begin(), std::min(N, most_lobe_bands), kernel.begin());
    const glm::vec3 mirrored = glm::normalize(2.0f * cos_outgoing * hit.normal - outgoing);
    // The integral of BRDF times cosine, sqrt(4 pi) times its first coefficient.
    const glm::vec3 albedo = lobe.albedo.with_cosine<1>(cos_outgoing)[0] * (2.0f * glm::root_pi<float>());
    sum += albedo * zonal::reconstruct(zonal::convolve(radiance, kernel), mirrored);
  }
  return sum;
}

/// All lights, as many at a time as a packet has lanes.
template <int N>
class ExactField final : public LightField {
 public:
  explicit ExactField(const SphereLights& lights) {
    for (std::size_t first = 0; first < lights.size(); first += zonal::kNativeLanes)
      packets_.emplace_back(lights, first);
  }

  zonal::Sh<N, glm::vec3> at(const glm::vec3& position) const {
    const Lanes x(position.x), y(position.y), z(position.z);
    zonal::Sh<N, std::array<Lanes, 3>> sums;
    for (auto& rgb : sums) rgb.fill(Lanes(0));
    for (const Packet& packet : packets_) {
      zonal::project<N>(packet.light, x, y, z, [&](auto l, auto m, const Lanes& value) ZONAL_INLINE {
        auto& rgb = sums[zonal::sh_index(l, m)];
        for (std::size_t c = 0; c < 3; ++c) zonal::add_product(rgb[c], value, packet.colour[c]);
      });
    }
    zonal::Sh<N, glm::vec3> sh;
    for (int i = 0; i < N * N; ++i) sh[i] = {sums[i][0].sum(), sums[i][1].sum(), sums[i][2].sum()};
    return sh;
  }

  glm::vec3 reflected(const Hit& hit, const glm::vec3& outgoing, const Reflector& reflector) const override {
    return reflect(at(hit.position), hit, outgoing, reflector);
  }

 private:
  using Lanes = zonal::Packet<float, zonal::kNativeLanes>;

  struct Packet {
    /// What is missing in the last packet is black.
    Packet(const SphereLights& lights, std::size_t first) {
      float fields[7][zonal::kNativeLanes];
      for (std::size_t lane = 0; lane < zonal::kNativeLanes; ++lane) {
        const bool exists = first + lane < lights.size();
        const auto& [sphere, rgb] = lights[exists ? first + lane : first];
        for (int i = 0; i < 3; ++i) {
          fields[i][lane] = sphere.center[i];
          fields[4 + i][lane] = exists ? rgb[i] : 0.0f;
        }
        fields[3][lane] = sphere.radius;
      }
      for (int i = 0; i < 3; ++i) light.center[i] = Lanes::load(fields[i]);
      light.radius = Lanes::load(fields[3]);
      for (std::size_t c = 0; c < 3; ++c) colour[c] = Lanes::load(fields[4 + c]);
    }

    zonal::SphereLight<Lanes> light;
    std::array<Lanes, 3> colour;
  };
  std::vector<Packet> packets_;
};

template <int N, zonal::Interpolation method>
class InterpolatedField final : public LightField {
 public:
  explicit InterpolatedField(const zonal::CoefficientGrid<N>& grid) : grid_(grid) {}

  glm::vec3 reflected(const Hit& hit, const glm::vec3& outgoing, const Reflector& reflector) const override {
    return reflect(zonal::interpolate<method>(grid_, hit.position), hit, outgoing, reflector);
  }

 private:
  const zonal::CoefficientGrid<N>& grid_;
};

template <int N>
class LightGridOf final : public LightGrid {
 public:
  LightGridOf(const Bounds& box, const glm::ivec3& resolution) : grid(box.lower, box.upper, resolution) {}

  std::unique_ptr<LightField> interpolated(zonal::Interpolation method) const override {
    using zonal::Interpolation;
    switch (method) {
      case Interpolation::trilinear: return std::make_unique<InterpolatedField<N, Interpolation::trilinear>>(grid);
      case Interpolation::taylor: return std::make_unique<InterpolatedField<N, Interpolation::taylor>>(grid);
      case Interpolation::hermite: break;
    }
    return std::make_unique<InterpolatedField<N, Interpolation::hermite>>(grid);
  }

  zonal::CoefficientGrid<N> grid;
};

template <int N>
class LightingOf final : public Lighting {
 public:
  explicit LightingOf(const SphereLights& lights) : lights_(lights) {}

  std::unique_ptr<LightField> exact() const override { return std::make_unique<ExactField<N>>(lights_); }

  std::unique_ptr<LightGrid> grid(const Bounds& box, const glm::ivec3& resolution, GridContent content) const override {
    auto made = std::make_unique<LightGridOf<N>>(box, resolution);
    if (content == GridContent::values) {
      set_values(made->grid);
    } else {
      zonal::add_lights(made->grid, lights_, [](int count, const auto& body) { for_each_in_parallel(count, body); });
    }
    return made;
  }

 private:
  /// The gradients stay zero.
  void set_values(zonal::CoefficientGrid<N>& grid) const {
    const ExactField<N> field(lights_);
    const glm::ivec3 size = grid.resolution();
    for_each_in_parallel(size.x * size.y * size.z, [&](int i) {
      const glm::ivec3 vertex(i % size.x, i / size.x % size.y, i / size.x / size.y);
      grid.set(vertex, {field.at(grid.position(vertex)), {}});
    });
  }

  const SphereLights& lights_;
};

}  // namespace example::grid_render
