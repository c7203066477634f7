// The paper's steps as they stand, kept as the reference: a bucket's samples are carried through the volume both ways
// along their rays, to the grid points within the kernel's reach; holes are repaired in three dimensions; what all
// points have is added to their coefficients.
//
// Beside the plane of resample.hpp: a ray counts at a grid point by its distance from the point, and not at points of a
// plane between which the grid point then interpolates; and it ends where the volume does, so that at the faces of the
// box the kernel is cut off. Cost of B buckets, P probes, and V points in a cube: some 9 V^(1/3) weighted additions for
// each of B P.
//
// [1] Loew, Ynnerman, Larsson, Unger, HDR light probe sequence resampling for realtime incident light field rendering,
//     SCCG 2009, section 3.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "resample.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

template <int N>
class ReferenceFieldSums {
 public:
  using Grid = CoefficientGrid<N, GridContent::values>;
  static constexpr const char* name = "space";

  explicit ReferenceFieldSums(const Grid& grid) : grid_(grid), sums_(grid.vertex_count()) {}

  /// Adds a block, as FieldSums does, but always by means.
  template <class ForEach = SerialForEach>
  void add(const DirectionBuckets& buckets, const SampleBlock& block, const std::vector<ProbePlace>& probes,
           float sphere_radius, const Resampling& resampling, ForEach&& for_each = {}) {
    lattices_.resize(SampleBlock::most_buckets);
    std::array<bool, SampleBlock::most_buckets> is_known{};
    for_each(static_cast<int>(block.count), [&](int b) {
      const auto n = static_cast<std::size_t>(b);
      is_known[n] = carry(buckets[block.first + n].direction, block.samples + n * probes.size(), probes, sphere_radius,
                          resampling.repair, lattices_[n]);
    });
    for (std::size_t n = 0; n < block.count; ++n) {
      if (!is_known[n]) continue;
      const Bucket& bucket = buckets[block.first + n];
      const Sh<N, double> weights = evaluate<N>(glm::dvec3(bucket.direction)) * double(bucket.solid_angle);
      for_each(grid_.resolution().z, [&](int k) {
        const std::size_t layer = sums_.size() / std::size_t(grid_.resolution().z);
        for (std::size_t v = std::size_t(k) * layer; v < std::size_t(k + 1) * layer; ++v) {
          const LatticePoint& point = lattices_[n][v];
          sums_[v] += weights * glm::dvec3(point.r, point.g, point.b);
        }
      });
      one_ += weights;
    }
  }

  template <class Visit>
  void visit_state(const Visit& visit) {
    static_assert(sizeof(Sh<N, glm::dvec3>) == 3 * N * N * sizeof(double));
    visit(&sums_[0][0].x, std::size_t{3 * N * N} * sums_.size());
    visit(&one_[0], static_cast<std::size_t>(one_.size()));
  }

  /// As FieldSums::finish.
  template <class ForEach = SerialForEach>
  bool finish(Grid& result, ForEach&& = {}) {
    const bool is_any = one_[0] > 0;
    detail::for_each_point(grid_.resolution(), [&](int i, int j, int k, std::size_t v) {
      const Sh<N, glm::dvec3>& sum = sums_[v];
      Sh<N, glm::vec3> value{};
      for (int n = 0; is_any && n < N * N; ++n) {
        value[n] = glm::vec3(detail::constant_exact_coefficient(n, sum[n], one_[n], sum[0], one_[0]));
      }
      grid_.set({i, j, k}, value);
    });
    result = grid_;
    return is_any;
  }

 private:
  // A bucket's samples to all grid points.
  bool carry(const glm::vec3& direction, const RadianceSample* samples, const std::vector<ProbePlace>& probes,
             float sphere_radius, Repair how, std::vector<LatticePoint>& lattice) const {
    lattice.assign(sums_.size(), LatticePoint{});
    const glm::vec3 way = glm::normalize(direction / grid_.spacing());  // of rays, in cells
    for (std::size_t p = 0; p < probes.size(); ++p) {
      if (!is_sample(samples[p])) continue;
      const glm::vec3 origin = (ray_origin(probes[p], direction, sphere_radius) - grid_.low()) / grid_.spacing();
      march(origin, way, samples[p], lattice.data());
    }
    for (LatticePoint& point : lattice) detail::normalise(point);
    return repair(how, lattice.data(), grid_.resolution());
  }

  // Layer by layer of the axis that the ray goes along most, the points in reach: each once.
  void march(const glm::vec3& origin, const glm::vec3& way, const RadianceSample& sample, LatticePoint* lattice) const {
    const glm::vec3 size = glm::abs(way);
    const int z = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0, x = (z + 1) % 3, y = (z + 2) % 3;
    const glm::ivec3& resolution = grid_.resolution();
    const float reach = kKernelRadius / size[z];  // within a layer
    for (int layer = 0; layer < resolution[z]; ++layer) {
      const glm::vec3 at = origin + way * ((float(layer) - origin[z]) / way[z]);
      glm::ivec3 point;
      point[z] = layer;
      for (point[y] = first(at[y] - reach, resolution[y]); point[y] <= last(at[y] + reach, resolution[y]); ++point[y]) {
        for (point[x] = first(at[x] - reach, resolution[x]); point[x] <= last(at[x] + reach, resolution[x]);
             ++point[x]) {
          const glm::vec3 offset = glm::vec3(point) - origin, across = offset - way * glm::dot(offset, way);
          const float distance2 = glm::dot(across, across);
          if (!(distance2 <= kKernelRadius * kKernelRadius)) continue;
          detail::add_weighted(lattice[grid_.vertex_index(point)], {sample.r, sample.g, sample.b, 1},
                               kernel_weight(distance2));
        }
      }
    }
  }
  static int first(float x, int size) { return detail::index_below(std::ceil(x), size); }
  static int last(float x, int size) { return int(std::floor((std::min)((std::max)(x, -1.0F), float(size - 1)))); }

  Grid grid_;
  std::vector<Sh<N, glm::dvec3>> sums_;
  Sh<N, double> one_{};
  std::vector<std::vector<LatticePoint>> lattices_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
