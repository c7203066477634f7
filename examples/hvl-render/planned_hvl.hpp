#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <zonal/many_lights/hvl_tree.hpp>
#include <zonal/many_lights/receiver_groups.hpp>

#include "cached_gatherer.hpp"
#include "gather_hvl.hpp"
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
    if (input.options.checked_share > 0.0f) lights_ = std::move(lights);
    for (const MaterialNeeds& material : plan.materials) symmetry_.push_back(material.receiving.symmetry);
    for (std::size_t i = 0; i < input.materials.receiving.size(); ++i) one_colour_.push_back(one_colour(i));
    // The rest is for what the glance is off by.
    tolerance_.relative = 0.95f * static_cast<float>(input.options.tolerance);
    tolerance_.with_visibility = input.options.centre_visibility;
  }

  void add(Image& image, const PrimaryHits& hits, const Stage& stage) override {
    const Tiles tiles(image.width, hits);
    if (!(tolerance_.typical_radiance > 0.0f)) tolerance_.typical_radiance = glance(tiles, hits);
    figures_ += for_each_tile(tiles, 1, [&](const Tile& tile, Scratch& scratch) {
      collect(tile, hits, scratch);
      const PlanFigures figures =
          for_each_group(scratch, [&](const Group& group) { return add_group(image, hits, group, scratch); });
      stage.progress.advance(stage.label, stage.cost_per_pixel * tile.width * tile.height);
      return figures;
    });
  }

  PlanFigures figures() const override { return figures_; }
  LightBytes bytes() const override {
    const auto full =
        static_cast<std::size_t>(zonal::EvenEmission::size(input_.options.emission_bands)) * 3 + 10;  // numbers
    return {tree_.bytes(), static_cast<std::size_t>(tree_.size()) * full * sizeof(float)};
  }

 private:
  /// Pixels of the slice.
  struct Tile {
    int left, top, width, height;
  };
  struct Tiles {
    int width, height, side, across, down;

    /// A twentieth of the picture across: cuts then cost little, and few surfaces change much within a tile.
    Tiles(int image_width, const PrimaryHits& hits)
        : width(image_width), height(hits.slice().rows), side(std::clamp(image_width / 80 * 4, 8, 64)) {
      // About as many hits, whatever is seen of a pixel.
      side = std::max(4, static_cast<int>(side / std::sqrt(static_cast<double>(hits.per_pixel()))) / 4 * 4);
      across = (width + side - 1) / side;
      down = (height + side - 1) / side;
    }

    int count() const { return across * down; }
    Tile operator[](int number) const {
      const int left = number % across * side, top = number / across * side;
      return {left, top, std::min(side, width - left), std::min(side, height - top)};
    }
  };
  /// A hit of a tile: of which pixel and sample of the image.
  struct Place {
    const Hit* hit;
    std::size_t pixel, sample;
    std::uint32_t pattern;  // 0 to 15, by which it takes a draw
  };
  struct Group {
    zonal::GroupedReceiver* receivers;
    int count;
  };
  /// A material that looks the same from everywhere, in one colour: Lambert's.
  struct OneColour {
    zonal::Zh<N, float> coefficients;
    glm::vec3 colour;
  };
  /// What a thread works with.
  struct Scratch {
    std::vector<Place> places;
    std::vector<zonal::GroupedReceiver> receivers;
    std::vector<zonal::DrawnLights<NE>> draws;
    std::optional<zonal::LightCut<N, NE, H>> cut;

    const Place& place(const Group& group, int i) const {
      return places[static_cast<std::size_t>(group.receivers[i].index)];
    }
  };

  /// The sum of body(tile, scratch) over every step-th tile, on all threads, added up in order.
  template <class Body>
  PlanFigures for_each_tile(const Tiles& tiles, int step, const Body& body) {
    std::vector<PlanFigures> figures(static_cast<std::size_t>(tiles.count()));
    tbb::parallel_for(0, tiles.count(), step, [&](int number) {
      if (!stop_requested()) figures[static_cast<std::size_t>(number)] = body(tiles[number], scratch_.local());
    });
    throw_if_interrupted();
    PlanFigures sum;
    for (const PlanFigures& tile : figures) sum += tile;
    return sum;
  }

  /// The sum of body(group) over the groups of a tile, with their cuts found.
  template <class Body>
  PlanFigures for_each_group(Scratch& scratch, const Body& body) const {
    PlanFigures sum;
    zonal::for_each_receiver_group(scratch.receivers.data(), static_cast<int>(scratch.receivers.size()),
                                   [&](zonal::GroupedReceiver* receivers, int count) {
                                     sum += for_each_part(Group{receivers, count}, scratch, body);
                                   });
    return sum;
  }

  /// Parts a group of which some are so much nearer to lights that those chosen do not tell of all.
  template <class Body>
  PlanFigures for_each_part(const Group& group, Scratch& scratch, const Body& body) const {
    constexpr int least_count = 32;
    const auto is_uneven = [&](const zonal::CutTolerance& tolerance, double most) {
      find_cut(group, tolerance, scratch);
      return group.count >= 2 * least_count && scratch.cut->unevenness() > most;
    };
    zonal::CutTolerance coarse = tolerance_;
    coarse.relative = std::max(coarse.relative, 0.2f);
    if (is_uneven(coarse, 3.0) || is_uneven(tolerance_, 4.0)) {
      const int half = zonal::halve_receivers(group.receivers, group.count);
      PlanFigures sum = for_each_part({group.receivers, half}, scratch, body);
      return sum += for_each_part({group.receivers + half, group.count - half}, scratch, body);
    }
    return body(group);
  }

  void collect(const Tile& tile, const PrimaryHits& hits, Scratch& scratch) const {
    // Ordered dither: what stands near together, in rows and columns too, is spread over the draws.
    constexpr std::uint32_t ordered[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    scratch.places.clear();
    scratch.receivers.clear();
    const auto per_pixel = static_cast<std::uint32_t>(hits.per_pixel());
    for (int y = tile.top; y < tile.top + tile.height; ++y) {
      for (int x = tile.left; x < tile.left + tile.width; ++x) {
        const std::size_t in_slice = hits.index(x, y), pixel = hits.index(x, y + hits.slice().first_row);
        for (std::uint32_t sample = 0; sample < per_pixel; ++sample) {
          const std::optional<Hit>& hit = hits.of_pixel(in_slice)[sample];
          if (!hit) continue;
          scratch.receivers.push_back({hit->position, hit->normal, static_cast<int>(scratch.places.size())});
          const std::uint32_t pattern = (ordered[y % 4][x % 4] + 7 * sample) % 16;
          scratch.places.push_back({&*hit, pixel, pixel * per_pixel + sample, pattern});
        }
      }
    }
  }

  /// The tolerance's typical radiance, by cuts at some of the tiles.
  float glance(const Tiles& tiles, const PrimaryHits& hits) {
    constexpr int one_of = 3;
    const PlanFigures figures = for_each_tile(tiles, one_of, [&](const Tile& tile, Scratch& scratch) {
      collect(tile, hits, scratch);
      return for_each_group(scratch, [&](const Group& group) {
        PlanFigures seen;
        seen.hits = static_cast<std::size_t>(group.count);
        seen.magnitude = std::sqrt(scratch.cut->power()) * group.count;
        draw(group, 1, scratch);
        for (int i = 0; i < zonal::cut_receivers; ++i) {
          const glm::vec3 radiance = gather(scratch.draws[0], *chosen(group, i, scratch).hit);
          seen.power += power_of(radiance) * group.count / zonal::cut_receivers;
        }
        return seen;
      });
    });
    return figures.magnitude > 0.0 ? static_cast<float>(figures.power / figures.magnitude) : 0.0f;
  }

  std::uint64_t seed_of(const Group& group, const Scratch& scratch) const {
    return hash64(input_.options.seed ^ hash64(scratch.place(group, 0).sample));
  }

  /// One of those that stand for the group.
  const Place& chosen(const Group& group, int i, const Scratch& scratch) const {
    const std::uint64_t seed = seed_of(group, scratch);
    const double part = (i + zonal::detail::scatter(seed, static_cast<std::uint64_t>(i))) / zonal::cut_receivers;
    return scratch.place(group, std::min(static_cast<int>(part * group.count), group.count - 1));
  }

  void find_cut(const Group& group, const zonal::CutTolerance& tolerance, Scratch& scratch) const {
    zonal::BoundedReceiver<N, float> receivers[zonal::cut_receivers];
    for (int i = 0; i < zonal::cut_receivers; ++i) receivers[i] = bounded(*chosen(group, i, scratch).hit);
    if (!scratch.cut) scratch.cut.emplace(tree_.tree());
    scratch.cut->find(zonal::as_packet(receivers), tolerance);
  }

  void draw(const Group& group, int draws, Scratch& scratch) const {
    scratch.draws.resize(static_cast<std::size_t>(draws));
    zonal::ReceiverBox box;
    for (int i = 0; i < group.count; ++i) box.add(group.receivers[i].position, group.receivers[i].normal);
    tree_.draw(*scratch.cut, box, seed_of(group, scratch), scratch.draws);
  }

  PlanFigures add_group(Image& image, const PrimaryHits& hits, const Group& group, Scratch& scratch) const {
    const zonal::LightCut<N, NE, H>& cut = *scratch.cut;
    constexpr int most_draws = 8, hits_of_a_draw = 12;
    const int draws = std::clamp(group.count / hits_of_a_draw, 1, most_draws);
    draw(group, draws, scratch);

    PlanFigures figures;
    figures.hits = static_cast<std::size_t>(group.count), figures.groups = 1;
    figures.variance = cut.variance() * group.count;
    figures.cut_lights = static_cast<double>(cut.size()) * group.count;
    for (const auto& drawn : scratch.draws) figures.pairs += static_cast<double>(drawn.size()) * group.count / draws;
    for (std::uint32_t number = 0; number < static_cast<std::uint32_t>(draws); ++number) {
      for (int i = 0; i < group.count; ++i) {
        const Place& place = scratch.place(group, i);
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
    return zonal::bounded_receiver(receiver, coefficients_at<N>(input_.materials, hit, receiver));
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
  zonal::CutTolerance tolerance_;
  zonal::HvlCache<NE> lights_;  // to check
  zonal::HvlTree<NE> tree_;
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
