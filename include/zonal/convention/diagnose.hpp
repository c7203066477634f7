// The doctor: what somebody's spherical harmonics are, from their values alone.
//
// Their functions are fitted by ours, three bands beyond theirs. A right one is a harmonic of one convention: of its
// axes, in its order, with its sign and scale. All combinations of these are tried, and the one under which the fewest
// terms are wrong is taken; what then is wrong names itself: a sign, a factor, a term in the place of another, one that
// mixes several, one that is no sum of harmonics at all.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "doctor_words.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What was found. A term is named (l, m) after the harmonic that it should be, and by its place in their order.
struct Diagnosis {
  int bands = 0;
  bool is_right = false;                ///< no fault: every term is what the convention says
  std::vector<std::string_view> names;  ///< the named conventions that have just this basis
  Convention convention;                ///< of the nearest basis; its quantity says which cosine's factors are in it
  double scale = 1;                     ///< by which all terms differ from the convention's
  double noise = 0;                     ///< root mean square of what no harmonic explains, the middle one of all terms
  double tolerance = 0;                 ///< relative difference from which on a term counts as wrong
  std::vector<std::string> faults;      ///< one sentence each, the gravest first
};

/// Directions that tell the harmonics of so many bands, and those of a few bands more, apart: 4 (N+2)^2 of them, on a
/// spiral, unit vectors to 1e-16. In an order that never changes.
inline std::vector<Direction> diagnosis_directions(int bands) {
  const int count = 4 * (bands + 2) * (bands + 2);
  const double golden_angle = static_cast<double>(kPi * (3 - constexpr_sqrt(5.0L)));
  std::vector<Direction> all;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2.0 * i + 1) / count, sine = std::sqrt((1 - z) * (1 + z)), angle = golden_angle * i + 0.3;
    all.push_back({sine * std::cos(angle), sine * std::sin(angle), z});
  }
  return all;
}

namespace detail::doctor {
inline void check_input(int bands, const std::vector<Direction>& directions, const std::vector<double>& values) {
  if (bands < 1 || bands > 20) refuse("the doctor knows 1 to 20 bands, not " + std::to_string(bands));
  const int count = bands * bands;
  if (values.size() != directions.size() * static_cast<std::size_t>(count)) {
    refuse(std::to_string(values.size()) + " values for " + std::to_string(directions.size()) + " directions of " +
           std::to_string(count) + " terms");
  }
}

// Without what rounding to a few digits has changed of their length.
inline std::vector<Direction> unit_vectors(std::vector<Direction> directions) {
  for (Direction& d : directions) {
    const double length = std::hypot(d[0], d[1], d[2]);
    if (!(std::abs(length - 1) < 1e-3)) refuse("a direction that is no unit vector");
    for (double& component : d) component /= length;
  }
  return directions;
}

// A direction a row. What is no number, or so large that squares are none, is a fault, and 0.
inline Matrix table_of(int terms, const std::vector<double>& values, std::vector<std::string>& faults) {
  Matrix table(static_cast<int>(values.size() / static_cast<std::size_t>(terms)), terms);
  std::copy(values.begin(), values.end(), table.values.begin());
  for (int i = 0; i < terms; ++i) {
    int missing = 0;
    for (int k = 0; k < table.rows; ++k) {
      if (!(std::abs(table[k][i]) <= 1e100)) ++missing, table[k][i] = 0;
    }
    if (missing == 0) continue;
    faults.push_back("term " + std::to_string(i) + " is no number at " + std::to_string(missing) + " of " +
                     std::to_string(table.rows) + " directions");
  }
  return table;
}

// By harmonics of three bands more than theirs, or of as many as the directions tell apart.
inline Fit fit_beyond(int bands, const std::vector<Direction>& directions, const Matrix& table) {
  for (int more = 3; more >= 0; --more) {
    if ((bands + more) * (bands + more) > table.rows) continue;
    Fit fitted = fit(directions, table, bands + more);
    if (fitted.bands != 0) return fitted;
  }
  refuse(std::to_string(directions.size()) + " directions do not tell " + std::to_string(bands * bands) +
         " harmonics apart");
}

inline double middle_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// What a basis that is of no name comes nearest to, and what is then wrong with it.
inline void name_faults(const Fit& fitted, Diagnosis& r) {
  const Reading reading = best_reading(fitted.terms, r.bands, r.tolerance);
  r.convention = reading.convention;
  r.scale = reading.scale;
  if (is_mirrored(reading.convention.axes)) {
    r.faults.push_back("the axes are left-handed: a coordinate has the wrong sign, or two are exchanged");
  }
  if (!(std::abs(reading.scale - 1) <= r.tolerance)) {
    r.faults.push_back("all terms are " + factor_text(reading.scale, r.tolerance) + " of what they should be");
  }
  for (std::string& fault : faults_of(fitted, reading, r.bands, r.tolerance)) r.faults.push_back(std::move(fault));
}
}  // namespace detail::doctor

