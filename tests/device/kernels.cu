// Kernels of every room that a graphics processor can run, to be compiled and looked at: support/device.cmake.
#include <zonal/light/point.hpp>
#include <zonal/light/sphere.hpp>
#include <zonal/light/triangle.hpp>
#include <zonal/transform/reconstruct_adjoint.hpp>
#include <zonal/zonal.hpp>

struct Vec3 {
  float v[3];
  __host__ __device__ float operator[](int i) const { return v[i]; }
};

template <class C>
__device__ float total(const C& c) {
  float s = 0;
  for (int i = 0; i < c.size(); ++i) s += c.values[i];
  return s;
}

__global__ void scalar_room(const float* x, float* out) {
  const auto at = zonal::sin_cos(x[0]);
  out[0] =
      at.sine + at.cosine + zonal::exp(x[1]) + zonal::asin(x[2]) + zonal::acos(x[3]) + zonal::angle_from(x[4], x[5]);
}

__global__ void basis_room(const Vec3* d, float* out) {
  const auto g = zonal::evaluate_with_gradient<6>(d[0]);
  const auto h = zonal::evaluate_with_hessian<3>(d[0]);
  out[0] = total(zonal::evaluate<5>(d[0])) + total(zonal::evaluate_even<5>(d[0][0], d[0][2])) +
           total(zonal::evaluate_zonal<5>(d[0][2]));
  out[1] =
      total(g.gradient[0]) + total(g.gradient[1]) + total(g.gradient[2]) + total(h.hessian[3]) + total(h.hessian[5]);
}

__global__ void lobe_room(const float* x, float* out) {
  out[0] = total(zonal::project<5>(zonal::SphericalCap<float>::from_sphere(x[0], x[1])));
  out[1] = total(zonal::project<5>(zonal::SphericalCap<float>::from_angle(x[2])));
  out[2] = total(zonal::project_derivative<5>(zonal::SphericalCap<float>::from_sphere(x[0], x[1])));
  out[3] =
      total(zonal::project<5, float>(zonal::LambertLobe{})) + total(zonal::project<5>(zonal::PhongLobe<float>{x[3]}));
  out[4] = total(zonal::project<5>(zonal::SphericalGaussian<float>{x[4]}));
}

__global__ void transform_room(const zonal::Sh<5, float>* sh, const zonal::Zh<5, float>* zh, const Vec3* d,
                               float* out) {
  out[0] =
      total(zonal::orient(zh[0], d[0])) + total(zonal::convolve(sh[0], zh[0])) + total(zonal::convolve(zh[0], zh[1]));
  out[4] = total(zonal::product(sh[0], sh[1])) + total(zonal::product(sh[0], zh[0])) +
           zonal::triple_product(sh[0], sh[1], sh[2]);
  out[1] = zonal::dot(sh[0], sh[1]) + zonal::reconstruct(sh[0], d[0]) + zonal::reconstruct_zonal(zh[0], d[0][2]);
  out[2] = zonal::reconstruct_convolved(sh[0], zh[0], d[0]) +
           zonal::reconstruct_convolved(sh[0], zonal::LambertLobe{}, d[0]);
  out[3] = total(zonal::apply_window(sh[0], zonal::Window::hann)) +
           total(zonal::apply_window(zh[0], zonal::Window::sinc, 4.5));
  const auto adjoint = zonal::reconstruct_with_adjoint<zonal::ColourRule::splat>(sh[0], d[1], out[5]);
  out[5] = zonal::reconstruct_along(sh[0], d[1]) + total(adjoint.by_sh) + adjoint.by_direction[0];
}

__global__ void light_room(const zonal::SphereLight<float>* sphere, const zonal::SpotLight<float>* spot,
                           const glm::vec3* x, const zonal::TriangleSphereLight<float>* tri,
                           const zonal::DirectionalLight<float>* sun, float* out) {
  out[2] = total(zonal::project<5>(tri[0], x[0])) + total(zonal::project_with_gradient<5>(sun[0], x[0]).value);
  out[0] = total(zonal::project<5>(sphere[0], x[0])) + total(zonal::project<5>(spot[0], x[0]));
  const auto g = zonal::project_with_gradient<5>(sphere[0], x[0]);
  const auto s = zonal::project_with_gradient<5>(spot[0], x[0]);
  out[1] = total(g.value) + total(g.gradient[2]) + total(s.value) + total(s.gradient[2]);
}
