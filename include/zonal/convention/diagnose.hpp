// The doctor: what somebody's spherical harmonics are, from their values alone.
//
// Their functions are fitted by ours, three bands beyond theirs. A right one is a harmonic of one convention: of its
// axes, in its order, with its sign and scale. All combinations of these are tried, and the one under which the fewest
// terms are wrong is taken; what then is wrong names itself: a sign, a factor, a term in the place of another, one that
// mixes several, one that is no sum of harmonics at all.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../many_bands/evaluate.hpp"
#include "../many_bands/rotate.hpp"
#include "named.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

using Direction = std::array<double, 3>;

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

struct Matrix {
  int rows, columns;
  std::vector<double> values;
  Matrix(int row_count, int column_count)
      : rows(row_count),
        columns(column_count),
        values(static_cast<std::size_t>(row_count) * static_cast<std::size_t>(column_count)) {}
  double* operator[](int i) { return values.data() + static_cast<std::ptrdiff_t>(i) * columns; }
  const double* operator[](int i) const { return values.data() + static_cast<std::ptrdiff_t>(i) * columns; }
};

/// Cholesky's factor of a symmetric matrix in its lower half; false where it is not positive by some margin.
inline bool factorise(Matrix& a) {
  for (int j = 0; j < a.columns; ++j) {
    const double before = a[j][j];
    for (int k = 0; k < j; ++k) a[j][j] -= a[j][k] * a[j][k];
    if (!(a[j][j] > 1e-9 * before)) return false;
    a[j][j] = std::sqrt(a[j][j]);
    for (int i = j + 1; i < a.rows; ++i) {
      for (int k = 0; k < j; ++k) a[i][j] -= a[i][k] * a[j][k];
      a[i][j] /= a[j][j];
    }
  }
  return true;
}
inline void solve(const Matrix& factor, double* x) {
  for (int i = 0; i < factor.rows; ++i) {
    for (int k = 0; k < i; ++k) x[i] -= factor[i][k] * x[k];
    x[i] /= factor[i][i];
  }
  for (int i = factor.rows - 1; i >= 0; --i) {
    for (int k = i + 1; k < factor.rows; ++k) x[i] -= factor[k][i] * x[k];
    x[i] /= factor[i][i];
  }
}

inline Matrix basis_at(const std::vector<Direction>& directions, int bands) {
  const ManyBands<double> many(bands);
  BasisSpace<double> space(bands);
  Matrix y(static_cast<int>(directions.size()), bands * bands);
  for (int k = 0; k < y.rows; ++k) evaluate(many, directions[static_cast<std::size_t>(k)], space, y[k]);
  return y;
}

struct Fit {
  int bands = 0;             // of the harmonics that they were fitted by
  Matrix terms;              // their terms, one a row, by our harmonics
  std::vector<double> rest;  // root mean square of what is left of each
};

/// Least squares; bands 0 where the directions do not tell so many harmonics apart.
inline Fit fit(const std::vector<Direction>& directions, const Matrix& values, int bands) {
  const Matrix y = basis_at(directions, bands);
  Matrix gram(y.columns, y.columns);
  for (int k = 0; k < y.rows; ++k) {
    for (int i = 0; i < y.columns; ++i) {
      for (int j = 0; j <= i; ++j) gram[i][j] += y[k][i] * y[k][j];
    }
  }
  Fit r{0, Matrix(values.columns, y.columns), std::vector<double>(static_cast<std::size_t>(values.columns))};
  if (!factorise(gram)) return r;
  r.bands = bands;
  for (int term = 0; term < values.columns; ++term) {
    double* x = r.terms[term];
    for (int k = 0; k < y.rows; ++k) {
      for (int i = 0; i < y.columns; ++i) x[i] += y[k][i] * values[k][term];
    }
    solve(gram, x);
    double squares = 0;
    for (int k = 0; k < y.rows; ++k) {
      double left = values[k][term];
      for (int i = 0; i < y.columns; ++i) left -= x[i] * y[k][i];
      squares += left * left;
    }
    r.rest[static_cast<std::size_t>(term)] = std::sqrt(squares / y.rows);
  }
  return r;
}

// The harmonics about other axes by ours: row (l, m) is Y_l^m of the direction in these axes.
inline Matrix harmonics_about(const Axes& axes, int bands) {
  const ManyRotation<double> rotation(
      bands, Rotation<2, double>::from_axes(AxisVector<double>(axes.x), AxisVector<double>(axes.y),
                                            AxisVector<double>(axes.z)));
  Matrix r(bands * bands, bands * bands);
  for (int i = 0; i < r.rows; ++i) {
    ManySh<double> one(bands);
    one[i] = 1;
    const ManySh<double> turned = rotate(one, rotation);
    std::copy(turned.begin(), turned.end(), r[i]);
  }
  return r;
}

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

