// How far a light that is drawn from a cluster strays from the cluster's sum, seen from a receiver: a bound, proved
// from what the node of the tree knows.
//
// Light j of the cluster, of weight w_j, adds w_j E_j C_j P_j to the receiver's radiance. E is what it sends towards
// the receiver per unit of weight, C the cosine at the light, P = H sum_l e_l R_l / d^2 with R_l = sum_m F_l^m
// Y_l^m(w), e_l the cap's coefficient over sin^2 a (cap.hpp), H the share above the horizon. Drawn with the probability
// w_j / W, for which it then counts W / w_j times, it gives the cluster's sum in the mean; with E, C, P at the means of
// position, normal and emission, its variance is at most W^2 times the mean square of
//
//   E_j C_j P_j - E C P  =  (P_j - P) C_j E_j  +  P (C_j - C) E_j  +  P C (E_j - E)
//
// Each difference is a slope, bounded over all of the cluster, times how far a light's position, normal or emission
// lies from the mean. Along the line of sight only the distance changes, across it only the direction. Root mean
// squares of sums are no more than the sums of root mean squares (Minkowski).
#pragma once

#include <cstddef>

#include "../basis/gradient.hpp"
#include "../gather/hvl.hpp"
#include "../scalar/fields.hpp"
#include "light_tree.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

/// e_l changes with sin^2 a by no more than this, up to the sine given: by l(l+1)/8 about, from 1 at a point.
inline constexpr long double widest_sine = 0.75L;
inline float widening_of_degree(int l) { return l == 1 ? 0.0F : (glm::max)(0.77F, float(l * (l + 1)) / 8); }

/// Stands for "not known": the receiver is too near for a bound.
inline constexpr float unknown_deviation = 1e18F;

}  // namespace detail

/// Receivers as the bound needs them, one or a packet.
template <int N, class T>
struct BoundedReceiver {
  T position[3], normal[3], tangent[3];
  T material[3][std::size_t{N * N}];      // F in that frame, RGB
  T slope[3], curvature[3], widening[3];  // F's greatest derivatives, per radian; and of sum e_l R_l by sin^2 a

  template <class Visit>
  ZONAL_INLINE constexpr void members(const Visit& visit) {
    visit(position), visit(normal), visit(tangent), visit(material), visit(slope), visit(curvature), visit(widening);
  }
};

/// `material` is F at the outgoing direction, in the frame of the receiver's normal and this tangent.
template <int N>
BoundedReceiver<N, float> bounded_receiver(const Receiver& receiver, const glm::vec3& tangent,
                                           const Sh<N, glm::vec3>& material) {
  const glm::vec3 slope = greatest_slope(material), curvature = greatest_curvature(material);
  const glm::vec3 widening =
      detail::sum_of_norms(material, [](int l) { return detail::widening_of_degree(l) * detail::value_of_norm(l); });
  BoundedReceiver<N, float> result;
  for (int c = 0; c < 3; ++c) {
    result.position[c] = receiver.position[c];
    result.normal[c] = receiver.normal[c];
    result.tangent[c] = tangent[c];
    for (int i = 0; i < N * N; ++i) result.material[c][i] = material.values[i][c];
    result.slope[c] = slope[c], result.curvature[c] = curvature[c], result.widening[c] = widening[c];
  }
  return result;
}
/// The same of an isotropic material, in the frame where the eye has phi = 0.
template <int N>
BoundedReceiver<N, float> bounded_receiver(const Receiver& receiver, const EvenSh<N, glm::vec3>& material) {
  return bounded_receiver(receiver, detail::tangent_towards(receiver.normal, receiver.outgoing),
                          detail::all_orders(material));
}
/// The same of an anisotropic material, in the frame of the receiver's tangent.
template <int N>
BoundedReceiver<N, float> bounded_receiver(const Receiver& receiver, const AnisotropicTable& material) {
  const glm::vec3 own = detail::tangent_towards(receiver.normal, receiver.tangent);
  const glm::vec3 outgoing = detail::in_frame(receiver.outgoing, receiver.normal, own);
  return bounded_receiver(receiver, detail::turned_tangent(outgoing, receiver.normal, own),
                          material.with_cosine<N>(outgoing));
}

