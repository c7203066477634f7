// The greatest errors of this library's functions, in code: what is promised, how it is known, and the worst input
// found.
//
//   constexpr double e = zonal::accuracy_bound("evaluate", "float", 5);  // of sqrt((2l+1)/4pi)
//
// The tests check these numbers, and docs/accuracy.md is written from them. An input counts as exact: what its own
// rounding does to the result is not the function's error.
#pragma once

#include <stdexcept>
#include <string_view>

#include "scalar/target.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// How it is known that no error is greater.
enum class Ground {
  proved,       // by intervals over the whole range (tools/zonal-prove): of roundings, whatever is fused
  every_input,  // every number of the scalar in the range was tried
  searched,     // by hill climbing and random inputs, with a margin
};

/// The greatest error of a kernel of the registry (kernels/kernel_list.hpp), or of another function, in a scalar type,
/// over a range, at a number of bands (0: has none).
struct Accuracy {
  std::string_view room;
  std::string_view function;
  std::string_view scalar;
  int bands;
  std::string_view range;
  std::string_view unit;  // the errors are measured in this
  double bound;           // no error is greater
  Ground ground;
  double worst;                  // the greatest error found
  std::string_view worst_input;  // of up to four numbers, in hexadecimal; longer ones: tests/data/worst_inputs.csv
  std::string_view remark;       // why there is no proof, or the bound is more than 8 times the worst error found
  double common = 0;             // what random inputs of all scalars stay below; 0: not drawn
};

