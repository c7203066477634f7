// A kernel written down as a function: its name, its parameters, and its record.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../kernels/kernel_io.hpp"
#include "../scalar/recorder.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace shader {

using kernels::all_orders;
using kernels::Direction;
using kernels::Parameter;

struct RecordedFunction {
  std::string name;     // zonal_evaluate_5
  std::string summary;  // one line
  std::string remark;   // a further line, or none: which coefficients it has, if not all
  std::vector<Parameter> parameters;
  std::unique_ptr<Recording> recording;
  std::vector<Recorder> outputs;      // of all outputs and inouts, one after the other
  std::vector<bool> kept;             // which of them are written: of an inout, those that change
  std::deque<std::string> own_names;  // of parameters that no kernel has named

  bool is_input(const Recorder& r) const {
    return !r.is_constant() && recording->lines()[static_cast<std::size_t>(r.line())].operation == Operation::input;
  }

  /// The operations that the outputs asked for need.
  OperationCount count() const {
    const std::vector<Recorder> asked = kept_outputs();
    return recording->count(asked.begin(), asked.end());
  }
  std::vector<Recorder> kept_outputs() const {
    std::vector<Recorder> asked;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      if (kept[i]) asked.push_back(outputs[i]);
    }
    return asked;
  }
};

/// Leaves out the coefficients for which keep(l, m) does not hold: the arrays that have them become shorter, and what
/// they alone need is not computed. Whether there were any to choose from.
template <class Keep>
bool keep_coefficients(RecordedFunction& function, Keep keep) {
  std::vector<Recorder> outputs;
  std::vector<bool> kept;
  std::size_t at = 0;
  bool has_any = false;
  for (Parameter& p : function.parameters) {
    if (p.direction == Direction::in) continue;
    const int count = p.elements();
    if (p.has_orders) p.count = 0;
    for (int i = 0, l = 0; i < count; ++i) {
      if (i == (l + 1) * (l + 1)) ++l;
      const bool stays = !p.has_orders || keep(l, i - l * (l + 1));
      p.count += p.has_orders && stays;
      for (int c = 0; c < p.components; ++c, ++at) {
        if (!stays) continue;
        outputs.push_back(function.outputs[at]);
        kept.push_back(function.kept[at]);
      }
    }
    has_any = has_any || p.has_orders;
  }
  function.outputs = std::move(outputs);
  function.kept = std::move(kept);
  return has_any;
}

/// What is written down of a kernel: all; the coefficients of orders m and -m alone, in a loop over m; or what is left
/// where elements of one of its input arrays are zero, which then stand in the function's array no more.
struct Part {
  int order = all_orders;
  std::string_view array = {};
  std::vector<bool> kept = {};  // of the array's elements

  Part() = default;
  Part(int the_order) : order(the_order) {}  // NOLINT: an order is a part
  Part(std::string_view the_array, std::vector<bool> the_kept) : array(the_array), kept(std::move(the_kept)) {}

  bool is_of(const Parameter& parameter) const { return parameter.name == array; }
  int kept_count() const { return static_cast<int>(std::count(kept.begin(), kept.end(), true)); }
  bool leaves_out() const { return kept_count() < static_cast<int>(kept.size()); }
  /// _order_<m>, or _kept_<the elements as bits, 16 to a digit of four>, or nothing.
  std::string suffix() const {
    if (order != all_orders) return "_order_" + std::to_string(order);
    if (!leaves_out()) return "";
    std::string digits;
    for (std::size_t first = 0; first < kept.size(); first += 4) {
      unsigned digit = 0;
      for (std::size_t i = first; i < (std::min)(first + 4, kept.size()); ++i)
        digit |= unsigned(kept[i]) << (i - first);
      digits.insert(digits.begin(), "0123456789abcdef"[digit]);
    }
    return "_kept_" + digits;
  }
};

/// zonal_<name>_<bands>, and what it is a part of.
inline std::string function_name(const char* entry, bool has_bands, int bands, const Part& part) {
  return std::string("zonal_") + entry + (has_bands ? "_" + std::to_string(bands) : "") + part.suffix();
}
template <class Entry>
std::string function_name(int bands, const Part& part) {
  return function_name(Entry::name, Entry::has_bands, bands, part);
}

namespace detail {
// What the entry's kernel does, written down. Not a template: the table has hundreds of instances.
inline RecordedFunction record(std::string name, const char* summary, void (*run)(kernels::DescribingIo<Recorder>&),
                               const Part& part) {
  RecordedFunction result;
  result.name = std::move(name);
  result.summary = summary;
  result.recording = std::make_unique<Recording>();
  std::size_t next = 0;  // number of the array
  kernels::DescribingIo<Recorder> io(
      [&](const Parameter& parameter) {
        const bool is_zero = part.is_of(parameter) && !part.kept[next++ / std::size_t(parameter.components)];
        return is_zero ? Recorder(0) : result.recording->input(parameter.name);
      },
      part.order);
  run(io);
  result.parameters = io.parameters();
  for (Parameter& parameter : result.parameters) {
    if (part.is_of(parameter)) parameter.count = part.kept_count();
  }
  result.outputs = io.outputs();
  result.kept.assign(result.outputs.size(), true);
  std::size_t output = 0;
  for (const Parameter& parameter : result.parameters) {
    if (parameter.direction == Direction::in) continue;
    for (int i = 0; i < parameter.size(); ++i, ++output) {
      // An inout that stays as it is needs no statement.
      if (parameter.direction == Direction::inout) result.kept[output] = !result.is_input(result.outputs[output]);
    }
  }
  return result;
}
}  // namespace detail

/// An entry of the table (kernels/kernel_list.hpp) with N bands, written down.
template <class Entry, int N>
RecordedFunction record(const Part& part = {}) {
  return detail::record(function_name<Entry>(N, part), Entry::summary,
                        &Entry::template run<N, kernels::DescribingIo<Recorder>>, part);
}

}  // namespace shader
}  // namespace ZONAL_TARGET
}  // namespace zonal
