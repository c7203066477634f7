// Harmonics virtual lights for materials of one diffuse and one circularly symmetric glossy lobe [1, 6.3]: a cap meets
// two zonal lobes, in N terms where the gather of hvl.hpp has N^2.
//
//   L_o(x) = sum_j L_j ( albedo sum_l A_l lambert_l Y_l^0(n . w)  +  max(0, n . w) sum_l A_l z_l Y_l^0(r . w) )
//
// r is the mirror direction of the eye. The first sum is [1, Appendix B], with degree 4 where that ends at 2. In the
// second the cosine is taken out of the integral, at the light's centre. Light is sent by the BRDF itself.
//
// [1] Mezieres et al., Harmonics Virtual Lights, CGF 41(6), 2022.
#pragma once

#include "../lobe/cap.hpp"
#include "../lobe/lambert.hpp"
#include "../material/zonal_table.hpp"
#include "light_cache.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What a receiver's material is at the direction to the eye. T is the kernel's scalar.
template <int N, class T>
struct ZonalReceiver {
  T mirror[3];                  // unit, world: the mirror direction of the eye
  T diffuse[3];                 // albedo, RGB
  T glossy[3][std::size_t{N}];  // zonal coefficients about the mirror direction, RGB
  bool is_diffuse;              // all glossy coefficients are zero
};

/// The outgoing radiance that one light (or one packet of lights) causes, to radiance[3], RGB.
template <int N, class T>
ZONAL_INLINE inline void hvl_zonal_radiance(const LightRecord<T>& light, const Brdf& glossy,
                                            const ReceiverFrame<T>& receiver, const ZonalReceiver<N, T>& material,
                                            T (&radiance)[3]) {
  const auto [direction, distance, inverse] = look_at(light, receiver);
  const T cos_receiver = detail::dot3(direction, receiver.normal);
  const auto cap = SphericalCap<T>::from_sphere(distance, inverse, light.radius);
  T a[std::size_t{N}];  // A_l / pi
  detail::hemisphere_cap_sums<N>(cap, [&](auto l, const T& sum) ZONAL_INLINE { a[l] = sum; });

  constexpr auto lambert = project<5, double>(LambertLobe{});
  T irradiance = T(0);  // over pi^2 L_j
  evaluate_zonal<(N < 5 ? N : 5)>(cos_receiver, [&](auto l, const T& y) ZONAL_INLINE {
    if constexpr (l % 2 == 0 || l == 1) irradiance = irradiance + a[l] * (T(lambert.values[l]) * y);
  });
  T reflected[3];
  for (int c = 0; c < 3; ++c) reflected[c] = material.diffuse[c] * maximum(T(0), irradiance);

  if (!material.is_diffuse) {
    T sum[3] = {T(0), T(0), T(0)};
    evaluate_zonal<N>(detail::dot3(direction, material.mirror), [&](auto l, const T& y) ZONAL_INLINE {
      const T weight = a[l] * y;
      for (int c = 0; c < 3; ++c) sum[c] = sum[c] + weight * material.glossy[c][l];
    });
    const T cosine = maximum(T(0), cos_receiver);
    for (int c = 0; c < 3; ++c) reflected[c] = reflected[c] + cosine * maximum(T(0), sum[c]);
  }

  // pi of A_l cancels that of the sphere's disc, pi r^2.
  T sent[3];
  detail::reflected_flux(light, glossy, direction, sent);
  const T scale =
      maximum(T(0), -detail::dot3(direction, light.normal)) / maximum(light.radius * light.radius, T(1e-30L));
  for (int c = 0; c < 3; ++c) radiance[c] = sent[c] * reflected[c] * scale;
}

/// Outgoing radiance, RGB, at the receiver from all lights of the cache: one bounce, N bands of the receiver's
/// material, of which those beyond its table's are zero. `tint` multiplies its diffuse part, as a texture does.
template <int N>
glm::vec3 gather_hvl_zonal(const LightCache& cache, const Receiver& receiver, const ZonalTable& material,
                           const Visibility& visible = {}, const glm::vec3& tint = glm::vec3(1.0F)) {
  using Lanes = PacketArray<LightRecord>::Lanes;
  const float cos_outgoing = glm::dot(receiver.normal, receiver.outgoing);
  const glm::vec3 mirror = 2.0F * cos_outgoing * receiver.normal - receiver.outgoing;
  const Zh<N, glm::vec3> lobe = material.glossy<N>(cos_outgoing);
  ZonalReceiver<N, Lanes> local;
  local.is_diffuse = material.is_diffuse();
  const glm::vec3 albedo = tint * material.diffuse_albedo(cos_outgoing);
  for (int c = 0; c < 3; ++c) {
    local.mirror[c] = Lanes(mirror[c]);
    local.diffuse[c] = Lanes(albedo[c]);
    for (int l = 0; l < N; ++l) local.glossy[c][l] = Lanes(lobe[l][c]);
  }
  const auto frame = detail::frame_of<Lanes>(receiver);
  return detail::sum_groups(cache, visible, [&](const LightCache::Group& group, const auto& light, auto& rgb) {
    hvl_zonal_radiance<N>(light, group.glossy, frame, local, rgb);
  });
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
