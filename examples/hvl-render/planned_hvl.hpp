#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <zonal/many_lights/hvl_tree.hpp>

#include "cached_gatherer.hpp"
#include "cut_rule.hpp"
#include "gather_hvl.hpp"
#include "hit_groups.hpp"
#include "planned_gather.hpp"
#include "shared/random.hpp"

namespace example::hvl_render {

/// Tile after tile: the hits of a tile by surface; for each of these groups a cut of the tree; and of that some draws,
/// each for the pixels at one place of a pattern of 4 x 4.
template <int N, int NE, zonal::Horizon H>
class PlannedHvl final : public PlannedGatherer {
 public:
  PlannedHvl(const GatherInput& input, const ScenePlan& plan) : input_(input) {
    zonal::HvlCache<NE> lights(lit(input.map));
    tree_ = zonal::HvlTree<NE>(lights, [](int count, const auto& body) { tbb::parallel_for(0, count, body); });
    if (tree_.size() > 0) turn_length_ = 0.2f * glm::length(tree_.tree().node(0).reach);
    if (input.options.checked_share > 0.0f) lights_ = std::move(lights);
    for (const MaterialNeeds& material : plan.materials) symmetry_.push_back(material.receiving.symmetry);
    for (std::size_t i = 0; i < input.materials.receiving.size(); ++i) one_colour_.push_back(one_colour(i));
  }

  void add(Image& image, const PrimaryHits& hits, const Stage& stage) override {
    const Tiles tiles(image.width, hits, tree_.size());
    const CutRule rule =
        find_cut_rule(input_.options.tolerance, tree_.size(), [&](const CutRule& tried, double exponent) {
          return for_each_tile<Glance>(tiles, false, [&](const Tile& tile, Scratch& scratch) {
            return for_each_group<Glance>(tiles, tile, hits, tried, scratch,
                                          [&](const HitGroup& group) { return glance(group, exponent, scratch); });
          });
        });
    figures_ += for_each_tile<PlanFigures>(tiles, true, [&](const Tile& tile, Scratch& scratch) {
      const PlanFigures figures =
          for_each_group<PlanFigures>(tiles, tile, hits, rule, scratch,
                                      [&](const HitGroup& group) { return add_group(image, hits, group, scratch); });
      stage.progress.advance(stage.label, stage.cost_per_pixel * tile.width * tile.height);
      return figures;
    });
  }

  PlanFigures figures() const override { return figures_; }
  LightBytes bytes() const override {
    const auto full = static_cast<std::size_t>(zonal::hvl_record_size(input_.options.emission_bands));  // numbers
    return {tree_.bytes(), static_cast<std::size_t>(tree_.size()) * full * sizeof(float)};
  }

 private:
  /// A material that looks the same from everywhere, in one colour: Lambert's.
  struct OneColour {
    zonal::Zh<N, float> coefficients;
    glm::vec3 colour;
  };
  /// What a thread works with.
  struct Scratch {
    HitGroups groups;
    std::vector<zonal::DrawnLights<NE>> draws;
    std::optional<zonal::LightCut<N, NE, H>> cut;
    std::array<const Hit*, zonal::cut_receivers> chosen;  // one of each part of the group
  };

  /// The sum of body(tile, scratch) over all tiles, or a fifth of them, on all threads, added up in order.
  template <class Sum, class Body>
  Sum for_each_tile(const Tiles& tiles, bool all, const Body& body) {
    std::vector<Sum> sums(static_cast<std::size_t>(tiles.count()));
    tbb::parallel_for(0, tiles.count(), [&](int number) {
      if (stop_requested() || !(all || tiles.is_sample(number))) return;
      sums[static_cast<std::size_t>(number)] = body(tiles[number], scratch_.local());
    });
    throw_if_interrupted();
    Sum total;
    for (const Sum& sum : sums) total += sum;
    return total;
  }

  /// The sum of body(group) over the groups of a tile, with their cuts found.
  template <class Sum, class Body>
  Sum for_each_group(const Tiles& tiles, const Tile& tile, const PrimaryHits& hits, const CutRule& rule,
                     Scratch& scratch, const Body& body) const {
    Sum sum;
    scratch.groups.for_each(tile, tiles.least_group(), hits, turn_length_, [&](const HitGroup& group) {
      find_cut(group, rule, scratch);
      sum += body(group);
    });
    return sum;
  }