/// What a cluster adds to a receiver's radiance, RGB: about, and a bound on the standard deviation of a light drawn for
/// all; unknown_deviation where the receiver stands nearer than twice the cluster's reach or in one of its spheres.
template <class T>
struct ClusterBound {
  T radiance[3], deviation[3];
};

namespace detail {

/// v S v of a node's covariance of positions, and how far its lights lie from the mean along v at most.
template <class T>
ZONAL_INLINE inline T variance_along(const float (&s)[6], const T (&v)[3]) {
  return v[0] * (T(s[0]) * v[0] + T(2 * s[1]) * v[1] + T(2 * s[2]) * v[2]) +
         v[1] * (T(s[3]) * v[1] + T(2 * s[4]) * v[2]) + v[2] * (T(s[5]) * v[2]);
}
template <class T>
ZONAL_INLINE inline T reach_along(const glm::vec3& reach, const T (&v)[3]) {
  return T(reach.x) * abs(v[0]) + T(reach.y) * abs(v[1]) + T(reach.z) * abs(v[2]);
}

/// A cluster seen from a receiver.
template <class T>
struct ClusterView {
  T direction[3], distance, inverse;  // of the mean position
  T reach, nearest, inverse_nearest;  // distance to any light at least
  T turn;                             // greatest angle from the mean direction
  T along, across;                    // root mean squares: of the change of distance, and that angle
};

template <int NE, class T>
ZONAL_INLINE inline ClusterView<T> view_cluster(const LightNode<NE>& node, const T (&from)[3]) {
  ClusterView<T> view;
  for (int i = 0; i < 3; ++i) view.direction[i] = T(node.position[i]) - from[i];
  view.distance = sqrt(maximum(dot3(view.direction, view.direction), T(1e-30L)));
  view.inverse = T(1) / view.distance;
  for (T& x : view.direction) x = x * view.inverse;
  view.reach = T(glm::length(node.reach));
  view.nearest = maximum(view.distance - view.reach, T(0.5L) * view.distance);
  view.inverse_nearest = T(1) / view.nearest;
  view.turn = T(1.0472L) * view.reach * view.inverse;  // of its sine, up to 1/2, an angle is at most pi/3 times
  const float* s = node.covariance;
  const T along2 = maximum(variance_along(node.covariance, view.direction), T(0));
  view.across = sqrt(maximum(T(s[0] + s[3] + s[5]) - along2, T(0))) * view.inverse_nearest;
  view.along = sqrt(along2) + T(0.5L) * view.reach * view.across;  // what lies beside is also farther away
  return view;
}

/// The cosine at the lights.
template <class T>
struct LightCosine {
  T mean, greatest, spread;
};

/// By how the direction changes; or by the height above the light's plane over the distance, which is the better where
/// a cluster is flat: seen from its own plane it sends nothing.
template <int NE, class T>
ZONAL_INLINE inline LightCosine<T> cosine_seen(const LightNode<NE>& node, const ClusterView<T>& view) {
  const T normal[3] = {T(node.normal.x), T(node.normal.y), T(node.normal.z)};
  const T cosine = -dot3(view.direction, normal), length2 = dot3(normal, normal);
  const T far = view.distance + view.reach;
  const T slope = minimum(sqrt(maximum(length2 - cosine * cosine, T(0))) + T(0.5L) * view.turn, T(1));
  const T by_direction = slope * view.across + T(node.normal_spread);
  const T height_spread = sqrt(maximum(variance_along(node.covariance, normal), T(0))) + T(node.normal_spread) * far;
  const T by_height = (height_spread + abs(cosine) * view.along) * view.inverse_nearest;
  const T height = cosine * view.distance + reach_along(node.reach, normal) + T(node.normal_reach) * far;
  const T greatest = minimum(cosine + view.turn + T(node.normal_reach), maximum(height, T(0)) * view.inverse_nearest);
  return {maximum(T(0), cosine), clamp(greatest, T(0), T(1)), minimum(by_direction, by_height)};
}

}  // namespace detail

