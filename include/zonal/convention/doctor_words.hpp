// The doctor's third step: what is wrong with each term, in words.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "doctor_reading.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail::doctor {

inline std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", value);
  return text;
}
inline std::string text_of(const Term& term) {
  return "(" + std::to_string(term.l) + "," + std::to_string(term.m) + ")";
}

// A factor, and what it probably is.
inline std::string factor_text(double factor, double tolerance) {
  constexpr double pi = static_cast<double>(kPi);
  const struct {
    double value;
    const char* name;
  } known[] = {{std::sqrt(2.0), "sqrt(2)"},
               {std::sqrt(3.0), "sqrt(3)"},
               {std::sqrt(5.0), "sqrt(5)"},
               {std::sqrt(6.0), "sqrt(6)"},
               {pi, "pi"},
               {std::sqrt(pi), "sqrt(pi)"},
               {2 * pi, "2 pi"},
               {4 * pi, "4 pi"},
               {std::sqrt(4 * pi), "sqrt(4 pi)"},
               {std::sqrt(2 * pi), "sqrt(2 pi)"},
               {1.5, "3/2"}};
  const double size = std::abs(factor);
  for (const auto& each : known) {
    if (std::abs(size / each.value - 1) <= 4 * tolerance) return text_of(factor) + " (" + each.name + ")";
    if (std::abs(size * each.value - 1) <= 4 * tolerance) {
      const std::string name = each.name;
      const bool is_single = name.find(' ') == std::string::npos || name.front() == 's';
      return text_of(factor) + " (1/" +
             (each.value < 1.6 && name == "3/2" ? "1.5"
              : is_single                       ? name
                                                : "(" + name + ")") +
             ")";
    }
  }
  return text_of(factor);
}

// What a term is made of, the largest part first: "0.92 (4,-1) + 0.38 (2,-1)", as shares of the convention's terms.
inline std::string parts_text(const double* term, const Matrix& harmonics, int bands, const Reading& reading,
                              double tolerance) {
  struct Part {
    double share, size;
    Term at;
  };
  std::vector<Part> parts;
  double greatest = 0;
  for (int l = 0; l < bands; ++l) {
    for (int m = -l; m <= l; ++m) {
      const double along = dot(term, harmonics[sh_index(l, m)], harmonics.columns);
      // Beyond what the convention lists: in units of orthonormal harmonics.
      const bool is_listed = l <= greatest_degree(reading.convention);
      const double unit = static_cast<double>(is_listed ? basis_factor(reading.convention, l, m)
                                                        : phase_sign(reading.convention.phase, m));
      parts.push_back({along / (unit * reading.scale), std::abs(along), {l, m}});
      greatest = (std::max)(greatest, std::abs(along));
    }
  }
  // The greatest first; those alike but for rounding by degree and order.
  const auto rank = [&](const Part& part) {
    const double steps = std::round(part.size / (tolerance * greatest));
    return steps > 0 ? steps : 0;  // of what is no number too
  };
  std::stable_sort(parts.begin(), parts.end(), [&](const Part& a, const Part& b) { return rank(a) > rank(b); });
  std::string text;
  int shown = 0;
  for (const Part& part : parts) {
    if (part.size <= 3 * tolerance * greatest) break;
    if (++shown > 5) return text + " and more";
    text += (text.empty() ? "" : " + ") + text_of(part.share) + " " + text_of(part.at);
  }
  return text;
}

// The other term that this one is, with what factor; its own place where it is none.
inline int place_of_other(const double* term, int own, const Matrix& harmonics, const Reading& reading, int bands,
                          double tolerance, double& factor) {
  const std::vector<Term> in_order = terms_in(reading.convention.order, bands);
  const double length = std::sqrt(dot(term, term, harmonics.columns));
  for (int i = 0; i < bands * bands; ++i) {
    const Term at = in_order[static_cast<std::size_t>(i)];
    const double along = dot(term, harmonics[sh_index(at.l, at.m)], harmonics.columns);
    if (i == own || std::abs(along) < (1 - tolerance) * length) continue;
    const double unit = static_cast<double>(basis_factor(reading.convention, at.l, at.m) *
                                            quantity_factor(reading.convention.quantity, at.l));
    factor = along / (unit * reading.scale);
    return i;
  }
  return own;
}

inline std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  }
  return text;
}

// Terms of one convention that are wrong, in words.
inline std::vector<std::string> faults_of(const Fit& fitted, const Reading& reading, int bands, double tolerance) {
  const std::vector<Term> in_order = terms_in(reading.convention.order, bands);
  const Matrix harmonics = harmonics_about(reading.convention.axes, fitted.bands);
  const auto name = [&](int i) { return text_of(in_order[static_cast<std::size_t>(i)]); };
  std::vector<std::string> faults;
  std::vector<std::pair<double, std::vector<std::string>>> groups;  // by one factor
  std::vector<int> others(in_order.size());
  std::vector<double> factors(in_order.size(), 1);
  for (int i = 0; i < bands * bands; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    others[k] =
        reading.are_alike[k] ? i : place_of_other(fitted.terms[i], i, harmonics, reading, bands, tolerance, factors[k]);
  }
  for (int i = 0; i < bands * bands; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    const double* term = fitted.terms[i];
    const double length = std::sqrt(dot(term, term, fitted.terms.columns));
    if (reading.are_alike[k]) {
      const double factor = reading.factors[k] / reading.scale;
      if (std::abs(factor - 1) <= tolerance) continue;
      const auto same = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
        return std::abs(group.first - factor) <= 2 * tolerance * std::abs(factor);
      });
      if (same != groups.end()) {
        same->second.push_back(name(i));
      } else {
        groups.push_back({factor, {name(i)}});
      }
    } else if (fitted.rest[k] > tolerance * length) {
      faults.push_back(
          name(i) + " is no sum of harmonics of degrees 0 to " + std::to_string(fitted.bands - 1) + ": " +
          text_of(100 * fitted.rest[k] * std::sqrt(4 * static_cast<double>(kPi)) / (std::max)(length, fitted.rest[k])) +
          " % of it is something else");
    } else if (!(length > 0)) {
      faults.push_back(name(i) + " is zero");
    } else if (others[k] != i) {
      const int other = others[k];
      const bool are_swapped = others[static_cast<std::size_t>(other)] == i;
      if (are_swapped && other < i) continue;  // said already
      const std::string times =
          std::abs(factors[k] - 1) <= 4 * tolerance ? std::string() : ", times " + factor_text(factors[k], tolerance);
      faults.push_back(are_swapped ? name(i) + " and " + name(other) + " are exchanged" + times
                                   : "in the place of " + name(i) + " is " + name(other) + times);
    } else {
      faults.push_back(name(i) + " mixes harmonics: it is " +
                       parts_text(term, harmonics, fitted.bands, reading, tolerance));
    }
  }
  for (const auto& [factor, names] : groups) {
    const std::string terms = joined(names);
    const bool are_many = names.size() > 1;
    if (std::abs(factor + 1) <= tolerance) {
      faults.push_back(terms + (are_many ? " have the wrong sign" : " has the wrong sign"));
    } else {
      faults.push_back(terms + (are_many ? " are " : " is ") + factor_text(factor, tolerance) + " of what " +
                       (are_many ? "they" : "it") + " should be");
    }
  }
  return faults;
}
}  // namespace detail::doctor
}  // namespace ZONAL_TARGET
}  // namespace zonal
