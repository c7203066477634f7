// What two programs that both store "spherical harmonics" may still mean by them: signs, order, scale, axes, and of
// what they are the coefficients.
//
// A system has a basis of its own, B_i(d) = n_lm s_m Y_l^m(h), where h is the direction in the harmonics' axes, s the
// sign of its phase and n its normalisation. The function is then
//
//   f(d) = offset + sum of c_i B_i(d) / scale    where the numbers are an expansion in that basis,
//   c_i = scale * integral of f B_i              where they are projections on it,
//
// which is the same for an orthonormal basis only.
#pragma once

#include <string>

#include "../basis/normalisation.hpp"
#include "../basis/sh.hpp"
#include "../lobe/lambert.hpp"
#include "axes.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Whether harmonics of odd order have the sign (-1)^m (Condon and Shortley's), as this library's have.
enum class Phase { condon_shortley, none };

/// In which order the coefficients of a degree come. Degrees always ascend.
enum class CoefficientOrder {
  ascending,     ///< -l ... l: index l(l+1)+m, as here; ambisonics' "ACN"
  alternating,   ///< 0, 1, -1, 2, -2, ...
  furse_malham,  ///< the same, but for degree 1: 1, -1, 0, that is X, Y, Z
  descending     ///< l ... -l
};

/// The scale of the basis, given by the mean of its squares or by its greatest values.
enum class Normalisation {
  orthonormal,   ///< the integral of the square is 1
  n3d,           ///< the mean of the square is 1: sqrt(4 pi) times orthonormal; e3nn's "component"
  sn3d,          ///< the squares of a degree add up to 1 (Schmidt): n3d / sqrt(2l+1); e3nn's "norm"
  furse_malham,  ///< the greatest value is 1, but W is 1/sqrt(2); to degree 3
  polynomial     ///< no factor: 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2, y(3x^2-y^2), xyz, y(5z^2-1), z(5z^2-3),
                 ///< x(5z^2-1), z(x^2-y^2), x(x^2-3y^2); to degree 3
};

enum class Meaning { expansion, projection };

/// Of what the numbers are the coefficients: of radiance L, of the irradiance E that it makes, or of E / pi, what a
/// white matt surface sends out.
enum class Quantity { radiance, irradiance, irradiance_over_pi };

/// Each member's default is this library's.
struct Convention {
  Phase phase = Phase::condon_shortley;
  CoefficientOrder order = CoefficientOrder::ascending;
  Normalisation normalisation = Normalisation::orthonormal;
  Meaning meaning = Meaning::expansion;
  Axes axes{};  ///< where the harmonics' own x, y and z (the polar axis) are, in the system's coordinates
  Quantity quantity = Quantity::radiance;
  double scale = 1;   ///< the stored numbers are so many times as large
  double offset = 0;  ///< the function is so much more than what the harmonics add up to
};

/// The greatest degree for which the convention says anything.
constexpr int greatest_degree(const Convention& convention) {
  const bool is_listed =
      convention.normalisation == Normalisation::furse_malham || convention.normalisation == Normalisation::polynomial;
  return is_listed ? 3 : 1 << 14;
}

/// Where the coefficient of degree l and order m is stored.
constexpr int stored_index(CoefficientOrder order, int l, int m) {
  const int first = l * l, alternating = m == 0 ? 0 : m > 0 ? 2 * m - 1 : -2 * m;
  switch (order) {
    case CoefficientOrder::alternating: return first + alternating;
    case CoefficientOrder::furse_malham: return first + (l == 1 ? (m == 0 ? 2 : alternating - 1) : alternating);
    case CoefficientOrder::descending: return first + l - m;
    case CoefficientOrder::ascending: break;
  }
  return sh_index(l, m);
}

namespace detail {

// Polynomials' factors squared, times 4 pi: Y = sqrt(that / 4 pi) times the polynomial.
constexpr long double polynomial_square(int l, int m) {
  const int order = m < 0 ? -m : m;
  switch (l) {
    case 0: return 1;
    case 1: return 3;
    case 2: return order == 0 ? 5.0L / 4 : m == 2 ? 15.0L / 4 : 15;
    default: return order == 0 ? 7.0L / 4 : order == 1 ? 21.0L / 8 : order == 3 ? 35.0L / 8 : m == 2 ? 105.0L / 4 : 105;
  }
}

// What sn3d is multiplied by, squared.
constexpr long double furse_malham_square(int l, int m) {
  const int order = m < 0 ? -m : m;
  switch (l) {
    case 0: return 1.0L / 2;
    case 1: return 1;
    case 2: return order == 0 ? 1 : 4.0L / 3;
    default: return order == 0 ? 1 : order == 1 ? 45.0L / 32 : order == 2 ? 9.0L / 5 : 8.0L / 5;
  }
}

// n of the header: the basis in units of the orthonormal one.
constexpr long double normalisation_factor(Normalisation normalisation, int l, int m) {
  switch (normalisation) {
    case Normalisation::n3d: return constexpr_sqrt(4 * kPi);
    case Normalisation::sn3d: return constexpr_sqrt(4 * kPi / (2 * l + 1));
    case Normalisation::furse_malham: return constexpr_sqrt(4 * kPi / (2 * l + 1) * furse_malham_square(l, m));
    case Normalisation::polynomial: return constexpr_sqrt(4 * kPi / polynomial_square(l, m));
    case Normalisation::orthonormal: break;
  }
  return 1;
}

constexpr long double phase_sign(Phase phase, int m) { return phase == Phase::none && m % 2 != 0 ? -1 : 1; }

// n s of the header: the convention's basis in units of this library's, in the harmonics' axes.
constexpr long double basis_factor(const Convention& convention, int l, int m) {
  return phase_sign(convention.phase, m) * normalisation_factor(convention.normalisation, l, m);
}

// By how much a degree of radiance is multiplied to be that of the quantity.
constexpr long double quantity_factor(Quantity quantity, int l) {
  return quantity == Quantity::radiance     ? 1
         : quantity == Quantity::irradiance ? 2 * kPi * cosine_integral(l)
                                            : 2 * cosine_integral(l);
}
// From one quantity to another. What the cosine has taken away is not there to be brought back: 0.
constexpr long double quantity_ratio(Quantity from, Quantity to, int l) {
  if (from == to) return 1;
  if (from == Quantity::radiance) return quantity_factor(to, l);
  if (to != Quantity::radiance) return quantity_factor(to, 0) / quantity_factor(from, 0);
  const long double factor = quantity_factor(from, l);
  return factor > 0 || factor < 0 ? 1 / factor : 0;
}

// By how much a coefficient of ours is multiplied to be stored, the quantity being the same.
constexpr long double stored_factor(const Convention& to, int l, int m) {
  const long double basis = basis_factor(to, l, m);
  return static_cast<long double>(to.scale) * (to.meaning == Meaning::projection ? basis : 1 / basis);
}

inline void check_convention(const Convention& convention, int bands) {
  check_axes(convention.axes.x, convention.axes.y, convention.axes.z);
  if (bands - 1 > greatest_degree(convention)) {
    refuse("a convention of degrees 0 to " + std::to_string(greatest_degree(convention)) + " for " +
           std::to_string(bands) + " bands");
  }
  if (!(convention.scale > 0 || convention.scale < 0)) refuse("a convention whose scale is 0 or no number");
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
