// The greatest errors that zonal promises, once: the tests read them from here, and so does docs/accuracy.md
// (accuracy_document.hpp).
#pragma once

#include <stdexcept>
#include <string_view>

/// One promise: the greatest error of a kernel of the registry (zonal/kernels/kernel_list.hpp), or of a function of
/// zonal/scalar/math.hpp, in a scalar type, over a range, at a number of bands (0: has none).
struct Accuracy {
  std::string_view kernel;
  std::string_view scalar;
  int bands;
  std::string_view range;
  std::string_view unit;  // the error is measured in this
  double bound;
};

inline constexpr std::string_view kAllDirections = "all unit vectors, poles included";
inline constexpr std::string_view kAllCosines = "-1 to 1";
inline constexpr std::string_view kNormalResults = "results that are normal numbers";
inline constexpr std::string_view kOfTheDegree = "sqrt((2l+1)/4pi)";
inline constexpr std::string_view kSteepest = "the degree's steepest slope";
inline constexpr std::string_view kAllCaps = "half angles from asin(1e-12) to pi - asin(1e-12)";
inline constexpr std::string_view kSmallCaps = "half angles from asin(1e-12) to pi/2";
inline constexpr std::string_view kLargest = "largest coefficient";
inline constexpr std::string_view kAnyLength = "directions to all sides, squares of their lengths normal numbers";
inline constexpr std::string_view kUlpOfTerms = "ulp of the sum of its terms' greatest magnitudes";
inline constexpr std::string_view kUlpOfResult = "ulp of the result";
inline constexpr std::string_view kUlpOfPi = "ulp of pi";

inline constexpr std::string_view kAnyScalar = "any";
inline constexpr std::string_view kRendering = "such as a renderer has";
inline constexpr std::string_view kUlpOfLargest = "ulp of its largest output";
inline constexpr std::string_view kUlpOfTypical = "ulp of its largest output, or of their root mean square if larger";

/// The number of bands at which every kernel runs in every scalar: the rooms' own tests go further, with fewer scalars.
inline constexpr int run_bands = 4;

/// The promise of every kernel, against itself in long double (kernels/every_scalar_test.cpp). Where sums that
/// are all the outputs may cancel, the unit is at least what such outputs commonly are.
constexpr Accuracy in_any_scalar(std::string_view kernel, double ulps, std::string_view unit = kUlpOfLargest) {
  return {kernel, kAnyScalar, run_bands, kRendering, unit, ulps};
}

