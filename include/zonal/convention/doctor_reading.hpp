// The doctor's second step: the convention under which the fewest of the terms are wrong.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "doctor_fit.hpp"
#include "named.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail::doctor {

inline bool is_mirrored(const Axes& axes) { return !is_right_handed({axes.x, axes.y, -axes.z}); }

// All 48, the usual ones first.
inline std::vector<Axes> all_axes() {
  std::vector<Axes> all;
  for (const int first : {0, 1, 2}) {
    for (const int step : {1, 2}) {
      for (int signs = 0; signs < 8; ++signs) {
        const int at[3] = {first, (first + step) % 3, (first + 2 * step) % 3};
        Axis axes[3];
        for (int i = 0; i < 3; ++i) axes[i] = static_cast<Axis>((at[i] + 1) * ((signs >> i & 1) != 0 ? -1 : 1));
        all.push_back({axes[0], axes[1], axes[2]});
      }
    }
  }
  return all;
}

struct Term {
  int l, m;
};

inline std::vector<Term> terms_in(CoefficientOrder order, int bands) {
  std::vector<Term> all(static_cast<std::size_t>(bands * bands));
  for (int l = 0; l < bands; ++l) {
    for (int m = -l; m <= l; ++m) all[static_cast<std::size_t>(stored_index(order, l, m))] = {l, m};
  }
  return all;
}

// Their terms as read by one convention: of each, how many times the convention's term it is, and whether it is that
// and nothing else.
struct Reading {
  Convention convention;
  double scale = 1, cost = std::numeric_limits<double>::infinity();
  std::vector<double> factors;
  std::vector<bool> are_alike;
  int exchanged = 0;  // pairs of terms that stand in each other's place
};

// Values that agree, the largest group of them; `taken` are left out.
inline double commonest(const std::vector<double>& values, const std::vector<bool>& taken, double tolerance,
                        int& count) {
  std::vector<double> left;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!taken[i]) left.push_back(values[i]);
  }
  std::sort(left.begin(), left.end());
  double best = 1;
  count = 0;
  for (std::size_t i = 0, end = 0; i < left.size(); ++i) {
    while (end < left.size() && left[end] <= left[i] + tolerance * std::abs(left[i])) ++end;
    if (static_cast<int>(end - i) > count) count = static_cast<int>(end - i), best = left[(i + end) / 2];
  }
  return best;
}

inline bool is_named_basis(const Convention& c) {
  return std::any_of(std::begin(kConventions), std::end(kConventions), [&](const NamedConvention& named) {
    const Convention& known = named.convention;
    return c.phase == known.phase && c.order == known.order && c.normalisation == known.normalisation &&
           c.axes == known.axes;
  });
}

// How many words a reading needs: a word a wrong term, fewer where many are wrong in the same way, and some for what is
// unusual in it.
inline double cost_of(const Reading& reading, double tolerance) {
  double words = 0;
  std::vector<bool> done(reading.factors.size());
  for (std::size_t i = 0; i < done.size(); ++i) {
    const bool is_right =
        reading.are_alike[i] && std::abs(reading.factors[i] - reading.scale) <= tolerance * std::abs(reading.scale);
    done[i] = is_right || !reading.are_alike[i];
    if (!reading.are_alike[i]) words += 1;
  }
  for (;;) {
    int count = 0;
    const double factor = commonest(reading.factors, done, tolerance, count);
    if (count == 0) break;
    words += (std::min)(count + 0.0, 1.5 + 0.05 * count);
    bool is_any = false;
    for (std::size_t i = 0; i < done.size(); ++i) {
      if (!done[i] && std::abs(reading.factors[i] - factor) <= 2 * tolerance * std::abs(factor))
        done[i] = is_any = true;
    }
    if (!is_any) break;
  }
  words -= reading.exchanged;  // of two terms, one word
  const Convention& c = reading.convention;
  // Degrees 0 and 1 do not tell a wrong sign from another axis: there the sign is the likelier.
  const double of_few_bands = reading.factors.size() <= 4 ? 0.5 : 0;
  if (c.axes != Axes{}) words += of_few_bands + (is_mirrored(c.axes) ? 0.9 : 0.6);
  if (c.order != CoefficientOrder::ascending) words += 0.3;
  if (c.normalisation != Normalisation::orthonormal) words += 0.2;
  if (c.quantity != Quantity::radiance) words += 0.3;
  if (!(std::abs(reading.scale - 1) <= tolerance)) words += 0.8;
  if (!is_named_basis(c)) words += 0.1;
  return words;
}

// Pairs among the terms that are not alike what they should be, which are each other's; of a few terms only, for many
// are no exchange but another order.
inline int count_exchanged(const Matrix& terms, const Matrix& harmonics, const std::vector<Term>& in_order,
                           const std::vector<bool>& are_alike, double tolerance) {
  std::vector<int> others;
  for (int i = 0; i < terms.rows; ++i) {
    if (!are_alike[static_cast<std::size_t>(i)]) others.push_back(i);
  }
  if (others.size() > 6) return 0;
  const auto is_like = [&](int i, int j) {
    const Term at = in_order[static_cast<std::size_t>(j)];
    const double along = dot(terms[i], harmonics[sh_index(at.l, at.m)], harmonics.columns);
    return std::abs(along) > (1 - tolerance) * std::sqrt(dot(terms[i], terms[i], terms.columns));
  };
  int pairs = 0;
  for (std::size_t a = 0; a < others.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) pairs += is_like(others[a], others[b]) && is_like(others[b], others[a]) ? 1 : 0;
  }
  return pairs;
}

// Their terms beside those of one order about one system of axes: how many times such a term each is, and whether it is
// nothing else.
struct Likeness {
  std::vector<double> along;
  std::vector<bool> are_alike;
};

