// From a record to the text of a function.
//
// Operations keep their order and their grouping, so the text computes what the kernel computes, to the bit: a + (b +
// c) keeps its parentheses, and no two constants meet, for they were combined in float when they were written down.
#pragma once

#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../file/number_text.hpp"
#include "dialect.hpp"
#include "recorded_function.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace shader {

struct TextOptions {
  bool compound = true;  // what is used once stands where it is used; otherwise every operation has a temporary
  bool precise = false;  // the compiler may not reassociate nor contract, where the dialect has a word for it
  bool flat = false;     // a parameter for each element instead of an array: y_4 for y[4], and _flat after the name
  std::string prefix = "zonal_";  // of all names
};

/// A name that begins with zonal_ as the options have it.
inline std::string prefixed(const std::string& name, const TextOptions& options) {
  return options.prefix + name.substr(sizeof "zonal_" - 1);
}
/// How the text calls the function.
inline std::string text_name(const RecordedFunction& function, const TextOptions& options) {
  return prefixed(function.name, options) + (options.flat ? "_flat" : "");
}

/// The shortest decimal that reads back to the same float, with the suffix that makes it one.
inline std::string literal(float value) {
  if (!std::isfinite(value)) throw std::logic_error("a kernel's constant is not finite");
  std::string text = shortest_text(value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text + "f";
}

namespace detail {

/// How tightly an expression holds together.
enum class Binding { choice, comparison, sum, product, negation, primary };

struct Expression {
  std::string text;
  Binding binding;
};

inline std::string within(const Expression& e, Binding least) {
  return e.binding < least ? "(" + e.text + ")" : e.text;
}
/// The next tighter one: for the operand to the right of - and /, and of + and * as well, which do not associate.
inline Binding tighter(Binding binding) { return static_cast<Binding>(static_cast<int>(binding) + 1); }

class FunctionWriter {
 public:
  FunctionWriter(const RecordedFunction& function, const Dialect& dialect, const TextOptions& options)
      : function_(function), dialect_(dialect), options_(options), lines_(function.recording->lines()) {
    for (const Parameter& parameter : function.parameters) {
      if (parameter.direction != Direction::in) outputs_.push_back(&parameter);
    }
    const Parameter& first = *outputs_.front();
    const bool can_return = first.components == 1 || dialect.declarations != Declarations::cpp;
    returns_ = outputs_.size() == 1 && !first.is_array() && can_return;
  }

  std::string text() {
    std::string result = comment() + signature() + " {\n";
    write_body();
    return result + body_ + "}\n";
  }

  std::string signature() const {
    const std::vector<std::string> parameters = declarations();
    const std::string result = returns_ ? type(*outputs_.front()) : "void";
    std::string text = std::string(dialect_.function);
    text += is(Declarations::wgsl) ? "fn " : result + " ";
    text += text_name(function_, options_) + "(";
    std::size_t column = text.size();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (i > 0) text += ",";
      const bool wraps = i > 0 && column + parameters[i].size() > 115;
      if (wraps) column = 4;
      text += i == 0 ? "" : wraps ? "\n    " : " ";
      text += parameters[i];
      column += parameters[i].size() + 2;
    }
    text += ")";
    if (is(Declarations::wgsl) && returns_) text += " -> " + result;
    return text;
  }

  /// Of all parameters, one each.
  std::vector<std::string> declarations() const {
    std::vector<std::string> all;
    for (const Parameter& p : function_.parameters) {
      if (returns_ && &p == outputs_.front()) continue;
      if (!is_flat(p)) {
        all.push_back(declaration(p, p.name, p.count));
      } else {
        for (int i = 0; i < p.count; ++i) all.push_back(declaration(p, flat_name(p, i), 0));
      }
    }
    return all;
  }

 private:
  bool is(Declarations d) const { return dialect_.declarations == d; }

  std::string comment() const {
    const OperationCount count = function_.count();
    std::string text = "// " + function_.summary + "\n";
    if (!function_.remark.empty()) text += "// " + function_.remark + "\n";
    text += "// " + std::to_string(count.total()) + " operations: ";
    text += std::to_string(count.additions) + " additions, " + std::to_string(count.multiplications) +
            " multiplications, " + std::to_string(count.divisions) + " divisions, " + std::to_string(count.functions) +
            " square roots, " + std::to_string(count.comparisons) + " comparisons and choices.\n";
    return text;
  }

  // ---- The signature -----------------------------------------------------------------------------------------------

  // vec3, and as it is declared: highp vec3.
  std::string bare_type(const Parameter& p) const {
    return std::string(p.components == 1 ? dialect_.number : p.components == 2 ? dialect_.pair : dialect_.triple);
  }
  std::string type(const Parameter& p) const { return std::string(dialect_.precision) + bare_type(p); }
  std::string precise() const { return options_.precise ? std::string(dialect_.precise) : ""; }
  static std::string brackets(int count) { return "[" + std::to_string(count) + "]"; }
  bool is_flat(const Parameter& p) const { return options_.flat && p.is_array(); }
  static std::string flat_name(const Parameter& p, int i) { return std::string(p.name) + "_" + std::to_string(i); }

  // An array of so many, or a single one if 0.
  std::string declaration(const Parameter& p, const std::string& name, int count) const {
    const std::string array = count > 0 ? brackets(count) : "";
    const bool is_in = p.direction == Direction::in;
    const std::string way = is_in ? "" : p.direction == Direction::out ? "out " : "inout ";
    switch (dialect_.declarations) {
      case Declarations::glsl:
        return (is_in ? "" : precise()) + (is_in && count > 0 ? "in " : way) + type(p) + " " + name + array;
      case Declarations::hlsl: return way + type(p) + " " + name + array;
      case Declarations::wgsl: {
        const std::string whole = count > 0 ? "array<" + type(p) + ", " + std::to_string(count) + ">" : type(p);
        return name + ": " + (is_in ? whole : "ptr<function, " + whole + ">");
      }
      case Declarations::cpp: break;
    }
    const std::string all = array + (p.components > 1 ? brackets(p.components) : "");
    const std::string number(dialect_.number);
    if (all.empty()) return number + (is_in ? " " : " &") + name;
    return (is_in ? "const " : "") + number + " (&" + name + ")" + all;
  }

  // ---- The body ----------------------------------------------------------------------------------------------------

  /// y[4], gradient[4].x, or (*y)[4]; y_4 where it is flat.
  std::string element(const Parameter& p, int index) const {
    const bool by_pointer = is(Declarations::wgsl) && p.direction != Direction::in;
    std::string text = is_flat(p) ? flat_name(p, index / p.components) : p.name;
    if (by_pointer) text = "(*" + text + ")";
    if (p.is_array() && !is_flat(p)) text += brackets(index / p.components);
    if (p.components > 1) {
      const int component = index % p.components;
      text += dialect_.has_components ? "." + std::string(1, "xyz"[component]) : brackets(component);
    }
    return text;
  }

  // Each output after what it needs, and that in the order of its operands: the text then does not depend on the order
  // in which a C++ compiler evaluates operands.
  void write_body() {
    const std::vector<Recorder> asked = function_.kept_outputs();
    live_ = function_.recording->needed(asked.begin(), asked.end());
    count_uses(asked);
    name_inputs();
    if (returns_) {
      write_return();
    } else {
      write_outputs();
    }
  }

  void count_uses(const std::vector<Recorder>& asked) {
    uses_.assign(lines_.size(), 0);
    for (const Recorder& output : asked) {
      if (!output.is_constant()) ++uses_[static_cast<std::size_t>(output.line())];
    }
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (!live_[i]) continue;
      // Where it is spelled as a choice, a minimum names its operands twice.
      const bool twice = is_spelled_as_choice(lines_[i].operation);
      for (const int operand : lines_[i].operands) {
        if (operand >= 0) uses_[static_cast<std::size_t>(operand)] += twice ? 2 : 1;
      }
    }
  }

  void name_inputs() {
    expressions_.assign(lines_.size(), {});
    std::size_t line = 0;
    for (const Parameter& p : function_.parameters) {
      if (p.direction == Direction::out) continue;
      for (int i = 0; i < p.size(); ++i, ++line) {
        while (lines_[line].operation != Operation::input) ++line;
        expressions_[line] = {element(p, i), Binding::primary};
      }
    }
  }

  void write_line(std::size_t i) {
    if (!expressions_[i].text.empty()) return;
    for (const int operand : lines_[i].operands) {
      if (operand >= 0) write_line(static_cast<std::size_t>(operand));
    }
    Expression e = expression(lines_[i]);
    const bool is_flag = lines_[i].operation == Operation::less || lines_[i].operation == Operation::less_equal;
    const bool stays = lines_[i].operation == Operation::constant ||
                       (options_.compound && uses_[i] == 1 && e.text.size() < longest_compound);
    if (!stays) {
      const std::string name = (is_flag ? "is_" : "t") + std::to_string(temporaries_++);
      body_ += "  " +
               local(is_flag ? "bool" : std::string(dialect_.precision) + std::string(dialect_.number),
                     !is_flag && is(Declarations::hlsl)) +
               name + " = " + e.text + ";\n";
      e = {name, Binding::primary};
    }
    expressions_[i] = std::move(e);
  }

  // What stands before the name of a new one.
  std::string local(const std::string& its_type, bool is_precise) const {
    return (is_precise ? precise() : "") + std::string(dialect_.local) + (is(Declarations::wgsl) ? "" : its_type + " ");
  }

  bool is_spelled_as_choice(Operation operation) const {
    return !dialect_.has_minimum && (operation == Operation::minimum || operation == Operation::maximum);
  }

  Expression expression(const Recording::Line& line) const {
    const auto operand = [&](int i) -> const Expression& {
      return expressions_[static_cast<std::size_t>(line.operands[i])];
    };
    const auto infix = [&](const char* sign, Binding binding) -> Expression {
      return {within(operand(0), binding) + sign + within(operand(1), tighter(binding)), binding};
    };
    const auto call = [&](std::string_view name, std::initializer_list<int> operands) -> Expression {
      std::string text(name);
      for (const int i : operands) text += (text.size() == name.size() ? "(" : ", ") + operand(i).text;
      return {text + ")", Binding::primary};
    };
    const auto choice = [](const std::string& condition, const Expression& a, const Expression& b) -> Expression {
      return {condition + " ? " + within(a, Binding::comparison) + " : " + within(b, Binding::comparison),
              Binding::choice};
    };
    const auto less = [](const Expression& a, const Expression& b) {
      return within(a, Binding::sum) + " < " + within(b, Binding::sum);
    };
    switch (line.operation) {
      case Operation::input: break;
      case Operation::constant:
        return {literal(line.constant), std::signbit(line.constant) ? Binding::negation : Binding::primary};
      case Operation::negate: return {"-" + within(operand(0), Binding::primary), Binding::negation};
      case Operation::add: return infix(" + ", Binding::sum);
      case Operation::subtract: return infix(" - ", Binding::sum);
      case Operation::multiply: return infix(" * ", Binding::product);
      case Operation::divide: return infix(" / ", Binding::product);
      case Operation::minimum:
        if (dialect_.has_minimum) return call("min", {0, 1});
        return choice(less(operand(1), operand(0)), operand(1), operand(0));
      case Operation::maximum:
        if (dialect_.has_minimum) return call("max", {0, 1});
        return choice(less(operand(0), operand(1)), operand(1), operand(0));
      case Operation::absolute: return call(dialect_.absolute, {0});
      case Operation::square_root: return call(dialect_.square_root, {0});
      case Operation::less: return {less(operand(0), operand(1)), Binding::comparison};
      case Operation::less_equal:
        return {within(operand(0), Binding::sum) + " <= " + within(operand(1), Binding::sum), Binding::comparison};
      case Operation::select:
        if (!dialect_.has_ternary) return call("select", {2, 1, 0});
        return choice(within(operand(0), Binding::comparison), operand(1), operand(2));
    }
    throw std::logic_error("an input has no expression");
  }

  std::string value(const Recorder& r) {
    if (r.is_constant()) return literal(r.constant());
    const auto line = static_cast<std::size_t>(r.line());
    write_line(line);
    return expressions_[line].text;
  }

  void write_outputs() {
    std::size_t i = 0;
    for (const Parameter* p : outputs_) {
      for (int index = 0; index < p->size(); ++index, ++i) {
        if (!function_.kept[i]) continue;
        const std::string text = value(function_.outputs[i]);
        body_ += "  " + element(*p, index) + " = " + text + ";\n";
      }
    }
  }

  void write_return() {
    const Parameter& p = *outputs_.front();
    std::vector<std::string> components;
    std::size_t length = 0;
    for (const Recorder& output : function_.outputs) length += components.emplace_back(value(output)).size() + 2;
    const std::string separator = length > longest_compound ? ",\n      " : ", ";
    std::string whole;
    for (const std::string& component : components) whole += (whole.empty() ? "" : separator) + component;
    if (p.components > 1) whole = bare_type(p) + "(" + whole + ")";
    body_ += "  " + local(type(p), true) + p.name + " = " + whole + ";\n  return " + p.name + ";\n";
  }

  static constexpr std::size_t longest_compound = 72;

  const RecordedFunction& function_;
  const Dialect& dialect_;
  const TextOptions& options_;
  const std::vector<Recording::Line>& lines_;
  std::vector<const Parameter*> outputs_;
  bool returns_;
  std::vector<bool> live_;
  std::vector<int> uses_;
  std::vector<Expression> expressions_;  // by line: what to write for it
  int temporaries_ = 0;
  std::string body_;
};

}  // namespace detail

/// The function in a dialect: comment, signature and body. The same record and options always give the same text.
inline std::string function_text(const RecordedFunction& function, const Dialect& dialect,
                                 const TextOptions& options = {}) {
  return detail::FunctionWriter(function, dialect, options).text();
}

/// Its signature alone, without what ends it.
inline std::string signature_text(const RecordedFunction& function, const Dialect& dialect,
                                  const TextOptions& options = {}) {
  return detail::FunctionWriter(function, dialect, options).signature();
}
/// How many parameters it has in the text.
inline std::size_t parameter_count(const RecordedFunction& function, const Dialect& dialect,
                                   const TextOptions& options) {
  return detail::FunctionWriter(function, dialect, options).declarations().size();
}

}  // namespace shader
}  // namespace ZONAL_TARGET
}  // namespace zonal