inline constexpr Accuracy kKernelAccuracy[] = {
    {"evaluate", "float", 5, kAllDirections, kOfTheDegree, 1e-6},
    {"evaluate", "float", 10, kAllDirections, kOfTheDegree, 3e-6},
    {"evaluate", "float", 21, kAllDirections, kOfTheDegree, 1.2e-5},
    {"evaluate", "double", 21, kAllDirections, kOfTheDegree, 1e-13},
    {"evaluate_even", "float", 5, kAllDirections, kOfTheDegree, 1e-6},
    {"evaluate_even", "float", 10, kAllDirections, kOfTheDegree, 3e-6},
    {"evaluate_even", "float", 21, kAllDirections, kOfTheDegree, 1.2e-5},
    {"evaluate_even", "double", 21, kAllDirections, kOfTheDegree, 1e-13},
    {"evaluate_zonal", "float", 5, kAllCosines, kOfTheDegree, 1e-6},
    {"evaluate_zonal", "float", 10, kAllCosines, kOfTheDegree, 3e-6},
    {"evaluate_zonal", "float", 21, kAllCosines, kOfTheDegree, 1.2e-5},
    {"evaluate_zonal", "double", 21, kAllCosines, kOfTheDegree, 1e-13},
    {"evaluate_with_gradient", "float", 10, kAllDirections, kSteepest, 4e-6},
    {"evaluate_with_gradient", "float", 21, kAllDirections, kSteepest, 1e-5},
    {"evaluate_with_gradient", "double", 21, kAllDirections, kSteepest, 1e-13},
    {"cap", "float", 10, kAllCaps, kLargest, 4e-7},
    {"cap", "float", 21, kAllCaps, kLargest, 4e-7},
    {"cap", "float", 51, kAllCaps, kLargest, 8e-7},
    {"cap", "double", 51, kAllCaps, kLargest, 2e-15},
    {"cap_up_to_hemisphere", "float", 10, kSmallCaps, kLargest, 4e-7},
    {"cap_up_to_hemisphere", "float", 21, kSmallCaps, kLargest, 7e-7},
    {"cap_up_to_hemisphere", "double", 21, kSmallCaps, kLargest, 2e-15},
    {"cap_derivative", "float", 10, kAllCaps, kLargest, 1.2e-6},
    {"cap_derivative", "float", 21, kAllCaps, kLargest, 2e-6},
    {"cap_derivative", "float", 51, kAllCaps, kLargest, 4e-6},
    {"cap_derivative", "double", 51, kAllCaps, kLargest, 8e-15},
    {"lambert", "float", 21, "", kLargest, 6e-8},
    {"lambert", "double", 21, "", kLargest, 2e-16},
    {"phong", "float", 21, "exponents 1 to 1000", kLargest, 2.5e-7},
    {"phong", "double", 21, "exponents 1 to 1000", kLargest, 5e-16},
    {"spherical_gaussian", "float", 21, "sharpness 0 to 1e6", kLargest, 1e-6},
    {"spherical_gaussian", "double", 21, "sharpness 0 to 1e6", kLargest, 2e-15},
    {"reconstruct_with_adjoint", "float", 3, kAnyLength, kUlpOfTerms, 4.5},
    {"reconstruct_with_adjoint", "float", 4, kAnyLength, kUlpOfTerms, 8},
    {"reconstruct_with_adjoint", "float", 10, kAnyLength, kUlpOfTerms, 60},
    {"reconstruct_with_adjoint", "double", 4, kAnyLength, kUlpOfTerms, 8},
    {"reconstruct_with_adjoint", "double", 10, kAnyLength, kUlpOfTerms, 60},
    in_any_scalar("evaluate", 4),
    in_any_scalar("evaluate_even", 5),
    in_any_scalar("evaluate_zonal", 3),
    in_any_scalar("evaluate_with_gradient", 5),
    in_any_scalar("cap", 2),
    in_any_scalar("cap_up_to_hemisphere", 3),
    in_any_scalar("sphere_cap", 5),
    in_any_scalar("cap_derivative", 5),
    in_any_scalar("lambert", 1),
    in_any_scalar("phong", 3),
    in_any_scalar("spherical_gaussian", 4),
    in_any_scalar("orient", 3),
    in_any_scalar("reconstruct", 4, kUlpOfTypical),
    in_any_scalar("reconstruct_even", 4, kUlpOfTypical),
    in_any_scalar("reconstruct_zonal", 6, kUlpOfTypical),
    in_any_scalar("reconstruct_lambert", 3, kUlpOfTypical),
    in_any_scalar("reconstruct_along", 8, kUlpOfTypical),
    in_any_scalar("splat", 6, kUlpOfTypical),
    in_any_scalar("reconstruct_with_adjoint", 12, kUlpOfTypical),
    in_any_scalar("splat_with_adjoint", 12, kUlpOfTypical),
    in_any_scalar("reconstruct_convolved", 6, kUlpOfTypical),
    in_any_scalar("convolve", 2),
    in_any_scalar("convolve_zonal", 2),
    in_any_scalar("dot", 3, kUlpOfTypical),
    in_any_scalar("dot_even", 3, kUlpOfTypical),
    in_any_scalar("dot_zonal", 2, kUlpOfTypical),
    in_any_scalar("rotate_about_z", 3),
    // 10.5 is the worst seen of millions, in packets of float; 9 in built-in numbers.
    in_any_scalar("prepare_rotation", 12, kUlpOfTypical),
    in_any_scalar("rotate", 6),
    in_any_scalar("product", 3),
    in_any_scalar("product_with_zonal", 3),
    in_any_scalar("triple_product", 3, kUlpOfTypical),
    in_any_scalar("hann_window", 3),
    in_any_scalar("sinc_window", 3),
    in_any_scalar("apply_hann_window", 6),
    in_any_scalar("apply_sinc_window", 6),
    in_any_scalar("project_sphere", 25),
    in_any_scalar("project_sphere_with_gradient", 25),
    in_any_scalar("cell_position", 2),
    in_any_scalar("trilinear_weights", 3),
    in_any_scalar("hermite_weights", 4),
    in_any_scalar("visibility_place", 10),
    in_any_scalar("seen_share", 60),
    in_any_scalar("visible_trilinear_weights", 10),
    in_any_scalar("visible_hermite_weights", 10),
    in_any_scalar("clear_sums", 0),
    in_any_scalar("add_sphere", 4),
    in_any_scalar("finish_sums", 2),
    in_any_scalar("material_row", 2, kUlpOfTypical),
    in_any_scalar("material_between_rows", 3, kUlpOfTypical),
    in_any_scalar("tangent_towards", 20),
    in_any_scalar("horizon_smoothstep", 2, kUlpOfTypical),
    in_any_scalar("horizon_exact", 2, kUlpOfTypical),
    in_any_scalar("hvl_radiance_diffuse", 20, kUlpOfTypical),
    in_any_scalar("hvl_radiance", 25, kUlpOfTypical),
    in_any_scalar("hvl_radiance_diffuse_exact", 20, kUlpOfTypical),
    in_any_scalar("hvl_radiance_exact", 25, kUlpOfTypical),
    in_any_scalar("hvl_radiance_diffuse_no_horizon", 20, kUlpOfTypical),
    in_any_scalar("hvl_radiance_no_horizon", 25, kUlpOfTypical),
    in_any_scalar("hvl_radiance_zonal_diffuse", 20, kUlpOfTypical),
    in_any_scalar("hvl_radiance_zonal", 25, kUlpOfTypical),
    in_any_scalar("hvl_radiance_zonal_diffuse_exact", 20, kUlpOfTypical),
    in_any_scalar("hvl_radiance_zonal_exact", 25, kUlpOfTypical),
    in_any_scalar("hvl_radiance_zonal_diffuse_no_horizon", 20, kUlpOfTypical),
    in_any_scalar("hvl_radiance_zonal_no_horizon", 25, kUlpOfTypical),
    in_any_scalar("is_same_surface", 0),
    in_any_scalar("arcs", 3),
    in_any_scalar("project_spot_with_gradient", 30),
    in_any_scalar("project_triangle_sphere_with_gradient", 30),
    in_any_scalar("project_polygon_with_gradient", 35),
};

