#pragma once

// Everything that depends on the number of bands and the kind of light; each pair has a source file of its own.

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include <zonal/grid/add_lights.hpp>
#include <zonal/grid/add_polygons.hpp>
#include <zonal/grid/grid_file.hpp>
#include <zonal/grid/interpolate.hpp>
#include <zonal/lobe/lambert.hpp>
#include <zonal/transform/convolve.hpp>
#include <zonal/transform/dot.hpp>

#include "light_packet.hpp"
#include "lighting.hpp"
#include "parallel.hpp"

namespace example::grid_render {

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

/// Of a polygon's edge integrals, relative to its coefficient of degree 0.
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
  template <class Wide, class Sink>
  ZONAL_INLINE void operator()(const Wide& light, const Lanes (&at)[3], Sink&& sink) const {
    const auto demand = zonal::edge_demand<N>(light, edge_tolerance, at[0], at[1], at[2]);
    float reaches[zonal::kNativeLanes], allowances[zonal::kNativeLanes];
    demand.reach.store(reaches);
    demand.allowance.store(allowances);
    const float reach = *std::max_element(std::begin(reaches), std::end(reaches)),
                allowance = *std::min_element(std::begin(allowances), std::end(allowances));
    const int nodes = zonal::edge_nodes(N, static_cast<double>(reach), static_cast<double>(allowance));
    zonal::finish<N>(zonal::polygon_sums<N>(light, zonal::edge_rule(nodes), at[0], at[1], at[2]),
                     [&](auto l, auto m, const Lanes& value, const auto&...) ZONAL_INLINE { sink(l, m, value); });
  }
};

template <class Grid, class Light>
void add_to_grid(Grid& grid, const Lights<Light>& lights) {
  zonal::add_lights(grid, lights, [](int count, const auto& body) { for_each_in_parallel(count, body); });
}
template <class Grid, int V>
void add_to_grid(Grid& grid, const Lights<zonal::PolygonLight<V, float>>& lights) {
  zonal::add_lights(grid, lights, edge_tolerance,
                    [](int count, const auto& body) { for_each_in_parallel(count, body); });
}

/// Coefficients of lights in packets at a point.
template <int N, class Light>
zonal::Sh<N, glm::vec3> sum_of_lights(const std::vector<LightPacket<Light>>& packets, const glm::vec3& position) {
  const Lanes receiver[3] = {Lanes(position.x), Lanes(position.y), Lanes(position.z)};
  const Projection<N, Light> projection;
  zonal::Sh<N, std::array<Lanes, 3>> sums;
  for (auto& rgb : sums) rgb.fill(Lanes(0));
  for (const LightPacket<Light>& packet : packets) {
    projection(packet.light, receiver, [&](auto l, auto m, const Lanes& value) ZONAL_INLINE {
      auto& rgb = sums[zonal::sh_index(l, m)];
      for (std::size_t c = 0; c < 3; ++c) zonal::add_product(rgb[c], value, packet.colour[c]);
    });
  }
  zonal::Sh<N, glm::vec3> sh;
  for (int i = 0; i < N * N; ++i) sh[i] = {sums[i][0].sum(), sums[i][1].sum(), sums[i][2].sum()};
  return sh;
}

/// All lights, as many at a time as a packet has lanes.
template <int N, class Light>
class ExactField final : public LightField {
 public:
  explicit ExactField(const Lights<Light>& lights) : packets_(packets_of(lights)) {}

  zonal::Sh<N, glm::vec3> at(const glm::vec3& position) const { return sum_of_lights<N>(packets_, position); }

  glm::vec3 reflected(const Hit& hit, const glm::vec3& outgoing, const Reflector& reflector) const override {
    return reflect(at(hit.position), hit, outgoing, reflector);
  }

 private:
  std::vector<LightPacket<Light>> packets_;
};

template <zonal::Interpolation method, class Grid>
class InterpolatedField final : public LightField {
 public:
  explicit InterpolatedField(const Grid& grid) : grid_(grid) {}

  glm::vec3 reflected(const Hit& hit, const glm::vec3& outgoing, const Reflector& reflector) const override {
    return reflect(zonal::interpolate<method>(grid_, hit.position), hit, outgoing, reflector);
  }

 private:
  const Grid& grid_;
};

template <int N, GridContent content>
class LightGridOf final : public LightGrid {
 public:
  using Grid = zonal::CoefficientGrid<N, content>;
  explicit LightGridOf(Grid coefficients) : grid(std::move(coefficients)) {}

  glm::ivec3 resolution() const override { return grid.resolution(); }

  std::unique_ptr<LightField> interpolated(zonal::Interpolation method) const override {
    using zonal::Interpolation;
    if constexpr (Grid::has_gradients) {
      switch (method) {
        case Interpolation::taylor: return std::make_unique<InterpolatedField<Interpolation::taylor, Grid>>(grid);
        case Interpolation::hermite: return std::make_unique<InterpolatedField<Interpolation::hermite, Grid>>(grid);
        case Interpolation::trilinear: break;
      }
    }
    if (zonal::blocks_read(method) > Grid::block_count) throw std::logic_error("a grid of values alone");
    return std::make_unique<InterpolatedField<Interpolation::trilinear, Grid>>(grid);
  }

  void save(const std::filesystem::path& path) const override { zonal::save_grid(path, grid); }

  Grid grid;
};

template <int N, class Light>
class LightingOf final : public Lighting {
 public:
  explicit LightingOf(Lights<Light> lights) : lights_(std::move(lights)) {}

  std::size_t light_count() const override { return lights_.size(); }

  std::unique_ptr<LightField> exact() const override { return std::make_unique<ExactField<N, Light>>(lights_); }

  std::unique_ptr<LightGrid> grid(const Bounds& box, const glm::ivec3& resolution, GridContent content) const override {
    if (content == GridContent::values) return filled<GridContent::values>(box, resolution);
    return filled<GridContent::values_and_gradients>(box, resolution);
  }

 private:
  template <GridContent content>
  std::unique_ptr<LightGrid> filled(const Bounds& box, const glm::ivec3& resolution) const {
    using Grid = LightGridOf<N, content>;
    auto made = std::make_unique<Grid>(typename Grid::Grid(box.lower, box.upper, resolution));
    add_to_grid(made->grid, lights_);
    return made;
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

extern template class LightGridOf<3, GridContent::values>;
extern template class LightGridOf<3, GridContent::values_and_gradients>;
extern template class LightGridOf<5, GridContent::values>;
extern template class LightGridOf<5, GridContent::values_and_gradients>;
extern template class LightGridOf<7, GridContent::values>;
extern template class LightGridOf<7, GridContent::values_and_gradients>;
extern template class LightGridOf<9, GridContent::values>;
extern template class LightGridOf<9, GridContent::values_and_gradients>;
extern template class LightingOf<3, Sphere>;
extern template class LightingOf<5, Sphere>;
extern template class LightingOf<7, Sphere>;
extern template class LightingOf<9, Sphere>;
extern template class LightingOf<5, Triangle>;
extern template class LightingOf<9, Triangle>;
extern template class LightingOf<5, TriangleSphere>;
extern template class LightingOf<9, TriangleSphere>;

}  // namespace example::grid_render
