// Fewer probes where they tell nothing new: a sequence is taken as a camera moves, as often as it can.
//
// [1] Loew, Ynnerman, Larsson, Unger, HDR light probe sequence resampling for realtime incident light field rendering,
//     SCCG 2009, section 5.1.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "../scalar/for_each.hpp"
#include "buckets.hpp"
#include "sequence.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Where a probe is redundant: if it is like the last one that is kept, and like the next, and lies close to both. The
/// paper compares with its neighbours in the sequence; where light changes slowly, with them all could go, each like
/// the next, the last unlike the first.
struct Thinning {
  float difference = 0.05F;  // energy of the absolute difference, of the mean energy of the two
  float distance = std::numeric_limits<float>::infinity();  // in the positions' unit
};

namespace detail {
/// The energy of the absolute difference, of the mean of both; of directions that both know. Infinite where there are
/// none.
inline double relative_difference(const DirectionBuckets& buckets, const RadianceSample* a, const RadianceSample* b) {
  double difference = 0, energy = 0;
  bool is_any = false;
  for (std::size_t n = 0; n < buckets.size(); ++n) {
    if (!is_sample(a[n]) || !is_sample(b[n])) continue;
    const auto solid_angle = double(buckets[n].solid_angle);
    for (int c = 0; c < 3; ++c) {
      difference += solid_angle * std::abs(double(a[n][c]) - double(b[n][c]));
      energy += solid_angle * 0.5 * (double(a[n][c]) + double(b[n][c]));
    }
    is_any = true;
  }
  if (!is_any) return std::numeric_limits<double>::infinity();
  return energy > 0 ? difference / energy : 0;
}
}  // namespace detail

/// The numbers of the probes that are not redundant, ascending; the first and the last always are among them.
/// load(probe, use): see bake.hpp; each picture is loaded once, `together` of them at a time.
template <class Load, class ForEach = SerialForEach>
std::vector<std::size_t> thin(const ProbeSequence& sequence, const DirectionBuckets& buckets, const Thinning& thinning,
                              const Load& load, ForEach&& for_each = {}, std::size_t together = 32) {
  const std::vector<SequenceProbe>& probes = sequence.probes;
  const std::size_t size = buckets.size();
  // What the last one kept shows, and a run of those that follow.
  std::vector<RadianceSample> kept(size), run(size * (together + 1));
  std::size_t begin = 0, end = 0;
  const auto samples_of = [&](std::size_t n) {
    if (n >= end) {
      if (end > 0) {  // the last stays, as the first
        std::copy_n(run.data() + size * (end - 1 - begin), size, run.data());
        begin = end - 1;
      }
      end = (std::min)(begin + together + 1, probes.size());
      const std::size_t first = n;
      for_each(static_cast<int>(end - first), [&](int i) {
        const std::size_t number = first + static_cast<std::size_t>(i);
        load(probes[number], [&](const auto& environment) {
          PictureFaults faults;
          buckets.sort(environment, sequence.orientation_of(probes[number]), sequence.dead_angle_is,
                       run.data() + size * (number - begin), 1, faults);
        });
      });
    }
    return run.data() + size * (n - begin);
  };
  std::vector<std::size_t> result;
  const auto keep = [&](std::size_t n, const RadianceSample* samples) {
    result.push_back(n);
    std::copy_n(samples, size, kept.data());
  };
  for (std::size_t n = 0; n < probes.size(); ++n) {
    if (n == 0 || n + 1 == probes.size()) {
      keep(n, samples_of(n));
      continue;
    }
    const RadianceSample* next = samples_of(n + 1);  // first: it may move the run
    const RadianceSample* own = samples_of(n);
    const auto is_close = [&](std::size_t other) {
      return glm::distance(probes[n].position, probes[other].position) <= thinning.distance;
    };
    const auto is_like = [&](const RadianceSample* other) {
      return detail::relative_difference(buckets, own, other) <= double(thinning.difference);
    };
    if (!(is_close(result.back()) && is_close(n + 1) && is_like(kept.data()) && is_like(next))) keep(n, own);
  }
  return result;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
