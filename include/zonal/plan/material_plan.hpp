// Which coefficients of a material a tolerance asks for.
//
// A receiver's light is sum_l A_l(a) sum_m F_l^m Y_l^m(w) times what the light sends, a light's sum_lm F'_l^m Y_l^m(w)
// (gather/hvl.hpp). A plan leaves some of the coefficients out: all from a degree on, all of m other than 0, those that
// are zero. With D_l the coefficients of degree l that are left out of a row of the table, and relative to the root
// mean square over all directions of the whole,
//
//   mean  = sqrt(sum_l A_l^2 |D_l|^2 / sum_l A_l^2 |F_l|^2)                     the root mean square over directions
//   worst = sum_l A_l |D_l| sqrt(2l+1) / sqrt(sum_l A_l^2 |F_l|^2)              at any direction, at most
//
// the first by Parseval's theorem, equal; the second by Cauchy-Schwarz on each degree and the addition theorem,
// sum_m Y_l^m^2 = (2l+1) / 4 pi, a bound. |.| is over orders and RGB together. A_l counts by its ratio to A_0, 1 for
// small lights. Where a negative sum is cut to zero, the difference does not grow.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "../basis/symmetry.hpp"
#include "../lobe/cap.hpp"
#include "../material/anisotropic_rows.hpp"
#include "../material/material_rows.hpp"
#include "../scalar/index.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What a tolerance bounds, relative to the root mean square over directions: the root mean square of the difference,
/// or the greatest difference.
enum class Measure { mean, worst };

/// An error by both.
struct PlanError {
  double mean = 0, worst = 0;
  double by(Measure measure) const { return measure == Measure::mean ? mean : worst; }
};

/// Lights by how large they look: of sin a from one to the other, in [0, 1]. Points, unless told otherwise.
struct CapClass {
  double least_sine = 0, greatest_sine = 0;
};

/// What a plan is asked for: `bands` of the table at most (the plan's errors are against these), the tolerance,
/// relative. Tolerance 0 leaves nothing out.
struct CoefficientRequest {
  int bands;
  double tolerance;
  Measure measure = Measure::mean;
  CapClass caps = {};
};

/// Coefficients that are kept: of `bands` bands those of the symmetry but for zeros; (l, m) at l (l + 1) + m in `kept`.
/// The error is that of leaving out the others, the greatest of the rows that were looked at.
struct CoefficientPlan {
  Symmetry symmetry = Symmetry::none;
  int bands = 1;
  std::vector<bool> kept = {true};
  PlanError error;

  bool keeps(int l, int m) const { return l < bands && kept[std::size_t(sh_index(l, m))]; }
  int kept_count() const { return int(std::count(kept.begin(), kept.end(), true)); }
};

