#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace example {

/// The stages that programs have in common, as reports name them.
namespace stage_name {
inline constexpr const char* scene = "scene and BVH";
inline constexpr const char* materials = "material projection";
inline constexpr const char* primary = "primary rays";
}  // namespace stage_name

/// What a run had at its disposal.
struct Machine {
  int cores = 0;
  int threads = 0;
};

/// What every run counts.
struct RunCounts {
  std::size_t triangles = 0;
  std::size_t materials = 0;
  std::size_t primary_samples = 0;
  std::size_t primary_hits = 0;
  std::size_t pixels_not_finite = 0;
};

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

}  // namespace example
