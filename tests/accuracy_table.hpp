// The greatest errors that zonal promises, once: the tests read them from here, and so does docs/accuracy.md.
#pragma once

#include <stdexcept>
#include <string_view>

/// One promise: the greatest error of a function in a scalar type, over a range, at a number of bands (0: has none).
struct Accuracy {
  std::string_view function;
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
inline constexpr std::string_view kUlpOfResult = "ulp of the result";
inline constexpr std::string_view kUlpOfPi = "ulp of pi";

inline constexpr Accuracy kAccuracyTable[] = {
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
    {"project(SphericalCap)", "float", 10, kAllCaps, kLargest, 4e-7},
    {"project(SphericalCap)", "float", 21, kAllCaps, kLargest, 4e-7},
    {"project(SphericalCap)", "float", 51, kAllCaps, kLargest, 8e-7},
    {"project(SphericalCap)", "double", 51, kAllCaps, kLargest, 2e-15},
    {"project_up_to_hemisphere(SphericalCap)", "float", 10, kSmallCaps, kLargest, 4e-7},
    {"project_up_to_hemisphere(SphericalCap)", "float", 21, kSmallCaps, kLargest, 7e-7},
    {"project_up_to_hemisphere(SphericalCap)", "double", 21, kSmallCaps, kLargest, 2e-15},
    {"project_derivative(SphericalCap)", "float", 10, kAllCaps, kLargest, 1.2e-6},
    {"project_derivative(SphericalCap)", "float", 21, kAllCaps, kLargest, 2e-6},
    {"project_derivative(SphericalCap)", "float", 51, kAllCaps, kLargest, 4e-6},
    {"project_derivative(SphericalCap)", "double", 51, kAllCaps, kLargest, 8e-15},
    {"project(LambertLobe)", "float", 21, "", kLargest, 6e-8},
    {"project(LambertLobe)", "double", 21, "", kLargest, 2e-16},
    {"project(PhongLobe)", "float", 21, "exponents 1 to 1000", kLargest, 2.5e-7},
    {"project(PhongLobe)", "double", 21, "exponents 1 to 1000", kLargest, 5e-16},
    {"project(SphericalGaussian)", "float", 21, "sharpness 0 to 1e6", kLargest, 1e-6},
    {"project(SphericalGaussian)", "double", 21, "sharpness 0 to 1e6", kLargest, 2e-15},
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

/// The bound of the one row for this function, scalar and number of bands.
constexpr double accuracy_bound(std::string_view function, std::string_view scalar, int bands = 0) {
  for (const Accuracy& row : kAccuracyTable) {
    if (row.function == function && row.scalar == scalar && row.bands == bands) return row.bound;
  }
  throw std::invalid_argument("no such row in the table of accuracy");
}

/// "float" or "double", and the packets of either.
template <class T>
inline constexpr std::string_view scalar_name = sizeof(T) == sizeof(float) ? "float" : "double";
template <class T>
inline constexpr std::string_view packet_name = sizeof(T) == sizeof(float) ? "Packet of float" : "Packet of double";
