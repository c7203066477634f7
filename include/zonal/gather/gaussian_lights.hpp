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
// [1] Y. Tokuyoshi, Fast Indirect Illumination Using Two Virtual Spherical Gaussians, SIGGRAPH Asia 2015 Posters,
//     supplement.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "../lobe/gaussian_product.hpp"
#include "../material/brdf.hpp"
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

namespace detail {

/// The sharpness of the SG that stands for max(cos, 0) / pi [1, 1.1].
inline constexpr float diffuse_sharpness = 2.0F;

/// The sums of one component of a set of texels.
class GaussianSums {
 public:
  void add(const VirtualLight& texel, const glm::vec3& reflectance, const glm::vec3& axis, float sharpness) {
    const glm::dvec3 rgb(texel.flux * reflectance), at(texel.position);
    const double weight = (rgb.x + rgb.y + rgb.z) / 3.0;
    reflected_ += rgb;
    weight_ += weight;
    direction_ += weight * double(sharpness / (sharpness + 1.0F)) * glm::dvec3(axis);
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
    light.sharpness = float((std::min)(mean / (std::max)(1.0 - mean, 1e-9), 1e6));
    light.coefficient = glm::vec3(reflected_) / gaussian_integral(light.sharpness);
    return light;
  }

 private:
  glm::dvec3 reflected_{0.0}, direction_{0.0}, position_{0.0}, normal_{0.0};
  double weight_ = 0.0, square_ = 0.0;
};

/// Adds a lobe of a texel to the sums of its kinds; what it does not reflect weighs nothing.
inline void add_lobe(const VirtualLight& texel, const BrdfLobe& lobe, GaussianSums& diffuse, GaussianSums& glossy) {
  const float cosine = glm::dot(texel.normal, texel.to_primary);
  const glm::vec3 mirror = 2.0F * cosine * texel.normal - texel.to_primary;
  diffuse.add(texel, diffuse_albedo(lobe, cosine), texel.normal, diffuse_sharpness);
  glossy.add(texel, glossy_albedo(lobe, cosine), mirror, glossy_lobe(lobe, cosine).sharpness());
}

}  // namespace detail

/// A pair of lights, diffuse and glossy, for every block of `block` x `block` texels of the square map of `side` x
/// `side` lights, row by row; a single pair where block >= side; block is at least 1. Components that reflect nothing
/// are left out.
inline std::vector<GaussianLight> make_gaussian_lights(const VirtualLight* map, int side, int block) {
  std::vector<GaussianLight> lights;
  block = (std::max)(block, 1);
  for (int top = 0; top < side; top += block) {
    for (int left = 0; left < side; left += block) {
      detail::GaussianSums diffuse, glossy;
      for (int row = top; row < (std::min)(top + block, side); ++row) {
        for (int column = left; column < (std::min)(left + block, side); ++column) {
          const VirtualLight& texel = map[row * side + column];
          if (texel.brdf == nullptr || glm::dot(texel.normal, texel.to_primary) <= 0.0F) continue;
          for (const BrdfLobe& lobe : texel.brdf->lobes) detail::add_lobe(texel, lobe, diffuse, glossy);
        }
      }
      for (const detail::GaussianSums* sums : {&diffuse, &glossy}) {
        if (const std::optional<GaussianLight> light = sums->light()) lights.push_back(*light);
      }
    }
  }
  return lights;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