inline double dot(const double* a, const double* b, int count) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += a[i] * b[i];
  return sum;
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

inline Reading best_reading(const Matrix& terms, int bands, double tolerance) {
  Reading best;
  const int count = bands * bands;
  for (const Axes& axes : all_axes()) {
    const Matrix expected = harmonics_about(axes, bands);
    for (const CoefficientOrder order : {CoefficientOrder::ascending, CoefficientOrder::alternating,
                                         CoefficientOrder::furse_malham, CoefficientOrder::descending}) {
      const std::vector<Term> in_order = terms_in(order, bands);
      std::vector<double> along(static_cast<std::size_t>(count));
      Reading reading;
      reading.are_alike.resize(along.size());
      for (int i = 0; i < count; ++i) {
        const std::size_t k = static_cast<std::size_t>(i);
        const double* y = expected[sh_index(in_order[k].l, in_order[k].m)];
        along[k] = dot(terms[i], y, count);
        const double squared = dot(terms[i], terms[i], terms.columns);
        double across = squared - along[k] * along[k];
        if (across < 1e-6 * squared) {  // without the cancellation
          across = 0;
          for (int j = 0; j < terms.columns; ++j) {
            const double left = terms[i][j] - (j < count ? along[k] * y[j] : 0);
            across += left * left;
          }
        }
        reading.are_alike[k] = squared > 0 && across <= tolerance * tolerance * squared;
      }
      const auto others = std::count(reading.are_alike.begin(), reading.are_alike.end(), false);
      if (static_cast<double>(others) / 2 >= best.cost) continue;  // it cannot be the best
      reading.exchanged = count_exchanged(terms, expected, in_order, reading.are_alike, tolerance);
      for (const Phase phase : {Phase::condon_shortley, Phase::none}) {
        for (const Normalisation normalisation : {Normalisation::orthonormal, Normalisation::n3d, Normalisation::sn3d,
                                                  Normalisation::polynomial, Normalisation::furse_malham}) {
          for (const Quantity quantity : {Quantity::radiance, Quantity::irradiance_over_pi, Quantity::irradiance}) {
            Convention& c = reading.convention;
            c = Convention{phase, order, normalisation, Meaning::expansion, axes, quantity};
            if (bands - 1 > greatest_degree(c)) continue;
            reading.factors.clear();
            bool is_possible = true;
            for (int i = 0; i < count; ++i) {
              const Term at = in_order[static_cast<std::size_t>(i)];
              const long double by_cosine = quantity_factor(quantity, at.l);
              if (!(by_cosine > 0 || by_cosine < 0)) is_possible = false;
              reading.factors.push_back(
                  along[static_cast<std::size_t>(i)] /
                  static_cast<double>(phase_sign(phase, at.m) * normalisation_factor(normalisation, at.l, at.m) *
                                      by_cosine));
            }
            if (!is_possible) continue;
            std::vector<bool> are_others = reading.are_alike;
            are_others.flip();
            int agreeing = 0;
            const double common = commonest(reading.factors, are_others, tolerance, agreeing);
            for (const double scale : {1.0, common}) {
              reading.scale = scale;
              reading.cost = cost_of(reading, tolerance);
              if (reading.cost < best.cost) best = reading;
            }
          }
        }
      }
    }
  }
  return best;
}

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
      const double unit =
          static_cast<double>(phase_sign(reading.convention.phase, m) *
                              (is_listed ? normalisation_factor(reading.convention.normalisation, l, m) : 1));
      parts.push_back({along / (unit * reading.scale), std::abs(along), {l, m}});
      greatest = (std::max)(greatest, std::abs(along));
    }
  }
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.size > b.size; });
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
    const double unit = static_cast<double>(phase_sign(reading.convention.phase, at.m) *
                                            normalisation_factor(reading.convention.normalisation, at.l, at.m) *
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

// Whether their terms are those of a convention, all of them.
inline bool has_basis_of(const Convention& convention, const Matrix& terms, int bands, double tolerance) {
  if (bands - 1 > greatest_degree(convention)) return false;
  const Matrix harmonics = harmonics_about(convention.axes, bands);
  const std::vector<Term> in_order = terms_in(convention.order, bands);
  for (int i = 0; i < bands * bands; ++i) {
    const Term at = in_order[static_cast<std::size_t>(i)];
    const double unit = static_cast<double>(phase_sign(convention.phase, at.m) *
                                            normalisation_factor(convention.normalisation, at.l, at.m));
    double squares = 0;
    for (int j = 0; j < terms.columns; ++j) {
      const double left = terms[i][j] - (j < harmonics.columns ? unit * harmonics[sh_index(at.l, at.m)][j] : 0);
      squares += left * left;
    }
    if (!(squares <= tolerance * tolerance * unit * unit)) return false;
  }
  return true;
}

}  // namespace detail::doctor

