// Anisotropic materials: their coefficients by both angles of the outgoing direction.
//
// As in projection.hpp, with two differences. The frame, z = normal and wo in the plane y = 0 with wo.x >= 0, is turned
// about the normal with wo: coefficients of nearby azimuths are then nearly equal, and those of an isotropic material
// equal. And f is not even in phi there: all N*N coefficients are kept.
//
// A whole table is 90 * 360 rows [1] of 4 to 16 ms each (GGX of roughness 0.1 to 0.5), and 340 MB at 21 bands: a row is
// projected when it is first asked for.
//
// [1] Mezieres et al., Harmonics Virtual Lights, CGF 41(6), 2022, section 4.2.
#pragma once

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "../basis/sh.hpp"
#include "../scalar/constexpr_math.hpp"
#include "../scalar/scalar.hpp"
#include "projection.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The coefficients, RGB, dimensionless, for one outgoing direction, in its frame; error as in BrdfProjection.
template <int N>
struct AnisotropicProjection {
  Sh<N, glm::dvec3> with_cosine{}, without_cosine{};
  double error = 0.0;
};

namespace detail {

inline glm::dvec3 turn_about_z(const glm::dvec3& v, double cosine, double sine) {
  return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z};
}

template <int N>
Sh<N, glm::dvec3> join(const EvenSh<N, glm::dvec3>& even, const EvenSh<N, glm::dvec3>& odd) {
  Sh<N, glm::dvec3> sh{};
  for (int l = 0; l < N; ++l) {
    for (int m = 0; m <= l; ++m) {
      sh(l, -m) = odd(l, m);
      sh(l, m) = even(l, m);  // last: of the two at m = 0
    }
  }
  return sh;
}

template <int N, class F>
AnisotropicProjection<N> project_anisotropic_once(const F& brdf, double cos_outgoing, double azimuth,
                                                  const QuadratureRule& rule) {
  const double cosine = std::cos(azimuth), sine = std::sin(azimuth);
  const auto part = [&](double sign) {
    return [&brdf, cosine, sine, sign](const glm::dvec3& wi, const glm::dvec3& wo) {
      const glm::dvec3 turned_wo = turn_about_z(wo, cosine, sine);
      return 0.5 * (brdf(turn_about_z(wi, cosine, sine), turned_wo) +
                    sign * brdf(turn_about_z({wi.x, -wi.y, wi.z}, cosine, sine), turned_wo));
    };
  };
  const auto even = project_brdf_once<N, Parity::even>(part(1.0), cos_outgoing, rule);
  const auto odd = project_brdf_once<N, Parity::odd>(part(-1.0), cos_outgoing, rule);
  return {join(even.with_cosine, odd.with_cosine), join(even.without_cosine, odd.without_cosine), 0.0};
}

}  // namespace detail

/// Projects brdf, a callable (glm::dvec3 wi, glm::dvec3 wo) -> glm::dvec3 in 1/sr, seen from cos_outgoing in [0, 1] and
/// the azimuth in radians. Refined as project_brdf is, and its error is the same measure.
template <int N, class F>
AnisotropicProjection<N> project_anisotropic_brdf(const F& brdf, double cos_outgoing, double azimuth, double tolerance,
                                                  const ProjectionQuadrature& quadrature) {
  auto coarse = detail::project_anisotropic_once<N>(brdf, cos_outgoing, azimuth, quadrature.rule(0));
  for (int level = 1;; ++level) {
    auto fine = detail::project_anisotropic_once<N>(brdf, cos_outgoing, azimuth, quadrature.rule(level));
    fine.error = (std::max)(detail::relative_movement(coarse.with_cosine, fine.with_cosine),
                            detail::relative_movement(coarse.without_cosine, fine.without_cosine));
    if (fine.error <= tolerance || level + 1 == ProjectionQuadrature::levels) return fine;
    coarse = fine;
  }
}

/// F (with cosine) and F' (without), RGB, of an anisotropic material, one row per degree of the outgoing angle, 0 to
/// 89, and per degree of its azimuth, 0 to 359; bilinear between rows, beyond 89 degrees constant. Bands: Bands, at
/// most 21.
///
/// Rows are projected when they are first asked for. Any number of threads may ask at once; two that need the same new
/// row may both project it, and one result is kept: brdf must bear being called from several threads.
template <int Bands>
class AnisotropicTable {
  static_assert(1 <= Bands && Bands <= 21, "bands out of range: 1 <= Bands <= 21");

