// A recorded function with its derivatives: forward and backward in one, for training in a shader.
//
// Beside what the function takes and gives, it takes by_<output>, a loss's derivatives by each output, and gives
// by_<input>, those by each input asked for: zonal_reconstruct_along_colour_4_adjoint(sh, direction, value, by_value,
// by_sh, by_direction). Who has no use for the value ignores it: shader compilers leave out what is not used.
#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../scalar/adjoint.hpp"
#include "recorded_function.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace shader {

/// Why a function has no adjoint of the inputs asked for; `what()` is a line that begins with the function's name.
struct NoAdjoint : std::runtime_error {
  using std::runtime_error::runtime_error;
};

namespace detail {

inline std::vector<Recorder> input_lines(Recording& recording) {
  std::vector<Recorder> inputs;
  for (std::size_t i = 0; i < recording.lines().size(); ++i) {
    if (recording.lines()[i].operation == Operation::input) {
      inputs.push_back(recording.result_of(static_cast<int>(i)));
    }
  }
  return inputs;
}

inline bool is_nothing(const std::vector<Recorder>& derivatives) {
  return std::all_of(derivatives.begin(), derivatives.end(),
                     [](const Recorder& derivative) { return zonal::detail::is(derivative, 0); });
}

class AdjointMaker {
 public:
  AdjointMaker(RecordedFunction&& function, const std::vector<std::string>& by)
      : function_(std::move(function)), by_(by), inputs_(input_lines(*function_.recording)) {
    for (const Parameter& p : function_.parameters) {
      if (p.direction == Direction::inout) refuse("adds to what it is given, which has no adjoint here");
    }
    check_names();
  }

  RecordedFunction make() {
    const std::vector<Parameter> forward = function_.parameters;
    std::vector<Recorder> by_outputs;
    for (const Parameter& p : forward) {
      if (p.direction != Direction::out) continue;
      add_parameter(p, Direction::in);
      for (int i = 0; i < p.size(); ++i)
        by_outputs.push_back(function_.recording->input(function_.parameters.back().name));
    }
    add_derivatives(forward, by_outputs);
    function_.kept.assign(function_.outputs.size(), true);
    function_.name += "_adjoint";
    function_.remark += (function_.remark.empty() ? "" : " ") +
                        std::string("Then by_<input>: what by_<output>, a loss's derivatives, come to by the inputs.");
    return std::move(function_);
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const { throw NoAdjoint(function_.name + " " + why); }

  bool is_asked(const Parameter& p) const {
    return by_.empty() || std::find(by_.begin(), by_.end(), p.name) != by_.end();
  }

  void check_names() const {
    std::string names;
    for (const Parameter& p : function_.parameters) {
      if (p.direction == Direction::in) names += (names.empty() ? "" : ", ") + std::string(p.name);
    }
    if (names.empty()) refuse("has no inputs");
    for (const std::string& name : by_) {
      const auto is_it = [&](const Parameter& p) { return p.direction == Direction::in && name == p.name; };
      if (std::none_of(function_.parameters.begin(), function_.parameters.end(), is_it)) {
        refuse("has no input '" + name + "', but " + names);
      }
    }
  }

  /// by_<name>, of the same type.
  void add_parameter(const Parameter& p, Direction direction) {
    function_.own_names.push_back("by_" + std::string(p.name));
    for (const Parameter& other : function_.parameters) {
      if (other.name == function_.own_names.back()) refuse("has a parameter '" + std::string(other.name) + "' already");
    }
    Parameter own = p;
    own.name = function_.own_names.back().c_str();
    own.direction = direction;
    own.domain = kernels::Domain::coefficient;
    own.is_gradient = false;
    function_.parameters.push_back(own);
  }

  void add_derivatives(const std::vector<Parameter>& forward, const std::vector<Recorder>& by_outputs) {
    std::vector<Recorder> asked;
    for_each_asked(forward, [&](const Parameter&, auto first, auto last) { asked.insert(asked.end(), first, last); });
    const std::vector<Recorder> all = adjoints(*function_.recording, function_.outputs, by_outputs, asked);
    auto next = all.begin();
    bool has_any = false;
    for_each_asked(forward, [&](const Parameter& p, auto, auto) {
      const std::vector<Recorder> derivatives(next, next + p.size());
      next += p.size();
      if (is_nothing(derivatives)) {
        if (by_.empty()) return;
        refuse("does not change with '" + std::string(p.name) + "'");
      }
      has_any = true;
      add_parameter(p, Direction::out);
      function_.outputs.insert(function_.outputs.end(), derivatives.begin(), derivatives.end());
    });
    if (!has_any) refuse("has no derivative by any input");
  }

  // visit(parameter, its first line, the end of its lines)
  template <class Visit>
  void for_each_asked(const std::vector<Parameter>& forward, Visit visit) const {
    auto line = inputs_.begin();
    for (const Parameter& p : forward) {
      if (p.direction != Direction::in) continue;
      if (is_asked(p)) visit(p, line, line + p.size());
      line += p.size();
    }
  }

  RecordedFunction function_;
  const std::vector<std::string>& by_;
  std::vector<Recorder> inputs_;  // line by line
};

}  // namespace detail

/// The function and its derivatives by the inputs of these names; if none, by all with which it changes. Throws
/// NoAdjoint.
inline RecordedFunction adjoint_function(RecordedFunction&& function, const std::vector<std::string>& by = {}) {
  return detail::AdjointMaker(std::move(function), by).make();
}

}  // namespace shader
}  // namespace ZONAL_TARGET
}  // namespace zonal
