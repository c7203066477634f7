// The registry's entries of the room `lobe` (kernel_list.hpp).
#pragma once

#include "../lobe/cap.hpp"
#include "../lobe/lambert.hpp"
#include "../lobe/phong.hpp"
#include "../lobe/spherical_gaussian.hpp"
#include "kernel_io.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

struct Cap : Kernel {
  static constexpr const char* name = "cap";
  static constexpr const char* summary = "Zonal coefficients of a spherical cap, by cosine and sine of its half angle.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const SphericalCap<T> cap = io.cap("cap", Domain::angle);
    project<N>(cap, ZonalOutput<T>{io.output("z", N)});
  }
};

struct HemisphereCap : Kernel {
  static constexpr const char* name = "cap_up_to_hemisphere";
  static constexpr const char* summary = "The same up to the hemisphere, in fewer operations.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const SphericalCap<T> cap = io.cap("cap", Domain::half_angle);
    project_up_to_hemisphere<N>(cap, ZonalOutput<T>{io.output("z", N)});
  }
};

struct SphereCap : Kernel {
  static constexpr const char* name = "sphere_cap";
  static constexpr const char* summary = "Zonal coefficients of the cap that a sphere covers, seen from a distance.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const T distance = io.number("distance", Domain::length), radius = io.number("radius", Domain::radius);
    project_up_to_hemisphere<N>(SphericalCap<T>::from_sphere(distance, radius), ZonalOutput<T>{io.output("z", N)});
  }
};

struct CapDerivative : Kernel {
  static constexpr const char* name = "cap_derivative";
  static constexpr const char* summary = "Derivatives of the cap's coefficients by its half angle.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const SphericalCap<T> cap = io.cap("cap", Domain::angle);
    project_derivative<N>(cap, ZonalOutput<T>{io.output("z", N)});
  }
};

struct Lambert : Kernel {
  static constexpr const char* name = "lambert";
  static constexpr const char* summary = "Zonal coefficients of the clamped cosine over pi.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    project<N, T>(LambertLobe{}, ZonalOutput<T>{io.output("z", N)});
  }
};

struct Phong : Kernel {
  static constexpr const char* name = "phong";
  static constexpr const char* summary = "Zonal coefficients of the cosine power that integrates to 1.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const T exponent = io.number("exponent", Domain::exponent);
    project<N>(PhongLobe<T>{exponent}, ZonalOutput<T>{io.output("z", N)});
  }
};

struct Gaussian : Kernel {
  static constexpr const char* name = "spherical_gaussian";
  static constexpr const char* summary = "Zonal coefficients of exp(sharpness (cos theta - 1)).";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const T sharpness = io.number("sharpness", Domain::exponent);
    project<N>(SphericalGaussian<T>{sharpness}, ZonalOutput<T>{io.output("z", N)});
  }
};

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
