// Incident radiance in six floats: its integral, RGB, and the integral of its luminance times the direction. They are
// sums, so they are filtered as coefficients are; and they can be read in two ways, which is why one type serves both:
//
// as_first_degree: luminance of degrees 0 and 1 and the colour of degree 0, what renderers call L1 luminance and CoCg.
// as_gaussian: one spherical Gaussian, about the vector, as sharp as the vector is long.
//
// [1] Y. Tokuyoshi, Virtual spherical Gaussian lights for real-time glossy indirect illumination, CGF 34(7), 2015.
// [2] A. Banerjee et al., Clustering on the unit hypersphere using von Mises-Fisher distributions, JMLR 6, 2005.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "../lobe/spherical_gaussian.hpp"
#include "../scalar/luminance.hpp"
#include "../transform/orient.hpp"
#include "incident.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// luminance.hpp's weights of RGB.
inline constexpr glm::vec3 kLuminance{kLuminanceWeights[0], kLuminanceWeights[1], kLuminanceWeights[2]};

struct RadianceMoments {
  glm::vec3 total{0};   // the integral of radiance, W/m^2, RGB
  glm::vec3 vector{0};  // the integral of luminance times direction

  /// The radiance of degrees 0 and 1. Each channel has luminance's shape.
  Sh<2, glm::vec3> as_first_degree() const {
    constexpr auto y0 = rounded<float>(detail::zonal_normalisation<0>),
                   y1 = rounded<float>(detail::zonal_normalisation<1>);
    const float luminance = glm::dot(total, kLuminance);
    const glm::vec3 colour = luminance > 0 ? total / luminance : glm::vec3(0);
    return {{total * y0, colour * (-y1 * vector.y), colour * (y1 * vector.z), colour * (-y1 * vector.x)}};
  }

  /// The Gaussian of the same moments, within 3 % of its sharpness [2, Eq. 4.4], on N bands. A vector as long as the
  /// luminance, all light from one direction, has the sharpness 1e4.
  template <int N>
  Sh<N, glm::vec3> as_gaussian() const {
    constexpr float sharpest = 1e4F;
    const float luminance = glm::dot(total, kLuminance), length = glm::length(vector);
    const float share = luminance > 0 ? minimum(length / luminance, 1.0F) : 0.0F;
    const float sharpness = minimum(share * (3 - share * share) / maximum(1 - share * share, 1e-6F), sharpest);
    Zh<N, float> lobe = project<N>(SphericalGaussian<float>{sharpness});
    constexpr auto y0 = rounded<float>(detail::zonal_normalisation<0>);
    lobe /= lobe[0] / y0;  // of integral 1
    return orient(lobe, length > 0 ? vector / length : glm::vec3(0, 0, 1)) * total;
  }
};

/// Sums them up lane by lane, as RadianceSum does coefficients.
class MomentSum {
 public:
  using T = LightSet::Lanes;

  MomentSum() {
    for (T& sum : sums_) sum = T(0);
  }
  ZONAL_INLINE void operator()(const Arrival<T>& arrival) {
    T luminance(0);
    for (int c = 0; c < 3; ++c) {
      sums_[c] = sums_[c] + arrival.irradiance[c];
      add_product(luminance, arrival.irradiance[c], T(kLuminance[c]));
    }
    for (int i = 0; i < 3; ++i) add_product(sums_[3 + i], luminance, arrival.direction[i]);
  }
  RadianceMoments moments() const {
    return {{sums_[0].sum(), sums_[1].sum(), sums_[2].sum()}, {sums_[3].sum(), sums_[4].sum(), sums_[5].sum()}};
  }

 private:
  T sums_[6];
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
