#pragma once

#include <cstddef>
#include <vector>

#include <tbb/global_control.h>

#include "image.hpp"
#include "interrupt.hpp"
#include "run_program.hpp"
#include "scene.hpp"
#include "stage_times.hpp"

namespace example {

void print_warnings(const char* program, const Scene& scene);

/// How many pixels were not finite: they are black now, and warned of.
std::size_t repair(const char* program, const std::vector<Image*>& pictures);

/// Says so where nothing is in view, or nothing of it lit. True for a black picture.
bool warn_if_black(const char* program, const Image& picture, std::size_t primary_hits);

/// Holds TBB to a number of threads, 0 for all the machine has, as long as it lives.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);

  const Machine& machine() const { return machine_; }

 private:
  Machine machine_;
  tbb::global_control control_;
};

}  // namespace example
