// Virtual spherical Gaussian lights [1]: what many texels of a reflective shadow map reflect, as one Gaussian of
// position and one spherical Gaussian (SG) of direction, for the diffuse part and the glossy part apart. A material's
// share of either is what its model says, material/model.hpp.
//
// An SG's sharpness lambda stands for the mean direction lambda / (lambda + 1) xi; means are averaged,
// weighted by the light that a texel reflects, and turned back, lambda = |mean| / (1 - |mean|) [1, 2.1]. Positions give
// their mean and variance. [1] takes the variance for that along one axis of a plane, where it is the sum over both;
// here it is halved. And a texel is no point but a disc of its light's radius: else a pair for few texels is as spiky
// as a point light.
//
// The formulas of 2024 differ in this. An SG's mean direction has the length coth(lambda) - 1 / lambda, as [1]'s
// estimate has not, and the average is turned back to that. The glossy SG is [2]'s. And an SG sends a part of its light
// below the surface, where nothing receives it: a lobe counts for as much more as leaves its albedo above its own
// horizon. The diffuse SG is that whose part above has the mean direction of a diffuse lobe, 2/3 of the normal.
//
// [1] Y. Tokuyoshi, Fast Indirect Illumination Using Two Virtual Spherical Gaussians, SIGGRAPH Asia 2015 Posters,
//     supplement.
// [2] Y. Tokuyoshi, D. Ikeda, P. Kulkarni, T. Harada, Hierarchical Light Sampling with Accurate Spherical Gaussian
//     Lighting, SIGGRAPH Asia 2024; its supplement, and the author's sources of the VSGL of 2015 renewed.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "../lobe/gaussian_horizon.hpp"
#include "../lobe/gaussian_product.hpp"
#include "../material/brdf.hpp"
#include "receiver.hpp"
#include "virtual_light.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The light of many texels: radiant intensity coefficient exp(sharpness (cos - 1)) about the axis, spread about
/// `position` with `variance` along each axis of a plane.
struct GaussianLight {
  glm::vec3 position, normal;  // means; the normal serves visibility only
  float variance;              // m^2
  glm::vec3 axis;              // unit
  float sharpness;
  glm::vec3 coefficient;  // W/sr, RGB
};

/// By which formulas lights are made and gathered: [1]'s, or those that came after, [2].
enum class Vsgl { of_2015, of_2024 };

namespace detail {

/// The sharpness of the SG that stands for max(cos, 0) / pi: [1, 1.1]; and that of which 1 / (1 - e^-lambda) -
/// 1 / lambda, the mean cosine above its horizon, is 2/3.
template <Vsgl formulas>
inline constexpr float diffuse_sharpness = formulas == Vsgl::of_2015 ? 2.0F : 2.1491258F;

/// The length of an SG's mean direction, and the sharpness of that length.
template <Vsgl formulas>
double mean_length(double sharpness) {
  return formulas == Vsgl::of_2015 ? sharpness / (sharpness + 1.0) : gaussian_mean_length(sharpness);
}
template <Vsgl formulas>
double sharpness_of(double length) {
  const double inside = (std::min)(length, 1.0 - 1e-6);  // a sharpness of 1e6
  return formulas == Vsgl::of_2015 ? inside / (1.0 - inside) : gaussian_sharpness(inside);
}

/// The sums of one component of a set of texels.
template <Vsgl formulas>
class GaussianSums {
 public:
  void add(const VirtualLight& texel, const glm::vec3& reflectance, const GlossyGaussian& lobe) {
    const glm::dvec3 rgb(texel.flux * reflectance), at(texel.position);
    const double weight = (rgb.x + rgb.y + rgb.z) / 3.0;
    reflected_ += rgb;
    weight_ += weight;
    direction_ += weight * mean_length<formulas>(double(lobe.sharpness)) * glm::dvec3(lobe.axis);
    position_ += weight * at;
    square_ += weight * (glm::dot(at, at) + 0.5 * double(texel.radius) * double(texel.radius));
    normal_ += weight * glm::dvec3(texel.normal);
  }

