// Which kernels are timed for the tables, at which numbers of bands: entries of the registry
// (zonal/kernels/kernel_list.hpp) and their rivals. The others are timed at one number of bands: registry_bench.cpp.
#pragma once

#include <zonal/kernels/basis_kernels.hpp>
#include <zonal/kernels/lobe_kernels.hpp>
#include <zonal/kernels/transform_kernels.hpp>

#include "built_bands.hpp"
#include "rivals.hpp"

namespace zonal_bench {

/// An entry at N bands.
template <class E, int N>
struct Timed {
  using Entry = E;
  static constexpr const char* name = E::name;
  static constexpr int bands = N;
};

/// visit(Timed<Entry, N>{}) for each N.
template <class Entry, int... N, class Visit>
void at(Bands<N...>, Visit&& visit) {
  (visit(Timed<Entry, N>{}), ...);
}

/// The rows of HVL Fig. 6, and as far as the polynomials go.
using FigureBands = Built<Bands<1, 2, 3, 4, 5, 6, 7, 8, 9, 10>, Bands<5>>;
/// The bands of the gradient paper's Table 1.
using GradientBands = Built<Bands<3, 4, 5, 6, 8, 10>, Bands<5>>;

template <class Visit>
void for_evaluate_kernels(Visit&& visit) {
  at<kernels::Evaluate>(FigureBands{}, visit);
  at<kernels::Evaluate>(Built<Bands<16>, Bands<>>{}, visit);
  at<Polynomial>(FigureBands{}, visit);
}
template <class Visit>
void for_cap_kernels(Visit&& visit) {
  at<kernels::Cap>(FigureBands{}, visit);
  at<LegendreCap>(FigureBands{}, visit);
  at<ClosedFormCap>(FigureBands{}, visit);
}
template <class Visit>
void for_orient_kernels(Visit&& visit) {
  at<kernels::Orient>(FigureBands{}, visit);
}
template <class Visit>
void for_gradient_kernels(Visit&& visit) {
  at<kernels::EvaluateWithGradient>(GradientBands{}, visit);
  at<PolynomialGradient>(GradientBands{}, visit);
  at<SloanLikeAngular>(GradientBands{}, visit);
  at<SloanLike>(GradientBands{}, visit);
  at<DirectAngular>(GradientBands{}, visit);
  at<Direct>(GradientBands{}, visit);
}

}  // namespace zonal_bench
