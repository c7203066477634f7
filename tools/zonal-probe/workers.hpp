#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "shared/interrupt.hpp"
#include "shared/progress.hpp"

namespace zonal_probe {

/// All threads of the machine, or so many, and a bar of their progress.
class Workers {
 public:
  Workers(int threads, bool shows_progress)
      : threads_(threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))),
        progress_(shows_progress) {}

  void expect(double units) { progress_.expect(units); }

  /// A for_each, as zonal's functions take it; of all that is to be done so many units. Throws Interrupted soon after
  /// Ctrl-C, and what a body throws.
  auto loop(const char* label, double units) {
    return [this, label, units](int count, const auto& body) {
      std::atomic<int> next{0};
      std::exception_ptr thrown;
      std::mutex guard;
      const auto work = [&] {
        try {
          for (int i = next++; i < count && !example::stop_requested(); i = next++) {
            body(i);
            progress_.advance(label, units / count);
          }
        } catch (...) {
          const std::lock_guard lock(guard);
          thrown = std::current_exception();
          next = count;
        }
      };
      std::vector<std::thread> others;
      for (int i = 1; i < std::min(threads_, count); ++i) others.emplace_back(work);
      work();
      for (std::thread& other : others) other.join();
      if (thrown) std::rethrow_exception(thrown);
      example::throw_if_interrupted();
    };
  }

 private:
  int threads_;
  example::Progress progress_;
};

}  // namespace zonal_probe