namespace accuracy {

inline constexpr std::string_view kAllDirections = "all unit vectors, to 4 ulp";
inline constexpr std::string_view kNormalisedDirections = "vectors normalised in the scalar, poles included";
inline constexpr std::string_view kAllCosines = "-1 to 1";
inline constexpr std::string_view kNormalResults = "results that are normal numbers";
inline constexpr std::string_view kAllCaps = "half angles from asin(1e-12) to pi - asin(1e-12)";
inline constexpr std::string_view kSmallCaps = "half angles from asin(1e-12) to pi/2";
inline constexpr std::string_view kAllExponents = "exponents 0 to 1024";
inline constexpr std::string_view kAllSharpness = "sharpness 0 to 2^20";
inline constexpr std::string_view kAnyLength = "directions to all sides, squares of their lengths normal numbers";
inline constexpr std::string_view kRendering = "such as a renderer has";
inline constexpr std::string_view kZeroToPi = "0 to pi";
inline constexpr std::string_view kAcute = "-pi/2 to pi/2";
inline constexpr std::string_view kWidths = "widths 1/2 to 1024";

inline constexpr std::string_view kOfTheDegree = "sqrt((2l+1)/4pi)";
inline constexpr std::string_view kSteepest = "the degree's steepest slope";
inline constexpr std::string_view kLargest = "largest coefficient";
inline constexpr std::string_view kUlpOfTerms = "ulp of the sum of its terms' greatest magnitudes";
inline constexpr std::string_view kUlpOfResult = "ulp of the result";
inline constexpr std::string_view kUlpOfPi = "ulp of pi";
inline constexpr std::string_view kUlpOfOne = "ulp of 1";
inline constexpr std::string_view kUlpOfLargest = "ulp of its largest output";
inline constexpr std::string_view kUlpOfTypical = "ulp of its largest output, or of their root mean square if larger";

inline constexpr std::string_view kNorm = "norm of the coefficients";
inline constexpr std::string_view kOfChannels = "sum of the channels";
inline constexpr std::string_view kOfResult = "the result";
inline constexpr std::string_view kLargestOf = "largest coefficient, or slope";
inline constexpr std::string_view kUnit = "1";

inline constexpr std::string_view kAnyScalar = "any";

/// The number of bands at which every kernel runs in every scalar: the rooms' own tests go further, with fewer scalars.
inline constexpr int run_bands = 4;

// Why there is no proof.
inline constexpr std::string_view kManyScalars = "for packets and dual numbers as well, whose roots and orders differ";
inline constexpr std::string_view kCancels = "what the search makes cancel; random inputs stay far below";
inline constexpr std::string_view kSingular = "grows without bound towards inputs that have no answer: random ones";
inline constexpr std::string_view kManyBands = "intervals grow too wide at so many bands";
inline constexpr std::string_view kBranches = "no kernel of the registry; random inputs, in float against double";
inline constexpr std::string_view kLoops = "loops of a number known at run time: no record";
inline constexpr std::string_view kManyNumbers = "takes more numbers than cells have sides";
inline constexpr std::string_view kManyNodes = "its record is too long";
inline constexpr std::string_view kTooMany = "too many numbers to try; the same steps as in float";
inline constexpr std::string_view kPackets = "each lane takes the steps of the scalar";

constexpr Accuracy proved(std::string_view room, std::string_view function, std::string_view scalar, int bands,
                          std::string_view range, std::string_view unit, double bound, double worst,
                          std::string_view worst_input, std::string_view remark = "") {
  return {room, function, scalar, bands, range, unit, bound, Ground::proved, worst, worst_input, remark};
}
constexpr Accuracy tried(std::string_view room, std::string_view function, std::string_view scalar, int bands,
                         std::string_view range, std::string_view unit, double bound, double worst,
                         std::string_view worst_input, std::string_view remark = "") {
  return {room, function, scalar, bands, range, unit, bound, Ground::every_input, worst, worst_input, remark};
}
constexpr Accuracy searched(std::string_view room, std::string_view function, std::string_view scalar, int bands,
                            std::string_view range, std::string_view unit, double bound, double worst,
                            std::string_view worst_input, std::string_view remark) {
  return {room, function, scalar, bands, range, unit, bound, Ground::searched, worst, worst_input, remark};
}
/// The promises of every kernel, against itself in long double: of random inputs in every scalar, and of all. Where
/// sums that are all the outputs may cancel, the unit is at least what such outputs commonly are.
constexpr Accuracy in_any_scalar(std::string_view room, std::string_view kernel, double common, double bound,
                                 double worst, std::string_view unit = kUlpOfLargest,
                                 std::string_view remark = kManyScalars) {
  return {room, kernel, kAnyScalar, run_bands, kRendering, unit, bound, Ground::searched, worst, "", remark, common};
}
constexpr Accuracy over_data(std::string_view room, std::string_view function, std::string_view scalar,
                             std::string_view range, std::string_view unit, double bound, double worst,
                             std::string_view remark) {
  return {room, function, scalar, 0, range, unit, bound, Ground::searched, worst, "", remark};
}
constexpr Accuracy of_many_bands(std::string_view function, std::string_view scalar, int bands, std::string_view range,
                                 std::string_view unit, double bound, double worst) {
  return {"many_bands", function, scalar, bands, range, unit, bound, Ground::searched, worst, "", kLoops};
}

/// Of the kernels of the registry, list by list.
inline constexpr Accuracy kKernels[] = {
    proved("basis", "evaluate", "float", 5, kAllDirections, kOfTheDegree, 1.2e-06, 4.814e-07,
           "-0x1.30cad2p-3 -0x1.cacd62p-4 -0x1.f70a22p-1"),
    proved("basis", "evaluate", "float", 10, kAllDirections, kOfTheDegree, 7.6e-06, 2.13e-06,
           "-0x1.11cf56p-5 0x1.894a46p-11 -0x1.ffb6bap-1"),
    searched("basis", "evaluate", "float", 21, kAllDirections, kOfTheDegree, 1.2e-05, 6.409e-06,
             "0x1.25c99ap-7 -0x1.29774ep-9 -0x1.fffa64p-1", kManyBands),
    searched("basis", "evaluate", "double", 21, kAllDirections, kOfTheDegree, 1e-13, 1.38e-14,
             "-0x1.459b84f9bf021p-12 -0x1.dfade902915a2p-13 -0x1.fffffd8128af5p-1", kManyBands),
    in_any_scalar("basis", "evaluate", 4, 4, 2.246),
    proved("basis", "evaluate_even", "float", 5, kAllDirections, kOfTheDegree, 1.3e-06, 4.784e-07,
           "0x1.cbfb46p-4 0x1.b667d4p-3 -0x1.f0d0bep-1"),
    proved("basis", "evaluate_even", "float", 10, kAllDirections, kOfTheDegree, 8.1e-06, 2.13e-06,
           "0x1.f9c9ecp-6 0x1.a49cp-7 0x1.ffb6bap-1"),
    searched("basis", "evaluate_even", "float", 21, kAllDirections, kOfTheDegree, 1.2e-05, 6.585e-06,
             "0x1.1bc07ep-6 0x1.6f272ep-5 -0x1.ff689ep-1", kManyBands),
    searched("basis", "evaluate_even", "double", 21, kAllDirections, kOfTheDegree, 1e-13, 1.383e-14,
             "-0x1.0350dd8c976fcp-11 -0x1.7f05c5eda7f4p-10 -0x1.ffffd81427245p-1", kManyBands),
    in_any_scalar("basis", "evaluate_even", 5, 5, 3.271),
    proved("basis", "evaluate_zonal", "float", 5, kAllCosines, kOfTheDegree, 1.2e-06, 4.814e-07, "0x1.f70a22p-1"),
    proved("basis", "evaluate_zonal", "float", 10, kAllCosines, kOfTheDegree, 7.6e-06, 2.13e-06, "0x1.ffb6bap-1"),
    proved("basis", "evaluate_zonal", "float", 21, kAllCosines, kOfTheDegree, 3.7e-05, 6.585e-06, "0x1.ff689ep-1"),
    proved("basis", "evaluate_zonal", "double", 21, kAllCosines, kOfTheDegree, 6.7e-14, 1.537e-14,
           "0x1.ffe5cf2d5597cp-1"),
    in_any_scalar("basis", "evaluate_zonal", 3, 3, 2.301),
    proved("basis", "evaluate_with_gradient", "float", 5, kAllDirections, kSteepest, 9.9e-07, 4.872e-07,
           "0x1.2eb76cp-7 -0x1.56e9f8p-4 0x1.fe2e3ep-1"),
    proved("basis", "evaluate_with_gradient", "float", 10, kAllDirections, kSteepest, 8.3e-06, 1.938e-06,
           "-0x1.fdabd2p-7 -0x1.e4dcfap-6 -0x1.ffb6bap-1"),
    searched("basis", "evaluate_with_gradient", "float", 21, kAllDirections, kSteepest, 1e-5, 6.172e-06,
             "0x1.86c7a6p-7 -0x1.1bc562p-11 0x1.fff6a8p-1", kManyNodes),
    searched("basis", "evaluate_with_gradient", "double", 21, kAllDirections, kSteepest, 1e-13, 1.378e-14,
             "0x1.cfcc0dd4f3c1ap-11 -0x1.c04f3fbebbd1ep-10 0x1.ffffc1cd95cbep-1", kManyNodes),
    in_any_scalar("basis", "evaluate_with_gradient", 5, 5, 3.84),
    proved("lobe", "cap", "float", 5, kAllCaps, kLargest, 4.6e-07, 2.787e-07, "0x1.925712p-1 0x1.3ca614p-1"),
    proved("lobe", "cap", "float", 10, kAllCaps, kLargest, 6.4e-07, 3.894e-07, "0x1.e3ee7ap-1 0x1.4e63fap-2"),
    searched("lobe", "cap", "float", 21, kAllCaps, kLargest, 6.4e-07, 4.209e-07, "0x1.f9e9fap-1 0x1.3ad5a2p-3",
             kManyBands),
    searched("lobe", "cap", "double", 21, kAllCaps, kLargest, 1.1e-15, 7.113e-16,
             "0x1.f9d559f4ad9cp-1 0x1.3ce62fa6e127dp-3", kManyBands),
    searched("lobe", "cap", "float", 51, kAllCaps, kLargest, 8e-7, 6.084e-07, "0x1.ff172ap-1 0x1.e813fep-5",
             kManyBands),
    searched("lobe", "cap", "double", 51, kAllCaps, kLargest, 2e-15, 1.04e-15,
             "0x1.fec816df378d3p-1 0x1.1a68604cf84c7p-4", kManyBands),
    in_any_scalar("lobe", "cap", 2, 2, 1.548),
    proved("lobe", "cap_up_to_hemisphere", "float", 5, kSmallCaps, kLargest, 4.4e-07, 2.9e-07,
           "0x1.ffdd5ap-1 0x1.78bae8p-6"),
    proved("lobe", "cap_up_to_hemisphere", "float", 10, kSmallCaps, kLargest, 6.7e-07, 4.729e-07,
           "0x1.fffbc8p-1 0x1.06c6bep-7"),
    searched("lobe", "cap_up_to_hemisphere", "float", 21, kSmallCaps, kLargest, 1.4e-06, 8.772e-07,
             "0x1.fffefap-1 0x1.020e98p-8", kManyBands),
    proved("lobe", "cap_up_to_hemisphere", "double", 21, kSmallCaps, kLargest, 1.3e-14, 1.735e-15,
           "0x1.fffffffbe4b34p-1 0x1.0363d81bed68ep-15"),
    in_any_scalar("lobe", "cap_up_to_hemisphere", 3, 3, 1.962),
    in_any_scalar("lobe", "sphere_cap", 5, 5, 3.365),
    proved("lobe", "cap_derivative", "float", 5, kAllCaps, kLargest, 7.4e-07, 4.773e-07, "0x1.67105cp-3 0x1.f811ccp-1"),
    proved("lobe", "cap_derivative", "float", 10, kAllCaps, kLargest, 2.3e-06, 1.221e-06,
           "-0x1.fca6p-10 0x1.ffffbep-1"),
    searched("lobe", "cap_derivative", "float", 21, kAllCaps, kLargest, 2.9e-06, 1.891e-06,
             "0x1.0702ep-6 0x1.ffef1ep-1", kManyBands),
    searched("lobe", "cap_derivative", "double", 21, kAllCaps, kLargest, 4.6e-15, 3.017e-15,
             "0x1.069cf8dc2689dp-1 0x1.b7854359d4372p-1", kManyBands),
    searched("lobe", "cap_derivative", "float", 51, kAllCaps, kLargest, 4.6e-06, 3.522e-06,
             "-0x1.3056b6p-1 0x1.9bbafcp-1", kManyBands),
    searched("lobe", "cap_derivative", "double", 51, kAllCaps, kLargest, 8e-15, 6.395e-15,
             "0x1.01b166a7ac055p-1 0x1.ba6c5a1731e6dp-1", kManyBands),
    in_any_scalar("lobe", "cap_derivative", 5, 5, 3.398),
    searched("lobe", "lambert", "float", 21, "", kLargest, 6e-8, 4.5e-08, "", "a constant"),
    searched("lobe", "lambert", "double", 21, "", kLargest, 2e-16, 5.475e-17, "", "a constant"),
    in_any_scalar("lobe", "lambert", 1, 1, 0.3775),
    proved("lobe", "phong", "float", 5, kAllExponents, kLargest, 3.9e-07, 2.816e-07, "0x1.d02f92p+4"),
    proved("lobe", "phong", "float", 10, kAllExponents, kLargest, 9.5e-07, 5.461e-07, "0x1.fd099ap+7"),
    proved("lobe", "phong", "float", 21, kAllExponents, kLargest, 1.9e-06, 8.78e-07, "0x1.fe5a2ap+9"),
    proved("lobe", "phong", "double", 21, kAllExponents, kLargest, 3.5e-15, 1.675e-15, "0x1.fe816f03a2f8bp+8"),
    in_any_scalar("lobe", "phong", 3, 3, 2.31),
    proved("lobe", "spherical_gaussian", "float", 5, kAllSharpness, kLargest, 6.7e-07, 4.159e-07, "0x1.972e0ap+3"),
    proved("lobe", "spherical_gaussian", "float", 10, kAllSharpness, kLargest, 1.2e-06, 6.246e-07, "0x1.91dc64p+5"),
    proved("lobe", "spherical_gaussian", "float", 21, kAllSharpness, kLargest, 2.1e-06, 6.518e-07, "0x1.e9a746p+7"),
    proved("lobe", "spherical_gaussian", "double", 21, kAllSharpness, kLargest, 3.7e-15, 1.359e-15,
           "0x1.c91f4100b0e8dp+7"),
    in_any_scalar("lobe", "spherical_gaussian", 4, 4.2, 3.282),
    in_any_scalar("transform", "orient", 3, 4, 3.167, kUlpOfLargest, kCancels),
    in_any_scalar("transform", "reconstruct", 4, 7.3, 5.753, kUlpOfTypical, kCancels),
    in_any_scalar("transform", "reconstruct_even", 4, 6.9, 5.429, kUlpOfTypical, kCancels),
    in_any_scalar("transform", "reconstruct_zonal", 6, 9.2, 7.282, kUlpOfTypical, kCancels),
    in_any_scalar("transform", "reconstruct_lambert", 3, 5.2, 4.135, kUlpOfTypical, kCancels),
    in_any_scalar("transform", "reconstruct_along", 8, 13, 10.11, kUlpOfTypical, kCancels),
    in_any_scalar("transform", "splat", 6, 15, 11.31, kUlpOfTypical, kCancels),
    searched("transform", "reconstruct_with_adjoint", "float", 3, kAnyLength, kUlpOfTerms, 4.5, 3.464, "",
             kManyNumbers),
    searched("transform", "reconstruct_with_adjoint", "float", 4, kAnyLength, kUlpOfTerms, 8, 6.075, "", kManyNumbers),
    searched("transform", "reconstruct_with_adjoint", "float", 10, kAnyLength, kUlpOfTerms, 60, 43.39, "",
             kManyNumbers),
    searched("transform", "reconstruct_with_adjoint", "double", 4, kAnyLength, kUlpOfTerms, 8, 6.304, "", kManyNumbers),
    searched("transform", "reconstruct_with_adjoint", "double", 10, kAnyLength, kUlpOfTerms, 60, 48.85, "",
             kManyNumbers),
    in_any_scalar("transform", "reconstruct_with_adjoint", 12, 58, 45.64, kUlpOfTypical, kCancels),
    in_any_scalar("transform", "splat_with_adjoint", 12, 50, 39.5, kUlpOfTypical, kCancels),
    in_any_scalar("transform", "reconstruct_convolved", 6, 18, 13.96, kUlpOfTypical, kCancels),
    in_any_scalar("transform", "convolve", 2, 2, 1.353),
    in_any_scalar("transform", "convolve_zonal", 2, 2, 1.345),
    in_any_scalar("transform", "dot", 3, 7.2, 5.699, kUlpOfTypical, kCancels),
    in_any_scalar("transform", "dot_even", 3, 5.7, 4.52, kUlpOfTypical, kCancels),
    in_any_scalar("transform", "dot_zonal", 2, 3.8, 2.95, kUlpOfTypical, kCancels),
    in_any_scalar("transform", "rotate_about_z", 3, 3, 1.858),
    in_any_scalar("transform", "prepare_rotation", 12, 12, 8.76, kUlpOfTypical),
    in_any_scalar("transform", "rotate", 6, 45, 35.16, kUlpOfLargest, kCancels),
    in_any_scalar("transform", "product", 3, 22, 17.26, kUlpOfLargest, kCancels),
    in_any_scalar("transform", "product_with_zonal", 3, 26, 20.31, kUlpOfLargest, kCancels),
    in_any_scalar("transform", "triple_product", 3, 8.3, 6.579, kUlpOfTypical, kCancels),
    tried("transform", "hann_window", "float", 10, kWidths, kLargest, 2.3e-07, 2.09621e-07, "0x1.f201fp+2"),
    in_any_scalar("transform", "hann_window", 3, 3, 1.59),
    tried("transform", "sinc_window", "float", 10, kWidths, kLargest, 2.4e-07, 2.17455e-07, "0x1.bbf75ep+0"),
    in_any_scalar("transform", "sinc_window", 3, 3, 1.664),
    in_any_scalar("transform", "apply_hann_window", 6, 14, 10.45, kUlpOfLargest, kCancels),
    in_any_scalar("transform", "apply_sinc_window", 6, 70, 55.27, kUlpOfLargest, kCancels),
    in_any_scalar("light", "project_sphere", 25, 25, 12.63),
    in_any_scalar("light", "project_sphere_with_gradient", 25, 25, 19.15),
    in_any_scalar("grid", "cell_position", 2, 2.3, 1.805),
    in_any_scalar("grid", "trilinear_weights", 3, 3, 2.354),
    in_any_scalar("grid", "hermite_weights", 4, 4.8, 3.811),
    in_any_scalar("grid", "visibility_place", 10, 10, 6.816, kUlpOfLargest, kSingular),
    in_any_scalar("grid", "seen_share", 60, 220, 174.2, kUlpOfLargest, kCancels),
    in_any_scalar("grid", "visible_trilinear_weights", 10, 10, 4.437),
    in_any_scalar("grid", "visible_hermite_weights", 10, 10, 5.384),
    in_any_scalar("grid", "clear_sums", 0, 0, 0),
    in_any_scalar("grid", "add_sphere", 4, 36, 28.26, kUlpOfLargest, kCancels),
    in_any_scalar("grid", "finish_sums", 2, 2, 1.504),
    in_any_scalar("material", "material_row", 2, 2.9, 2.238, kUlpOfTypical, kCancels),
    in_any_scalar("material", "material_between_rows", 3, 3, 2.125, kUlpOfTypical),
    in_any_scalar("gather", "tangent_towards", 20, 210, 160.1, kUlpOfLargest, kSingular),
    in_any_scalar("gather", "horizon_smoothstep", 2, 2, 1.592, kUlpOfTypical),
    in_any_scalar("gather", "horizon_exact", 2, 2.4, 1.869, kUlpOfTypical),
    in_any_scalar("gather", "hvl_radiance_diffuse", 20, 97, 77.01, kUlpOfTypical, kCancels),
    in_any_scalar("gather", "hvl_radiance", 25, 170, 131.8, kUlpOfTypical, kCancels),
    in_any_scalar("gather", "hvl_radiance_diffuse_exact", 20, 190, 144.1, kUlpOfTypical, kCancels),
    in_any_scalar("gather", "hvl_radiance_exact", 25, 200, 158.8, kUlpOfTypical, kCancels),
    in_any_scalar("gather", "hvl_radiance_diffuse_no_horizon", 20, 84, 66.84, kUlpOfTypical, kCancels),
    in_any_scalar("gather", "hvl_radiance_no_horizon", 25, 170, 132.7, kUlpOfTypical, kCancels),
    in_any_scalar("gather", "hvl_radiance_zonal_diffuse", 20, 180, 139.7, kUlpOfTypical, kCancels),
    in_any_scalar("gather", "hvl_radiance_zonal", 25, 200, 158.9, kUlpOfTypical, kCancels),
    in_any_scalar("gather", "hvl_radiance_zonal_diffuse_exact", 20, 130, 97.73, kUlpOfTypical, kCancels),
    in_any_scalar("gather", "hvl_radiance_zonal_exact", 25, 340, 265.4, kUlpOfTypical, kCancels),
    in_any_scalar("gather", "hvl_radiance_zonal_diffuse_no_horizon", 20, 140, 108.3, kUlpOfTypical, kCancels),
    in_any_scalar("gather", "hvl_radiance_zonal_no_horizon", 25, 440, 346.9, kUlpOfTypical, kCancels),
    in_any_scalar("screen", "is_same_surface", 0, 0, 0),
    in_any_scalar("convention", "reconstruct_seven_vectors", 3.7, 3.7, 2.895, kUlpOfTypical, kCancels),
    in_any_scalar("convention", "reconstruct_nine_polynomials", 4, 6.7, 5.313, kUlpOfTypical, kCancels),
    in_any_scalar("convention", "reconstruct_polynomials", 4, 4.6, 3.632, kUlpOfTypical, kCancels),
    in_any_scalar("probe", "linear_axis", 1.8, 1.8, 1.345),
    in_any_scalar("probe", "hallucinate_zh3", 4, 5.6, 4.424, kUlpOfTypical, kCancels),
    in_any_scalar("probe", "irradiance_zh3", 4, 5.6, 4.389, kUlpOfTypical, kCancels),
    in_any_scalar("probe", "irradiance_nonlinear", 7, 7.9, 6.177, kUlpOfTypical, kCancels),
    in_any_scalar("probe", "irradiance_six_floats", 12, 55, 43.29, kUlpOfTypical, kCancels),
    in_any_scalar("probe", "irradiance_six_floats_nonlinear", 7.7, 7.7, 5.992, kUlpOfTypical, kCancels),
    in_any_scalar("probe", "irradiance_bytes", 5, 6.8, 5.344, kUlpOfTypical, kCancels),
    in_any_scalar("scalar", "arcs", 3, 3, 1.588),
    in_any_scalar("light", "project_spot_with_gradient", 30, 30, 19.44),
    in_any_scalar("light", "project_triangle_sphere_with_gradient", 30, 30, 20.32),
    in_any_scalar("light", "project_polygon_with_gradient", 35, 35, 21.12),
};

/// Of the other functions.
inline constexpr Accuracy kFunctions[] = {
    tried("scalar", "asin", "float", 0, kAllCosines, kUlpOfResult, 2.1, 2.00042, "0x1.ae4b38p-1"),
    searched("scalar", "asin", "double", 0, kAllCosines, kUlpOfResult, 2.1, 1.929, "", kTooMany),
    searched("scalar", "asin", "Packet of float", 0, kAllCosines, kUlpOfResult, 2.1, 1.969, "", kPackets),
    searched("scalar", "asin", "Packet of double", 0, kAllCosines, kUlpOfResult, 2.1, 1.929, "", kPackets),
    tried("scalar", "acos", "float", 0, kAllCosines, kUlpOfPi, 1.5, 1.30638, "-0x1.bbcf6cp-1"),
    searched("scalar", "acos", "double", 0, kAllCosines, kUlpOfPi, 1.5, 1.236, "", kTooMany),
    searched("scalar", "acos", "Packet of float", 0, kAllCosines, kUlpOfPi, 1.5, 1.293, "", kPackets),
    searched("scalar", "acos", "Packet of double", 0, kAllCosines, kUlpOfPi, 1.5, 1.236, "", kPackets),
    tried("scalar", "exp", "float", 0, kNormalResults, kUlpOfResult, 6, 5.31344, "0x1.17fe18p+6"),
    searched("scalar", "exp", "double", 0, kNormalResults, kUlpOfResult, 6, 5.462, "", kTooMany),
    searched("scalar", "exp", "Packet of float", 0, kNormalResults, kUlpOfResult, 6, 4.417, "", kPackets),
    searched("scalar", "exp", "Packet of double", 0, kNormalResults, kUlpOfResult, 6, 5.462, "", kPackets),
    tried("scalar", "angle_from", "float", 0, kZeroToPi, kUlpOfPi, 1.5, 1.20079, "-0x1.590f46p-1"),
    searched("scalar", "angle_from", "double", 0, kZeroToPi, kUlpOfPi, 1.5, 1.1, "", kTooMany),
    searched("scalar", "angle_from", "Packet of float", 0, kZeroToPi, kUlpOfPi, 1.5, 1.233, "", kPackets),
    searched("scalar", "angle_from", "Packet of double", 0, kZeroToPi, kUlpOfPi, 1.5, 1.1, "", kPackets),
    tried("scalar", "sin_cos", "float", 0, kAcute, kUlpOfOne, 1.5, 1.38436, "0x1.8f07fep+0"),
    searched("scalar", "sin_cos", "double", 0, kAcute, kUlpOfOne, 1.5, 1.15, "", kTooMany),
    searched("lobe", "gaussian_integral", "float", 0, "sharpness 1e-3 to 1e5", kUlpOfResult, 170, 123.507, "",
             kBranches),
    searched("lobe", "gaussian_mean_length", "float", 0, "sharpness 1e-3 to 1e5", kUlpOfResult, 4.9, 3.70199, "",
             kBranches),
    searched("lobe", "gaussian_above_horizon", "float", 0, "sharpness 1e-3 to 1e5", kUlpOfOne, 5.9, 4.50406, "",
             kBranches),
    searched("lobe", "gaussian_product", "float", 0, "sharpness 1e-2 to 1e4", kUlpOfOne, 2.1, 1.54975, "", kBranches),
    searched("material", "reflectance_conductor", "float", 0, "cosines 1e-4 to 1", kUlpOfLargest, 2.9, 2.19975, "",
             kBranches),
    searched("material", "reflectance_dielectric", "float", 0, "cosines 1e-4 to 1", kUlpOfLargest, 6.4, 4.90207, "",
             kBranches),
    searched("material", "reflectance_schlick", "float", 0, "cosines 1e-4 to 1", kUlpOfLargest, 2.7, 2.06599, "",
             kBranches),
    searched("material", "evaluate_ggx", "float", 0, "cosines 1e-4 to 1, roughness 0.02 to 1", kUlpOfLargest, 9.3,
             7.05225, "", kBranches),
    searched("material", "evaluate_oren_nayar", "float", 0, "cosines 1e-4 to 1, roughness 0.02 to 1", kUlpOfLargest, 11,
             7.85788, "", kBranches),
    searched("basis", "evaluate_polynomial", "float", 0, "unit vectors, 5 bands", kUlpOfLargest, 7, 5.29035, "",
             kBranches),
    searched("basis", "evaluate_with_hessian", "float", 0, "unit vectors, 5 bands", kUlpOfLargest, 7.4, 5.61701, "",
             kBranches),
    searched("probe", "nonlinear_irradiance_over_pi", "float", 0, "unit normals, a mean of 1", kUlpOfOne, 19, 11.2649,
             "", kBranches),
};

/// Of the functions of many bands (zonal/many_bands/), against Boost.Multiprecision.
inline constexpr Accuracy kOfManyBands[] = {
    of_many_bands("evaluate", "float", 21, kNormalisedDirections, kOfTheDegree, 2e-6, 1.02e-06),
    of_many_bands("evaluate", "float", 190, kNormalisedDirections, kOfTheDegree, 8e-6, 2.31e-06),
    of_many_bands("evaluate", "float", 250, kNormalisedDirections, kOfTheDegree, 1e-5, 2.09e-06),
    of_many_bands("evaluate", "double", 21, kNormalisedDirections, kOfTheDegree, 3e-15, 1.63e-15),
    of_many_bands("evaluate", "double", 190, kNormalisedDirections, kOfTheDegree, 1.5e-14, 3.3e-15),
    of_many_bands("evaluate", "double", 1000, kNormalisedDirections, kOfTheDegree, 1e-13, 3.38e-14),
    of_many_bands("evaluate", "double", 2000, kNormalisedDirections, kOfTheDegree, 2e-13, 1.48e-14),
    of_many_bands("evaluate_with_gradient", "float", 21, kNormalisedDirections, kSteepest, 2e-6, 1.25e-06),
    of_many_bands("evaluate_with_gradient", "float", 190, kNormalisedDirections, kSteepest, 1e-5, 3.06e-06),
    of_many_bands("evaluate_with_gradient", "double", 190, kNormalisedDirections, kSteepest, 1.5e-14, 3.72e-15),
    of_many_bands("evaluate_with_gradient", "double", 1000, kNormalisedDirections, kSteepest, 1e-13, 1.15e-14),
    of_many_bands("evaluate_zonal", "float", 190, kAllCosines, kLargest, 1e-5, 6.92e-06),
    of_many_bands("evaluate_zonal", "double", 190, kAllCosines, kLargest, 4e-15, 1.74e-15),
    of_many_bands("evaluate_zonal", "double", 1000, kAllCosines, kLargest, 3e-14, 1.31e-14),
    of_many_bands("cap", "float", 190, kAllCaps, kLargest, 5e-7, 2.97e-07),
    of_many_bands("cap", "double", 190, kAllCaps, kLargest, 1.2e-15, 6.5e-16),
    of_many_bands("cap", "double", 1000, kAllCaps, kLargest, 4e-15, 1.58e-15),
    of_many_bands("cap_derivative", "float", 190, kAllCaps, kLargest, 8e-6, 4.09e-06),
    of_many_bands("cap_derivative", "double", 190, kAllCaps, kLargest, 1e-14, 5.71e-15),
    of_many_bands("cap_derivative", "double", 1000, kAllCaps, kLargest, 5e-14, 2.34e-14),
    of_many_bands("lambert", "float", 190, "", kLargest, 6e-8, 4.5e-08),
    of_many_bands("lambert", "double", 190, "", kLargest, 1.2e-16, 5.47e-17),
    of_many_bands("lambert", "double", 1000, "", kLargest, 1.2e-16, 5.47e-17),
    of_many_bands("phong", "float", 190, "exponents 0 to 1e6", kLargest, 5e-7, 2.81e-07),
    of_many_bands("phong", "double", 190, "exponents 0 to 1e6", kLargest, 1e-15, 5.55e-16),
    of_many_bands("phong", "double", 1000, "exponents 0 to 1e6", kLargest, 2e-15, 9.43e-16),
    of_many_bands("spherical_gaussian", "float", 190, "sharpness 1e-3 to 1e8", kLargest, 1e-6, 4.86e-07),
    of_many_bands("spherical_gaussian", "double", 190, "sharpness 1e-3 to 1e8", kLargest, 2e-15, 9.29e-16),
    of_many_bands("spherical_gaussian", "double", 1000, "sharpness 1e-3 to 1e8", kLargest, 5e-15, 2.15e-15),
    of_many_bands("rotate", "float", 190, kNormalisedDirections, kOfTheDegree, 3e-6, 1.48e-06),
    of_many_bands("rotate", "double", 190, kNormalisedDirections, kOfTheDegree, 5e-15, 2.71e-15),
    of_many_bands("rotate", "double", 1000, kNormalisedDirections, kOfTheDegree, 7e-14, 5.13e-15),
};

/// Of functions over data (sums over lights and texels, lookups, fits), whose errors come of the rows above and of
/// sums: measured by their rooms' tests, on the data that the range names.
inline constexpr Accuracy kOverData[] = {
    over_data("environment", "project", "float", "pictures of 1 to 70 texels, suns of 1e5 among them; 3 and 9 bands",
              "the channel's first coefficient", 1.5e-6, 3.35e-07, "against the plain sum in double"),
    over_data("environment", "reconstruct", "float", "pictures of 3 and 64 texels, 4 bands", kLargest, 3e-7, 7.48e-08,
              "against every texel in double"),
    over_data("environment", "EnvironmentSampler", "double", "drawn directions", "the direction's density", 1e-14, 0,
              "the density drawn with, against that of the direction"),
    over_data("field", "resample", "float", "a light at infinity, any probes", kNorm, 1e-5, 5.54e-06,
              "against the bucket sum in double; 1e-6 of it by ReferenceFieldSums"),
    over_data("field", "resample, gradients", "float", "the same, where the gradient is 0", "norm over the cell", 1e-5,
              4.01e-06, "against 0"),
    over_data("fit", "fit_samples", "double", "functions of 4 bands, 16 to 1000 samples",
              "norm times the condition of the samples", 3e-15, 2.3e-15,
              "against the function sampled; the worst of 600 draws by SSE2, AVX2 and AVX-512 each"),
    over_data("gather", "gather", "float", "up to 59 lights, 1 to 21 bands", kOfChannels, 3.5e-6, 4.54e-07,
              "against the definition in double; of sums of less than 1e-3 by 1e-3"),
    over_data("gather", "gather, a million lights", "float", "the sum of packets", kOfResult, 8.3e-6, 3.66e-07,
              "proved of the sum alone, whatever the number: 65 + log2(lanes) roundings, twice (scalar/long_sum.hpp)"),
    over_data("gather", "gather_vpl", "float", "up to 59 lights, clamped or not", kOfChannels, 2e-6, 2.4e-07,
              "against the definition in double"),
    over_data("gather", "gather_hvl_zonal", "float", "a Phong lobe about the normal, 21 bands", kOfChannels, 5e-4,
              1.52e-04, "against the integral over the cap: what 21 bands leave out"),
    over_data("grid", "add_lights", "float", "up to 17 lights, grids of up to 70 vertices; values and gradients",
              kLargestOf, 5e-6, 1.64e-06, "against the sum in double"),
    over_data("grid", "add_lights, polygons", "float", "the same of quadrilaterals, tolerance 1e-7", kLargestOf, 2e-5,
              7.41e-06, "against the sum in double"),
    over_data("grid", "interpolate", "float", "random grids, all methods", "the largest number that a vertex may have",
              1e-6, 2.72e-07, "against the polynomial in double"),
    over_data("grid", "interpolate_with_gradient", "float", "random grids, all methods",
              "the largest number that a vertex may have, over the least cell's unit", 6e-6, 1.6e-06,
              "against the polynomial's derivative"),
    over_data("grid", "AdaptiveGrid", "float", "with all vertices of the fine grid", kUnit, 2e-6, 0,
              "against the fine grid, of which it has the bits here"),
    over_data("many_lights", "gather", "float", "300 lights, all drawn", kOfResult, 1e-6, 1.19e-07,
              "against the gather of all lights"),
    over_data("plan", "plan_receiver", "double", "five materials, tolerances 0.02 to 0.3", "the mean error", 1e-15,
              1.39e-16, "the mean that it says, against a sum over directions; its worst error is a bound"),
    over_data("screen", "filter", "float", "noise from 0 to 1, all patterns, broken surfaces", kUlpOfOne, 4, 0.9,
              "against the sum in double"),
    over_data("screen", "incident_radiance", "float", "1 to 37 lights of any kind", "sum of the lights' irradiances",
              2e-6, 2.67e-07, "against the sum in double; most of it at a spot's edge"),
    over_data("screen", "reflected_radiance", "float", "a white table of 5 bands", kOfResult, 4e-7, 6.9e-08,
              "against Lambert in closed form; of other materials the table's tolerance is added"),
    over_data("material", "evaluate", "float", "every model; within 1e-4 of the mirror direction too", kOfResult, 4e-6,
              2.36e-06, "against long double; Phong's and GGX's steepest included"),
    over_data("material", "ggx_albedo", "double", "roughness 1", kUnit, 4e-4, 2.22e-4,
              "a quadrature, against the closed form"),
    over_data("material", "sheen_albedo", "double", "roughness 0.1 to 1", kUnit, 5e-4, 1.59e-4,
              "a fit, against the integral"),
    over_data("material", "project_zonal", "float", "plastic, 9 bands", "first coefficient", 3e-5, 4.07e-06,
              "against the mean over circles, 10^6 nodes"),
    over_data("transform", "full_product", "double", "random functions of 1 to 13 bands", "norm of the product", 5e-16,
              3.1e-16, "against a quadrature in long double"),
    over_data("transform", "rotation_derivative", "double", "a random function of 10 bands", kUnit, 5e-15, 7.38e-16,
              "[L_x, L_y] against L_z"),
    over_data("transform", "ShSampler", "float", "drawn directions, 9 bands", "ulp of the largest density", 40, 15.4,
              "the density drawn with, against the function in double"),
};

/// Whether every row says of its worst error what it has to: a ratio of more than 8 needs a remark, and so does every
/// bound that is not proved.
template <class Rows>
constexpr bool are_explained(const Rows& rows) {
  for (const Accuracy& row : rows) {
    if (row.worst > row.bound) return false;
    const bool is_tight = row.bound <= 8 * row.worst, is_known = row.ground != Ground::searched;
    if (row.remark.empty() && !(is_tight && is_known)) return false;
  }
  return true;
}
static_assert(are_explained(kKernels) && are_explained(kFunctions) && are_explained(kOfManyBands) &&
              are_explained(kOverData));

}  // namespace accuracy

