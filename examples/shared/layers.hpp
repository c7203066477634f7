#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "common_options.hpp"
#include "primary_hits.hpp"
#include "stage_times.hpp"

namespace example {

/// Light that is added to a picture: the whole of it, or one part, as direct light is.
struct Layer {
  std::string name;                                           // of its time, and while it runs
  double cost;                                                // of a primary sample, in primary rays
  std::function<void(const PrimaryHits&, const Stage&)> add;  // a slice of it
};

/// Adds the mean of radiance(hit, number of the sample in the picture), which it may ask for on all threads. The
/// picture must outlive the layer.
template <class Radiance>
Layer layer(std::string name, double cost, Image& picture, Radiance radiance) {
  return {std::move(name), cost,
          [&picture, radiance = std::move(radiance)](const PrimaryHits& hits, const Stage& stage) {
            add_radiance(picture, hits, stage, radiance);
          }};
}

/// Traces the primary rays and adds the layers, one after the other, slice by slice, with a bar of progress. Returns
/// how many positions see a surface. Throws Interrupted soon after Ctrl-C.
std::size_t render_layers(const Scene& scene, const RayCaster& caster, const CommonOptions& options,
                          const std::vector<Layer>& layers, StageTimes& times);

/// Positions that render_layers looks from.
std::size_t primary_samples(const CommonOptions& options);

}  // namespace example