  /// Nothing where nothing is reflected.
  std::optional<GaussianLight> light() const {
    if (!(weight_ > 0.0)) return std::nullopt;
    const glm::dvec3 position = position_ / weight_, direction = direction_ / weight_;
    const double trace = (std::max)(square_ / weight_ - glm::dot(position, position), 0.0);
    const double mean = glm::length(direction);
    GaussianLight light;
    light.position = glm::vec3(position);
    light.normal = glm::vec3(glm::normalize(normal_ + glm::dvec3(0.0, 0.0, 1e-30)));
    light.variance = float(0.5 * trace);
    light.axis = mean > 1e-9 ? glm::vec3(direction / mean) : light.normal;
    light.sharpness = float(sharpness_of<formulas>(mean));
    light.coefficient = glm::vec3(reflected_) / gaussian_integral(light.sharpness);
    return light;
  }

 private:
  glm::dvec3 reflected_{0.0}, direction_{0.0}, position_{0.0}, normal_{0.0};
  double weight_ = 0.0, square_ = 0.0;
};

/// The glossy part of a lobe that light meets at that cosine, in the frame of x towards the light: what it reflects,
/// and about where.
struct GlossyShare {
  glm::vec3 reflectance;
  GlossyGaussian gaussian;
};
template <Vsgl formulas>
GlossyShare glossy_share(const BrdfLobe& lobe, float cosine) {
  const glm::vec3 to_primary(std::sqrt((std::max)((1.0F - cosine) * (1.0F + cosine), 0.0F)), 0.0F, cosine);
  if constexpr (formulas == Vsgl::of_2015) {
    const glm::vec3 mirror(-to_primary.x, 0.0F, cosine);
    return {glossy_albedo(lobe, cosine), {mirror, glossy_lobe(lobe, cosine).sharpness()}};
  } else {
    const GlossyGaussian gaussian = glossy_gaussian(lobe, to_primary);
    const float above = gaussian_above_horizon(gaussian.axis.z, gaussian.sharpness).share;
    return {gaussian_reflection(lobe, gaussian.axis, 0.0F, to_primary) / above, gaussian};
  }
}

/// Adds a lobe of a texel to the sums of its kinds; what it does not reflect weighs nothing.
template <Vsgl formulas>
void add_lobe(const VirtualLight& texel, const BrdfLobe& lobe, GaussianSums<formulas>& diffuse,
              GaussianSums<formulas>& glossy) {
  const float cosine = glm::dot(texel.normal, texel.to_primary), sharpness = diffuse_sharpness<formulas>;
  const float above = formulas == Vsgl::of_2015 ? 1.0F : gaussian_above_horizon(1.0F, sharpness).share;
  diffuse.add(texel, diffuse_albedo(lobe, cosine) / above, {texel.normal, sharpness});
  GlossyShare share = glossy_share<formulas>(lobe, (std::min)(cosine, 1.0F));
  const glm::vec3 axis = share.gaussian.axis, tangent = tangent_towards(texel.normal, texel.to_primary);
  glossy.add(texel, share.reflectance, {axis.x * tangent + axis.z * texel.normal, share.gaussian.sharpness});
}

}  // namespace detail

/// A pair of lights, diffuse and glossy, for every block of `block` x `block` texels of the square map of `side` x
/// `side` lights, row by row; a single pair where block >= side; block is at least 1. Components that reflect nothing
/// are left out.
template <Vsgl formulas = Vsgl::of_2015>
std::vector<GaussianLight> make_gaussian_lights(const VirtualLight* map, int side, int block) {
  std::vector<GaussianLight> lights;
  block = (std::max)(block, 1);
  for (int top = 0; top < side; top += block) {
    for (int left = 0; left < side; left += block) {
      detail::GaussianSums<formulas> diffuse, glossy;
      for (int row = top; row < (std::min)(top + block, side); ++row) {
        for (int column = left; column < (std::min)(left + block, side); ++column) {
          const VirtualLight& texel = map[row * side + column];
          if (texel.brdf == nullptr || !(glm::dot(texel.normal, texel.to_primary) > 0.0F)) continue;
          for (const BrdfLobe& lobe : texel.brdf->lobes) detail::add_lobe(texel, lobe, diffuse, glossy);
        }
      }
      for (const detail::GaussianSums<formulas>* sums : {&diffuse, &glossy}) {
        if (const std::optional<GaussianLight> light = sums->light()) lights.push_back(*light);
      }
    }
  }
  return lights;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
