#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>

namespace example {

/// A bar with the time left, on standard error, when that is a terminal; otherwise nothing. Safe to advance
/// from many threads.
class Progress {
 public:
  explicit Progress(bool enabled);
  ~Progress();  // leaves a clean line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The work of the whole run, in any unit that takes about equal time.
  void expect(double units) { expected_ = units; }
  void advance(const char* label, double units);

 private:
  void draw(const char* label, double share, std::chrono::duration<double> elapsed);

  using Clock = std::chrono::steady_clock;
  bool enabled_;
  double expected_ = 1.0;
  std::atomic<double> done_{0.0};
  std::atomic_flag drawing_ = ATOMIC_FLAG_INIT;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_drawn_ = start_;
  bool drawn_ = false;
};

}  // namespace example