/// `may_be_hidden`: what stands between is not known; any light may be seen or not.
template <int N, int NE, Horizon method, class T>
ZONAL_INLINE inline ClusterBound<T> bound_cluster(const LightNode<NE>& node, const BoundedReceiver<N, T>& receiver,
                                                  bool may_be_hidden = false) {
  const auto view = detail::view_cluster(node, receiver.position);

  // What it sends, and the cosine at the light, which is 1 for one of no surface.
  T sent[3] = {T(0), T(0), T(0)};
  evaluate<NE>(-view.direction[0], -view.direction[1], -view.direction[2],
               [&](auto l, auto m, const T& y) ZONAL_INLINE {
                 for (int c = 0; c < 3; ++c) sent[c] = sent[c] + T(node.emission(l, m)[c]) * y;
               });
  detail::LightCosine<T> cosine{T(1), T(1), T(0)};
  if (node.normal_reach > 0 || node.normal != glm::vec3(0)) cosine = detail::cosine_seen(node, view);

  // What the receiver makes of it, and how that changes with the direction.
  T bitangent[3];
  detail::cross3(receiver.normal, receiver.tangent, bitangent);
  const T x = detail::dot3(view.direction, receiver.tangent), y = detail::dot3(view.direction, bitangent),
          z = detail::dot3(view.direction, receiver.normal);
  T reflected[3], change[3][3];
  for (int c = 0; c < 3; ++c) reflected[c] = change[c][0] = change[c][1] = change[c][2] = T(0);
  evaluate_with_gradient<N>(x, y, z,
                            [&](auto l, auto m, const T& value, const T& gx, const T& gy, const T& gz) ZONAL_INLINE {
                              for (int c = 0; c < 3; ++c) {
                                const T& f = receiver.material[c][sh_index(l, m)];
                                reflected[c] = reflected[c] + f * value;
                                change[c][0] = change[c][0] + f * gx;
                                change[c][1] = change[c][1] + f * gy;
                                change[c][2] = change[c][2] + f * gz;
                              }
                            });

  // How large the lights look, and which share of them stands above the horizon: between these two.
  const T sine = T(node.greatest_radius) * view.inverse_nearest;
  const T least_sine = T(node.least_radius) / (view.distance + view.reach);
  const T sine2 = sine * sine, widening = maximum(sine2 - least_sine * least_sine, T(0));
  T least_share(may_be_hidden ? 0 : 1), greatest_share(1);
  if constexpr (method != Horizon::none) {
    const T height = z * view.distance, reach = minimum(view.reach, detail::reach_along(node.reach, receiver.normal));
    least_share = select(height - reach >= T(node.greatest_radius), least_share, T(0));
    greatest_share = select(height + reach <= T(-node.greatest_radius), T(0), T(1));
  }
  const T share = T(0.5L) * (greatest_share + least_share), share_spread = T(0.5L) * (greatest_share - least_share);

  const T near2 = view.inverse_nearest * view.inverse_nearest, far2 = view.inverse * view.inverse;
  const T falloff = far2 * view.inverse_nearest + near2 * view.inverse;  // 1/d^2 changes by no more, per length
  const T unknown(detail::unknown_deviation);
  ClusterBound<T> bound;
  for (int c = 0; c < 3; ++c) {
    const T value = abs(reflected[c]) + receiver.widening[c] * sine2;
    // By the derivative at the mean and the greatest second one; or by the greatest derivative.
    T slope[3];
    for (int i = 0; i < 3; ++i) {
      slope[i] = change[c][0] * receiver.tangent[i] + change[c][1] * bitangent[i] + change[c][2] * receiver.normal[i];
    }
    const T steep = sqrt(maximum(detail::variance_along(node.covariance, slope), T(0))) * view.inverse_nearest;
    const T changes =
        minimum(receiver.slope[c] * view.across, steep + T(0.5L) * receiver.curvature[c] * view.turn * view.across);
    const T p = share * value * far2;
    const T p_spread =
        greatest_share * (near2 * (changes + receiver.widening[c] * widening) + value * falloff * view.along) +
        share_spread * value * far2;
    const T e = maximum(sent[c], T(0)), e_slope(node.emission_slope[c]);
    const T e_greatest = e + T(node.emission_reach) + e_slope * view.turn;
    const T e_spread = T(node.emission_spread[c]) + e_slope * view.across;
    const T deviation = (p_spread * cosine.greatest + p * cosine.spread) * e_greatest + p * cosine.mean * e_spread;
    bound.radiance[c] = T(node.weight) * (share * reflected[c]) * (far2 * cosine.mean * e);
    bound.deviation[c] = select(view.distance < T(2) * view.reach, unknown,
                                select(T(detail::widest_sine) < sine, unknown, T(node.weight) * deviation));
  }
  return bound;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
