#pragma once

#include <functional>
#include <string>

#include "interrupt.hpp"

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

}  // namespace example
