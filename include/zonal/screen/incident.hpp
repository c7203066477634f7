// Light on its way to a pixel: samples of lights of every kind, and the incident radiance that they make.
//
// A sample is a point that shines, or a direction that light comes from. What it adds to the coefficients is
// Y_l^m(w) E, with w the direction to it and E the irradiance on a surface that faces it: the estimator Y_l^m(w) L / p
// of [1], 3.2, with the density in E already.
//
//   E = power * profile / d^2      points, d at least `least_distance`
//   E = power * profile            directions
//   profile = t (1 - smooth) + t t (3 - 2 t) smooth,  t = (cos - edge) slope in [0, 1]
//
// cos is that between the sample's axis and the way to the pixel. Lights below the horizon of the surface itself, not
// of its bumps, give nothing: a ray to them would start into the surface.
//
// [1] Segovia and Wald, Screen space spherical harmonics filters for instant global illumination.
#pragma once

#include <cstddef>
#include <limits>

#include <glm/vec3.hpp>

#include "../basis/evaluate.hpp"
#include "../gather/packet_array.hpp"
#include "../scalar/fields.hpp"
#include "../scalar/function_ref.hpp"
#include "../scalar/long_sum.hpp"
#include "../scalar/packet.hpp"
#include "../scalar/vector3.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A sample of a light, one or a packet of them. One without power gives nothing.
template <class T>
struct LightSample {
  T position[3];  // of a point; else the unit direction towards the light
  T is_point;     // 1, or 0
  T axis[3];      // unit; of isotropic ones 0
  T edge, slope;  // where the profile leaves 0, and how fast it grows
  T smooth;       // 1, or 0 where it grows linearly
  T power[3];     // RGB: of points W/sr on the axis, of directions W/m^2

  template <class Visit>
  ZONAL_INLINE constexpr void members(const Visit& visit) {
    visit(position), visit(is_point), visit(axis), visit(edge), visit(slope), visit(smooth), visit(power);
  }
};

/// The same everywhere: radiant intensity, W/sr.
inline LightSample<float> point_sample(const glm::vec3& position, const glm::vec3& intensity) {
  return {{position.x, position.y, position.z}, 1, {0, 0, 0}, -2, 1, 0, {intensity.x, intensity.y, intensity.z}};
}
/// A point that shines into a cone about a unit axis: 0 beyond the outer angle, all within the inner, smooth between.
inline LightSample<float> spot_sample(const glm::vec3& position, const glm::vec3& axis, const glm::vec3& intensity,
                                      float cos_outer, float cos_inner) {
  const float slope = 1 / maximum(cos_inner - cos_outer, 1e-6F);
  return {{position.x, position.y, position.z},   1, {axis.x, axis.y, axis.z}, cos_outer, slope, 1,
          {intensity.x, intensity.y, intensity.z}};
}
/// A piece of a diffuse surface: an area light's, of radiance L and area A, has the intensity L A along its normal; one
/// that reflects the flux F with the albedo a has F a / pi: a bounce of indirect light.
inline LightSample<float> surface_sample(const glm::vec3& position, const glm::vec3& normal,
                                         const glm::vec3& intensity) {
  return {{position.x, position.y, position.z},   1, {normal.x, normal.y, normal.z}, 0, 1, 0,
          {intensity.x, intensity.y, intensity.z}};
}
/// From infinitely far: irradiance on a surface that faces it, W/m^2. Of an environment, radiance / (density * number
/// of samples). to_light: unit.
inline LightSample<float> directional_sample(const glm::vec3& to_light, const glm::vec3& irradiance) {
  return {{to_light.x, to_light.y, to_light.z}, 0, {0, 0, 0}, -2, 1, 0, {irradiance.x, irradiance.y, irradiance.z}};
}

/// Light that arrives at a pixel.
template <class T>
struct Arrival {
  T direction[3];   // unit, from the pixel to the light
  T distance;       // to a point; of directions 1
  T irradiance[3];  // on a surface that faces it, W/m^2, RGB
};

