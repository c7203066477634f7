#include "layers.hpp"

namespace example {

std::size_t render_layers(const Scene& scene, const RayCaster& caster, const CommonOptions& options,
                          const std::vector<Layer>& layers, StageTimes& times) {
  constexpr double primary_cost = 1.0;
  double cost = primary_cost;
  for (const Layer& layer : layers) cost += layer.cost;
  Progress progress(!options.quiet);
  progress.expect(cost * static_cast<double>(primary_samples(options)));

  const auto stage = [&](const char* label, double sample_cost) {
    return Stage{progress, label, sample_cost * options.antialias * options.antialias};
  };
  std::size_t hit_count = 0;
  for_each_slice(options.width, options.height, options.antialias, [&](Slice slice) {
    const PrimaryHits hits = times.time(stage_name::primary, [&] {
      return trace_primary(caster, scene.camera, options.width, options.height, slice, options.antialias,
                           stage(stage_name::primary, primary_cost));
    });
    hit_count += hits.count();
    for (const Layer& layer : layers) {
      times.time(layer.name, [&] { layer.add(hits, stage(layer.name.c_str(), layer.cost)); });
    }
  });
  return hit_count;
}

std::size_t primary_samples(const CommonOptions& options) {
  return static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height) *
         static_cast<std::size_t>(options.antialias) * static_cast<std::size_t>(options.antialias);
}

}  // namespace example
