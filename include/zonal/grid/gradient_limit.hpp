// The gradient of a light near by, as a grid can use it.
//
// Interpolation carries a vertex's gradient a whole cell far, and beside a light it holds for a fraction of one: on the
// surface of a sphere light the slope A_l' is infinite, and about its centre, or a point light, directions turn by 1/d
// per unit of length. Used as they are, such gradients gave an irradiance of -800 where the truth lies in [0, 1]. So a
// grid takes no more of a gradient than what the light itself can change over a cell. With h the longest side of a
// cell, and d the distance to the light's centre:
//
// - the direction to the light turns as if it were no nearer than h: A_l/d becomes A_l min(1/d, 1/h);
// - the slope is at most three times the way that is left to nothing, A_0, or to the light seen from its centre, C_0,
//   on a cell's length. A cubic stays between its ends if its slopes there are at most three times the chord's
//   (Fritsch and Carlson 1980). So all A_l' are multiplied by
//
//     min(1, 3 min(A_0, C_0 - A_0) / (h |A_0'|))
//
//   which takes the slope to 0 where the surface of a sphere light meets the vertex: inside, it is 0.
// - of a modulation m, such as a spot's cone, no more than 3 m / h is taken: from its dark side on.
// - A light that is a point is taken to be 5/16 h away where it is nearer. Its 1/d^2 has no bound, but over a cell with
//   the light at one corner it has the mean 1.92 / h^2; with the value at this distance, the cell's eight vertices have
//   the same mean. Values of other lights are what they are.
//
// All of this is continuous in the light's position, and does nothing to lights more than a cell away: from d >= h, and
// gaps between surface and vertex of more than h/6 and of two thirds of h for small lights. So it leaves the order of
// the interpolation alone. It limits each light by itself, before any sum. (A light whose A_0 is not monotone in d has
// its slope limited near the extremes of it as well.)
//
// E/pi of one sphere light of radiance 1 by interpolation from 3 bands, over its greatest in the box; 10^5 random
// lights of 0.01 to 4 cells, the surface 1e-6 to 3 radii from a vertex (tests/grid/beside_light_test.cpp):
//
//   Hermite -0.042 to 1.056     Taylor -0.28 to 1.24     trilinear -0.035 to 1.049
//
// where trilinear's excess is that of 3 bands. Taylor expands each vertex over the whole cell, hence its wider range.
// Polygon lights have their own limit (add_polygons.hpp): a gradient is an integral over edges of 1/rho, the distance
// of each point, which counts for no more than 1/h. Not limited: the loops over lights of the generated shaders.
#pragma once

#include "../light/radial.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What limits a light's gradient: 1 over the longest side of a grid's cells and the side itself, in units of length,
/// and C_0 of the light in it (value_at_centre).
template <class T>
struct GradientLimit {
  T cell, inverse_cell, at_centre;
};

namespace detail {

// Whether a light says that it is a point.
template <class Light, class = void>
struct IsPoint : std::false_type {};
template <class Light>
struct IsPoint<Light, std::void_t<decltype(Light::is_point)>> : std::bool_constant<Light::is_point> {};

// What to multiply something of this size by, so that it is at most `most`: 1 where it is so already.
template <class T>
ZONAL_INLINE constexpr T factor_to(const T& most, const T& size) {
  const T tiny = T(1e-30L);  // against 0/0
  return (most + tiny) / (maximum(most, size) + tiny);
}

template <class Light, class T>
ZONAL_INLINE constexpr Sight<T> no_nearer_than_a_cell_can_tell(Sight<T> sight, const T& cell, const T& inverse_cell) {
  if constexpr (IsPoint<Light>::value) {
    sight.distance = maximum(sight.distance, T(0.3125L) * cell);
    sight.inverse_distance = minimum(sight.inverse_distance, T(3.2L) * inverse_cell);
  }
  return sight;
}

}  // namespace detail

/// The limit for a light in a grid whose cells' longest side is `cell`.
template <class Light, class T>
constexpr GradientLimit<T> gradient_limit(const Light& light, const T& cell) {
  const T inverse = T(1) / cell;
  const Sight<T> centre = detail::no_nearer_than_a_cell_can_tell<Light>(Sight<T>::to(T(0), T(0), T(0)), cell, inverse);
  return {cell, inverse, light.template profile<1>(centre).value.values[0]};
}

/// What a vertex at (x, y, z) takes of a light.
template <int N, class Light, class T>
ZONAL_INLINE constexpr SeenLight<N, T> see_limited(const Light& light, const T& x, const T& y, const T& z,
                                                   const GradientLimit<T>& limit) {
  SeenLight<N, T> seen{};
  seen.sight =
      detail::no_nearer_than_a_cell_can_tell<Light>(detail::sight(light, x, y, z), limit.cell, limit.inverse_cell);
  seen.profile = light.template profile<N>(seen.sight);
  if constexpr (detail::ModulationOf<Light, T>::exists) {
    Modulation<T>& m = seen.modulation;
    m = light.modulation(seen.sight);
    const T size = limit.cell * sqrt(detail::dot3(m.gradient, m.gradient));
    const T factor = detail::factor_to(T(3) * abs(m.value), size);
    for (T& component : m.gradient) component = component * factor;
  }

  const T value = seen.profile.value.values[0], size = limit.cell * abs(seen.profile.slope.values[0]);
  const T factor = detail::factor_to(T(3) * minimum(abs(value), abs(limit.at_centre - value)), size);
  unroll<0, N>([&](auto l) ZONAL_INLINE { seen.profile.slope.values[l] = seen.profile.slope.values[l] * factor; });
  seen.sight.inverse_distance = minimum(seen.sight.inverse_distance, limit.inverse_cell);
  return seen;
}

/// Coefficients at a vertex x of a grid whose cells' longest side is `cell`, and their gradient as far as the grid
/// takes it.
template <int N, class Light, class T>
ShGradient<N, T> project_with_limited_gradient(const Light& light, const glm::vec<3, T>& x, T cell) {
  ShGradient<N, T> sh;
  project_seen_with_gradient<detail::ModulationOf<Light, T>::exists>(
      see_limited<N>(light, x[0], x[1], x[2], gradient_limit(light, cell)), detail::into(sh));
  return sh;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