  Glance glance(const HitGroup& group, double exponent, Scratch& scratch) const {
    Glance seen;
    seen.variance = scratch.cut->variance() * group.count();
    if (seen.variance > 0.0) seen.scaled = seen.variance / std::pow(scratch.cut->greatest_variance(), exponent);
    draw(group, 1, scratch);
    for (int part = 0; part < group.parts.parts; ++part) {
      const Hit& hit = *scratch.chosen[static_cast<std::size_t>(part)];
      seen.power += power_of(gather(scratch.draws[0], hit)) * group.parts.size(part);
    }
    return seen;
  }

  zonal::CutTolerance tolerance_of(const HitGroup& group, const CutRule& rule) const {
    constexpr double cut_cost = 400.0;  // gathers of a light that cost as much as to find and draw it for all
    zonal::CutTolerance tolerance;
    tolerance.with_visibility = input_.options.centre_visibility;
    tolerance.relative = rule.relative;
    tolerance.of_one_light = static_cast<float>(rule.of_one_light * (1.0 + cut_cost / group.count()));
    return tolerance;
  }

  std::uint64_t seed_of(const HitGroup& group, const Scratch& scratch) const {
    return hash64(input_.options.seed ^ hash64(scratch.groups.place(group, 0).sample));
  }

  /// For one of each part, at random, that stands for the part.
  void find_cut(const HitGroup& group, const CutRule& rule, Scratch& scratch) const {
    zonal::BoundedReceiver<N, float> receivers[zonal::cut_receivers];
    for (int part = 0; part < group.parts.parts; ++part) {
      const int first = group.parts.first[part], size = group.parts.size(part);
      const double place = zonal::detail::scatter(seed_of(group, scratch), static_cast<std::uint64_t>(part)) * size;
      const int chosen = first + std::min(static_cast<int>(place), size - 1);
      const Hit& hit = *scratch.groups.place(group, chosen).hit;
      scratch.chosen[static_cast<std::size_t>(part)] = &hit;
      zonal::Box3 positions;
      float chord = 0.0f;
      for (int i = first; i < first + size; ++i) {
        positions.add(group.receivers[i].position);
        chord = std::max(chord, glm::distance(group.receivers[i].normal, hit.normal));
      }
      const float tilt = 2.0f * std::asin(std::min(0.5f * chord, 1.0f));
      const float weight = static_cast<float>(zonal::cut_receivers * size) / static_cast<float>(group.count());
      receivers[part] = zonal::weighted(zonal::spread_over(bounded(hit), positions, tilt), weight);
    }
    std::fill(receivers + group.parts.parts, receivers + zonal::cut_receivers, zonal::weighted(receivers[0], 0.0f));
    if (!scratch.cut) scratch.cut.emplace(tree_.tree());
    scratch.cut->find(zonal::as_packet(receivers), tolerance_of(group, rule));
  }

  void draw(const HitGroup& group, int draws, Scratch& scratch) const {
    scratch.draws.resize(static_cast<std::size_t>(draws));
    zonal::ReceiverBox box;
    for (int i = 0; i < group.count(); ++i) box.add(group.receivers[i].position, group.receivers[i].normal);
    tree_.draw(*scratch.cut, box, seed_of(group, scratch), scratch.draws);
  }

  PlanFigures add_group(Image& image, const PrimaryHits& hits, const HitGroup& group, Scratch& scratch) const {
    const zonal::LightCut<N, NE, H>& cut = *scratch.cut;
    constexpr int most_draws = 4, hits_of_a_draw = 96;
    const int draws = std::clamp(group.count() / hits_of_a_draw, 1, most_draws);
    draw(group, draws, scratch);

    PlanFigures figures;
    figures.hits = static_cast<std::size_t>(group.count()), figures.groups = 1;
    figures.variance = cut.variance() * group.count();
    figures.cut_lights = static_cast<double>(cut.size()) * group.count();
    for (const auto& drawn : scratch.draws) figures.pairs += static_cast<double>(drawn.size()) * group.count() / draws;
    for (std::uint32_t number = 0; number < static_cast<std::uint32_t>(draws); ++number) {
      for (int i = 0; i < group.count(); ++i) {
        const Place& place = scratch.groups.place(group, i);
        if (place.pattern * static_cast<std::uint32_t>(draws) / 16 != number) continue;
        const glm::vec3 radiance = gather(scratch.draws[number], *place.hit);
        image.pixels[place.pixel] += radiance / static_cast<float>(hits.per_pixel());
        figures.power += power_of(radiance);
        if (is_checked(place.sample)) check(figures, radiance, *place.hit);
      }
    }
    return figures;
  }