 public:
  static constexpr int angles = 90, azimuths = 360;
  using BrdfFunction = std::function<glm::dvec3(glm::dvec3 wi, glm::dvec3 wo)>;
  using Coefficients = Sh<Bands, glm::vec3>;

  /// brdf in 1/sr, of unit vectors in the local frame; see project_brdf for the tolerance.
  explicit AnisotropicTable(BrdfFunction brdf, double tolerance = 1e-4)
      : brdf_(std::move(brdf)), tolerance_(tolerance), rows_(std::size_t{angles} * azimuths) {
    for (auto& row : rows_) row.store(nullptr, std::memory_order_relaxed);
  }
  ~AnisotropicTable() {
    for (auto& row : rows_) delete row.load(std::memory_order_relaxed);
  }
  AnisotropicTable(const AnisotropicTable&) = delete;
  AnisotropicTable& operator=(const AnisotropicTable&) = delete;

  /// F at the outgoing direction, a unit vector of z in [0, 1]; in the frame turned with it.
  Coefficients with_cosine(const glm::vec3& outgoing) const { return interpolate(&Row::with_cosine, outgoing); }
  /// F', the same.
  Coefficients without_cosine(const glm::vec3& outgoing) const { return interpolate(&Row::without_cosine, outgoing); }

  /// Rows projected so far, of 32400.
  int rows_built() const {
    return int(std::count_if(rows_.begin(), rows_.end(), [](const auto& row) { return row.load() != nullptr; }));
  }

 private:
  struct Row {
    Coefficients with_cosine, without_cosine;
  };

  Coefficients interpolate(Coefficients Row::*kind, const glm::vec3& outgoing) const {
    const double degree = double(kPi) / 180.0, x = double(outgoing.x), y = double(outgoing.y), z = double(outgoing.z);
    // What is no number is 0: rows are looked up by these.
    const double tilt = std::atan2(std::hypot(x, y), z) / degree, around = std::atan2(y, x) / degree + azimuths;
    const double angle = tilt > 0.0 ? (std::min)(tilt, double(angles - 1)) : 0.0;
    const double turn = around > 0.0 ? around : 0.0;
    const int low = (std::min)(int(angle), angles - 2), first = int(turn);
    const auto s = float(angle - low), t = float(turn - first);
    Coefficients sum{};
    const auto add = [&](int row, int azimuth, float weight) {
      if (!detail::is_equal(weight, 0.0F)) sum += this->row(row, azimuth % azimuths).*kind * weight;
    };
    add(low, first, (1.0F - s) * (1.0F - t));
    add(low, first + 1, (1.0F - s) * t);
    add(low + 1, first, s * (1.0F - t));
    add(low + 1, first + 1, s * t);
    return sum;
  }

  const Row& row(int angle, int azimuth) const {
    std::atomic<const Row*>& place = rows_[std::size_t(angle * azimuths + azimuth)];
    const Row* present = place.load(std::memory_order_acquire);
    if (present != nullptr) return *present;
    std::unique_ptr<const Row> mine = project_row(angle, azimuth);
    if (place.compare_exchange_strong(present, mine.get(), std::memory_order_acq_rel)) return *mine.release();
    return *present;  // another thread was faster
  }

  std::unique_ptr<const Row> project_row(int angle, int azimuth) const {
    const double degree = double(kPi) / 180.0;
    const auto exact =
        project_anisotropic_brdf<Bands>(brdf_, std::cos(degree * angle), degree * azimuth, tolerance_, quadrature_);
    auto row = std::make_unique<Row>();
    for (int i = 0; i < Coefficients::size(); ++i) {
      row->with_cosine[i] = glm::vec3(exact.with_cosine[i]);
      row->without_cosine[i] = glm::vec3(exact.without_cosine[i]);
    }
    return row;
  }

  BrdfFunction brdf_;
  double tolerance_;
  ProjectionQuadrature quadrature_;
  mutable std::vector<std::atomic<const Row*>> rows_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
