// The pictures that are projected, one a mapping.
#pragma once

#include <cstddef>
#include <vector>

#include <zonal/environment/mapping.hpp>

#include "built_bands.hpp"

namespace zonal_bench {

struct EnvironmentPicture {
  zonal::Mapping mapping;
  int width, height;
};

inline std::size_t texel_count(const EnvironmentPicture& picture) {
  return static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
}

inline std::vector<EnvironmentPicture> environment_pictures() {
  using zonal::Mapping;
  constexpr int size = is_quick ? 64 : 2048;
  return {{Mapping::equirectangular, 2 * size, size},
          {Mapping::vertical_cross, 3 * size / 2, 2 * size},
          {Mapping::horizontal_cross, 2 * size, 3 * size / 2},
          {Mapping::vertical_faces, size / 2, 3 * size},
          {Mapping::horizontal_faces, 3 * size, size / 2},
          {Mapping::mirror_sphere, size, size},
          {Mapping::angular_map, size, size},
          {Mapping::octahedral, size, size}};
}

}  // namespace zonal_bench
