// The registry's entries of the rooms `convention` and `probe` (kernel_list.hpp): what shaders make of a light probe,
// in the forms that engines store it in.
#pragma once

#include "../convention/shader_forms.hpp"
#include "../probe/nonlinear_l1.hpp"
#include "../probe/six_floats.hpp"
#include "../probe/storage.hpp"
#include "../probe/zh3.hpp"
#include "kernel_io.hpp"
#include "transform_kernels.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

namespace detail {
// Degrees 0 and 1.
template <class Io>
auto take_linear(Io& io, const char* name) {
  return take_sh<2>(io, name);
}
}  // namespace detail

struct ReconstructSevenVectors : Kernel {
  static constexpr const char* name = "reconstruct_seven_vectors";
  static constexpr const char* summary =
      "Irradiance over pi of one channel of Unity's or Unreal's seven vectors, at a normal.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto a = io.template numbers<4>("a", Domain::coefficient),
               b = io.template numbers<4>("b", Domain::coefficient);
    const T c = io.number("c", Domain::coefficient);
    const auto normal = io.vector("normal", Domain::unit_vector);
    const SevenVectors<T> vectors{{a[0], a[1], a[2], a[3]}, {b[0], b[1], b[2], b[3]}, c};
    io.output("value", 0)[0] = reconstruct(vectors, normal);
  }
};

struct ReconstructNinePolynomials : Kernel {
  static constexpr const char* name = "reconstruct_nine_polynomials";
  static constexpr const char* summary =
      "Irradiance over pi of Babylon.js' polynomial, x y z xx yy zz yz zx xy, at a normal.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto p = io.template coefficients<9>("polynomial");
    const auto normal = io.vector("normal", Domain::unit_vector);
    const NinePolynomials<T> nine{p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8]};
    io.output("value", 0)[0] = reconstruct(nine, normal);
  }
};

struct ReconstructPolynomials : Kernel {
  static constexpr const char* name = "reconstruct_polynomials";
  static constexpr const char* summary =
      "The value of plain polynomials, 1 y z x xy yz 3zz-1 xz xx-yy, as Filament's shaders and Unity's nine have it.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    const auto polynomials = detail::take_sh<3>(io, "polynomials");
    const auto normal = io.vector("normal", Domain::unit_vector);
    io.output("value", 0)[0] = reconstruct_polynomials(polynomials, normal);
  }
};

struct LinearAxis : Kernel {
  static constexpr const char* name = "linear_axis";
  static constexpr const char* summary =
      "Where the light of two bands comes from, a unit vector; z where from nowhere.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto linear = detail::take_linear(io, "radiance");
    const auto axis = io.output_triples("axis", 0);
    T v[3];
    linear_axis(linear, v);
    axis.set(0, v[0], v[1], v[2]);
  }
};

struct HallucinateZh3 : Kernel {
  static constexpr const char* name = "hallucinate_zh3";
  static constexpr const char* summary = "ZH3's quadratic coefficient, guessed from two bands and their axis.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto linear = detail::take_linear(io, "radiance");
    const auto a = io.vector("axis", Domain::unit_vector);
    const T axis[3] = {a[0], a[1], a[2]};
    io.output("zonal", 0)[0] = hallucinated_zonal(linear, axis);
  }
};

struct IrradianceZh3 : Kernel {
  static constexpr const char* name = "irradiance_zh3";
  static constexpr const char* summary =
      "Irradiance over pi of ZH3, radiance of two bands and one quadratic about an axis.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto linear = detail::take_linear(io, "radiance");
    const T zonal = io.coefficient("zonal");
    const auto a = io.vector("axis", Domain::unit_vector);
    const auto normal = io.vector("normal", Domain::unit_vector);
    const T axis[3] = {a[0], a[1], a[2]};
    io.output("value", 0)[0] = irradiance_zh3_over_pi(linear, zonal, axis, normal);
  }
};

struct IrradianceNonlinear : Kernel {
  static constexpr const char* name = "irradiance_nonlinear";
  static constexpr const char* summary = "Irradiance over pi of radiance of two bands, Geomerics' positive curve.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    const auto radiance = detail::take_linear(io, "radiance");
    const auto normal = io.vector("normal", Domain::unit_vector);
    io.output("value", 0)[0] = nonlinear_irradiance_over_pi(radiance, normal, Index<1>{});
  }
};

template <SixFloatsShape shape>
struct IrradianceSixFloats : Kernel {
  static constexpr const char* name =
      shape == SixFloatsShape::linear ? "irradiance_six_floats" : "irradiance_six_floats_nonlinear";
  static constexpr const char* summary = shape == SixFloatsShape::linear
                                             ? "Irradiance over pi, RGB, of luminance on two bands with Co and Cg."
                                             : "The same by Geomerics' positive curve.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto y = io.template numbers<4>("luminance", Domain::coefficient);
    const T co = io.number("co", Domain::coefficient), cg = io.number("cg", Domain::coefficient);
    const auto normal = io.vector("normal", Domain::unit_vector);
    const auto colour = io.output_triples("colour", 0);
    const SixFloats<T> six{{{y[0], y[1], y[2], y[3]}}, co, cg};
    irradiance_over_pi<shape>(six, normal, [&](auto i, const T& value) { colour[0][i] = value; });
  }
};

struct IrradianceBytes : Kernel {
  static constexpr const char* name = "irradiance_bytes";
  static constexpr const char* summary =
      "Irradiance over pi of radiance that stands as whole numbers -127 to 127 times one scale.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const T scale[1] = {io.number("scale", Domain::length)};
    const auto stored = detail::take_sh<N>(io, "stored");
    const auto normal = io.vector("normal", Domain::unit_vector);
    io.output("value", 0)[0] = reconstruct_scaled<ByteScale::channel>(scale, stored, normal, true);
  }
};

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
