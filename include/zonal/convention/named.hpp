// The conventions of engines, file formats and libraries, by name. docs/rooms/convention.md says for each where it is
// defined, where its sources disagree, and what is assumed then.
#pragma once

#include <string_view>

#include "convention.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

struct NamedConvention {
  std::string_view name;  ///< in lower case, with underscores
  std::string_view what;  ///< whose numbers these are
  Convention convention;
  Frame frame;              ///< right, up and forward in its world; where it has none, this library's for pictures
  int bands;                ///< how many it stores at most; 0: any number
  std::string_view source;  ///< where it is defined
};

/// Frames that several systems share. Directions into a picture of this library are zonal_picture's: x ahead, z up.
namespace frames {
inline constexpr Frame opengl{Axis::x, Axis::y, Axis::minus_z};         ///< right-handed, y up, looking along -z
inline constexpr Frame gltf{Axis::minus_x, Axis::y, Axis::z};           ///< right-handed, y up, assets facing +z
inline constexpr Frame unity{Axis::x, Axis::y, Axis::z};                ///< left-handed, y up; Direct3D's too
inline constexpr Frame unreal{Axis::y, Axis::z, Axis::x};               ///< left-handed, z up, x ahead
inline constexpr Frame colmap{Axis::x, Axis::minus_y, Axis::z};         ///< right-handed, y down, z ahead
inline constexpr Frame zonal_picture{Axis::minus_y, Axis::z, Axis::x};  ///< right-handed, z up; ambisonics' too
}  // namespace frames

namespace detail {

inline constexpr Convention with_phase{};
inline constexpr Convention without_phase{Phase::none};

constexpr Convention plain_polynomials(Quantity quantity) {
  Convention c = without_phase;
  c.normalisation = Normalisation::polynomial;
  c.quantity = quantity;
  return c;
}
constexpr Convention of_quantity(Convention c, Quantity quantity) {
  c.quantity = quantity;
  return c;
}
// Colour is what the harmonics add up to, plus a half.
constexpr Convention splats() {
  Convention c;
  c.offset = 0.5;
  return c;
}
// The polar axis is y, and what is x elsewhere is z.
constexpr Convention e3nn(Normalisation normalisation) {
  Convention c = without_phase;
  c.axes = {Axis::z, Axis::x, Axis::y};
  c.normalisation = normalisation;
  return c;
}
// Channels are what a microphone of that shape records: projections.
constexpr Convention ambisonics(Normalisation normalisation, CoefficientOrder order) {
  Convention c = without_phase;
  c.normalisation = normalisation;
  c.order = order;
  c.meaning = Meaning::projection;
  return c;
}

}  // namespace detail

