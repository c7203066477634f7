#pragma once

#include <atomic>
#include <csignal>

namespace hvl_render {

/// Thrown where work stops because the user asked for it.
struct Interrupted {};

namespace interrupt_detail {
inline std::atomic<bool> requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");
}  // namespace interrupt_detail

inline bool stop_requested() {
  return interrupt_detail::requested.load(std::memory_order_relaxed);
}

inline void throw_if_interrupted() {
  if (stop_requested()) throw Interrupted{};
}

/// Ctrl-C asks once, politely; a second one ends the program at once.
inline void listen_for_interrupts() {
  const auto handler = [](int signal) {
    interrupt_detail::requested.store(true, std::memory_order_relaxed);
    std::signal(signal, SIG_DFL);
  };
  std::signal(SIGINT, handler);
  std::signal(SIGTERM, handler);
}

}  // namespace hvl_render
