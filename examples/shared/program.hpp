#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include <tbb/global_control.h>

#include "image.hpp"
#include "scene.hpp"

namespace example {

/// What body() returns, or, of what it throws, one line on standard error and the exit status: 2 for bad input, a
/// shell's for a signal, 1 for all else.
int run_program(const char* name, const std::function<int()>& body);

void warn(const char* program, const std::string& text);
void print_warnings(const char* program, const Scene& scene);

/// How many pixels were not finite: they are black now, and warned of.
std::size_t repair(const char* program, const std::vector<Image*>& pictures);

/// Holds TBB to a number of threads, 0 for all the machine has, as long as it lives.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);

  int threads() const { return threads_; }
  int machine_cores() const { return machine_cores_; }

 private:
  int machine_cores_;
  int threads_;
  tbb::global_control control_;
};

}  // namespace example
