#pragma once

// One face for Embree 3 and 4, whose ray queries take different arguments.

#if !defined(ZONAL_EMBREE_MAJOR)
#if __has_include(<embree4/rtcore.h>)
#define ZONAL_EMBREE_MAJOR 4
#else
#define ZONAL_EMBREE_MAJOR 3
#endif
#endif

#if ZONAL_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace example::embree {

inline void intersect(RTCScene scene, RTCRayHit& ray_hit) {
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(scene, &ray_hit);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &ray_hit);
#endif
}

/// Embree sets `ray.tfar` to minus infinity when anything is in the way.
inline void occluded(RTCScene scene, RTCRay& ray) {
#if RTC_VERSION_MAJOR >= 4
  rtcOccluded1(scene, &ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &ray);
#endif
}

}  // namespace example::embree