/// What basis these are the values of: `values` holds bands * bands numbers for each direction, one direction after the
/// other, in the order in which the code under test has them. Directions are unit vectors, to 1e-3, best those of
/// diagnosis_directions(); at least bands^2 of them, and twice that to be told mixtures with other degrees.
///
/// A term counts as wrong from a relative difference of 1e-5 on, or of 20 times the noise. Named conventions with noise
/// of up to 1e-5 of their values are recognised, and so are single faults down to the tolerance. 2 bands leave it open
/// whether a sign is wrong or an axis points the other way. Throws std::invalid_argument where there are not enough
/// directions, or numbers (refuse.hpp). 4 to 6 ms at 5 bands, 50 to 80 ms at 10, 1.6 to 2.9 s at 20.
inline Diagnosis diagnose(int bands, const std::vector<Direction>& directions, const std::vector<double>& values) {
  using namespace detail::doctor;
  check_input(bands, directions, values);
  Diagnosis r;
  r.bands = bands;
  const Fit fitted = fit_beyond(bands, unit_vectors(directions), table_of(bands * bands, values, r.faults));
  r.noise = middle_of(fitted.rest);
  r.tolerance = (std::max)(1e-5, 20 * r.noise);
  const std::vector<const NamedConvention*> found = named_bases(fitted.terms, bands, r.tolerance);
  for (const NamedConvention* named : found) r.names.push_back(named->name);
  if (found.empty()) {
    name_faults(fitted, r);
  } else {
    r.convention = found.front()->convention;
  }
  r.is_right = r.faults.empty();
  return r;
}

/// The same of a function: basis(x, y, z) gives back its bands * bands values, as anything with [i].
template <class Basis>
Diagnosis diagnose(int bands, const Basis& basis) {
  const std::vector<Direction> directions = diagnosis_directions(bands);
  std::vector<double> values;
  for (const Direction& d : directions) {
    const auto at = basis(d[0], d[1], d[2]);
    for (int i = 0; i < bands * bands; ++i) values.push_back(static_cast<double>(at[static_cast<std::size_t>(i)]));
  }
  return diagnose(bands, directions, values);
}

/// A convention in words: "phase of Condon and Shortley, order -l to l, orthonormal, polar axis z".
inline std::string describe(const Convention& c) {
  std::string text = c.phase == Phase::condon_shortley ? "with the phase of Condon and Shortley" : "without phase";
  switch (c.order) {
    case CoefficientOrder::ascending: text += ", orders -l to l"; break;
    case CoefficientOrder::alternating: text += ", orders 0, 1, -1, 2, -2, ..."; break;
    case CoefficientOrder::furse_malham: text += ", in Furse and Malham's order"; break;
    case CoefficientOrder::descending: text += ", orders l to -l"; break;
  }
  switch (c.normalisation) {
    case Normalisation::orthonormal: text += ", orthonormal"; break;
    case Normalisation::n3d: text += ", N3D (mean square 1)"; break;
    case Normalisation::sn3d: text += ", SN3D (Schmidt)"; break;
    case Normalisation::furse_malham: text += ", Furse and Malham's scale"; break;
    case Normalisation::polynomial: text += ", plain polynomials"; break;
  }
  if (c.axes == Axes{}) return text + ", polar axis z";
  return text + ", with " + detail::axis_name(c.axes.x) + ", " + detail::axis_name(c.axes.y) + ", " +
         detail::axis_name(c.axes.z) + " for the harmonics' x, y, z";
}

/// All of it, a line each, each ended.
inline std::string describe(const Diagnosis& diagnosis) {
  std::string text;
  if (!diagnosis.names.empty()) {
    text += "the basis of";
    for (std::size_t i = 0; i < diagnosis.names.size(); ++i) {
      text += (i == 0 ? " " : ", ") + std::string(diagnosis.names[i]);
    }
    text += "\n";
  }
  text += std::string(diagnosis.is_right ? "" : "nearest: ") + describe(diagnosis.convention) + "\n";
  if (diagnosis.convention.quantity != Quantity::radiance && diagnosis.names.empty()) {
    text += std::string("with a clamped cosine's factors in it, so that it turns radiance into ") +
            (diagnosis.convention.quantity == Quantity::irradiance ? "irradiance\n" : "irradiance / pi\n");
  }
  for (const std::string& fault : diagnosis.faults) text += "wrong: " + fault + "\n";
  return text;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