/// The one row for this kernel or function, scalar and number of bands.
constexpr Accuracy accuracy_of(std::string_view function, std::string_view scalar, int bands) {
  const auto is_it = [&](const Accuracy& row) {
    return row.function == function && row.scalar == scalar && row.bands == bands;
  };
  for (const Accuracy& row : accuracy::kKernels) {
    if (is_it(row)) return row;
  }
  for (const Accuracy& row : accuracy::kFunctions) {
    if (is_it(row)) return row;
  }
  throw std::invalid_argument("no such row in the table of accuracy");
}
constexpr double accuracy_bound(std::string_view function, std::string_view scalar, int bands = 0) {
  return accuracy_of(function, scalar, bands).bound;
}
/// The same with the number of bands known at run time.
constexpr double many_bands_bound(std::string_view function, std::string_view scalar, int bands) {
  for (const Accuracy& row : accuracy::kOfManyBands) {
    if (row.function == function && row.scalar == scalar && row.bands == bands) return row.bound;
  }
  throw std::invalid_argument("no such row in the table of accuracy");
}

/// Of a function over data.
constexpr Accuracy accuracy_over_data(std::string_view room, std::string_view function) {
  for (const Accuracy& row : accuracy::kOverData) {
    if (row.room == room && row.function == function) return row;
  }
  throw std::invalid_argument("no such row in the table of accuracy");
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