/// What basis these are the values of: `values` holds bands * bands numbers for each direction, one direction after the
/// other, in the order in which the code under test has them. Directions are unit vectors, best those of
/// diagnosis_directions(); at least bands^2 of them, and twice that to be told mixtures with other degrees.
///
/// A term counts as wrong from a relative difference of 1e-5 on, or of 20 times the noise. Named conventions with noise
/// of up to 1e-5 of their values are recognised, and so are single faults down to the tolerance. 2 bands leave it open
/// whether a sign is wrong or an axis points the other way. Throws std::invalid_argument where there are not enough
/// directions, or numbers (refuse.hpp). At 5 bands 10 ms, at 10 a quarter of a second.
inline Diagnosis diagnose(int bands, const std::vector<Direction>& directions, const std::vector<double>& values) {
  using namespace detail::doctor;
  if (bands < 1 || bands > 20) detail::refuse("the doctor knows 1 to 20 bands, not " + std::to_string(bands));
  const int count = bands * bands;
  if (values.size() != directions.size() * static_cast<std::size_t>(count)) {
    detail::refuse(std::to_string(values.size()) + " values for " + std::to_string(directions.size()) +
                   " directions of " + std::to_string(count) + " terms");
  }
  Diagnosis r;
  r.bands = bands;
  for (const Direction& d : directions) {
    const double length = std::hypot(d[0], d[1], d[2]);
    if (!(std::abs(length - 1) < 1e-3)) detail::refuse("a direction that is no unit vector");
  }
  Matrix table(static_cast<int>(directions.size()), count);
  std::copy(values.begin(), values.end(), table.values.begin());
  for (int i = 0; i < count; ++i) {
    int missing = 0;
    for (int k = 0; k < table.rows; ++k) {
      if (!std::isfinite(table[k][i])) ++missing, table[k][i] = 0;
    }
    if (missing > 0) {
      r.faults.push_back("term " + std::to_string(i) + " is no number at " + std::to_string(missing) + " of " +
                         std::to_string(table.rows) + " directions");
    }
  }
  Fit fitted{0, Matrix(0, 0), {}};
  for (int more = 3; more >= 0 && fitted.bands == 0; --more) {
    if ((bands + more) * (bands + more) <= table.rows) fitted = fit(directions, table, bands + more);
  }
  if (fitted.bands == 0) {
    detail::refuse(std::to_string(directions.size()) + " directions do not tell " + std::to_string(count) +
                   " harmonics apart");
  }
  std::vector<double> rest = fitted.rest;
  std::nth_element(rest.begin(), rest.begin() + count / 2, rest.end());
  r.noise = rest[static_cast<std::size_t>(count / 2)];
  r.tolerance = (std::max)(1e-5, 20 * r.noise);
  for (const NamedConvention& named : kConventions) {
    const bool has_bands = named.bands == 0 || bands <= named.bands;
    if (has_bands && has_basis_of(named.convention, fitted.terms, bands, r.tolerance)) {
      if (r.names.empty()) r.convention = named.convention;
      r.names.push_back(named.name);
    }
  }
  if (r.names.empty()) {
    const Reading reading = best_reading(fitted.terms, bands, r.tolerance);
    r.convention = reading.convention;
    r.scale = reading.scale;
    const Axes& axes = reading.convention.axes;
    if (is_mirrored(axes))
      r.faults.push_back("the axes are left-handed: a coordinate has the wrong sign, or two are exchanged");
    if (!(std::abs(reading.scale - 1) <= r.tolerance)) {
      r.faults.push_back("all terms are " + factor_text(reading.scale, r.tolerance) + " of what they should be");
    }
    const std::vector<std::string> wrong = faults_of(fitted, reading, bands, r.tolerance);
    r.faults.insert(r.faults.end(), wrong.begin(), wrong.end());
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
  const auto axis_name = [](Axis axis) {
    return std::string(detail::sign(axis) < 0 ? "-" : "") + "xyz"[detail::coordinate(axis)];
  };
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
  return text + ", with " + axis_name(c.axes.x) + ", " + axis_name(c.axes.y) + ", " + axis_name(c.axes.z) +
         " for the harmonics' x, y, z";
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
