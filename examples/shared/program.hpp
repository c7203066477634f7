#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <tbb/global_control.h>

#include "image.hpp"
#include "interrupt.hpp"
#include "scene.hpp"
#include "stage_times.hpp"

namespace example {

/// What body() returns, or, of what it throws, one line on standard error and the exit status: 2 for bad input, a
/// shell's for a signal, 1 for all else.
int report_errors(const char* name, const std::function<int()>& body);

/// A program's main: parse(argc, argv) gives a CommandLine, whose options run() takes.
template <class Parse, class Run>
int run_program(const char* name, int argc, char** argv, const Parse& parse, const Run& run) {
  return report_errors(name, [&] {
    const auto line = parse(argc, argv);
    if (line.exit_status) return *line.exit_status;
    listen_for_interrupts();
    run(line.options);
    return 0;
  });
}

void warn(const char* program, const std::string& text);
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
