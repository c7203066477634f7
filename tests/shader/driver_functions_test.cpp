// Every function at every number of bands on the driver, against its record (which record_test.cpp compares with C++):
// to the bit where the driver computes on the CPU.
#include <algorithm>
#include <array>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string_view>

#include "../catch.hpp"
#include "adjoints.hpp"
#include "driver.hpp"
#include "function_shader.hpp"
#include "shader_functions.hpp"

namespace {

using zonal::shader::all_orders;
using zonal::shader::FunctionEntry;
using zonal::shader::RecordedFunction;

std::vector<float> run_on_driver(Driver& driver, const RecordedFunction& function, const std::vector<float>& numbers,
                                 const zonal::shader::TextOptions& options) {
  const unsigned program =
      driver.compile("#version 450\n" + function_shader(std::array{std::cref(function)}, "0", options));
  const auto count = sample_count * static_cast<std::size_t>(output_count(function));
  const unsigned in = driver.make_buffer(numbers.empty() ? std::vector<float>(1) : numbers);
  const unsigned out = driver.make_buffer(std::vector<float>(count, std::numeric_limits<float>::quiet_NaN()));
  driver.run(program, {in, out}, sample_groups);
  const std::vector<float> results = driver.read_buffer(out, count);
  driver.delete_buffer(in);
  driver.delete_buffer(out);
  driver.delete_program(program);
  return results;
}

void check(Driver& driver, const RecordedFunction& function, int bands, const zonal::shader::TextOptions& options) {
  check_as_recorded(function, bands, driver.is_software(), [&](const std::vector<float>& numbers) {
    return run_on_driver(driver, function, numbers, options);
  });
}

/// select(driver, entry, bands, options) for every function at some numbers of bands, if it has any. The driver takes
/// long to compile large ones.
template <class Select>
void check_all(std::initializer_list<int> numbers_of_bands, Select select, zonal::shader::TextOptions options = {}) {
  Driver* driver = driver_or_skip();
  if (driver == nullptr) return;
  options.precise = true;
  for (const FunctionEntry& entry : zonal_glsl::shader_functions()) {
    for (const int bands : numbers_of_bands) {
      if (bands > zonal::shader::max_bands) continue;
      select(*driver, entry, std::min(bands, entry.most_bands), options);
      if (!entry.has_bands) break;
    }
  }
}
void check_all_at_two_bands(const zonal::shader::TextOptions& options) {
  check_all(
      {2},
      [](Driver& driver, const FunctionEntry& entry, int bands, const auto& text) {
        check(driver, entry.record(bands, all_orders), bands, text);
      },
      options);
}

}  // namespace

// The functions for colours repeat the others' operations, three times: at 2 bands.
TEST_CASE("Every function, at 1 to 3 and 10 bands, is on the driver what its record is") {
  check_all({1, 2, 3, 10}, [](Driver& driver, const FunctionEntry& entry, int bands, const auto& options) {
    const bool is_colour = entry.name.find("_colour") != std::string_view::npos;
    if (!is_colour || bands == 2) check(driver, entry.record(bands, all_orders), bands, options);
  });
}

TEST_CASE("Every pair of orders, at 1 to 3 and 5 bands, is on the driver what its record is") {
  check_all({1, 2, 3, 5}, [](Driver& driver, const FunctionEntry& entry, int bands, const auto& options) {
    for (int m = 0; m < entry.order_count(bands); ++m) check(driver, entry.record(bands, m), bands, options);
  });
}

TEST_CASE("Every adjoint, at 2 bands, is on the driver what its record is") {
  check_all({2}, [](Driver& driver, const FunctionEntry& entry, int bands, const auto& options) {
    if (const auto adjoint = adjoint_of(entry, bands)) check(driver, *adjoint, bands, options);
  });
}

TEST_CASE("A splat's colour and its derivatives, at 4 bands, are on the driver what their record is") {
  Driver* driver = driver_or_skip();
  if (driver == nullptr) return;
  zonal::shader::TextOptions options;
  options.precise = true;
  check(*driver, *adjoint_of(*zonal_glsl::find_function("splat_colour"), 4), 4, options);
  check(*driver, zonal_glsl::find_function("splat_with_adjoint")->record(4, all_orders), 4, options);
}

TEST_CASE("With a temporary for every operation the driver computes the same") {
  zonal::shader::TextOptions options;
  options.compound = false;
  check_all_at_two_bands(options);
}

TEST_CASE("Without arrays the driver computes the same") {
  zonal::shader::TextOptions options;
  options.flat = true;
  check_all_at_two_bands(options);
}