namespace detail {

/// Rows of coefficients that a plan looks at, each (l, m) at coefficient_index(symmetry, l, m).
struct PlannedRows {
  Symmetry symmetry;
  int bands;
  std::vector<const glm::vec3*> rows;
};

/// The least and the greatest of |A_l| / A_0 over the class, squared, of each degree.
struct CapFactors {
  std::array<double, std::size_t(MaterialTable::max_bands)> least{}, greatest{};
};

/// A_l / A_0 is the mean of P_l over the cap. Against t = 1 - cos a its slope is at most half of that of P_l, which is
/// at most l (l+1) / 2: what can lie between two samples is added.
inline CapFactors cap_factors(const CapClass& caps) {
  constexpr int bands = MaterialTable::max_bands;
  const auto versine = [](double sine) { return sine * sine / (1 + std::sqrt(1 - sine * sine)); };
  const double low = versine((std::max)(caps.least_sine, 1e-9)), high = versine((std::max)(caps.greatest_sine, 1e-9));
  const int steps = low < high ? 64 : 1;
  CapFactors factors;
  factors.least.fill(1);
  for (int i = 0; i <= steps; ++i) {
    const double t = low + (high - low) * i / steps;
    const auto z = project<bands>(SphericalCap<double>{1 - t, std::sqrt(t * (2 - t))});
    for (int l = 0; l < bands; ++l) {
      const double between = (high - low) / steps / 2 * l * (l + 1) / 4;
      const double ratio = std::abs(z[l] / z[0]) / std::sqrt(2.0 * l + 1), least = (std::max)(ratio - between, 0.0);
      const double greatest = (std::min)(ratio + between, 1.0);
      factors.least[std::size_t(l)] = (std::min)(factors.least[std::size_t(l)], least * least);
      factors.greatest[std::size_t(l)] = (std::max)(factors.greatest[std::size_t(l)], greatest * greatest);
    }
  }
  return factors;
}

/// |.|^2 of a row's coefficients by degree: of all, and of those that each symmetry leaves out.
struct RowEnergies {
  using Degrees = std::array<double, std::size_t(MaterialTable::max_bands)>;
  Degrees all{};
  std::array<Degrees, 3> left_out{};  // by Symmetry
  double whole = 0;                   // with the least that lights of the class leave of a degree
};

/// visit(l, m, |coefficient|^2) of those that a row has.
template <class Visit>
void for_each_energy(Symmetry symmetry, int bands, const glm::vec3* row, const Visit& visit) {
  for (int l = 0; l < bands; ++l) {
    for (int m = has_order(symmetry, -1) ? -l : 0; m <= l; ++m) {
      const glm::dvec3 f(row[coefficient_index(symmetry, l, m)]);
      visit(l, m, glm::dot(f, f));
    }
  }
}

/// How errors add up: a sum over degrees, which is to stay below a limit.
class ErrorSum {
 public:
  ErrorSum(Measure measure, const CapFactors& caps) : measure_(measure), caps_(caps) {}

  /// What |D_l|^2 adds: itself, or the bound of its values.
  double of_degree(int l, double left_out) const {
    const double square = caps_.greatest[std::size_t(l)] * left_out;
    return measure_ == Measure::mean ? square : std::sqrt(square * (2 * l + 1));
  }
  /// The sum that an error of so much makes, of a row of that energy.
  double limit(double error, double whole) const {
    return error * (measure_ == Measure::mean ? error * whole : std::sqrt(whole));
  }
  /// The error that such a sum is; infinite where lights may be so large that nothing is sure to be left.
  double error(double sum, double whole) const {
    const double ratio = sum > 0 ? sum / limit(1, whole) : 0;
    return measure_ == Measure::mean ? std::sqrt(ratio) : ratio;
  }

 private:
  Measure measure_;
  const CapFactors& caps_;
};

/// The fewest bands of the symmetry that a row needs for its error to be within the tolerance; bands + 1 if it has not
/// enough.
inline int least_bands(const RowEnergies& row, Symmetry symmetry, int bands, const ErrorSum& errors, double tolerance) {
  const auto& left_out = row.left_out[std::size_t(symmetry)];
  double sum = 0;
  for (int l = 0; l < bands; ++l) sum += errors.of_degree(l, left_out[std::size_t(l)]);
  const double limit = errors.limit(tolerance, row.whole);
  int n = bands + 1;
  while (n > 1 && sum <= limit) {
    --n;
    const auto last = std::size_t(n - 1);  // the next to go
    sum += errors.of_degree(n - 1, row.all[last]) - errors.of_degree(n - 1, left_out[last]);
  }
  return n;
}

/// All that a plan asks the rows of a table.
class PlannedTable {
 public:
  PlannedTable(const PlannedRows& table, const CoefficientRequest& request)
      : table_(table), bands_(std::clamp(request.bands, 1, table.bands)), caps_(cap_factors(request.caps)) {
    rows_.reserve(table.rows.size());
    for (const glm::vec3* row : table.rows) {
      RowEnergies& energies = rows_.emplace_back();
      for_each_energy(table.symmetry, bands_, row, [&](int l, int m, double energy) {
        energies.all[std::size_t(l)] += energy;
        energies.whole += caps_.least[std::size_t(l)] * energy;
        for (const Symmetry symmetry : {Symmetry::zonal, Symmetry::mirror}) {
          if (!has_order(symmetry, m)) energies.left_out[std::size_t(symmetry)][std::size_t(l)] += energy;
        }
      });
    }
  }

  int bands() const { return bands_; }

