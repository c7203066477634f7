// Which texel is which direction: the list of all mappings, and what each of them has.
//
// A mapping is made of a picture's width and height, has a `name`, and says by what_is_wrong(width, height) why a
// picture of that size cannot be one, empty if it can. Coordinates of texels are continuous: column 0 and row 0 are the
// edges of the picture on the left and above, texel (i, j) is [i, i + 1) x [j, j + 1), and its middle (i + 0.5, j +
// 0.5). Then
//
//   has_direction(i, j)       whether the texel is any: not where a cross has no face, nor beside a disc
//   direction(column, row)    unit vector, in double, exact to 1e-15; zeros where there is none
//   texel(direction)          the continuous {column, row}, the inverse, always in the picture, so that rounded down
//   they
//                             are a texel's; on an edge of two parts of the picture, of either. At the rim of a disc
//                             the texel may be one that is beside it
//   solid_angle(i, j)         of a texel, in sr, to 1e-14 of itself; 0 where it has no direction. Their sum is
//   covered()
//                             to 1e-14 of it, for pictures of any size
//   covered()                 4 pi; less where a dead angle is left out
//
// Up is +z, forward +x, left +y, except in faces of cubes as graphics interfaces have them, where up is +y; each
// mapping says where they are, and docs/rooms/environment.md shows it.
#pragma once

#include <cstring>

#include "cube.hpp"
#include "disc.hpp"
#include "equirectangular.hpp"
#include "octahedral.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

enum class Mapping {
  equirectangular,
  vertical_cross,
  horizontal_cross,
  vertical_faces,
  horizontal_faces,
  mirror_sphere,
  angular_map,
  octahedral
};
inline constexpr int kMappingCount = 8;

namespace detail {
template <class M>
struct MappingType {
  using Type = M;
};
}  // namespace detail

/// visit(tag), of which `typename decltype(tag)::Type` is the mapping's type; gives back what it does.
template <class Visit>
decltype(auto) visit_mapping(Mapping mapping, Visit&& visit) {
  switch (mapping) {
    case Mapping::equirectangular: return visit(detail::MappingType<Equirectangular>{});
    case Mapping::vertical_cross: return visit(detail::MappingType<VerticalCross>{});
    case Mapping::horizontal_cross: return visit(detail::MappingType<HorizontalCross>{});
    case Mapping::vertical_faces: return visit(detail::MappingType<VerticalFaces>{});
    case Mapping::horizontal_faces: return visit(detail::MappingType<HorizontalFaces>{});
    case Mapping::mirror_sphere: return visit(detail::MappingType<MirrorSphere>{});
    case Mapping::angular_map: return visit(detail::MappingType<AngularMap>{});
    case Mapping::octahedral: break;
  }
  return visit(detail::MappingType<Octahedral>{});
}

/// "equirectangular", "vertical cross", "horizontal cross", "vertical faces", "horizontal faces", "mirror sphere",
/// "angular map", "octahedral".
inline const char* mapping_name(Mapping mapping) {
  return visit_mapping(mapping, [](auto tag) { return decltype(tag)::Type::name; });
}

/// The mapping of a name; false, and nothing changed, where there is none.
inline bool find_mapping(const char* name, Mapping& mapping) {
  for (int i = 0; i < kMappingCount; ++i) {
    if (std::strcmp(name, mapping_name(static_cast<Mapping>(i))) == 0) {
      mapping = static_cast<Mapping>(i);
      return true;
    }
  }
  return false;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