  std::optional<OneColour> one_colour(std::size_t material) const {
    const auto& table = input_.materials.receiving[material];
    if (symmetry_[material] != zonal::Symmetry::zonal || table.angles() > 1 ||
        input_.materials.parts.count(static_cast<std::uint32_t>(material)) > 0) {
      return std::nullopt;
    }
    const auto colours = about_axis(table.template with_cosine<N>(1.0f));
    OneColour result{{}, colours[0]};
    for (int l = 0; l < N; ++l) {
      result.coefficients[l] =
          glm::dot(colours[l], result.colour) / std::max(glm::dot(result.colour, result.colour), 1e-30f);
      const glm::vec3 difference = colours[l] - result.coefficients[l] * result.colour;
      if (glm::length(difference) > 1e-6f * glm::length(result.colour)) return std::nullopt;
    }
    return result;
  }

  zonal::BoundedReceiver<N, float> bounded(const Hit& hit) const {
    const zonal::Receiver receiver = receiver_at(hit);
    if (const auto& anisotropic = input_.materials.anisotropic[hit.material]) {
      return zonal::bounded_receiver<N>(receiver, *anisotropic);
    }
    const auto coefficients = coefficients_at<N>(input_.materials, hit, receiver);
    if (symmetry_[hit.material] == zonal::Symmetry::zonal) {
      return zonal::bounded_receiver(receiver, about_axis(coefficients));
    }
    return zonal::bounded_receiver(receiver, coefficients);
  }

  zonal::Receiver receiver_at(const Hit& hit) const {
    return {hit.position, hit.normal, towards_camera(input_.scene, hit), hit.tangent};
  }

  /// From the cache of all lights, or from those drawn.
  template <class Lights>
  glm::vec3 gather(const Lights& lights, const Hit& hit) const {
    const CentreRay ray{input_.caster, hit};
    const zonal::Visibility visible = input_.options.centre_visibility ? zonal::Visibility(ray) : zonal::Visibility();
    const zonal::Receiver receiver = receiver_at(hit);
    if (const auto& anisotropic = input_.materials.anisotropic[hit.material]) {
      return zonal::gather<N, NE, H>(lights, receiver, *anisotropic, visible);
    }
    if (const auto& material = one_colour_[hit.material]) {
      return material->colour * zonal::gather<N, NE, H>(lights, receiver, material->coefficients, visible);
    }
    const auto coefficients = coefficients_at<N>(input_.materials, hit, receiver);
    if (symmetry_[hit.material] == zonal::Symmetry::mirror) {
      return zonal::gather<N, NE, H>(lights, receiver, coefficients, visible);
    }
    return zonal::gather<N, NE, H>(lights, receiver, about_axis(coefficients), visible);
  }

  static double power_of(const glm::vec3& radiance) { return glm::dot(glm::dvec3(radiance), glm::dvec3(radiance)); }

  bool is_checked(std::size_t sample) const {
    return unit_float(static_cast<std::uint32_t>(hash64(sample) >> 32)) < input_.options.checked_share;
  }
  void check(PlanFigures& figures, const glm::vec3& radiance, const Hit& hit) const {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const glm::vec3 full = gather(lights_, hit);
    figures.checked_seconds += std::chrono::duration<double>(Clock::now() - start).count();
    ++figures.checked;
    figures.checked_error += power_of(radiance - full);
    figures.checked_power += power_of(full);
  }

  GatherInput input_;
  std::vector<zonal::Symmetry> symmetry_;             // of each material
  std::vector<std::optional<OneColour>> one_colour_;  // where it is one
  zonal::HvlCache<NE> lights_;                        // to check
  zonal::HvlTree<NE> tree_;
  float turn_length_ = 1.0f;  // a turn by 1 rad matters as much to a receiver as to move by that
  tbb::enumerable_thread_specific<Scratch> scratch_;
  PlanFigures figures_;
};

/// Null for numbers of bands that are not compiled in.
template <zonal::Horizon H>
std::unique_ptr<PlannedGatherer> make_planned_hvl(const GatherInput& input, const ScenePlan& plan) {
  std::unique_ptr<PlannedGatherer> gatherer;
  for (const int emission_bands : compiled_emission_bands) {  // the least that will do
    if (gatherer || emission_bands < plan.emission_bands) continue;
    dispatch_hvl<H>(input.options.bands, emission_bands, [&](auto n, auto ne) {
      if constexpr (contains(compiled_planned_bands, n)) gatherer = std::make_unique<PlannedHvl<n, ne, H>>(input, plan);
    });
  }
  return gatherer;
}

}  // namespace example::hvl_render
