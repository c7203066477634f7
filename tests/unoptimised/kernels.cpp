// A kernel of every kind, to be compiled without optimisation: support/unoptimised.cmake.
#include <array>

#include <zonal/transform/reconstruct_adjoint.hpp>
#include <zonal/zonal.hpp>

using Direction = std::array<float, 3>;

float all(const Direction& d, const zonal::Sh<4, float>& sh, const zonal::Zh<4, float>& zh) {
  const auto cap = zonal::SphericalCap<float>::from_sphere(d[0], d[1]);
  return zonal::evaluate<6>(d)[3] + zonal::evaluate_even<4>(d[0], d[2])[1] +
         zonal::evaluate_with_hessian<3>(d).hessian[2][1] + zonal::evaluate_with_hessian<8>(d).hessian[2][1] +
         zonal::evaluate_with_gradient<4>(d).gradient[0][1] + zonal::evaluate_with_gradient<5>(d).gradient[0][1] +
         zonal::project<4>(cap)[1] + zonal::project_derivative<4>(cap)[1] +
         zonal::project<4, float>(zonal::LambertLobe{})[1] + zonal::project<4>(zonal::PhongLobe<float>{d[0]})[1] +
         zonal::project<4>(zonal::SphericalGaussian<float>{d[0]})[1] + zonal::orient(zh, d)[1] +
         zonal::convolve(sh, zh)[1] + zonal::product(sh, sh)[1] + zonal::product(sh, zh)[1] +
         zonal::product(zonal::Sh<7, float>{}, zonal::Sh<7, float>{})[1] + zonal::reconstruct(sh, d) +
         zonal::reconstruct_with_adjoint(sh, d, d[0]).value + zonal::reconstruct_convolved(sh, zh, d) +
         zonal::apply_window(zh, zonal::Window::hann)[1] + zonal::exp(d[0]) + zonal::acos(d[0]) +
         zonal::sin_cos(d[0]).sine + zonal::angle_from(d[0], d[1]);
}
