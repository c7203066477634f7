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

#include <cmath>
#include <cstddef>

#include "../basis/gradient.hpp"
#include "../gather/hvl.hpp"
#include "../scalar/dual.hpp"
#include "../scalar/fields.hpp"
#include "light_tree.hpp"
#include "receiver_groups.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

/// e_l changes with sin^2 a by no more than this, up to the sine given: by l(l+1)/8 about, from 1 at a point.
inline constexpr long double widest_sine = 0.75L;
inline float widening_of_degree(int l) { return l == 1 ? 0.0F : (glm::max)(0.77F, float(l * (l + 1)) / 8); }

/// Stands for "not known": the receiver is too near for a bound.
inline constexpr float unknown_deviation = 1e18F;

}  // namespace detail

/// Receivers as the bound needs them, one or a packet; each may stand for all at positions up to `reach` from its own,
/// along each axis, whose frames are turned by `tilt` from its own at most, radians, and of the same material.
template <int N, class T>
struct BoundedReceiver {
  T position[3], reach[3], normal[3], tangent[3], tilt;
  T material[3][std::size_t{N * N}];      // F in that frame, RGB
  T slope[3], curvature[3], widening[3];  // F's greatest derivatives, per radian; and of sum e_l R_l by sin^2 a
  bool is_zonal = false;                  // F is the same all about the normal, of all of a packet

