#pragma once

// The lighting of plans, by its number of bands.

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "band_list.hpp"
#include "grid_plan.hpp"
#include "lighting_bands.hpp"
#include "shared/stage_times.hpp"

namespace example::grid_render {

/// Of each cell of a lattice over the box the near lights that reach into it.
template <int N>
class NearLights {
 public:
  NearLights(const SphereLights& lights, const Bounds& box, const NearRange& near) {
    if (near.is_empty()) return;
    constexpr float most = 32.0f;
    low_ = box.lower;
    count_ = glm::ivec3(glm::clamp((box.upper - box.lower) / near.to, 1.0f, most));
    side_ = (box.upper - box.lower) / glm::vec3(count_);
    std::vector<Lights<NearSphere<float>>> reaching(static_cast<std::size_t>(count_.x * count_.y * count_.z));
    for (const auto& [light, colour] : lights) {
      const glm::vec3 reach(light.radius + near.to);
      const glm::ivec3 first = cell_of(light.center - reach), last = cell_of(light.center + reach);
      for (int z = first.z; z <= last.z; ++z) {
        for (int y = first.y; y <= last.y; ++y) {
          for (int x = first.x; x <= last.x; ++x) {
            reaching[number({x, y, z})].push_back({part_of<NearSphere>(light, near), colour});
          }
        }
      }
    }
    for (const auto& of_cell : reaching) cells_.push_back(packets_of(of_cell));
  }

  /// Adds to the coefficients what is near to a point of the box.
  void add(const glm::vec3& position, zonal::Sh<N, glm::vec3>& sh) const {
    if (cells_.empty()) return;
    const auto& lights = cells_[number(cell_of(position))];
    if (!lights.empty()) sh += sum_of_lights<N>(lights, position);
  }

  std::size_t bytes() const {
    std::size_t packets = 0;
    for (const auto& cell : cells_) packets += cell.size();
    return packets * sizeof(LightPacket<NearSphere<float>>);
  }

 private:
  glm::ivec3 cell_of(const glm::vec3& position) const {
    return glm::ivec3(glm::clamp((position - low_) / side_, glm::vec3(0.0f), glm::vec3(count_ - 1)));
  }
  std::size_t number(const glm::ivec3& cell) const {
    return static_cast<std::size_t>(cell.x + count_.x * (cell.y + count_.y * cell.z));
  }

  glm::vec3 low_{0.0f}, side_{1.0f};
  glm::ivec3 count_{0};
  std::vector<std::vector<LightPacket<NearSphere<float>>>> cells_;
};

inline Lights<FarSphere<float>> far_lights(const SphereLights& lights, const NearRange& near) {
  Lights<FarSphere<float>> result;
  for (const auto& [light, colour] : lights) result.push_back({part_of<FarSphere>(light, near), colour});
  return result;
}

/// The cells of a grid around some points: all of them, or where that is less work each point's own.
template <int N>
class GridCells {
 public:
  using Grid = zonal::CoefficientGrid<N>;

  GridCells(const Lights<FarSphere<float>>& lights, const Bounds& box, const glm::ivec3& resolution, std::size_t points)
      : lights_(lights), box_(box), resolution_(resolution) {
    // A cell's corners take a packet of vertices, as many as it has lanes.
    const auto vertices = static_cast<std::size_t>(resolution.x * resolution.y * resolution.z);
    if (vertices > zonal::kNativeLanes * points) return;
    whole_.emplace(box.lower, box.upper, resolution);
    add_to_grid(*whole_, lights);
  }

  /// With a grid that has the position's cell.
  template <class Visit>
  void visit(const glm::vec3& position, const Visit& visit) const {
    if (whole_) return visit(*whole_);
    const glm::vec3 side = (box_.upper - box_.lower) / glm::vec3(resolution_ - 1);
    const glm::ivec3 cell = glm::clamp(glm::ivec3((position - box_.lower) / side), glm::ivec3(0), resolution_ - 2);
    const glm::vec3 low = box_.lower + glm::vec3(cell) * side;
    Grid corners(low, low + side, glm::ivec3(2));
    zonal::add_lights(corners, lights_, zonal::SerialForEach());
    visit(corners);
  }

 private:
  const Lights<FarSphere<float>>& lights_;
  Bounds box_;
  glm::ivec3 resolution_;
  std::optional<Grid> whole_;
};

/// Coefficients of NG bands from a grid, and what is near in N.
template <int N, int NG, zonal::Interpolation method>
class GridAndNearLights final : public LightField {
 public:
  static constexpr GridContent content =
      zonal::blocks_read(method) > 1 ? GridContent::values_and_gradients : GridContent::values;
  using Grid = zonal::CoefficientGrid<NG, content>;

  GridAndNearLights(Grid grid, NearLights<N> near) : grid_(std::move(grid)), near_(std::move(near)) {}

