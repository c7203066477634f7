// The version of zonal, and the one place where it is written: CMakeLists.txt reads it from here.
#pragma once

#include "scalar/target.hpp"

#define ZONAL_VERSION_MAJOR 0
#define ZONAL_VERSION_MINOR 2
#define ZONAL_VERSION_PATCH 0

namespace zonal {
inline namespace ZONAL_TARGET {

inline constexpr int version_major = ZONAL_VERSION_MAJOR;
inline constexpr int version_minor = ZONAL_VERSION_MINOR;
inline constexpr int version_patch = ZONAL_VERSION_PATCH;

}  // namespace ZONAL_TARGET
}  // namespace zonal