  template <class Visit>
  ZONAL_INLINE constexpr void members(const Visit& visit) {
    visit(position), visit(reach), visit(normal), visit(tangent), visit(tilt), visit(material), visit(slope),
        visit(curvature), visit(widening);
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
  result.tilt = 0;
  for (int c = 0; c < 3; ++c) {
    result.position[c] = receiver.position[c], result.reach[c] = 0;
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
/// The same of a material that is the same all about the normal.
template <int N>
BoundedReceiver<N, float> bounded_receiver(const Receiver& receiver, const Zh<N, glm::vec3>& material) {
  Sh<N, glm::vec3> all{};
  for (int l = 0; l < N; ++l) all(l, 0) = material[l];
  BoundedReceiver<N, float> result =
      bounded_receiver(receiver, detail::tangent_towards(receiver.normal, receiver.outgoing), all);
  result.is_zonal = true;
  return result;
}
/// The same of an anisotropic material, in the frame of the receiver's tangent.
template <int N>
BoundedReceiver<N, float> bounded_receiver(const Receiver& receiver, const AnisotropicTable& material) {
  const detail::AnisotropicView eye(receiver.outgoing, receiver.normal, receiver.tangent);
  return bounded_receiver(receiver, eye.tangent, material.with_cosine<N>(eye.direction));
}

/// The same for all positions of a box, by its middle, and all frames turned from its own by `tilt` at most.
template <int N>
BoundedReceiver<N, float> spread_over(BoundedReceiver<N, float> receiver, const Box3& positions, float tilt) {
  const glm::vec3 middle = 0.5F * (positions.low + positions.high), reach = 0.5F * (positions.high - positions.low);
  for (int c = 0; c < 3; ++c) receiver.position[c] = middle[c], receiver.reach[c] = reach[c];
  receiver.tilt = tilt;
  return receiver;
}

/// As if it were `weight` receivers, in a mean of squares.
template <int N>
BoundedReceiver<N, float> weighted(BoundedReceiver<N, float> receiver, float weight) {
  const float factor = std::sqrt(weight);
  for (int c = 0; c < 3; ++c) {
    for (float& coefficient : receiver.material[c]) coefficient *= factor;
    receiver.slope[c] *= factor, receiver.curvature[c] *= factor, receiver.widening[c] *= factor;
  }
  return receiver;
}

/// What a cluster adds to a receiver's radiance, RGB: about, and a bound on the standard deviation of a light drawn for
/// all; unknown_deviation where the receiver stands nearer than twice the cluster's reach and its own, or in one of its
/// spheres.
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
ZONAL_INLINE inline T reach_along(const T (&reach)[3], const T (&v)[3]) {
  return reach[0] * abs(v[0]) + reach[1] * abs(v[1]) + reach[2] * abs(v[2]);
}

/// A cluster seen from the middle of where receivers are; and, of all of them, at most:
template <class T>
struct ClusterView {
  T direction[3], distance;         // of the mean position, from the middle
  T inverse;                        // of that distance
  T reach, own_reach;               // of the cluster, and of the receivers
  T least_distance, inverse_least;  // to the mean position
  T inverse_nearest;                // to any light
  T turn, own_turn;                 // angles: of a light from the mean, and of the mean from that direction
  T spread, along, across;          // root mean squares: of position, of the distance's change, of that angle
};

/// At least the angle of a sine up to 3/4; at most 4e-4 more up to 1/2.
template <class T>
ZONAL_INLINE inline T angle_of_sine(const T& sine) {
  return sine * (T(1) + T(0.23252L) * sine * sine);
}

template <int NE, int N, class T>
ZONAL_INLINE inline ClusterView<T> view_cluster(const LightNode<NE>& node, const BoundedReceiver<N, T>& receiver) {
  ClusterView<T> view;
  for (int i = 0; i < 3; ++i) view.direction[i] = T(node.position[i]) - receiver.position[i];
  view.distance = sqrt(maximum(dot3(view.direction, view.direction), T(1e-30L)));
  view.inverse = T(1) / view.distance;
  for (T& x : view.direction) x = x * view.inverse;
  view.reach = T(glm::length(node.reach));
  view.own_reach = sqrt(dot3(receiver.reach, receiver.reach));
  const T quarter = T(0.25L) * view.distance;
  view.least_distance = maximum(view.distance - view.own_reach, quarter);
  view.inverse_least = T(1) / view.least_distance;
  view.inverse_nearest = T(1) / maximum(view.least_distance - view.reach, quarter);
  view.turn = angle_of_sine(view.reach * view.inverse_least);
  view.own_turn = angle_of_sine(view.own_reach * view.inverse);
  const float* s = node.covariance;
  const T variance(s[0] + s[3] + s[5]), along2 = maximum(variance_along(node.covariance, view.direction), T(0));
  view.spread = sqrt(variance);
  const T turned = view.own_turn * view.spread;
  view.across = (sqrt(maximum(variance - along2, T(0))) + turned) * view.inverse_nearest;
  // What lies beside the line of sight is also farther away.
  view.along = sqrt(along2) + turned + T(0.5L) * view.reach * view.across;
  return view;
}

/// The cosine at the lights: towards the middle; at most; and how it differs.
template <class T>
struct LightCosine {
  T mean, most, greatest, spread;  // of the mean normal and position: as seen from the middle, and by any receiver
};

/// By how the direction changes; or by the height above the light's plane over the distance, which is the better where
/// a cluster is flat: seen from its own plane it sends nothing.
template <int NE, int N, class T>
ZONAL_INLINE inline LightCosine<T> cosine_seen(const LightNode<NE>& node, const ClusterView<T>& view,
                                               const BoundedReceiver<N, T>& receiver) {
  const T normal[3] = {T(node.normal.x), T(node.normal.y), T(node.normal.z)};
  const T reach[3] = {T(node.reach.x), T(node.reach.y), T(node.reach.z)};
  const T cosine = -dot3(view.direction, normal), length2 = dot3(normal, normal), height = cosine * view.distance;
  const T own_height = reach_along(receiver.reach, normal);
  const T far = view.distance + view.own_reach + view.reach;
  const T most = minimum(abs(cosine) + view.own_turn, (abs(height) + own_height) * view.inverse_least);
  const T slope = sqrt(maximum(length2 - cosine * cosine, T(0))) + view.own_turn + T(0.5L) * view.turn;
  const T by_direction = minimum(slope, T(1)) * view.across + T(node.normal_spread);
  const T height_spread = sqrt(maximum(variance_along(node.covariance, normal), T(0))) + T(node.normal_spread) * far;
  const T by_height = (height_spread + most * view.along) * view.inverse_nearest;
  // Less what positions are rounded by: what lies in one plane is to be known as dark.
  const T rounding = T(5e-7L) * (T(std::abs(glm::dot(node.position, node.normal))) + far);
  const T greatest_height = height + own_height + reach_along(reach, normal) + T(node.normal_reach) * far - rounding;
  const T greatest = minimum(cosine + view.own_turn + view.turn + T(node.normal_reach),
                             maximum(greatest_height, T(0)) * view.inverse_nearest);
  const T most_positive = minimum(cosine + view.own_turn, (height + own_height) * view.inverse_least);
  return {maximum(T(0), cosine), clamp(most_positive, T(0), T(1)), clamp(greatest, T(0), T(1)),
          minimum(by_direction, by_height)};
}

/// What the receiver makes of a point light at a direction of its frame, RGB, and how that changes with the direction.
template <int N, class T>
ZONAL_INLINE inline void reflect_with_gradient(const BoundedReceiver<N, T>& receiver, const T& x, const T& y,
                                               const T& z, T (&value)[3], T (&gradient)[3][3]) {
  for (int c = 0; c < 3; ++c) value[c] = gradient[c][0] = gradient[c][1] = gradient[c][2] = T(0);
  if (receiver.is_zonal) {
    T slope[3] = {T(0), T(0), T(0)};  // by z
    evaluate_zonal<N>(Dual<T, 1>::variable(z, 0), [&](auto l, const Dual<T, 1>& basis) ZONAL_INLINE {
      for (int c = 0; c < 3; ++c) {
        const T& f = receiver.material[c][sh_index(l, 0)];
        value[c] = value[c] + f * basis.value;
        slope[c] = slope[c] + f * basis.partial[0];
      }
    });
    for (int c = 0; c < 3; ++c) {
      gradient[c][0] = -slope[c] * (z * x), gradient[c][1] = -slope[c] * (z * y);
      gradient[c][2] = slope[c] * (T(1) - z * z);
    }
    return;
  }
  evaluate_with_gradient<N>(x, y, z,
                            [&](auto l, auto m, const T& basis, const T& gx, const T& gy, const T& gz) ZONAL_INLINE {
                              for (int c = 0; c < 3; ++c) {
                                const T& f = receiver.material[c][sh_index(l, m)];
                                value[c] = value[c] + f * basis;
                                gradient[c][0] = gradient[c][0] + f * gx;
                                gradient[c][1] = gradient[c][1] + f * gy;
                                gradient[c][2] = gradient[c][2] + f * gz;
                              }
                            });
}

}  // namespace detail

/// `may_be_hidden`: what stands between is not known; any light may be seen or not.
template <int N, int NE, Horizon method, class T>
ZONAL_INLINE inline ClusterBound<T> bound_cluster(const LightNode<NE>& node, const BoundedReceiver<N, T>& receiver,
                                                  bool may_be_hidden = false) {
  const auto view = detail::view_cluster(node, receiver);

  // What it sends, and the cosine at the light, which is 1 for one of no surface.
  T sent[3] = {T(0), T(0), T(0)};
  evaluate<NE>(-view.direction[0], -view.direction[1], -view.direction[2],
               [&](auto l, auto m, const T& y) ZONAL_INLINE {
                 for (int c = 0; c < 3; ++c) sent[c] = sent[c] + T(node.emission(l, m)[c]) * y;
               });
  detail::LightCosine<T> cosine{T(1), T(1), T(1), T(0)};
  if (node.normal_reach > 0 || node.normal != glm::vec3(0)) cosine = detail::cosine_seen(node, view, receiver);

  T bitangent[3];
  detail::cross3(receiver.normal, receiver.tangent, bitangent);
  const T x = detail::dot3(view.direction, receiver.tangent), y = detail::dot3(view.direction, bitangent),
          z = detail::dot3(view.direction, receiver.normal);
  T reflected[3], change[3][3];
  detail::reflect_with_gradient(receiver, x, y, z, reflected, change);

  // How large the lights look, and which share of them stands above the horizon: between these two.
  const T sine = T(node.greatest_radius) * view.inverse_nearest;
  const T least_sine = T(node.least_radius) / (view.distance + view.own_reach + view.reach);
  const T sine2 = sine * sine, widening = maximum(sine2 - least_sine * least_sine, T(0));
  T least_share(may_be_hidden ? 0 : 1), greatest_share(1);
  if constexpr (method != Horizon::none) {
    const T both[3] = {T(node.reach.x) + receiver.reach[0], T(node.reach.y) + receiver.reach[1],
                       T(node.reach.z) + receiver.reach[2]};
    const T height = z * view.distance;
    const T reach = minimum(view.reach + view.own_reach, detail::reach_along(both, receiver.normal)) +
                    receiver.tilt * (view.distance + view.own_reach + view.reach);
    least_share = select(height - reach >= T(node.greatest_radius), least_share, T(0));
    greatest_share = select(height + reach <= T(-node.greatest_radius), T(0), T(1));
  }
  const T share = T(0.5L) * (greatest_share + least_share), share_spread = T(0.5L) * (greatest_share - least_share);

  const T near2 = view.inverse_nearest * view.inverse_nearest, far2 = view.inverse_least * view.inverse_least;
  const T falloff = far2 * view.inverse_nearest + near2 * view.inverse_least;  // 1/d^2 changes by no more, per length
  const T unknown(detail::unknown_deviation);
  // Whatever the distance.
  const auto is_dark = cosine.greatest * greatest_share <= T(0);
  const auto is_near =
      minimum(T(0.75L) * view.distance - (view.reach + view.own_reach), T(detail::widest_sine) - sine) < T(0);
  const T own_turn = view.own_turn + receiver.tilt;  // of the receiver's frame against the direction
  ClusterBound<T> bound;
  for (int c = 0; c < 3; ++c) {
    // By the derivative at the mean and the greatest second one; or by the greatest derivative.
    T slope[3];
    for (int i = 0; i < 3; ++i) {
      slope[i] = change[c][0] * receiver.tangent[i] + change[c][1] * bitangent[i] + change[c][2] * receiver.normal[i];
    }
    const T bent = receiver.curvature[c] * own_turn;
    const T own_slope = minimum(receiver.slope[c], sqrt(detail::dot3(slope, slope)) + T(0.5L) * bent);
    const T value = abs(reflected[c]) + own_slope * own_turn + receiver.widening[c] * sine2;
    const T steep = sqrt(maximum(detail::variance_along(node.covariance, slope), T(0)));
    const T turned = (bent + receiver.slope[c] * own_turn) * view.spread;  // as the receiver moves
    const T changes =
        minimum(receiver.slope[c] * view.across,
                (steep + turned) * view.inverse_nearest + T(0.5L) * receiver.curvature[c] * view.turn * view.across);
    const T p = share * value * far2;
    const T p_spread =
        greatest_share * (near2 * (changes + receiver.widening[c] * widening) + value * falloff * view.along) +
        share_spread * value * far2;
    const T e = maximum(sent[c], T(0)), e_slope(node.emission_slope[c]), most_e = e + e_slope * view.own_turn;
    const T e_greatest = most_e + T(node.emission_reach) + e_slope * view.turn;
    const T e_spread = T(node.emission_spread[c]) + e_slope * view.across;
    const T deviation = (p_spread * cosine.greatest + p * cosine.spread) * e_greatest + p * cosine.most * e_spread;
    bound.radiance[c] = T(node.weight) * (share * reflected[c]) * (view.inverse * view.inverse * cosine.mean * e);
    bound.deviation[c] = select(is_dark, T(0), select(is_near, unknown, T(node.weight) * deviation));
  }
  return bound;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
