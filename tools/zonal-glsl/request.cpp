#include "request.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <string_view>
#include <utility>

#include <zonal/shader/adjoint_function.hpp>
#include <zonal/shader/file_text.hpp>
#include <zonal/shader/shells.hpp>

#include "shader_functions.hpp"

namespace zonal_glsl {
namespace {

using zonal::shader::Dialect;
using zonal::shader::FunctionEntry;
using zonal::shader::NamedText;
using zonal::shader::RecordedFunction;
using zonal::shader::Shell;

[[noreturn]] void refuse(const std::string& name, const char* what) { throw RequestError("'" + name + "' " + what); }

/// Which coefficients stay.
struct Coefficients {
  bool even_only = false;
  int degree = -1;  // -1: all

  bool keep(int l, int m) const { return (!even_only || m >= 0) && (degree < 0 || l == degree); }
};

Coefficients parse_coefficients(const std::string& name, const std::string& text, int bands) {
  if (text == "even") return {true, -1};
  const std::string prefix = "degree";
  int degree = -1;
  const char* end = text.data() + text.size();
  if (text.rfind(prefix, 0) == 0) {
    const auto [stop, error] = std::from_chars(text.data() + prefix.size(), end, degree);
    if (error == std::errc() && stop == end && 0 <= degree && degree < bands) return {false, degree};
  }
  refuse(name, "selects neither :even nor :degree<l>, l below the number of bands");
}

/// What the text says of them.
std::string remark(const std::string& selection, const Coefficients& coefficients) {
  if (coefficients.even_only) return "Of m >= 0 alone, (l, m) at l (l + 1) / 2 + m.";
  return "Of " + selection.substr(0, 6) + " " + selection.substr(6) + " alone, m at " + selection.substr(6) + " + m.";
}

class Selector {
 public:
  Selector(const Request& request, const Dialect& dialect) : request_(request), dialect_(dialect) {
    check_options();
    if (request.plan) add(*request.plan);
    for (const std::string& name : request.functions) add(name);
    for (const std::string& name : request.adjoints) add_adjoint(name);
  }
  Selection result;

 private:
  void check_options() const {
    const std::string& prefix = request_.text.prefix;
    const auto is_letter = [](char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); };
    const bool is_name = !prefix.empty() && is_letter(prefix[0]) &&
                         std::all_of(prefix.begin(), prefix.end(),
                                     [&](char c) { return is_letter(c) || ('0' <= c && c <= '9') || c == '_'; });
    // What GLSL keeps to itself: gl_, and two underscores.
    if (!is_name || prefix.rfind("gl_", 0) == 0 || prefix.find("__") != std::string::npos) {
      throw RequestError("--prefix: '" + prefix + "' begins no name of all languages");
    }
    if (request_.text.precise && dialect_.precise.empty()) {
      throw RequestError("--precise: " + std::string(dialect_.title) + " has no such word");
    }
  }

  void add(const zonal::shader::PlannedMaterials& plan) {
    check_loops("gather_planned");
    const zonal::shader::PlannedShells planned = planned_shells(plan, dialect_, request_.text);
    for (const auto& need : planned.needs) {
      add(find_function(need.function.function)->record(need.bands, need.function.part));
    }
    result.shells = planned.shells;
  }

  void check_loops(const std::string& name) const {
    if (!dialect_.has_loops) refuse(name, "is a loop, which is there in GLSL only");
    if (request_.text.flat) refuse(name, "is a loop, which takes arrays: not with --flat");
  }

  /// <name>[:<selection>][@<bands>]
  struct Item {
    std::string text, name, selection;
    bool has_bands;
    int bands;
  };
  Item parse(const std::string& text) const {
    const std::size_t at = text.find('@');
    const std::string name = text.substr(0, at);
    const bool has_bands = at != std::string::npos;
    const std::size_t colon = name.find(':');
    return {text, name.substr(0, colon), colon == std::string::npos ? "" : name.substr(colon), has_bands,
            has_bands ? parse_bands("'" + text + "'", text.substr(at + 1)) : request_.bands};
  }

  void add(const std::string& text) {
    const Item item = parse(text);
    if (const FunctionEntry* function = find_function(item.name)) {
      add(record(*function, item));
    } else if (const Shell* shell = zonal::shader::find_shell(item.name + item.selection)) {
      check_loops(item.name);
      add(*shell, item.bands);
    } else {
      refuse(item.name + item.selection, "is no function (--list names them)");
    }
  }
  void add_adjoint(const std::string& text) {
    const Item item = parse(text);
    const FunctionEntry* function = find_function(item.name);
    if (function == nullptr) {
      const bool is_loop = zonal::shader::find_shell(item.name) != nullptr;
      refuse(item.name, is_loop ? "is a loop, which has no adjoint" : "is no function (--list names them)");
    }
    try {
      add(adjoint_function(record(*function, item), request_.by));
    } catch (const zonal::shader::NoAdjoint& none) {
      throw RequestError(std::string("--adjoint: ") + none.what());
    }
  }

