// From samples of light probes to the coefficients of a grid, direction by direction.
//
// For each bucket the samples make a plane of radiance (direction_plane.hpp); each grid point looks its value up there,
// and adds value times solid angle times Y(direction) to its coefficients. Nothing else is kept, so memory is that of
// the grid, however many samples there are.
//
// Buckets come in blocks, and grid points in tiles of 16. A tile looks up a block of buckets, then adds it with its
// sums in registers. Cost, of B buckets, P probes, V grid points and C coefficients: some 7 additions of 16 numbers
// (where samples are dense 28) for each of B P, one look-up (with gradients five) for each of B V, and 3 B V C
// multiply-adds (with gradients four times as many).
//
// The result does not depend on the threads, to the bit.
//
// [1] Loew, Ynnerman, Larsson, Unger, HDR light probe sequence resampling for realtime incident light field rendering,
//     SCCG 2009, section 3.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "../basis/evaluate.hpp"
#include "../environment/picture_sums.hpp"
#include "../grid/coefficient_grid.hpp"
#include "../scalar/for_each.hpp"
#include "../scalar/lanes.hpp"
#include "../scalar/refuse.hpp"
#include "../scalar/unroll.hpp"
#include "buckets.hpp"
#include "direction_plane.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Where a probe was taken, and where its camera looked.
struct ProbePlace {
  glm::vec3 position;  // of the mirror sphere's middle
  glm::vec3 forward;   // unit; +x of the picture
};
inline ProbePlace place_of(const ProbeSequence& sequence, const SequenceProbe& probe) {
  return {probe.position, sequence.orientation_of(probe) * glm::vec3(1, 0, 0)};
}

/// Where a sample's ray begins: on the mirror sphere, where it was turned to the camera, and not in its middle
/// ([1] section 5.2).
inline glm::vec3 ray_origin(const ProbePlace& probe, const glm::vec3& direction, float sphere_radius) {
  const glm::vec3 normal = direction - probe.forward;
  const float length = glm::length(normal);
  return length > 0 ? probe.position + normal * (sphere_radius / length) : probe.position;
}

/// A block of buckets with what the probes have in them.
struct SampleBlock {
  static constexpr std::size_t most_buckets = 64;

  std::size_t first, count;       // buckets, at most most_buckets
  const RadianceSample* samples;  // count rows of one sample for each probe
};

/// A grid's coefficients on their way.
template <int N, GridContent content = GridContent::values>
class FieldSums {
 public:
  using Grid = CoefficientGrid<N, content>;
  static constexpr const char* name = "plane";

  /// Of nothing. The grid says where its points are; its coefficients are written over.
  explicit FieldSums(Grid grid) : grid_(std::move(grid)), rest_(lanes_ * Grid::vertex_size) {
    std::fill(grid_.data(), grid_.data() + grid_.size(), 0.0F);
  }

  /// Adds a block. Which blocks there are, and their order, must be the same for the same bits.
  template <class ForEach = SerialForEach>
  void add(const DirectionBuckets& buckets, const SampleBlock& block, const std::vector<ProbePlace>& probes,
           float sphere_radius, const Resampling& resampling, ForEach&& for_each = {}) {
    planes_.resize(SampleBlock::most_buckets);
    std::array<bool, SampleBlock::most_buckets> is_known{};
    for_each(static_cast<int>(block.count), [&](int b) {
      const auto n = static_cast<std::size_t>(b);
      is_known[n] = planes_[n].make(buckets[block.first + n].direction, block.samples + n * probes.size(), probes,
                                    sphere_radius, grid_, resampling);
    });
    known_.clear();
    for (std::size_t n = 0; n < block.count; ++n) {
      if (!is_known[n]) continue;
      const Bucket& bucket = buckets[block.first + n];
      known_.push_back({&planes_[n], evaluate<N>(bucket.direction) * bucket.solid_angle});
      for (int i = 0; i < N * N; ++i) one_[static_cast<std::size_t>(i)] += double(known_.back().weights[i]);
    }
    for_each(static_cast<int>(tile_count()), [&](int tile) { add_to_tile(static_cast<std::size_t>(tile)); });
  }

