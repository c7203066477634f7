#include "write.hpp"

#include <cstddef>

#include <zonal/convention/convert.hpp>
#include <zonal/convention/shader_forms.hpp>
#include <zonal/file/number_text.hpp>

#include "coefficients_file.hpp"
#include "shared/text_table.hpp"

namespace zonal_probe {
namespace {

using About = std::vector<std::pair<std::string, std::string>>;

struct Term {
  int l, m;
};

/// Degrees and orders in the order in which they are stored.
std::vector<Term> terms_of(const Stored& stored) {
  std::vector<Term> terms(stored.numbers.size());
  for (int l = 0; l < stored.bands; ++l) {
    for (int m = -l; m <= l; ++m) {
      terms[static_cast<std::size_t>(zonal::stored_index(stored.named->convention.order, l, m))] = {l, m};
    }
  }
  return terms;
}

std::string heading(const Stored& stored, const About& about, const char* comment) {
  std::string text;
  const auto add = [&](const std::string& line) { text += std::string(comment) + " " + line + "\n"; };
  for (const auto& [what, said] : about) add(what + ": " + said);
  add("convention: " + std::string(stored.named->name) + ", " + std::string(stored.named->what));
  add("quantity: " + quantity_text(stored.quantity) + ", " + std::to_string(stored.bands) +
      (stored.bands == 1 ? " band" : " bands"));
  add("frame: " + frame_text(stored.frame));
  return text;
}

// ---- Tables ---------------------------------------------------------------------------------------------------------

std::string table_text(const Stored& stored, const About& about) {
  std::string text = heading(stored, about, "#") + "#  l   m               r               g               b\n";
  const std::vector<Term> terms = terms_of(stored);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Colour& c = stored.numbers[i];
    text += example::format("%4d %3d %15.8g %15.8g %15.8g\n", terms[i].l, terms[i].m, c.r, c.g, c.b);
  }
  return text;
}

// ---- Programs' texts ------------------------------------------------------------------------------------------------

struct Language {
  const char *constant, *vector, *suffix;
};
const Language glsl{"const vec3 ", "vec3", ""}, hlsl{"static const float3 ", "float3", "f"};

/// A number as a literal of C++ and shaders: with a point or an exponent.
std::string literal(double number, const char* suffix) {
  std::string text = zonal::shortest_text(static_cast<float>(number));
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text + suffix;
}

std::string literals(const Colour& c, const char* suffix) {
  return literal(c.r, suffix) + ", " + literal(c.g, suffix) + ", " + literal(c.b, suffix);
}

std::string term_comment(const Term& term) {
  return "  // l " + std::to_string(term.l) + ", m " + std::to_string(term.m) + "\n";
}

std::string cpp_text(const Stored& stored, const std::string& name, const About& about) {
  const std::string count = std::to_string(stored.numbers.size());
  std::string text =
      heading(stored, about, "//") + "inline constexpr float " + name + "[" + count + "][3] = {  // red, green, blue\n";
  const std::vector<Term> terms = terms_of(stored);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    text += "    {" + literals(stored.numbers[i], "F") + "}," + term_comment(terms[i]);
  }
  return text + "};\n";
}

/// The polynomials of Normalisation::polynomial, in h, a direction in the axes of the harmonics.
constexpr int polynomial_bands = 4;
const char* const polynomials[polynomial_bands * polynomial_bands] = {"1.0",
                                                                      "h.y",
                                                                      "h.z",
                                                                      "h.x",
                                                                      "h.x * h.y",
                                                                      "h.y * h.z",
                                                                      "(3.0 * h.z * h.z - 1.0)",
                                                                      "h.x * h.z",
                                                                      "(h.x * h.x - h.y * h.y)",
                                                                      "h.y * (3.0 * h.x * h.x - h.y * h.y)",
                                                                      "h.x * h.y * h.z",
                                                                      "h.y * (5.0 * h.z * h.z - 1.0)",
                                                                      "h.z * (5.0 * h.z * h.z - 3.0)",
                                                                      "h.x * (5.0 * h.z * h.z - 1.0)",
                                                                      "h.z * (h.x * h.x - h.y * h.y)",
                                                                      "h.x * (h.x * h.x - 3.0 * h.y * h.y)"};

/// What the polynomial is multiplied by where the stored number is its coefficient.
double weight_of(const zonal::Convention& convention, const Term& term) {
  zonal::Convention plain;
  plain.phase = zonal::Phase::none;
  plain.normalisation = zonal::Normalisation::polynomial;
  return static_cast<double>(zonal::detail::stored_factor(plain, term.l, term.m) /
                             zonal::detail::stored_factor(convention, term.l, term.m));
}

std::string component(zonal::Axis axis) {
  const std::string text = axis_text(axis);
  return text[0] == '-' ? "-direction." + text.substr(1) : "direction." + text;
}

std::string evaluation_head(const Stored& stored, const std::string& name, const Language& language) {
  const std::string vector = language.vector;
  const bool is_radiance = stored.quantity == zonal::Quantity::radiance;
  return "\n// The " + quantity_text(stored.quantity) + (is_radiance ? " from" : " of a surface whose normal is") +
         " a unit vector in this frame.\n" + vector + " evaluate_" + name + "(" + vector + " direction) {\n";
}

