#pragma once

#include <cstddef>
#include <memory>

#include "gatherer.hpp"
#include "scene_plan.hpp"
#include "shared/primary_hits.hpp"

namespace example::hvl_render {

/// What a planned gather did, and how far it may be off. Sums over primary hits; radiance is RGB added up.
struct PlanFigures {
  std::size_t hits = 0, groups = 0;
  double pairs = 0;            // of hits and lights that were gathered
  double cut_lights = 0;       // of hits and lights that the cuts ask for, with those that turn out to be dark
  double power = 0;            // squares of the radiance
  double variance = 0;         // squares of the deviation, at most, as the cuts prove
  std::size_t checked = 0;     // hits gathered in full as well,
  double checked_seconds = 0;  // in this processor time;
  double checked_power = 0;    // the squares of what these are,
  double checked_error = 0;    // and of the difference

  PlanFigures& operator+=(const PlanFigures& other);
  /// Root mean squares relative to that of the radiance: as proved, and as measured.
  double proved_error() const;
  double measured_error() const;
  /// Processor time that all hits would take in full.
  double full_seconds() const;
};

/// Bytes that lights take: as planned, with the tree, and for the full gather.
struct LightBytes {
  std::size_t planned = 0, full = 0;
};

/// Gathers blocks of pixels within a tolerance.
class PlannedGatherer {
 public:
  PlannedGatherer() = default;
  virtual ~PlannedGatherer() = default;
  PlannedGatherer(const PlannedGatherer&) = delete;
  PlannedGatherer& operator=(const PlannedGatherer&) = delete;

  /// Adds to each pixel of the slice the mean over its hits. The same for any number of threads.
  virtual void add(Image& image, const PrimaryHits& hits, const Stage& stage) = 0;

  /// Of all slices so far.
  virtual PlanFigures figures() const = 0;
  virtual LightBytes bytes() const = 0;
};

/// By the options' tolerance, for harmonics virtual lights.
std::unique_ptr<PlannedGatherer> make_planned(const GatherInput& input, const ScenePlan& plan);

}  // namespace example::hvl_render