  /// The fewest coefficients within the tolerance, of the symmetries allowed.
  CoefficientPlan fewest(std::initializer_list<Symmetry> allowed, Measure measure, double tolerance) const {
    CoefficientPlan plan{table_.symmetry, bands_, {}, {}};
    for (const Symmetry symmetry : allowed) {
      int n = 1;
      for (const RowEnergies& row : rows_) {
        n = (std::max)(n, least_bands(row, symmetry, bands_, ErrorSum(measure, caps_), tolerance));
      }
      if (n <= bands_ && coefficient_count(symmetry, n) < coefficient_count(plan.symmetry, plan.bands)) {
        plan.symmetry = symmetry;
        plan.bands = n;
      }
    }
    keep_all(plan);
    return plan;
  }

  /// Leaves out what is small by itself, in all rows, to the tolerance together.
  void leave_out_small(CoefficientPlan& plan, Measure measure, double tolerance) const {
    std::vector<double> greatest(plan.kept.size(), 0.0);  // share of a row's energy
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const double share = rows_[i].whole > 0 ? 1 / rows_[i].whole : 0;
      for_each_energy(table_.symmetry, plan.bands, table_.rows[i], [&](int l, int m, double energy) {
        double& of_row = greatest[std::size_t(sh_index(l, m))];
        of_row = (std::max)(of_row, share * energy);
      });
    }
    const ErrorSum errors(measure, caps_);
    const double each = errors.limit(tolerance, 1) / coefficient_count(plan.symmetry, plan.bands);
    for (int l = 0; l < plan.bands; ++l) {
      for (auto i = std::size_t(l * l); i < std::size_t((l + 1) * (l + 1)); ++i) {
        plan.kept[i] = plan.kept[i] && errors.of_degree(l, greatest[i]) > each;
      }
    }
  }

  /// The greatest error of the rows where lost(l, m, energy) of a coefficient's energy are lost.
  template <class Lost>
  PlanError error_by(const Lost& lost) const {
    PlanError error;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      RowEnergies::Degrees sums{};
      for_each_energy(table_.symmetry, bands_, table_.rows[i],
                      [&](int l, int m, double energy) { sums[std::size_t(l)] += lost(l, m, energy); });
      const auto by = [&](Measure measure) {
        const ErrorSum errors(measure, caps_);
        double sum = 0;
        for (int l = 0; l < bands_; ++l) sum += errors.of_degree(l, sums[std::size_t(l)]);
        return errors.error(sum, rows_[i].whole);
      };
      error.mean = (std::max)(error.mean, by(Measure::mean));
      error.worst = (std::max)(error.worst, by(Measure::worst));
    }
    return error;
  }
  /// With what the plan keeps.
  PlanError error_of(const CoefficientPlan& plan) const {
    return error_by([&](int l, int m, double energy) { return plan.keeps(l, m) ? 0 : energy; });
  }

 private:
  void keep_all(CoefficientPlan& plan) const {
    plan.kept.assign(std::size_t(plan.bands * plan.bands), false);
    for (int l = 0; l < plan.bands; ++l) {
      for (int m = -l; m <= l; ++m) {
        plan.kept[std::size_t(sh_index(l, m))] = has_order(plan.symmetry, m) && has_order(table_.symmetry, m);
      }
    }
  }

  const PlannedRows& table_;
  int bands_;
  CapFactors caps_;
  std::vector<RowEnergies> rows_;
};

/// The symmetries are those that kernels are there for.
inline CoefficientPlan plan_coefficients(const PlannedRows& rows, std::initializer_list<Symmetry> allowed,
                                         const CoefficientRequest& request) {
  const PlannedTable table(rows, request);
  if (!(request.tolerance > 0)) return table.fewest({}, request.measure, 0);
  constexpr double of_small = 0.1;  // part of the tolerance
  CoefficientPlan plan = table.fewest(allowed, request.measure, (1 - of_small) * request.tolerance);
  table.leave_out_small(plan, request.measure, of_small * request.tolerance);
  plan.error = table.error_of(plan);
  return plan;
}

