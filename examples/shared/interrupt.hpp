#pragma once

#include <atomic>
#include <csignal>

namespace example {

/// Thrown where work stops because the user asked for it.
struct Interrupted {};

namespace interrupt_detail {
inline std::atomic<int> signal{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may only touch lock-free atomics");
}  // namespace interrupt_detail

/// The signal that asked for a stop; zero as long as none has.
inline int stop_signal() { return interrupt_detail::signal.load(std::memory_order_relaxed); }

inline bool stop_requested() { return stop_signal() != 0; }

inline void throw_if_interrupted() {
  if (stop_requested()) throw Interrupted{};
}

/// Ctrl-C asks once, politely; a second one ends the program at once.
inline void listen_for_interrupts() {
  const auto handler = [](int signal) {
    interrupt_detail::signal.store(signal, std::memory_order_relaxed);
    std::signal(signal, SIG_DFL);
  };
  std::signal(SIGINT, handler);
  std::signal(SIGTERM, handler);
}

}  // namespace example