  glm::vec3 reflected(const Hit& hit, const glm::vec3& outgoing, const Reflector& reflector) const override {
    auto sh = zonal::with_bands<N>(zonal::interpolate<method>(grid_, hit.position));
    near_.add(hit.position, sh);
    return reflect(sh, hit, outgoing, reflector);
  }

 private:
  Grid grid_;
  NearLights<N> near_;
};

template <int N>
zonal::Sh<N, glm::vec3> only_bands(zonal::Sh<N, glm::vec3> sh, int bands) {
  for (int i = bands * bands; i < N * N; ++i) sh[i] = glm::vec3(0.0f);
  return sh;
}

template <int N>
class PlannedLightingOf final : public PlannedLighting {
 public:
  explicit PlannedLightingOf(SphereLights lights) : lights_(std::move(lights)), exact_(lights_) {}

  std::unique_ptr<LightField> exact() const override { return std::make_unique<ExactField<N, Sphere>>(lights_); }

  std::vector<glm::vec3> radiance(const std::vector<SeenHit>& hits, const std::vector<Reflector>& reflectors,
                                  int bands) const override {
    std::vector<glm::vec3> result(hits.size());
    for_each_in_parallel(static_cast<int>(hits.size()), [&](int i) {
      const auto& [hit, outgoing] = hits[static_cast<std::size_t>(i)];
      const auto sh = only_bands(exact_.at(hit.position), bands);
      result[static_cast<std::size_t>(i)] = reflect(sh, hit, outgoing, reflectors[hit.material]);
    });
    return result;
  }

  std::vector<GridWay> errors(const PlanPoints& points, std::size_t one_of, const Bounds& box,
                              const glm::ivec3& resolution, const NearRange& near) const override {
    using zonal::Interpolation;
    std::vector<GridWay> ways;
    for (const int bands : AllBands::numbers) {
      if (bands > N) continue;
      for (const auto method : {Interpolation::trilinear, Interpolation::hermite}) ways.push_back({bands, method, {}});
    }
    const Lights<FarSphere<float>> far = far_lights(lights_, near);
    const NearLights<N> near_lights(lights_, box, near);
    const std::size_t count = (points.hits.size() + one_of - 1) / one_of;
    const GridCells<N> cells(far, box, resolution, count);
    std::vector<std::vector<glm::vec3>> by_way(points.hits.size());
    for_each_in_parallel(static_cast<int>(count), [&](int number) {
      const std::size_t i = one_of * static_cast<std::size_t>(number);
      const auto& [hit, outgoing] = points.hits[i];
      zonal::Sh<N, glm::vec3> trilinear, hermite;
      cells.visit(hit.position, [&, &hit = hit](const auto& grid) {  // clang++ captures a binding from 16 on only
        trilinear = zonal::interpolate<Interpolation::trilinear>(grid, hit.position);
        hermite = zonal::interpolate<Interpolation::hermite>(grid, hit.position);
      });
      zonal::Sh<N, glm::vec3> of_near{};
      near_lights.add(hit.position, of_near);
      for (const GridWay& way : ways) {
        const auto sh = only_bands(way.method == Interpolation::hermite ? hermite : trilinear, way.bands) + of_near;
        by_way[i].push_back(reflect(sh, hit, outgoing, points.reflectors[hit.material]));
      }
    });
    for (std::size_t k = 0; k < ways.size(); ++k) {
      ways[k].error =
          estimate_error(points, one_of, [&](std::size_t i) { return glm::dvec3(by_way[i][k] - points.radiance[i]); });
    }
    return ways;
  }

  PlannedField field(const Bounds& box, const GridChoice& choice) const override {
    PlannedField made;
    if (choice.bands == 0) {
      made.field = exact();
      return made;
    }
    AllBands::dispatch(choice.bands, [&](auto bands) {
      if constexpr (bands <= N) {
        made = choice.method == zonal::Interpolation::hermite
                   ? filled<bands, zonal::Interpolation::hermite>(box, choice)
                   : filled<bands, zonal::Interpolation::trilinear>(box, choice);
      }
    });
    return made;
  }

 private:
  template <int NG, zonal::Interpolation method>
  PlannedField filled(const Bounds& box, const GridChoice& choice) const {
    using Field = GridAndNearLights<N, NG, method>;
    PlannedField made;
    StageTimes times;
    times.time("", [&] {
      NearLights<N> near(lights_, box, choice.near);
      made.near_bytes = near.bytes();
      typename Field::Grid grid(box.lower, box.upper, choice.resolution);
      add_to_grid(grid, far_lights(lights_, choice.near));
      made.field = std::make_unique<Field>(std::move(grid), std::move(near));
    });
    made.fill_seconds = times.total();
    return made;
  }

  SphereLights lights_;
  ExactField<N, Sphere> exact_;
};

extern template class PlannedLightingOf<3>;
extern template class PlannedLightingOf<5>;
extern template class PlannedLightingOf<7>;
extern template class PlannedLightingOf<9>;

}  // namespace example::grid_render