  RecordedFunction record(const FunctionEntry& function, const Item& item) const {
    if (item.has_bands && !function.has_bands) refuse(item.text, "has no bands to choose");
    if (item.bands > function.most_bands) {
      throw RequestError("'" + item.text + "' has at most " + std::to_string(function.most_bands) + " bands");
    }
    RecordedFunction recorded = function.record(item.bands, zonal::shader::all_orders);
    if (!item.selection.empty()) {
      const std::string selection = item.selection.substr(1), name = item.name + item.selection;
      const Coefficients coefficients = parse_coefficients(name, selection, item.bands);
      if (!keep_coefficients(recorded, [&](int l, int m) { return coefficients.keep(l, m); })) {
        refuse(name, "has no outputs by degree and order to select from");
      }
      recorded.name += "_" + selection;
      recorded.remark = remark(selection, coefficients);
    }
    return recorded;
  }
  void add(RecordedFunction&& recorded) {
    const auto is_same = [&](const RecordedFunction& other) { return other.name == recorded.name; };
    if (std::any_of(result.functions.begin(), result.functions.end(), is_same)) return;
    const std::size_t parameters = parameter_count(recorded, dialect_, request_.text);
    if (parameters > static_cast<std::size_t>(dialect_.max_parameters)) {
      throw RequestError(recorded.name + " would have " + std::to_string(parameters) + " parameters; " +
                         std::string(dialect_.title) + " allows " + std::to_string(dialect_.max_parameters));
    }
    result.functions.push_back(std::move(recorded));
  }
  void add(const Shell& shell, int bands) {
    const std::string name = shell_name(shell, bands, request_.text);
    const auto is_same = [&](const NamedText& other) { return other.name == name; };
    if (std::any_of(result.shells.begin(), result.shells.end(), is_same)) return;
    for (const auto& need : shell.needs(bands)) add(find_function(need.function)->record(bands, need.part));
    result.shells.push_back({name, shell_text(shell, bands, dialect_, request_.text)});
  }

  const Request& request_;
  const Dialect& dialect_;
};

std::string join(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

/// The options that a file was made with.
std::string made_by(const Request& request) {
  const zonal::shader::TextOptions& text = request.text;
  std::string made;
  const auto option = [&](const char* name, const std::string& value) {
    if (!value.empty()) made += (made.empty() ? "" : " ") + (name + value);
  };
  if (request.plan) option("--plan ", request.plan_name);
  if (!request.functions.empty() || !request.adjoints.empty()) option("--bands ", std::to_string(request.bands));
  option("--functions ", join(request.functions));
  option("--adjoint ", join(request.adjoints));
  option("--by ", join(request.by));
  return made + (text.compound ? "" : " --temporaries") + (text.precise ? " --precise" : "") +
         (text.flat ? " --flat" : "") +
         (text.prefix == zonal::shader::TextOptions().prefix ? "" : " --prefix " + text.prefix);
}

}  // namespace

Selection select(const Request& request, const Dialect& dialect) { return Selector(request, dialect).result; }

std::string shader_file(const Request& request, const Dialect& dialect) {
  const Selection selection = select(request, dialect);
  return zonal::shader::file_text(selection.functions, selection.shells, dialect, made_by(request), request.text);
}

std::string function_list(const Request& request, const Dialect& dialect) {
  std::string text;
  const auto add = [&](std::string_view name, std::string_view summary, const std::string& signature) {
    std::string line(name);
    line.resize(std::max<std::size_t>(line.size() + 1, 30), ' ');
    text += line + std::string(summary) + "\n    " + signature + "\n";
  };
  for (const FunctionEntry& entry : shader_functions()) {
    if (request.bands > entry.most_bands) continue;
    const RecordedFunction function = entry.record(request.bands, zonal::shader::all_orders);
    add(entry.name, entry.summary, signature_text(function, dialect, request.text));
  }
  if (!dialect.has_loops) return text;
  text += "\nLoops, in GLSL only:\n";
  for (const Shell& shell : zonal::shader::shells) {
    add(shell.name, shell.summary, signature_text(shell, request.bands, dialect, request.text));
  }
  return text;
}

std::string operation_table(const Request& request, const Dialect& dialect) {
  std::string text = "function                                      total   add   mul   div  sqrt  choose\n";
  for (const RecordedFunction& function : select(request, dialect).functions) {
    const zonal::OperationCount c = function.count();
    char line[120];
    std::snprintf(line, sizeof line, "%-44s %6d %5d %5d %5d %5d %7d\n", function.name.c_str(), c.total(), c.additions,
                  c.multiplications, c.divisions, c.functions, c.comparisons);
    text += line;
  }
  return text;
}

}  // namespace zonal_glsl