  /// The coefficients. What no probe showed anywhere in the box counts as the mean of the rest, and a field of one
  /// radiance has one coefficient (TexelRule::constant_exact). False, and all 0, where no sample met the box.
  template <class ForEach = SerialForEach>
  bool finish(Grid& result, ForEach&& for_each = {}) {
    const bool is_any = one_[0] > 0;
    for_each(static_cast<int>(tile_count()), [&](int tile) { finish_tile(static_cast<std::size_t>(tile), is_any); });
    result = std::move(grid_);
    return is_any;
  }

  /// All that add() changes, to be kept or added up: visit(floats, count) and visit(doubles, count).
  template <class Visit>
  void visit_state(const Visit& visit) {
    visit(grid_.data(), grid_.size());
    visit(rest_.data(), rest_.size());
    visit(one_.data(), one_.size());
  }

 private:
  static constexpr std::size_t lanes_ = 16;  // grid points of a tile
  static constexpr auto channels_ = static_cast<std::size_t>(3 * Grid::block_count);

  struct Plane {
    DirectionPlane radiance;
    glm::vec3 slope[2];  // of the place on the plane, by position

    bool make(const glm::vec3& direction, const RadianceSample* samples, const std::vector<ProbePlace>& probes,
              float sphere_radius, const Grid& grid, const Resampling& resampling) {
      const glm::vec3 cells = 1.0F / grid.spacing();
      const bool is_any = radiance.make(direction * cells, grid.resolution(), resampling, [&](const auto& add) {
        for (std::size_t p = 0; p < probes.size(); ++p) {
          if (!is_sample(samples[p])) continue;
          add((ray_origin(probes[p], direction, sphere_radius) - grid.low()) * cells, samples[p]);
        }
      });
      for (int a = 0; a < 2; ++a) slope[a] = radiance.slope(a) * cells;
      return is_any;
    }
  };
  struct KnownBucket {
    const Plane* plane;
    Sh<N, float> weights;  // solid angle times Y
  };

  std::size_t tile_count() const { return (grid_.vertex_count() + lanes_ - 1) / lanes_; }
  // The sums of a tile stand in the place of its points in the grid, number by number with 16 points side by side;
  // those of a last one that is not full, apart.
  float* sums_of(std::size_t tile) {
    const bool is_full = (tile + 1) * lanes_ <= grid_.vertex_count();
    return is_full ? grid_.data() + tile * lanes_ * Grid::vertex_size : rest_.data();
  }

  void add_to_tile(std::size_t tile) {
    // Where its points are, in cells.
    glm::vec3 points[lanes_];
    const auto across = static_cast<std::size_t>(grid_.resolution().x),
               up = static_cast<std::size_t>(grid_.resolution().y);
    for (std::size_t lane = 0; lane < lanes_; ++lane) {
      const std::size_t vertex = (std::min)(tile * lanes_ + lane, grid_.vertex_count() - 1), row = vertex / across;
      points[lane] = {float(vertex % across), float(row % up), float(row / up)};
    }
    alignas(64) float values[SampleBlock::most_buckets][channels_][lanes_];
    for (std::size_t b = 0; b < known_.size(); ++b) look_up(*known_[b].plane, points, values[b]);
    add_values(values, sums_of(tile));
  }

  static void look_up(const Plane& plane, const glm::vec3 (&points)[lanes_], float (&values)[channels_][lanes_]) {
    for (std::size_t lane = 0; lane < lanes_; ++lane) {
      const auto [x, y] = plane.radiance.place(points[lane]);
      float numbers[4];
      const auto put = [&](std::size_t block, const Lanes<float, 4>& colour) {
        colour.store(numbers);
        for (std::size_t c = 0; c < 3; ++c) values[3 * block + c][lane] = numbers[c];
      };
      put(0, plane.radiance.radiance(x, y));
      if constexpr (Grid::has_gradients) {
        const auto by_x = plane.radiance.radiance(x + 0.5F, y) - plane.radiance.radiance(x - 0.5F, y);
        const auto by_y = plane.radiance.radiance(x, y + 0.5F) - plane.radiance.radiance(x, y - 0.5F);
        for (int axis = 0; axis < 3; ++axis) {
          put(std::size_t(1 + axis),
              Lanes<float, 4>(plane.slope[0][axis]) * by_x + Lanes<float, 4>(plane.slope[1][axis]) * by_y);
        }
      }
    }
  }

