// The registry: every kernel of the library once. The shader writer writes it, the tests bound it, the benchmarks time
// it.
//
// An entry has a name, a line that says what it gives, and itself: run<N>(io) for any scalar (kernel_io.hpp). A new
// kernel is one entry in the header of its room and its name in a list here.
//
// The name of a function in a shader is zonal_<name>_<bands>: no two functions share a name, in any language, whether
// it overloads or not.
#pragma once

#include "basis_kernels.hpp"
#include "gather_kernels.hpp"
#include "grid_kernels.hpp"
#include "light_kernels.hpp"
#include "lobe_kernels.hpp"
#include "material_kernels.hpp"
#include "probe_kernels.hpp"
#include "scalar_kernels.hpp"
#include "screen_kernels.hpp"
#include "transform_kernels.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

using BasisKernels =
    KernelList<Evaluate, EvaluateEven, EvaluateZonal, EvaluateWithGradient,             // basis
               Cap, HemisphereCap, SphereCap, CapDerivative, Lambert, Phong, Gaussian,  // lobes
               Orient, RotateAboutZ, PrepareRotation, Rotate, Reconstruct, ReconstructEven, ReconstructZonal,
               ReconstructLambert,  // transforms
               ReconstructAlong, Splat, ReconstructWithAdjoint<ColourRule::plain>,
               ReconstructWithAdjoint<ColourRule::splat>, ReconstructConvolved, Convolve, ConvolveZonal, Dot, DotEven,
               DotZonal, Product, ProductZonal, TripleProduct, WindowFactors<Window::hann>, WindowFactors<Window::sinc>,
               ApplyWindow<Window::hann>, ApplyWindow<Window::sinc>>;
// They run kernels of the other lists, and cost next to nothing to compile.
using ColourKernels =
    KernelList<OfColours<Orient>, OfColours<RotateAboutZ>, OfColours<Rotate>, OfColours<Reconstruct>,
               OfColours<ReconstructEven>, OfColours<ReconstructZonal>, OfColours<ReconstructLambert>,
               OfColours<ReconstructConvolved>, OfColours<ReconstructAlong>, OfColours<Splat>, OfColours<Convolve>,
               OfColours<Convolve, Colours::all>, OfColours<ConvolveZonal>, OfColours<ConvolveZonal, Colours::all>,
               OfColours<Dot>, OfColours<Dot, Colours::all>, OfColours<DotEven>, OfColours<DotEven, Colours::all>,
               OfColours<DotZonal>, OfColours<DotZonal, Colours::all>, OfColours<Product>,
               OfColours<Product, Colours::all>, OfColours<ProductZonal>, OfColours<TripleProduct>,
               OfColours<ApplyWindow<Window::hann>>, OfColours<ApplyWindow<Window::sinc>>,
               OfColours<ReconstructNinePolynomials>, OfColours<ReconstructPolynomials>, OfColours<HallucinateZh3>,
               OfColours<IrradianceZh3>, OfColours<IrradianceNonlinear>>;
using SceneKernels =
    KernelList<Sphere, SphereWithGradient,                             // lights
               CellPosition, CellWeightsOf<Interpolation::trilinear>,  // grid
               CellWeightsOf<Interpolation::hermite>, VisibilityPlace, SeenShare,
               VisibleWeightsOf<Interpolation::trilinear>, VisibleWeightsOf<Interpolation::hermite>, ClearSums,
               AddSphere, FinishSums,             //
               MaterialRow, MaterialBetweenRows,  // materials
               TangentTowards, HorizonOf<Horizon::smoothstep>, HorizonOf<Horizon::exact>, HvlRadiance<1>,
               HvlRadiance<3>,  // virtual lights
               HvlRadiance<1, Horizon::exact>, HvlRadiance<3, Horizon::exact>, HvlRadiance<1, Horizon::none>,
               HvlRadiance<3, Horizon::none>, HvlRadiance<1, Horizon::smoothstep, Symmetry::zonal>,
               HvlRadiance<3, Horizon::smoothstep, Symmetry::zonal>, HvlRadiance<1, Horizon::exact, Symmetry::zonal>,
               HvlRadiance<3, Horizon::exact, Symmetry::zonal>, HvlRadiance<1, Horizon::none, Symmetry::zonal>,
               HvlRadiance<3, Horizon::none, Symmetry::zonal>,  //
               IsSameSurface,                                   // screen
               ReconstructSevenVectors, ReconstructNinePolynomials, ReconstructPolynomials, LinearAxis, HallucinateZh3,
               IrradianceZh3, IrradianceNonlinear, IrradianceSixFloats<SixFloatsShape::linear>,
               IrradianceSixFloats<SixFloatsShape::nonlinear>, IrradianceBytes>;  // light probes
// They are no shader functions: of fixed lights.
using UnwrittenKernels = KernelList<Arcs, SpotWithGradient, TriangleSphereWithGradient, PolygonWithGradient>;

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
