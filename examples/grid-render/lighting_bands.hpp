#pragma once

// Everything that depends on the number of bands and the kind of light; each pair has a source file of its own.

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include <tbb/parallel_for.h>
#include <zonal/grid/add_lights.hpp>
#include <zonal/grid/add_polygons.hpp>
#include <zonal/grid/grid_file.hpp>
#include <zonal/grid/interpolate.hpp>
#include <zonal/lobe/lambert.hpp>
#include <zonal/transform/convolve.hpp>
#include <zonal/transform/dot.hpp>

#include "light_packet.hpp"
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
  const auto diffuse = [&](const glm::vec3& normal) {
    constexpr auto lambert = zonal::project<N, float>(zonal::LambertLobe{});
    return zonal::reconstruct(zonal::convolve(radiance, lambert), normal);
  };
  const auto glossy = [&](const GlossyLobe& lobe, const glm::vec3& mirrored) {
    return zonal::reconstruct(zonal::convolve(radiance, first_bands<N>(lobe.kernel)), mirrored);
  };
  return sum_of_lobes(hit, outgoing, reflector, diffuse, glossy);
}

/// Of a polygon's edge integrals, relative to its largest coefficient.
constexpr double edge_tolerance = 1e-5;

/// Lights as a point sees them: sink(l, m, value). Lights symmetric about their centre are closed forms.
template <int N, class Light>
struct Projection {
  template <class Wide, class Sink>
  ZONAL_INLINE void operator()(const Wide& light, const Lanes (&at)[3], Sink&& sink) const {
    zonal::project<N>(light, at[0], at[1], at[2], sink);
  }
};

/// Polygons are integrated along their edges, at as many nodes as the largest in the packet needs.
template <int N, int V>
struct Projection<N, zonal::PolygonLight<V, float>> {
  zonal::EdgeRules rules{N, edge_tolerance};

  template <class Wide, class Sink>
  ZONAL_INLINE void operator()(const Wide& light, const Lanes (&at)[3], Sink&& sink) const {
    float arcs[zonal::kNativeLanes];
    zonal::largest_arc(light, glm::vec<3, Lanes>(at[0], at[1], at[2])).store(arcs);
    const double arc = static_cast<double>(*std::max_element(std::begin(arcs), std::end(arcs)));
    zonal::finish<N>(zonal::polygon_sums<N>(light, rules.for_arc(arc), at[0], at[1], at[2]),
                     [&](auto l, auto m, const Lanes& value, const auto&...) ZONAL_INLINE { sink(l, m, value); });
  }
};

template <int N, class Light>
void add_to_grid(zonal::CoefficientGrid<N>& grid, const Lights<Light>& lights) {
  zonal::add_lights(grid, lights, [](int count, const auto& body) { for_each_in_parallel(count, body); });
}
template <int N, int V>
void add_to_grid(zonal::CoefficientGrid<N>& grid, const Lights<zonal::PolygonLight<V, float>>& lights) {
  zonal::add_lights(grid, lights, edge_tolerance,
                    [](int count, const auto& body) { for_each_in_parallel(count, body); });
}

/// All lights, as many at a time as a packet has lanes.
template <int N, class Light>
class ExactField final : public LightField {
 public:
  explicit ExactField(const Lights<Light>& lights) : packets_(packets_of(lights)) {}

  zonal::Sh<N, glm::vec3> at(const glm::vec3& position) const {
    const Lanes receiver[3] = {Lanes(position.x), Lanes(position.y), Lanes(position.z)};
    zonal::Sh<N, std::array<Lanes, 3>> sums;
    for (auto& rgb : sums) rgb.fill(Lanes(0));
    for (const LightPacket<Light>& packet : packets_) {
      projection_(packet.light, receiver, [&](auto l, auto m, const Lanes& value) ZONAL_INLINE {
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
  std::vector<LightPacket<Light>> packets_;
  Projection<N, Light> projection_;
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
  explicit LightGridOf(zonal::CoefficientGrid<N> coefficients) : grid(std::move(coefficients)) {}

  glm::ivec3 resolution() const override { return grid.resolution(); }

  std::unique_ptr<LightField> interpolated(zonal::Interpolation method) const override {
    using zonal::Interpolation;
    switch (method) {
      case Interpolation::trilinear: return std::make_unique<InterpolatedField<N, Interpolation::trilinear>>(grid);
      case Interpolation::taylor: return std::make_unique<InterpolatedField<N, Interpolation::taylor>>(grid);
      case Interpolation::hermite: break;
    }
    return std::make_unique<InterpolatedField<N, Interpolation::hermite>>(grid);
  }

  void save(const std::filesystem::path& path) const override { zonal::save_grid(path, grid); }

  zonal::CoefficientGrid<N> grid;
};

template <int N, class Light>
class LightingOf final : public Lighting {
 public:
  explicit LightingOf(Lights<Light> lights) : lights_(std::move(lights)) {}

  std::size_t light_count() const override { return lights_.size(); }

  std::unique_ptr<LightField> exact() const override { return std::make_unique<ExactField<N, Light>>(lights_); }

  std::unique_ptr<LightGrid> grid(const Bounds& box, const glm::ivec3& resolution, GridContent content) const override {
    auto made = std::make_unique<LightGridOf<N>>(zonal::CoefficientGrid<N>(box.lower, box.upper, resolution));
    if (content == GridContent::values) {
      set_values(made->grid);
    } else {
      add_to_grid(made->grid, lights_);
    }
    return made;
  }

 private:
  /// The gradients stay zero.
  void set_values(zonal::CoefficientGrid<N>& grid) const {
    const ExactField<N, Light> field(lights_);
    const glm::ivec3 size = grid.resolution();
    for_each_in_parallel(size.x * size.y * size.z, [&](int i) {
      const glm::ivec3 vertex(i % size.x, i / size.x % size.y, i / size.x / size.y);
      grid.set(vertex, {field.at(grid.position(vertex)), {}});
    });
  }

  Lights<Light> lights_;
};

using Sphere = zonal::SphereLight<float>;
using Triangle = zonal::TriangleLight<float>;
using TriangleSphere = zonal::TriangleSphereLight<float>;

// Each has a source file, lighting_*.cpp.
/// Whether it is compiled in: all that is offered, or, in the test command's short build, what tests ask for.
#ifdef ZONAL_QUICK
template <int N, class Light>
inline constexpr bool is_built = std::is_same_v<Light, Triangle> ? N == 5 : N != 7;
#else
template <int, class>
inline constexpr bool is_built = true;
#endif

extern template class LightGridOf<3>;
extern template class LightGridOf<5>;
extern template class LightGridOf<7>;
extern template class LightGridOf<9>;
extern template class LightingOf<3, Sphere>;
extern template class LightingOf<5, Sphere>;
extern template class LightingOf<7, Sphere>;
extern template class LightingOf<9, Sphere>;
extern template class LightingOf<5, Triangle>;
extern template class LightingOf<9, Triangle>;
extern template class LightingOf<5, TriangleSphere>;
extern template class LightingOf<9, TriangleSphere>;

}  // namespace example::grid_render
