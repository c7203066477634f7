#include "run_program.hpp"

#include <cstdio>
#include <exception>

#include <zonal/file/standard_output.hpp>

#include "input_error.hpp"

namespace example {
namespace {

constexpr int exit_bad_input = 2;
constexpr int exit_by_signal = 128;  // and the signal's number, as of a shell

}  // namespace

int report_errors(const char* name, const std::function<int()>& body) {
  try {
    return zonal::with_standard_output(body);
  } catch (const Interrupted& interrupted) {
    std::fprintf(stderr, "%s: interrupted, %s\n", name, interrupted.left.c_str());
    return exit_by_signal + stop_signal();
  } catch (const InputError& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return exit_bad_input;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return 1;
  }
}

void warn(const char* program, const std::string& text) {
  std::fprintf(stderr, "%s: warning: %s\n", program, text.c_str());
}

}  // namespace example