/// The table's rows: all, or those that are read at the cosines of some outgoing directions.
inline PlannedRows rows_of(const MaterialTable& table, const std::vector<glm::vec3>& rows,
                           const std::vector<float>& cosines) {
  std::vector<bool> is_read(std::size_t(table.angles()), cosines.empty());
  for (const float cosine : cosines) {
    const auto below = std::size_t(index_below(row_position(cosine, float(table.angles())), table.angles() - 1));
    is_read[below] = true;
    is_read[(std::min)(below + 1, is_read.size() - 1)] = true;
  }
  PlannedRows result{Symmetry::mirror, table.bands(), {}};
  for (std::size_t i = 0; i < is_read.size(); ++i) {
    if (is_read[i]) result.rows.push_back(rows.data() + i * std::size_t(table.row_size()));
  }
  return result;
}

/// Rows without symmetry.
inline PlannedRows rows_of(const std::vector<Sh<AnisotropicTable::max_bands, glm::vec3>>& coefficients, int bands) {
  PlannedRows result{Symmetry::none, bands, {}};
  for (const auto& sh : coefficients) result.rows.push_back(sh.values);
  return result;
}

}  // namespace detail

/// What a receiver of the material needs of F: zonal where the coefficients of m = 0 are enough (Lambert's, and what is
/// nearly the same about the normal), else as the table has them. All rows of the table count.
inline CoefficientPlan plan_receiver(const MaterialTable& table, const CoefficientRequest& request) {
  return detail::plan_coefficients(detail::rows_of(table, table.with_cosine_rows(), {}),
                                   {Symmetry::mirror, Symmetry::zonal}, request);
}

/// What a light of the material needs of F', of even l + m alone; the request's caps do not matter. `cosines` to the
/// primary light, those of its normal, say which rows are read: all, if there are none.
inline CoefficientPlan plan_emission(const MaterialTable& table, CoefficientRequest request,
                                     const std::vector<float>& cosines = {}) {
  request.caps = {};
  return detail::plan_coefficients(detail::rows_of(table, table.without_cosine_rows(), cosines), {Symmetry::mirror},
                                   request);
}

/// The error, at most, of holding what the plan keeps of F as half floats (kept_table.hpp): of each coefficient 2^-11
/// of it, and 2^-25 of a channel for those below 2^-14. Infinite beyond the greatest half float. It adds to the plan's.
inline PlanError half_error(const MaterialTable& table, const CoefficientPlan& receiving, const CapClass& caps = {}) {
  const detail::PlannedRows rows = detail::rows_of(table, table.with_cosine_rows(), {});
  return detail::PlannedTable(rows, {table.bands(), 0, Measure::mean, caps}).error_by([&](int l, int m, double energy) {
    if (!receiving.keeps(l, m)) return 0.0;
    const double magnitude = std::sqrt(energy), step = 0x1p-11 * magnitude + 0x1p-25 * std::sqrt(3.0);
    return magnitude > 65504 ? std::numeric_limits<double>::infinity() : energy > 0 ? step * step : 0.0;
  });
}

/// The same of anisotropic materials, by the outgoing directions given, for their tables have many rows: unit vectors
/// in the surface's own frame, z in [0, 1]. One that turns out to be isotropic is planned as such: but its kernel wants
/// the frame of the tangent all the same, unless it is zonal.
inline CoefficientPlan plan_receiver(const AnisotropicTable& table, const std::vector<glm::vec3>& outgoing,
                                     const CoefficientRequest& request) {
  std::vector<Sh<AnisotropicTable::max_bands, glm::vec3>> rows;
  for (const glm::vec3& direction : outgoing) {
    rows.push_back(table.with_cosine<AnisotropicTable::max_bands>(direction));
  }
  return detail::plan_coefficients(detail::rows_of(rows, table.bands()),
                                   {Symmetry::none, Symmetry::mirror, Symmetry::zonal}, request);
}
inline CoefficientPlan plan_emission(const AnisotropicTable& table, const std::vector<glm::vec3>& outgoing,
                                     CoefficientRequest request) {
  request.caps = {};
  std::vector<Sh<AnisotropicTable::max_bands, glm::vec3>> rows;
  for (const glm::vec3& direction : outgoing) {
    rows.push_back(table.without_cosine<AnisotropicTable::max_bands>(direction));
  }
  return detail::plan_coefficients(detail::rows_of(rows, table.bands()), {Symmetry::none}, request);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
