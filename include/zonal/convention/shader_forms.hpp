// Three bands as the shaders of engines take them: E / pi at a normal, in few vectors, without constants. All are made
// of Unity's nine numbers, plain polynomials: convert(radiance, Convention{}, find_convention("unity")->convention).
//
// [1] Sloan, Stupid spherical harmonics tricks, GDC 2008, appendix A10.
#pragma once

#include "../basis/sh.hpp"
#include "../scalar/vector3.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// E / pi of one channel, plain polynomials sorted by what a shader multiplies: a by (x, y, z, 1), b by (xy, yz, zz,
/// zx), c by xx - yy [1 A10]. Of Unity's unity_SHAr, unity_SHBr and unity_SHC.r, and of Unreal's
/// SkyIrradianceEnvironmentMap[0], [3] and [6].r; the other channels alike.
template <class T>
struct SevenVectors {
  T a[4], b[4], c;
};

template <class T>
constexpr SevenVectors<T> seven_vectors(const Sh<3, T>& unity) {
  const Sh<3, T>& p = unity;
  return {{p[3], p[1], p[2], p[0] - p[6]}, {p[4], p[5], T(3) * p[6], p[7]}, p[8]};
}
/// Back, to Unity's nine numbers.
template <class T>
constexpr Sh<3, T> to_unity(const SevenVectors<T>& v) {
  const T zonal = v.b[2] / T(3);
  return {{v.a[3] + zonal, v.a[1], v.a[2], v.a[0], v.b[0], v.b[1], zonal, v.b[3], v.c}};
}

/// E / pi at a unit normal, as those shaders have it. It may be negative: they clamp it.
template <class T, class V>
ZONAL_INLINE constexpr T reconstruct(const SevenVectors<T>& v, const V& normal) {
  const auto n = detail::as_direction<T>(normal);
  const T linear = v.a[0] * n.x + v.a[1] * n.y + v.a[2] * n.z + v.a[3];
  const T quadratic = v.b[0] * (n.x * n.y) + v.b[1] * (n.y * n.z) + v.b[2] * (n.z * n.z) + v.b[3] * (n.z * n.x);
  return linear + quadratic + v.c * (n.x * n.x - n.y * n.y);
}

/// Babylon.js' SphericalPolynomial of one channel, E / pi = x X + ... + xx XX + ... of a normal (X, Y, Z).
template <class T>
struct NinePolynomials {
  T x, y, z, xx, yy, zz, yz, zx, xy;
};

template <class T>
constexpr NinePolynomials<T> nine_polynomials(const Sh<3, T>& unity) {
  const Sh<3, T>& p = unity;  // 1 = xx + yy + zz, 3 zz - 1 = 2 zz - xx - yy
  return {p[3], p[1], p[2], p[0] - p[6] + p[8], p[0] - p[6] - p[8], p[0] + T(2) * p[6], p[5], p[7], p[4]};
}

template <class T, class V>
ZONAL_INLINE constexpr T reconstruct(const NinePolynomials<T>& p, const V& normal) {
  const auto n = detail::as_direction<T>(normal);
  return p.x * n.x + p.y * n.y + p.z * n.z + p.xx * (n.x * n.x) + p.yy * (n.y * n.y) + p.zz * (n.z * n.z) +
         p.yz * (n.y * n.z) + p.zx * (n.z * n.x) + p.xy * (n.x * n.y);
}

/// The value of plain polynomials, Unity's and Filament's nine numbers, at a unit vector.
template <class T, class V>
ZONAL_INLINE constexpr T reconstruct_polynomials(const Sh<3, T>& p, const V& normal) {
  const auto n = detail::as_direction<T>(normal);
  const T* c = p.values;
  return c[0] + c[1] * n.y + c[2] * n.z + c[3] * n.x + c[4] * (n.x * n.y) + c[5] * (n.y * n.z) +
         c[6] * (T(3) * (n.z * n.z) - T(1)) + c[7] * (n.x * n.z) + c[8] * (n.x * n.x - n.y * n.y);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
