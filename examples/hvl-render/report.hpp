#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "image.hpp"
#include "options.hpp"

namespace hvl_render {

/// The stages of a run, as the report names them.
namespace stage_name {
inline constexpr const char* scene = "scene and BVH";
inline constexpr const char* materials = "material projection";
inline constexpr const char* lights = "virtual lights";
inline constexpr const char* primary = "primary rays";
inline constexpr const char* direct = "direct light";
inline constexpr const char* gather = "gather";
inline constexpr const char* paths = "paths";
}  // namespace stage_name

/// Wall-clock seconds of the stages of a run, in the order in which they first ran.
class StageTimes {
 public:
  /// Runs work() and adds its time to the stage's; returns what work returned.
  template <class Work>
  decltype(auto) time(const std::string& stage, Work&& work) {
    const Timer timer(*this, stage);
    return work();
  }

  double seconds(const std::string& stage) const;
  double total() const;
  const std::vector<std::pair<std::string, double>>& stages() const { return stages_; }

 private:
  using Clock = std::chrono::steady_clock;
  struct Timer {
    Timer(StageTimes& stage_times, std::string stage_name) : times(stage_times), stage(std::move(stage_name)) {}
    ~Timer() { times.add(stage, std::chrono::duration<double>(Clock::now() - start).count()); }
    StageTimes& times;
    std::string stage;
    Clock::time_point start = Clock::now();
  };
  void add(const std::string& stage, double seconds);

  std::vector<std::pair<std::string, double>> stages_;
};

struct Counts {
  std::size_t triangles = 0;
  std::size_t materials = 0;
  std::size_t map_lights = 0;      // of the square map
  std::size_t virtual_lights = 0;  // those that carry light
  std::size_t primary_samples = 0;
  std::size_t primary_hits = 0;
  int samples_per_pixel = 0;  // paths
  std::size_t pixels_not_finite = 0;
};

/// Everything there is to say about a run.
struct Report {
  Options options;
  StageTimes times;
  Counts counts;
  int threads = 0;
  int machine_cores = 0;
  double material_error = 0.0;        // greatest of the projections, of each table's largest coefficient
  std::optional<ImageErrors> errors;  // where there was something to compare with
};

/// Nanoseconds of wall-clock time, all threads together, per primary hit and virtual light; zero without
/// lights.
double nanoseconds_per_gather(const Report& report);

/// The aligned table for the terminal.
std::string table(const Report& report);

std::string json_text(const Report& report);

}  // namespace hvl_render