inline Likeness compare(const Matrix& terms, const Matrix& expected, const std::vector<Term>& in_order,
                        double tolerance) {
  Likeness r;
  for (int i = 0; i < terms.rows; ++i) {
    const Term at = in_order[static_cast<std::size_t>(i)];
    const double* y = expected[sh_index(at.l, at.m)];
    const double along = dot(terms[i], y, expected.columns);
    const double squared = dot(terms[i], terms[i], terms.columns);
    double across = squared - along * along;
    if (across < 1e-6 * squared) {  // without the cancellation
      across = 0;
      for (int j = 0; j < terms.columns; ++j) {
        const double left = terms[i][j] - (j < expected.columns ? along * y[j] : 0);
        across += left * left;
      }
    }
    r.along.push_back(along);
    r.are_alike.push_back(squared > 0 && across <= tolerance * tolerance * squared);
  }
  return r;
}

// body(convention) of all that differ in what multiplies a term: phase, normalisation and a cosine's factors.
template <class Body>
void for_each_scaling(CoefficientOrder order, const Axes& axes, int bands, const Body& body) {
  for (const Phase phase : {Phase::condon_shortley, Phase::none}) {
    for (const Normalisation normalisation : {Normalisation::orthonormal, Normalisation::n3d, Normalisation::sn3d,
                                              Normalisation::polynomial, Normalisation::furse_malham}) {
      for (const Quantity quantity : {Quantity::radiance, Quantity::irradiance_over_pi, Quantity::irradiance}) {
        const Convention convention{phase, order, normalisation, Meaning::expansion, axes, quantity};
        if (bands - 1 <= greatest_degree(convention)) body(convention);
      }
    }
  }
}

// How many times the convention's each of their terms is; none where it has a degree that is zero.
inline std::vector<double> factors_by(const Convention& c, const std::vector<Term>& in_order,
                                      const std::vector<double>& along) {
  std::vector<double> factors;
  for (std::size_t i = 0; i < along.size(); ++i) {
    const Term at = in_order[i];
    const long double by_cosine = quantity_factor(c.quantity, at.l);
    if (!(by_cosine > 0 || by_cosine < 0)) return {};
    factors.push_back(along[i] / static_cast<double>(basis_factor(c, at.l, at.m) * by_cosine));
  }
  return factors;
}

// Takes the place of `best` where it costs less, as it is or with the scale that most of its terms share.
inline void keep_if_better(Reading& reading, double tolerance, Reading& best) {
  std::vector<bool> are_others = reading.are_alike;
  are_others.flip();
  int agreeing = 0;
  for (const double scale : {1.0, commonest(reading.factors, are_others, tolerance, agreeing)}) {
    reading.scale = scale;
    reading.cost = cost_of(reading, tolerance);
    if (reading.cost < best.cost) best = reading;
  }
}

inline Reading best_reading(const Matrix& terms, int bands, double tolerance) {
  Reading best;
  for (const Axes& axes : all_axes()) {
    const Matrix expected = harmonics_about(axes, bands);
    for (const CoefficientOrder order : {CoefficientOrder::ascending, CoefficientOrder::alternating,
                                         CoefficientOrder::furse_malham, CoefficientOrder::descending}) {
      const std::vector<Term> in_order = terms_in(order, bands);
      const Likeness likeness = compare(terms, expected, in_order, tolerance);
      const auto others = std::count(likeness.are_alike.begin(), likeness.are_alike.end(), false);
      if (static_cast<double>(others) / 2 >= best.cost) continue;  // it cannot be the best
      Reading reading;
      reading.are_alike = likeness.are_alike;
      reading.exchanged = count_exchanged(terms, expected, in_order, likeness.are_alike, tolerance);
      for_each_scaling(order, axes, bands, [&](const Convention& convention) {
        reading.convention = convention;
        reading.factors = factors_by(convention, in_order, likeness.along);
        if (!reading.factors.empty()) keep_if_better(reading, tolerance, best);
      });
    }
  }
  return best;
}

// Whether their terms are those of a convention, all of them. harmonics: those about its axes.
inline bool has_basis_of(const Convention& convention, const Matrix& harmonics, const Matrix& terms, int bands,
                         double tolerance) {
  const std::vector<Term> in_order = terms_in(convention.order, bands);
  for (int i = 0; i < bands * bands; ++i) {
    const Term at = in_order[static_cast<std::size_t>(i)];
    const double unit = static_cast<double>(basis_factor(convention, at.l, at.m));
    double squares = 0;
    for (int j = 0; j < terms.columns; ++j) {
      const double left = terms[i][j] - (j < harmonics.columns ? unit * harmonics[sh_index(at.l, at.m)][j] : 0);
      squares += left * left;
    }
    if (!(squares <= tolerance * tolerance * unit * unit)) return false;
  }
  return true;
}

// The named conventions that have their basis. Few systems of axes are named, and harmonics are turned once for each.
inline std::vector<const NamedConvention*> named_bases(const Matrix& terms, int bands, double tolerance) {
  std::vector<const NamedConvention*> found;
  std::vector<std::pair<Axes, Matrix>> turned;
  for (const NamedConvention& named : kConventions) {
    const Convention& c = named.convention;
    if ((named.bands != 0 && bands > named.bands) || bands - 1 > greatest_degree(c)) continue;
    auto about = std::find_if(turned.begin(), turned.end(), [&](const auto& entry) { return entry.first == c.axes; });
    if (about == turned.end()) about = turned.insert(about, {c.axes, harmonics_about(c.axes, bands)});
    if (has_basis_of(c, about->second, terms, bands, tolerance)) found.push_back(&named);
  }
  return found;
}
}  // namespace detail::doctor
}  // namespace ZONAL_TARGET
}  // namespace zonal