  // sums[block][coefficient][colour][lane] += the sum over buckets of weight[coefficient] * value[block][colour][lane].
  void add_values(const float (*values)[channels_][lanes_], float* sums) const {
    using Points = Lanes<float, kNativeLanes>;
    constexpr int parts = int{lanes_} / kNativeLanes, together = kNativeLanes == 16 ? 6 : 4;  // that registers hold
    for (int part = 0; part < parts * Grid::block_count; ++part) {
      const auto block = static_cast<std::size_t>(part / parts),
                 lane = static_cast<std::size_t>(part % parts * kNativeLanes);
      float* target = sums + block * std::size_t{Grid::block_size} * lanes_ + lane;
      unroll<0, (N * N + together - 1) / together>([&](auto group) {
        constexpr int first = group * together;
        constexpr auto count = static_cast<std::size_t>((std::min)(together, N * N - first));
        Points partial[count][3];
        const auto at = [&](std::size_t i, std::size_t c) { return target + (3 * (first + i) + c) * lanes_; };
        for (std::size_t i = 0; i < count; ++i) {
          for (std::size_t c = 0; c < 3; ++c) partial[i][c] = Points::load(at(i, c));
        }
        for (std::size_t b = 0; b < known_.size(); ++b) {
          Points colour[3];
          for (std::size_t c = 0; c < 3; ++c) colour[c] = Points::load(&values[b][3 * block + c][lane]);
          for (std::size_t i = 0; i < count; ++i) {
            const Points weight(known_[b].weights.values[first + i]);
            for (std::size_t c = 0; c < 3; ++c) partial[i][c].add_product(weight, colour[c]);
          }
        }
        for (std::size_t i = 0; i < count; ++i) {
          for (std::size_t c = 0; c < 3; ++c) partial[i][c].store(at(i, c));
        }
      });
    }
  }

  // From sums to coefficients, in the grid's order.
  void finish_tile(std::size_t tile, bool is_any) {
    const float* sums = sums_of(tile);
    const std::vector<float> numbers(sums, sums + lanes_ * Grid::vertex_size);
    const std::size_t first = tile * lanes_, count = (std::min)(lanes_, grid_.vertex_count() - first);
    for (std::size_t n = 0; n < std::size_t(Grid::vertex_size) * count; ++n) {
      const std::size_t vertex = n / Grid::vertex_size, number = n % Grid::vertex_size;
      const std::size_t coefficient = number % Grid::block_size / 3, first_number = number - 3 * coefficient;
      const double sum = double(numbers[number * lanes_ + vertex]);
      const double first_sum = double(numbers[first_number * lanes_ + vertex]);
      const double value =
          is_any ? detail::constant_exact_coefficient(int(coefficient), sum, one_[coefficient], first_sum, one_[0]) : 0;
      grid_.data()[first * Grid::vertex_size + n] = float(value);
    }
  }

  Grid grid_;
  std::vector<float> rest_;
  std::array<double, std::size_t{N * N}> one_{};  // the sum of solid angle times Y, of buckets that are known
  std::vector<Plane> planes_;
  std::vector<KnownBucket> known_;
};

/// All of it, where memory holds all samples: samples[b * probes.size() + p] is what probe p has in bucket b. Writes
/// the grid's coefficients; false, and all 0, where no ray came near the box. Sums is FieldSums, or ReferenceFieldSums.
template <class Sums, class ForEach = SerialForEach>
bool resample(typename Sums::Grid& grid, const DirectionBuckets& buckets, const std::vector<RadianceSample>& samples,
              const std::vector<ProbePlace>& probes, float sphere_radius, const Resampling& resampling = {},
              ForEach&& for_each = {}) {
  if (samples.size() != buckets.size() * probes.size()) {
    detail::refuse("samples that are not one for each bucket and probe");
  }
  Sums sums(grid);
  constexpr std::size_t most = SampleBlock::most_buckets;
  for (std::size_t first = 0; first < buckets.size() && !probes.empty(); first += most) {
    const SampleBlock block{first, (std::min)(most, buckets.size() - first), &samples[first * probes.size()]};
    sums.add(buckets, block, probes, sphere_radius, resampling, for_each);
  }
  return sums.finish(grid, for_each);
}
template <int N, GridContent content, class ForEach = SerialForEach>
bool resample(CoefficientGrid<N, content>& grid, const DirectionBuckets& buckets,
              const std::vector<RadianceSample>& samples, const std::vector<ProbePlace>& probes, float sphere_radius,
              const Resampling& resampling = {}, ForEach&& for_each = {}) {
  return resample<FieldSums<N, content>>(grid, buckets, samples, probes, sphere_radius, resampling, for_each);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
