#include "request.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>

#include <zonal/glsl/file_text.hpp>
#include <zonal/glsl/shells.hpp>

#include "shader_functions.hpp"

namespace zonal_glsl {
namespace {

using zonal::glsl::Dialect;
using zonal::glsl::Direction;
using zonal::glsl::FunctionEntry;
using zonal::glsl::Parameter;
using zonal::glsl::RecordedFunction;
using zonal::glsl::Shell;

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

/// Drops the coefficients that are not kept from every output that has them.
void keep_coefficients(RecordedFunction& function, const std::string& name, const Coefficients& coefficients,
                       int bands) {
  bool has_any = false;
  std::size_t at = 0;
  for (const Parameter& p : function.parameters) {
    if (p.direction == Direction::in) continue;
    const bool has_orders = p.count == bands * bands;
    has_any = has_any || has_orders;
    for (int i = 0; i < p.size(); ++i, ++at) {
      const int index = i / p.components, l = static_cast<int>(std::sqrt(index + 0.5)), m = index - l * (l + 1);
      if (has_orders && !coefficients.keep(l, m)) function.kept[at] = false;
    }
  }
  if (!has_any) refuse(name, "has no outputs by degree and order to select from");
}

class Selector {
 public:
  Selector(const Request& request, const Dialect& dialect) : bands_(request.bands), dialect_(dialect) {
    for (const std::string& name : request.functions) add(name);
  }
  Selection result;

 private:
  void add(const std::string& name) {
    const std::size_t colon = name.find(':');
    const std::string base = name.substr(0, colon);
    if (const FunctionEntry* function = find_function(base)) {
      RecordedFunction recorded = function->record(bands_, zonal::glsl::all_orders);
      if (colon != std::string::npos) {
        const std::string selection = name.substr(colon + 1);
        keep_coefficients(recorded, name, parse_coefficients(name, selection, bands_), bands_);
        recorded.name += "_" + selection;
      }
      add(std::move(recorded));
    } else if (const Shell* shell = zonal::glsl::find_shell(name)) {
      if (dialect_.name != "glsl450" && dialect_.name != "glsles300")
        refuse(name, "is a loop, which is there in GLSL only");
      add(*shell);
    } else {
      refuse(name, "is no function (--list names them)");
    }
  }
  void add(RecordedFunction&& recorded) {
    const auto is_same = [&](const RecordedFunction& other) { return other.name == recorded.name; };
    if (std::none_of(result.functions.begin(), result.functions.end(), is_same)) {
      result.functions.push_back(std::move(recorded));
    }
  }
  void add(const Shell& shell) {
    for (const auto& need : shell.needs(bands_)) add(find_function(need.function)->record(bands_, need.order));
    std::string text = shell.text(bands_);
    if (std::find(result.shells.begin(), result.shells.end(), text) == result.shells.end()) {
      result.shells.push_back(std::move(text));
    }
  }

  int bands_;
  const Dialect& dialect_;
};

std::string join(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

/// ZONAL_5_EVALUATE_CAP_GLSL: files of different contents have different guards.
std::string guard(const Request& request) {
  std::string name = "ZONAL_" + std::to_string(request.bands) + "_" + join(request.functions) + "_GLSL";
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? static_cast<char>(std::toupper(c)) : '_';
  return name;
}

}  // namespace

Selection select(const Request& request, const Dialect& dialect) { return Selector(request, dialect).result; }

std::string shader_file(const Request& request, const Dialect& dialect) {
  const Selection selection = select(request, dialect);
  const std::string made_by = "--bands " + std::to_string(request.bands) + " --functions " + join(request.functions) +
                              (request.text.compound ? "" : " --temporaries");
  return zonal::glsl::file_text(selection.functions, selection.shells, dialect, {guard(request), made_by},
                                request.text);
}

std::string function_list() {
  std::string text;
  const auto add = [&](std::string_view name, std::string_view summary) {
    std::string line(name);
    line.resize(std::max<std::size_t>(line.size() + 1, 30), ' ');
    text += line + std::string(summary) + "\n";
  };
  for (const FunctionEntry& entry : shader_functions()) add(entry.name, entry.summary);
  text += "\nLoops, in GLSL only:\n";
  for (const Shell& shell : zonal::glsl::shells) add(shell.name, shell.summary);
  return text;
}

std::string operation_table(const Request& request, const Dialect& dialect) {
  std::string text = "function                              total   add   mul   div  sqrt  choose\n";
  for (const RecordedFunction& function : select(request, dialect).functions) {
    const zonal::OperationCount c = function.count();
    char line[120];
    std::snprintf(line, sizeof line, "%-36s %6d %5d %5d %5d %5d %7d\n", function.name.c_str(), c.total(), c.additions,
                  c.multiplications, c.divisions, c.functions, c.comparisons);
    text += line;
  }
  return text;
}

}  // namespace zonal_glsl