inline constexpr Accuracy kFunctionAccuracy[] = {
    // A packet's square root is Eigen's, which may be 2 ulp off.
    {"asin", "float", 0, kAllCosines, kUlpOfResult, 2},
    {"asin", "double", 0, kAllCosines, kUlpOfResult, 2},
    {"asin", "Packet of float", 0, kAllCosines, kUlpOfResult, 4},
    {"asin", "Packet of double", 0, kAllCosines, kUlpOfResult, 6},
    {"acos", "float", 0, kAllCosines, kUlpOfPi, 1.5},
    {"acos", "double", 0, kAllCosines, kUlpOfPi, 1.5},
    {"acos", "Packet of float", 0, kAllCosines, kUlpOfPi, 2},
    {"acos", "Packet of double", 0, kAllCosines, kUlpOfPi, 2},
    {"exp", "float", 0, kNormalResults, kUlpOfResult, 6},
    {"exp", "double", 0, kNormalResults, kUlpOfResult, 6},
    {"exp", "Packet of float", 0, kNormalResults, kUlpOfResult, 6},
    {"exp", "Packet of double", 0, kNormalResults, kUlpOfResult, 6},
    {"angle_from", "float", 0, "0 to pi", kUlpOfPi, 1.5},
    {"angle_from", "double", 0, "0 to pi", kUlpOfPi, 1.5},
    {"angle_from", "Packet of float", 0, "0 to pi", kUlpOfPi, 2},
    {"angle_from", "Packet of double", 0, "0 to pi", kUlpOfPi, 2},
};

