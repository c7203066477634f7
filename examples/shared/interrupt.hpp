#pragma once

#include <atomic>
#include <csignal>
#include <ctime>
#include <string>

namespace example {

/// Thrown where work stops because the user asked for it.
struct Interrupted {
  std::string left = "nothing written";  // of what was asked for
};

namespace interrupt_detail {
inline std::atomic<int> signal{0};
inline std::atomic<long> milliseconds{0};  // when it came
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

inline long now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);  // which a signal handler may call
  return static_cast<long>(time.tv_sec) * 1000 + time.tv_nsec / 1000000;
}
}  // namespace interrupt_detail

/// The signal that asked for a stop; zero as long as none has.
inline int stop_signal() { return interrupt_detail::signal.load(std::memory_order_relaxed); }

inline bool stop_requested() { return stop_signal() != 0; }

inline void throw_if_interrupted() {
  if (stop_requested()) throw Interrupted{};
}

/// Ctrl-C asks once, politely; a second one ends the program at once. What comes within a fifth of a second counts as
/// one: `timeout` sends its signal to a program and to the program's group.
inline void listen_for_interrupts() {
  const auto handler = [](int signal) {
    constexpr long same_time = 200;
    if (!stop_requested()) {
      interrupt_detail::milliseconds.store(interrupt_detail::now(), std::memory_order_relaxed);
      interrupt_detail::signal.store(signal, std::memory_order_relaxed);
    } else if (interrupt_detail::now() - interrupt_detail::milliseconds.load(std::memory_order_relaxed) > same_time) {
      std::signal(signal, SIG_DFL);
      std::raise(signal);
    }
  };
  std::signal(SIGINT, handler);
  std::signal(SIGTERM, handler);
}

}  // namespace example
