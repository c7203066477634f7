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
    if (tree_.size() > 0) turn_length_ = 0.2f * glm::length(tree_.tree().node(0).reach);
    if (input.options.checked_share > 0.0f) lights_ = std::move(lights);
    for (const MaterialNeeds& material : plan.materials) symmetry_.push_back(material.receiving.symmetry);
    for (std::size_t i = 0; i < input.materials.receiving.size(); ++i) one_colour_.push_back(one_colour(i));
  }

  void add(Image& image, const PrimaryHits& hits, const Stage& stage) override {
    const Tiles tiles(image.width, hits, tree_.size());
    const Rule rule = glance(tiles, hits);
    figures_ += for_each_tile<PlanFigures>(tiles, true, [&](const Tile& tile, Scratch& scratch) {
      collect(tile, hits, scratch);
      const PlanFigures figures = for_each_group<PlanFigures>(
          scratch, rule, [&](const Group& group) { return add_group(image, hits, group, scratch); });
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
  static constexpr int few_lights = 2000;

  /// Pixels of the slice.
  struct Tile {
    int left, top, width, height;
  };
  struct Tiles {
    int width, height, side, across, down;

    /// A twentieth of the picture across: few surfaces change much within a tile. Of few lights a cut costs more than
    /// it saves where fewer hits share it.
    Tiles(int image_width, const PrimaryHits& hits, int lights)
        : width(image_width),
          height(hits.slice().rows),
          side(std::clamp(image_width / 80 * (lights < few_lights ? 6 : 4), 8, 96)) {
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
  /// Hits that share a cut, in parts of neighbours.
  struct Group {
    zonal::GroupedReceiver* receivers;
    zonal::ReceiverParts<zonal::cut_receivers> parts;

    int count() const { return parts.size(); }
  };
  /// A material that looks the same from everywhere, in one colour: Lambert's.
  struct OneColour {
    zonal::Zh<N, float> coefficients;
    glm::vec3 colour;
  };
  /// How finely the cuts of a slice are made: each by its own radiance, or, once it is known what a light may deviate
  /// by for all to be within the tolerance, all by that, which costs less.
  struct Rule {
    float relative;
    double of_one_light = 0.0;
  };
  /// What a thread works with.
  struct Scratch {
    std::vector<Place> places;
    std::vector<zonal::GroupedReceiver> receivers, few;  // all, and those of small groups
    std::vector<zonal::DrawnLights<NE>> draws;
    std::optional<zonal::LightCut<N, NE, H>> cut;
    std::array<int, zonal::cut_receivers> chosen;  // one of each part of the group

    const Place& place(const Group& group, int i) const {
      return places[static_cast<std::size_t>(group.receivers[i].index)];
    }
  };

  /// The sum of body(tile, scratch) over all tiles, or a fifth of them, on all threads, added up in order.
  template <class Sum, class Body>
  Sum for_each_tile(const Tiles& tiles, bool all, const Body& body) {
    std::vector<Sum> sums(static_cast<std::size_t>(tiles.count()));
    tbb::parallel_for(0, tiles.count(), [&](int number) {
      const bool is_wanted = all || (number % tiles.across + 2 * (number / tiles.across)) % 5 == 0;
      if (!is_wanted || stop_requested()) return;
      sums[static_cast<std::size_t>(number)] = body(tiles[number], scratch_.local());
    });
    throw_if_interrupted();
    Sum total;
    for (const Sum& sum : sums) total += sum;
    return total;
  }

  /// The sum of body(group) over the groups of a tile, with their cuts found: hits of one material on one surface, or
  /// of up to eight such groups that are too small for a cut of their own.
  template <class Sum, class Body>
  Sum for_each_group(Scratch& scratch, const Rule& rule, const Body& body) const {
    const int least_count = tree_.size() < few_lights ? 256 : 64;
    Sum sum;
    Group few{nullptr, {}};
    scratch.few.clear();
    const auto visit = [&](Group& group) {
      group.parts.halve_all(group.receivers, turn_length_);
      find_cut(group, rule, scratch);
      sum += body(group);
    };
    const auto visit_few = [&] {
      few.receivers = scratch.few.data();
      visit(few);
      few.parts = {};
      scratch.few.clear();
    };
    for_each_surface(scratch, [&](zonal::GroupedReceiver* receivers, int count) {
      if (count >= least_count) {
        Group group{receivers, {}};
        group.parts.add(count);
        return visit(group);
      }
      scratch.few.insert(scratch.few.end(), receivers, receivers + count);
      few.parts.add(count);
      if (few.parts.parts == zonal::cut_receivers || few.count() >= least_count) visit_few();
    });
    if (few.count() > 0) visit_few();
    return sum;
  }

  template <class Visit>
  void for_each_surface(Scratch& scratch, const Visit& visit) const {
    auto& all = scratch.receivers;
    const auto material = [&](const zonal::GroupedReceiver& receiver) {
      return scratch.places[static_cast<std::size_t>(receiver.index)].hit->material;
    };
    std::stable_sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return material(a) < material(b); });
    for (auto first = all.begin(), last = first; first != all.end(); first = last) {
      last =
          std::find_if(first, all.end(), [&](const auto& receiver) { return material(receiver) != material(*first); });
      zonal::for_each_receiver_group(&*first, static_cast<int>(last - first), visit);
    }
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

  /// By cuts at some tiles, ever nearer to the tolerance.
  Rule glance(const Tiles& tiles, const PrimaryHits& hits) {
    constexpr int most_passes = 5;
    constexpr double margin = 0.97, near = 0.1;  // for the other tiles; relative
    const double tolerance = input_.options.tolerance;
    // The variance is about as some power of that of one light: of very many lights 2/3, for the deviation is as one
    // over the lights that are drawn; of few more, for ever more of them are taken as they are.
    double exponent = 1.35 - 0.115 * std::log10(static_cast<double>(std::max(tree_.size(), 1)));
    const double first_exponent = 0.8 * exponent;
    Rule rule{2.0f * static_cast<float>(tolerance)};
    double last = 0.0, last_variance = 0.0;
    for (int pass = 0; pass < most_passes; ++pass) {
      const Glance seen = for_each_tile<Glance>(tiles, false, [&](const Tile& tile, Scratch& scratch) {
        collect(tile, hits, scratch);
        return for_each_group<Glance>(scratch, rule,
                                      [&](const Group& group) { return glance(group, first_exponent, scratch); });
      });
      const double target = std::pow(margin * tolerance, 2) * seen.power;
      if (!(seen.variance > 0.0 && target > 0.0)) break;  // no cluster of more than one light adds anything
      if (pass == 0) {
        rule.of_one_light = std::pow(target / seen.scaled, 1.0 / first_exponent);
        continue;
      }
      if (last > 0.0) {
        const double seen_exponent = std::log(seen.variance / last_variance) / std::log(rule.of_one_light / last);
        if (seen_exponent > 0.0) exponent = std::clamp(seen_exponent, 0.3, 3.0);
      }
      last = rule.of_one_light, last_variance = seen.variance;
      rule.of_one_light *= std::pow(target / seen.variance, 1.0 / exponent);
      if (std::abs(seen.variance - target) < near * target) break;
    }
    rule.relative = static_cast<float>(tolerance);
    return rule;
  }

  struct Glance {
    double power = 0.0, variance = 0.0;
    double scaled = 0.0;  // the variance over that of one light to the exponent

    Glance& operator+=(const Glance& other) {
      power += other.power, variance += other.variance, scaled += other.scaled;
      return *this;
    }
  };
  Glance glance(const Group& group, double exponent, Scratch& scratch) const {
    Glance seen;
    seen.variance = scratch.cut->variance() * group.count();
    if (seen.variance > 0.0) seen.scaled = seen.variance / std::pow(scratch.cut->greatest_variance(), exponent);
    draw(group, 1, scratch);
    for (int part = 0; part < group.parts.parts; ++part) {
      const Place& place = scratch.place(group, scratch.chosen[static_cast<std::size_t>(part)]);
      seen.power += power_of(gather(scratch.draws[0], *place.hit)) * group.parts.size(part);
    }
    return seen;
  }

  zonal::CutTolerance tolerance_of(const Group& group, const Rule& rule) const {
    constexpr double cut_cost = 400.0;  // gathers of a light that cost as much as to find and draw it for all
    zonal::CutTolerance tolerance;
    tolerance.with_visibility = input_.options.centre_visibility;
    tolerance.relative = rule.relative;
    tolerance.of_one_light = static_cast<float>(rule.of_one_light * (1.0 + cut_cost / group.count()));
    return tolerance;
  }

  std::uint64_t seed_of(const Group& group, const Scratch& scratch) const {
    return hash64(input_.options.seed ^ hash64(scratch.place(group, 0).sample));
  }

  /// For one of each part, at random, that stands for the part.
  void find_cut(const Group& group, const Rule& rule, Scratch& scratch) const {
    zonal::BoundedReceiver<N, float> receivers[zonal::cut_receivers];
    for (int part = 0; part < group.parts.parts; ++part) {
      const int first = group.parts.first[part], size = group.parts.size(part);
      const double place = zonal::detail::scatter(seed_of(group, scratch), static_cast<std::uint64_t>(part)) * size;
      const int chosen = first + std::min(static_cast<int>(place), size - 1);
      scratch.chosen[static_cast<std::size_t>(part)] = chosen;
      zonal::Box3 positions;
      float chord = 0.0f;
      for (int i = first; i < first + size; ++i) {
        positions.add(group.receivers[i].position);
        chord = std::max(chord, glm::distance(group.receivers[i].normal, group.receivers[chosen].normal));
      }
      const float tilt = 2.0f * std::asin(std::min(0.5f * chord, 1.0f));
      const float weight = static_cast<float>(zonal::cut_receivers * size) / static_cast<float>(group.count());
      receivers[part] =
          zonal::weighted(zonal::spread_over(bounded(*scratch.place(group, chosen).hit), positions, tilt), weight);
    }
    std::fill(receivers + group.parts.parts, receivers + zonal::cut_receivers, zonal::weighted(receivers[0], 0.0f));
    if (!scratch.cut) scratch.cut.emplace(tree_.tree());
    scratch.cut->find(zonal::as_packet(receivers), tolerance_of(group, rule));
  }

  void draw(const Group& group, int draws, Scratch& scratch) const {
    scratch.draws.resize(static_cast<std::size_t>(draws));
    zonal::ReceiverBox box;
    for (int i = 0; i < group.count(); ++i) box.add(group.receivers[i].position, group.receivers[i].normal);
    tree_.draw(*scratch.cut, box, seed_of(group, scratch), scratch.draws);
  }

  PlanFigures add_group(Image& image, const PrimaryHits& hits, const Group& group, Scratch& scratch) const {
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