/// Of the kernels of many bands (zonal/many_bands/), against Boost.Multiprecision.
inline constexpr Accuracy kManyBandsAccuracy[] = {
    {"evaluate", "float", 21, kAllDirections, kOfTheDegree, 2e-6},
    {"evaluate", "float", 190, kAllDirections, kOfTheDegree, 8e-6},
    {"evaluate", "float", 250, kAllDirections, kOfTheDegree, 1e-5},
    {"evaluate", "double", 21, kAllDirections, kOfTheDegree, 3e-15},
    {"evaluate", "double", 190, kAllDirections, kOfTheDegree, 1.5e-14},
    {"evaluate", "double", 1000, kAllDirections, kOfTheDegree, 1e-13},
    {"evaluate", "double", 2000, kAllDirections, kOfTheDegree, 2e-13},
    {"evaluate_with_gradient", "float", 21, kAllDirections, kSteepest, 2e-6},
    {"evaluate_with_gradient", "float", 190, kAllDirections, kSteepest, 1e-5},
    {"evaluate_with_gradient", "double", 190, kAllDirections, kSteepest, 1.5e-14},
    {"evaluate_with_gradient", "double", 1000, kAllDirections, kSteepest, 1e-13},
    {"evaluate_zonal", "float", 190, kAllCosines, kLargest, 1e-5},
    {"evaluate_zonal", "double", 190, kAllCosines, kLargest, 4e-15},
    {"evaluate_zonal", "double", 1000, kAllCosines, kLargest, 3e-14},
    {"cap", "float", 190, kAllCaps, kLargest, 5e-7},
    {"cap", "double", 190, kAllCaps, kLargest, 1.2e-15},
    {"cap", "double", 1000, kAllCaps, kLargest, 4e-15},
    {"cap_derivative", "float", 190, kAllCaps, kLargest, 8e-6},
    {"cap_derivative", "double", 190, kAllCaps, kLargest, 1e-14},
    {"cap_derivative", "double", 1000, kAllCaps, kLargest, 5e-14},
    {"lambert", "float", 190, "", kLargest, 6e-8},
    {"lambert", "double", 190, "", kLargest, 1.2e-16},
    {"lambert", "double", 1000, "", kLargest, 1.2e-16},
    {"phong", "float", 190, "exponents 0 to 1e6", kLargest, 5e-7},
    {"phong", "double", 190, "exponents 0 to 1e6", kLargest, 1e-15},
    {"phong", "double", 1000, "exponents 0 to 1e6", kLargest, 2e-15},
    {"spherical_gaussian", "float", 190, "sharpness 1e-3 to 1e8", kLargest, 1e-6},
    {"spherical_gaussian", "double", 190, "sharpness 1e-3 to 1e8", kLargest, 2e-15},
    {"spherical_gaussian", "double", 1000, "sharpness 1e-3 to 1e8", kLargest, 5e-15},
    {"rotate", "float", 190, kAllDirections, kOfTheDegree, 3e-6},
    {"rotate", "double", 190, kAllDirections, kOfTheDegree, 5e-15},
    {"rotate", "double", 1000, kAllDirections, kOfTheDegree, 7e-14},
};

/// The one row for this kernel or function, scalar and number of bands.
constexpr Accuracy accuracy_of(std::string_view kernel, std::string_view scalar, int bands) {
  const auto is_it = [&](const Accuracy& row) {
    return row.kernel == kernel && row.scalar == scalar && row.bands == bands;
  };
  for (const Accuracy& row : kKernelAccuracy) {
    if (is_it(row)) return row;
  }
  for (const Accuracy& row : kFunctionAccuracy) {
    if (is_it(row)) return row;
  }
  throw std::invalid_argument("no such row in the table of accuracy");
}
constexpr double accuracy_bound(std::string_view kernel, std::string_view scalar, int bands = 0) {
  return accuracy_of(kernel, scalar, bands).bound;
}

constexpr double many_bands_bound(std::string_view kernel, std::string_view scalar, int bands) {
  for (const Accuracy& row : kManyBandsAccuracy) {
    if (row.kernel == kernel && row.scalar == scalar && row.bands == bands) return row.bound;
  }
  throw std::invalid_argument("no such row in the table of accuracy");
}

/// "float" or "double", and the packets of either.
template <class T>
inline constexpr std::string_view scalar_name = sizeof(T) == sizeof(float) ? "float" : "double";
template <class T>
inline constexpr std::string_view packet_name = sizeof(T) == sizeof(float) ? "Packet of float" : "Packet of double";