inline constexpr NamedConvention kConventions[] = {
    {"zonal", "this library", detail::with_phase, frames::zonal_picture, 0, "docs/conventions.md"},
    {"sloan", "Sloan's generated code", detail::with_phase, frames::unity, 0,
     "Sloan, Efficient Spherical Harmonic Evaluation, JCGT 2(2), 2013; Stupid Spherical Harmonics Tricks, appendix A2"},
    {"directxmath", "DirectXMath's XMSHEvalDirection", detail::with_phase, frames::unity, 6,
     "microsoft/DirectXMath, SHMath/DirectXSH.cpp"},
    {"google", "google/spherical-harmonics", detail::with_phase, frames::zonal_picture, 0,
     "google/spherical-harmonics, sh/spherical_harmonics.h"},
    {"unreal", "Unreal Engine's FSHVector3", detail::with_phase, frames::unreal, 3, "Engine: Math/SHMath.h"},
    {"babylon", "Babylon.js' SphericalHarmonics", detail::with_phase, frames::unity, 3,
     "BabylonJS/Babylon.js, Maths/sphericalPolynomial.ts"},
    {"filament", "Filament's coefficients (CubemapSH::computeSH, cmgen --sh)", detail::with_phase, frames::opengl, 0,
     "google/filament, libs/ibl/src/CubemapSH.cpp"},
    {"filament_shader", "Filament's IndirectLight and frameUniforms.iblSH (cmgen --sh-shader)",
     detail::plain_polynomials(Quantity::irradiance_over_pi), frames::opengl, 3,
     "google/filament, libs/ibl/src/CubemapSH.cpp, computeIrradianceSH3Bands"},
    {"unity", "Unity's SphericalHarmonicsL2", detail::plain_polynomials(Quantity::irradiance_over_pi), frames::unity, 3,
     "Unity's manual, light probes; its shaders' SHEvalLinearL0L1 and SHEvalLinearL2"},
    {"threejs", "three.js' SphericalHarmonics3 and LightProbe", detail::without_phase, frames::opengl, 3,
     "mrdoob/three.js, src/math/SphericalHarmonics3.js"},
    {"godot", "Godot's lightmap captures", detail::without_phase, frames::opengl, 3,
     "godotengine/godot, scene_forward_clustered.glsl and lm_compute.glsl"},
    {"gaussian_splatting", "3D Gaussian splatting's f_dc and f_rest", detail::splats(), frames::colmap, 4,
     "graphdeco-inria/gaussian-splatting, utils/sh_utils.py"},
    {"khr_gaussian_splatting", "glTF's KHR_gaussian_splatting", detail::splats(), frames::gltf, 4,
     "KhronosGroup/glTF, extensions/2.0/Khronos/KHR_gaussian_splatting"},
    {"spz", "SPZ, once its bytes are numbers", detail::splats(), frames::opengl, 5,
     "nianticlabs/spz, src/cc/load-spz.cc"},
    {"gltf_image_based", "glTF's EXT_lights_image_based", detail::of_quantity(detail::with_phase, Quantity::irradiance),
     frames::gltf, 3, "KhronosGroup/glTF, extensions/2.0/Vendor/EXT_lights_image_based"},
    {"webxr", "WebXR's XRLightEstimate, ARCore's ambient harmonics", detail::with_phase, frames::opengl, 3,
     "immersive-web/lighting-estimation, index.bs; ARCore's sample hello_ar"},
    {"materialx",
     "MaterialX' projectEnvironment",
     detail::without_phase,
     {Axis::minus_y, Axis::z, Axis::minus_x},
     3,
     "AcademySoftwareFoundation/MaterialX, MaterialXRender/Harmonics.cpp"},
    {"shforhlsl", "MJP's SHforHLSL", detail::without_phase, frames::unity, 3, "TheRealMJP/SHforHLSL, SH.hlsli"},
    {"sphericart", "sphericart", detail::without_phase, frames::zonal_picture, 0,
     "Bigi et al., Fast evaluation of spherical harmonics with sphericart, J. Chem. Phys. 159, 2023, Eq. 1"},
    {"e3nn", "e3nn, normalization 'integral'", detail::e3nn(Normalisation::orthonormal), frames::opengl, 0,
     "e3nn/e3nn, o3/_spherical_harmonics.py"},
    {"e3nn_component", "e3nn, normalization 'component'", detail::e3nn(Normalisation::n3d), frames::opengl, 0,
     "e3nn/e3nn, o3/_spherical_harmonics.py"},
    {"e3nn_norm", "e3nn, normalization 'norm'", detail::e3nn(Normalisation::sn3d), frames::opengl, 0,
     "e3nn/e3nn, o3/_spherical_harmonics.py"},
    {"ambix", "ambisonics, ACN and SN3D (AmbiX)", detail::ambisonics(Normalisation::sn3d, CoefficientOrder::ascending),
     frames::zonal_picture, 0, "Nachbar et al., AmbiX - A Suggested Ambisonics Format, Ambisonics Symposium 2011"},
    {"n3d", "ambisonics, ACN and N3D", detail::ambisonics(Normalisation::n3d, CoefficientOrder::ascending),
     frames::zonal_picture, 0, "Daniel, thesis, Paris 2000; MPEG-H 3D Audio"},
    {"fuma", "ambisonics, Furse and Malham",
     detail::ambisonics(Normalisation::furse_malham, CoefficientOrder::furse_malham), frames::zonal_picture, 4,
     "Malham, Higher order ambisonic systems, 2003; R. Furse's table of encoding functions"}};

/// By its name, or none.
constexpr const NamedConvention* find_convention(std::string_view name) {
  for (const NamedConvention& known : kConventions) {
    if (known.name == name) return &known;
  }
  return nullptr;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
