// What the shader functions read, as buffers of floats: virtual lights, materials, grids, pixels. One call each.
//
// A buffer is plain 4-byte floats side by side, with no padding anywhere. Declared as an array of float it has the same
// layout in C++, std430 and WGSL's storage buffers (stride 4; std140 would put 16 bytes between); a shader reads float
// number i of it by a macro, so that it may as well be a texture of floats:
//
//   layout(std430, binding = 0) readonly buffer Lights { float lights[]; };
//   #define ZONAL_LIGHT(i) lights[i]
//
//   of                 floats                                      read by (shells.hpp)
//   HvlCache           ZONAL_LIGHT(i), light after light           gather; of one band gather_diffuse
//   MaterialTable      ZONAL_MATERIAL(i), two numbers, F, F'       material_with_cosine, material_without_cosine
//   KeptTable          the same, two numbers, F of what is kept    what zonal-glsl --plan writes
//   CoefficientGrid    ZONAL_GRID(i), vertex after vertex          interpolate_trilinear, interpolate_hermite
//   GridVisibility     ZONAL_VISIBILITY(i), vertex after vertex    interpolate_visible_trilinear, .._hermite
//   SurfacePicture     ZONAL_SURFACE(i), row after row             filter_across, filter_down
//   RadiancePicture    ZONAL_PIXEL(i), row after row               filter_across, filter_down
//
// They need neither zonal-glsl nor a recorder: this header is for the program that draws.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "../gather/hvl.hpp"
#include "../grid/coefficient_grid.hpp"
#include "../grid/visibility.hpp"
#include "../material/material_table.hpp"
#include "../plan/kept_table.hpp"
#include "../scalar/half.hpp"
#include "../scalar/refuse.hpp"
#include "../screen/plane_picture.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The lights of the cache, light after light; `gather` takes cache.size() for light_count. A light is
/// 10 + 3 emission_size floats, 22 with three bands of emission and 13 with one, in the order of HvlRecord:
///
///   0 to 2    position
///   3 to 5    normal, unit
///   6 to 8    tangent, unit: the direction to the primary light, projected on the tangent plane
///   9         radius, a length
///   10 on     emission: all of red, all of green, all of blue; degree l and order m of a colour, l + m even, m >= 0,
///             at emission_index(l, m): (0, 0); with three bands (0, 0), (1, 1), (2, 0), (2, 2). Pi times the radiance.
///
/// Shaders have no gather of lights of anisotropic materials: throws std::invalid_argument where the cache holds any;
/// without exceptions it ends the program (refuse.hpp), so ask cache.anisotropic().size() first.
template <int NE>
std::vector<float> shader_buffer(const HvlCache<NE>& cache) {
  if (cache.anisotropic().size() != 0) {
    detail::refuse("virtual lights of anisotropic materials, which shaders do not gather");
  }
  return cache.isotropic().by_record();
}

/// The material, 2 + 6 rows row_size floats:
///
///   0    rows: angles(), 90 or 1
///   1    row_size: coefficients in a row, bands (bands + 1) / 2
///   2    F: row after row, coefficient after coefficient, RGB innermost: with_cosine_rows()
///   2 + 3 rows row_size    F', the same: without_cosine_rows()
///
/// A table says how large it is, so several may stand in one buffer: the shader functions take where one begins, as the
/// number of its first float.
inline std::vector<float> shader_buffer(const MaterialTable& table) {
  std::vector<float> floats{float(table.angles()), float(table.row_size())};
  for (const auto* rows : {&table.with_cosine_rows(), &table.without_cosine_rows()}) {
    for (const glm::vec3& coefficient : *rows)
      floats.insert(floats.end(), {coefficient.r, coefficient.g, coefficient.b});
  }
  return floats;
}

/// What receivers read of a material by a plan, 2 + 3 rows row_size floats:
///
///   0    rows
///   1    row_size: coefficients that are kept
///   2    F: row after row, of each row those that are kept, degree by degree, RGB innermost
inline std::vector<float> shader_buffer(const KeptTable& table) {
  std::vector<float> floats = table.rows();
  floats.insert(floats.begin(), {float(table.angles()), float(table.row_size())});
  return floats;
}

/// Floats as half floats, two to an unsigned integer, the first in its low bits: as unpackHalf2x16 has them. Errors are
/// at most 2^-11 of a number, or 2^-25; materials' numbers of rows and coefficients are exact. Numbers beyond 65519 are
/// infinite.
inline std::vector<std::uint32_t> packed_halves(const std::vector<float>& floats) {
  std::vector<std::uint32_t> pairs((floats.size() + 1) / 2, 0);
  for (std::size_t i = 0; i < floats.size(); ++i) {
    pairs[i / 2] |= std::uint32_t{to_half(floats[i]).bits} << (16 * (i % 2));
  }
  return pairs;
}

/// The grid: vertex after vertex, x fastest, then y; per vertex four blocks, value and derivatives by x, y and z, or
/// the value alone (in the shader ZONAL_GRID_BLOCKS is then 1u); per block N*N coefficients, RGB innermost. A copy of
/// data() and size(), which may be handed over themselves. The shader takes low(), high() and resolution() besides. As
/// textures: grid/texture_planes.hpp.
template <int N, GridContent content>
std::vector<float> shader_buffer(const CoefficientGrid<N, content>& grid) {
  return {grid.data(), grid.data() + grid.size()};
}

/// What the grid's vertices see: vertex after vertex, 4 + 2 (2 rings + 1)^2 floats each (grid/visibility.hpp). A copy
/// of data() and size(). In the shader ZONAL_VISIBILITY_RINGS is rings(), 4u unless defined otherwise.
inline std::vector<float> shader_buffer(const GridVisibility& visibility) {
  return {visibility.data(), visibility.data() + visibility.size()};
}

/// Surfaces, or coefficients in float: a row of pixels is a row of each plane (screen/plane_picture.hpp), pitch()
/// numbers each, what pads them included. A copy of data() and size(), which may be handed over themselves. The shader
/// takes width(), height() and pitch() besides.
inline std::vector<float> shader_buffer(const PlanePicture<float>& picture) {
  return {picture.data(), picture.data() + picture.size()};
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
