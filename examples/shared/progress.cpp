#include "progress.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <sys/ioctl.h>
#include <unistd.h>

namespace example {
namespace {

int terminal_columns() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

std::string seconds_left(double seconds) {
  const long whole = std::lround(std::ceil(seconds));
  char text[32];
  std::snprintf(text, sizeof text, "%ld:%02ld left", whole / 60, whole % 60);
  return text;
}

}  // namespace

Progress::Progress(bool enabled) : enabled_(enabled && isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (drawn_) std::fputs("\r\033[K", stderr);
}

void Progress::advance(const char* label, double units) {
  const double done = done_.fetch_add(units, std::memory_order_relaxed) + units;
  if (!enabled_ || drawing_.test_and_set(std::memory_order_acquire)) return;
  const Clock::time_point now = Clock::now();
  if (now - last_drawn_ >= std::chrono::milliseconds(100)) {
    last_drawn_ = now;
    draw(label, std::min(1.0, done / expected_), now - start_);
  }
  drawing_.clear(std::memory_order_release);
}

void Progress::draw(const char* label, double share, std::chrono::duration<double> elapsed) {
  drawn_ = true;
  char percent[16];
  std::snprintf(percent, sizeof percent, " %3.0f %%", 100.0 * share);
  std::string text = label + std::string(percent);
  // A full last column would wrap the line.
  const int columns = terminal_columns() - 1;
  // The first moments tell nothing about the rest.
  if (share > 0.01) {
    const std::string left = "  " + seconds_left(elapsed.count() * (1.0 - share) / share);
    if (static_cast<int>(text.size() + left.size()) <= columns) text += left;
  }
  const int bar = std::min(40, columns - static_cast<int>(text.size()) - 3);
  if (bar >= 5) {
    const int filled = static_cast<int>(share * bar);
    const std::string drawn_bar =
        std::string(static_cast<std::size_t>(filled), '#') + std::string(static_cast<std::size_t>(bar - filled), '.');
    text = "[" + drawn_bar + "] " + text;
  }
  if (static_cast<int>(text.size()) > columns) text.resize(static_cast<std::size_t>(std::max(0, columns)));
  std::fprintf(stderr, "\r%s\033[K", text.c_str());
  std::fflush(stderr);
}

}  // namespace example