std::string evaluation(const Stored& stored, const std::string& name, const Language& language) {
  const zonal::Convention convention = stored.convention();
  const std::string vector = language.vector, constant = name + "_";
  const std::string in_axes = vector + "(" + component(convention.axes.x) + ", " + component(convention.axes.y) + ", " +
                              component(convention.axes.z) + ")";
  std::string text = evaluation_head(stored, name, language) + "  " + vector +
                     " h = " + (convention.axes == zonal::Axes{} ? "direction" : in_axes) + ";\n  return ";
  const std::vector<Term> terms = terms_of(stored);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const double weight = weight_of(convention, terms[i]);
    const std::string polynomial = polynomials[zonal::sh_index(terms[i].l, terms[i].m)];
    const std::string factor = literal(weight, language.suffix);
    text += i == 0 ? "" : "\n       + ";
    text += constant + std::to_string(i);
    if (factor != literal(1, language.suffix)) text += " * " + (factor[0] == '-' ? "(" + factor + ")" : factor);
    if (polynomial != "1.0") text += " * " + polynomial;
  }
  if (convention.offset > 0 || convention.offset < 0) {
    const std::string offset = literal(convention.offset, language.suffix);
    text += "\n       + " + vector + "(" + offset + ", " + offset + ", " + offset + ")";
  }
  return text + ";\n}\n";
}

std::string shader_text(const Stored& stored, const std::string& name, const About& about, const Language& language) {
  std::string text = heading(stored, about, "//");
  const std::vector<Term> terms = terms_of(stored);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    text += language.constant + name + "_" + std::to_string(i) + " = " + language.vector + "(" +
            literals(stored.numbers[i], language.suffix) + ");" + term_comment(terms[i]);
  }
  if (stored.bands > polynomial_bands) {
    return text + "// More than " + std::to_string(polynomial_bands) +
           " bands: zonal-glsl writes functions for them.\n";
  }
  return text + evaluation(stored, name, language);
}

/// What Unity hands to its shaders, and what SHEvalLinearL0L1 and SHEvalLinearL2 make of it.
std::string unity_text(const Stored& stored, const std::string& name, const About& about) {
  std::string text = heading(stored, about, "//");
  const auto add = [&](const std::string& type, const std::string& suffix, const auto& numbers) {
    text += "static const " + type + " " + name + "_" + suffix + " = " + type + "(";
    const char* between = "";
    for (const double number : numbers) {
      text += between + literal(number, hlsl.suffix);
      between = ", ";
    }
    text += ");\n";
  };
  std::vector<double> c;
  std::vector<zonal::SevenVectors<double>> channels;
  for (int k = 0; k < 3; ++k) {
    zonal::Sh<3, double> numbers{};
    for (int i = 0; i < 9; ++i) numbers[i] = stored.numbers[static_cast<std::size_t>(i)][k];
    channels.push_back(zonal::seven_vectors(numbers));
    c.push_back(channels.back().c);
  }
  for (std::size_t k = 0; k < 3; ++k) add("float4", std::string("SHA") + "rgb"[k], channels[k].a);
  for (std::size_t k = 0; k < 3; ++k) add("float4", std::string("SHB") + "rgb"[k], channels[k].b);
  add("float3", "SHC", c);
  const auto of_channels = [&](const std::string& suffix, const std::string& with) {
    std::string sum = "float3(";
    for (int k = 0; k < 3; ++k)
      sum += (k == 0 ? "dot(" : ", dot(") + name + "_" + suffix + "rgb"[k] + ", " + with + ")";
    return sum + ")";
  };
  return text + evaluation_head(stored, name, hlsl) +
         "  float3 n = direction;\n"
         "  float4 linear_terms = float4(n.x, n.y, n.z, 1.0);\n"
         "  float4 quadratic_terms = float4(n.x * n.y, n.y * n.z, n.z * n.z, n.z * n.x);\n"
         "  return " +
         of_channels("SHA", "linear_terms") + "\n       + " + of_channels("SHB", "quadratic_terms") + "\n       + " +
         name + "_SHC * (n.x * n.x - n.y * n.y);\n}\n";
}

// ---- JSON -----------------------------------------------------------------------------------------------------------

std::string json_members(const Stored& stored, const About& about) {
  std::string text;
  for (const auto& [what, said] : about) text += "  " + json_string(what) + ": " + json_string(said) + ",\n";
  text += "  \"degrees_and_orders\": [";
  const std::vector<Term> terms = terms_of(stored);
  for (std::size_t i = 0; i < terms.size(); ++i) {
    text += (i == 0 ? "[" : ", [") + std::to_string(terms[i].l) + ", " + std::to_string(terms[i].m) + "]";
  }
  return text + "],\n";
}

}  // namespace

std::string output_text(const Stored& stored, Format format, const std::string& name, const About& about) {
  switch (format) {
    case Format::json: return json_text(stored, json_members(stored, about));
    case Format::cpp: return cpp_text(stored, name, about);
    case Format::glsl: return shader_text(stored, name, about, glsl);
    case Format::hlsl: {
      const bool has_own_form = stored.named->name == "unity" && stored.bands == 3;
      return has_own_form ? unity_text(stored, name, about) : shader_text(stored, name, about, hlsl);
    }
    case Format::text: break;
  }
  return table_text(stored, about);
}

}  // namespace zonal_probe