/// `normal`: unit, geometric. least_distance > 0 bounds what a point gives that is nearer: it counts as standing there.
template <class T>
ZONAL_INLINE constexpr Arrival<T> arrive(const LightSample<T>& light, const T (&position)[3], const T (&normal)[3],
                                         const T& least_distance) {
  T to_light[3];
  for (int i = 0; i < 3; ++i) to_light[i] = light.position[i] - light.is_point * position[i];
  Arrival<T> arrival;
  arrival.distance = sqrt(maximum(detail::dot3(to_light, to_light), T(1e-30L)));
  const T inverse = T(1) / arrival.distance;
  for (int i = 0; i < 3; ++i) arrival.direction[i] = to_light[i] * inverse;

  const T t = clamp((-detail::dot3(light.axis, arrival.direction) - light.edge) * light.slope, T(0), T(1));
  const T profile = t + light.smooth * (t * t * (T(3) - (t + t)) - t);
  const T bounded = maximum(arrival.distance, light.is_point * least_distance);
  const T above = select(T(0) < detail::dot3(arrival.direction, normal), T(1), T(0));
  const T falloff = above * profile / (bounded * bounded);
  for (int i = 0; i < 3; ++i) arrival.irradiance[i] = light.power[i] * falloff;
  return arrival;
}

/// Is the way free, from the pixel in this unit direction, for this distance; of directions it is infinite. Asked for
/// each sample that would contribute; an empty one lets all pass. It refers to a callable that outlives the call.
using LightVisibility = FunctionRef<bool(const glm::vec3& direction, float distance)>;

/// A set of samples, as structure of arrays.
using LightSet = PacketArray<LightSample>;

/// body(arrival), a packet at a time, with what does not arrive black.
template <class Body>
ZONAL_INLINE inline void for_each_arrival(const LightSet& lights, const glm::vec3& position,
                                          const glm::vec3& geometric_normal, float least_distance,
                                          const LightVisibility& visible, const Body& body) {
  using T = LightSet::Lanes;
  const T x[3] = {T(position.x), T(position.y), T(position.z)};
  const T n[3] = {T(geometric_normal.x), T(geometric_normal.y), T(geometric_normal.z)};
  for (int i = 0; i < lights.packet_count(); ++i) {
    const LightSample<T> light = lights.packet(i);
    Arrival<T> arrival = arrive(light, x, n, T(least_distance));
    if (visible) {
      for (int lane = 0; lane < T::width; ++lane) {
        const auto& e = arrival.irradiance;
        if (!(e[0][lane] > 0 || e[1][lane] > 0 || e[2][lane] > 0)) continue;
        const glm::vec3 direction(arrival.direction[0][lane], arrival.direction[1][lane], arrival.direction[2][lane]);
        const bool is_point = light.is_point[lane] > 0;
        if (visible(direction, is_point ? arrival.distance[lane] : std::numeric_limits<float>::infinity())) continue;
        for (T& channel : arrival.irradiance) channel.set(lane, 0);
      }
    }
    body(arrival);
  }
}

/// Incident radiance on N bands, summed up lane by lane.
template <int N>
class RadianceSum {
 public:
  using T = LightSet::Lanes;

  RadianceSum() {
    for_each_sum([](T& sum) { sum = T(0); });
  }
  /// visit(sum) for each number that is summed up, for LongSums.
  template <class Visit>
  void for_each_sum(const Visit& visit) {
    for (T& sum : sums_) visit(sum);
  }
  ZONAL_INLINE void operator()(const Arrival<T>& arrival) {
    evaluate<N>(arrival.direction[0], arrival.direction[1], arrival.direction[2],
                [&](auto l, auto m, const T& y) ZONAL_INLINE {
                  for (int c = 0; c < 3; ++c) add_product(sums_[3 * sh_index(l, m) + c], y, arrival.irradiance[c]);
                });
  }
  Sh<N, glm::vec3> radiance() const {
    Sh<N, glm::vec3> sh;
    for (int i = 0; i < N * N; ++i) sh[i] = {sums_[3 * i].sum(), sums_[3 * i + 1].sum(), sums_[3 * i + 2].sum()};
    return sh;
  }

 private:
  T sums_[std::size_t(3 * N * N)];
};

/// The coefficients of the radiance that arrives at a pixel from a set of lights, W/(m^2 sr) over the whole sphere.
template <int N>
Sh<N, glm::vec3> incident_radiance(const LightSet& lights, const glm::vec3& position, const glm::vec3& geometric_normal,
                                   float least_distance, const LightVisibility& visible = {}) {
  RadianceSum<N> sum;
  LongSums<LightSet::Lanes> totals;
  int arrived = 0;
  for_each_arrival(lights, position, geometric_normal, least_distance, visible, [&](const auto& arrival) ZONAL_INLINE {
    sum(arrival);
    if (++arrived % terms_in_block == 0) totals.take(sum);
  });
  totals.finish(sum);
  return sum.radiance();
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
