// Loops over lights, a material's coefficients, grid vertices and neighbouring pixels, in GLSL: thin shells around the
// recorded functions, which hold all the mathematics.
//
// A shell reads lights, materials and grids through macros that the including shader defines, so that they may stand in
// any buffer, texture or uniform. What is written there, by one call each: buffers.hpp.
//
//   ZONAL_LIGHT(i)      float number i of the lights, light after light, the fields in the order given with each shell
//   ZONAL_MATERIAL(i)   float number i of materials, one after the other
//   ZONAL_GRID(i)       float number i of a grid, in the order of CoefficientGrid::data()
//   ZONAL_VISIBILITY(i) float number i of what its vertices see, in the order of GridVisibility::data()
//   ZONAL_SURFACE(i)    float number i of what the pixels see, in the order of SurfacePicture::data()
//   ZONAL_PIXEL(i)      float number i of the pixels' coefficients, in the order of RadiancePicture::data()
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "../gather/hvl.hpp"
#include "../kernels/kernel_list.hpp"
#include "file_text.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace shader {

/// A recorded function that a shell calls.
struct ShellNeed {
  std::string function;
  Part part = {};
};

struct Shell {
  std::string_view name, summary;
  std::vector<ShellNeed> (*needs)(int bands);
  std::string (*text)(int bands);
};

namespace detail {

/// The text with $N replaced by the number of bands, and further names by further numbers. What depends on dialect and
/// options, types ($float), $precise and $GUARD, is left to shell_text.
struct Substitution {
  std::string name, value;
};
inline std::string substitute(std::string text, const std::vector<Substitution>& substitutions) {
  for (const Substitution& s : substitutions) {
    for (std::size_t at = 0; (at = text.find(s.name, at)) != std::string::npos; at += s.value.size()) {
      text.replace(at, s.name.size(), s.value);
    }
  }
  return text;
}

/// A loop over all lights for each suffix of a function's name: one for all orders at once, or one for each order.
inline std::string light_loops(std::string_view loop, const std::vector<std::string>& suffixes) {
  std::string text;
  for (const std::string& suffix : suffixes) text += substitute(std::string(loop), {{"$SUFFIX", suffix}});
  return text;
}
template <class Entry>
std::vector<std::string> order_suffixes(int bands, bool is_reversed) {
  if (!is_reversed) return {""};
  std::vector<std::string> suffixes;
  for (int m = 0; m < Entry::order_count(bands); ++m) suffixes.push_back("_order_" + std::to_string(m));
  return suffixes;
}
template <class Entry>
std::vector<ShellNeed> with_orders(int bands, bool is_reversed) {
  if (!is_reversed) return {{Entry::name}};
  std::vector<ShellNeed> needs;
  for (int m = 0; m < Entry::order_count(bands); ++m) needs.push_back({Entry::name, Part(m)});
  return needs;
}

// ---- The gather of virtual lights -----------------------------------------------------------------------------------

/// A loop over lights around the kernel of the virtual lights: which one; of a receiver's coefficients all, or those
/// kept; whether order by order; and whether over lights that a cut has drawn, some of them clear of the horizon.
struct GatherLoop {
  int emission_bands;
  Horizon horizon;
  Symmetry symmetry;
  bool is_reversed = false;
  std::vector<bool> kept = {};  // by coefficient_index
  bool is_drawn = false;

  std::string kernel() const { return kernel(horizon); }
  std::string kernel(Horizon of) const { return name_of("hvl_radiance", of); }
  std::string name() const {
    return name_of(is_drawn ? "gather_drawn" : "gather", horizon) + (is_reversed ? "_reversed" : "");
  }
  Part part() const { return kept.empty() ? Part() : Part("material", kept); }
  int material_size(int bands) const { return kept.empty() ? coefficient_count(symmetry, bands) : part().kept_count(); }

 private:
  std::string name_of(std::string_view first, Horizon of) const {
    return kernels::hvl_name(first, emission_bands, of, symmetry).text;
  }
};

inline std::string load_light(int size) {
  std::string emission;
  for (int i = 0; i < size; ++i) {
    emission += "  hvl.emission[" + std::to_string(i) + "] = vec3(";
    for (int c = 0; c < 3; ++c) {
      emission += (c > 0 ? ", " : "") + ("ZONAL_LIGHT(at + " + std::to_string(10 + c * size + i) + "u)");
    }
    emission += ");\n";
  }
  return emission;
}

inline std::vector<ShellNeed> gather_needs(const GatherLoop& gather, int bands) {
  if (gather.is_drawn) return {{gather.kernel(Horizon::none), gather.part()}, {gather.kernel(), gather.part()}};
  if (!gather.is_reversed) return {{gather.kernel(), gather.part()}};
  std::vector<ShellNeed> needs;
  for (int m = 0; m < bands; ++m) needs.push_back({gather.kernel(), m});
  return needs;
}

inline std::string gather_text(const GatherLoop& gather, int bands) {
  const std::string text = R"(// A virtual light: $FIELDS floats, in the order of HvlRecord::members.
#ifndef $GUARDHVL_$NE
#define $GUARDHVL_$NE
struct zonal_Hvl_$NE {
  $vec3 position;
  $vec3 normal;
  $vec3 tangent;
  $float radius;
  $vec3 emission[$SIZE];
};
zonal_Hvl_$NE zonal_load_hvl_$NE($uint i) {
  $uint at = i * $FIELDSu;
  zonal_Hvl_$NE hvl;
  hvl.position = vec3(ZONAL_LIGHT(at), ZONAL_LIGHT(at + 1u), ZONAL_LIGHT(at + 2u));
  hvl.normal = vec3(ZONAL_LIGHT(at + 3u), ZONAL_LIGHT(at + 4u), ZONAL_LIGHT(at + 5u));
  hvl.tangent = vec3(ZONAL_LIGHT(at + 6u), ZONAL_LIGHT(at + 7u), ZONAL_LIGHT(at + 8u));
  hvl.radius = ZONAL_LIGHT(at + 9u);
$EMISSION  return hvl;
}
#endif
// The outgoing radiance that $LIGHTS. $WHICH
$vec3 zonal_$NAME($COUNT $vec3 position, $vec3 normal, $TANGENTin $vec3 material[$MATERIAL]) {
  $precise $vec3 sum = vec3(0.0f);
$LOOPS  return max(sum, vec3(0.0f));
}
)";
  const std::string loop = R"(  for ($uint i = $BEGIN; i < $END; ++i) {
    zonal_Hvl_$NE hvl = zonal_load_hvl_$NE(i);
    sum += zonal_$RADIANCE_$N$SUFFIX(hvl.position, hvl.normal, hvl.tangent, hvl.radius, hvl.emission,
                                     position, normal, $OFmaterial);
  }
)";
  const auto loop_of = [&](const std::string& kernel, const std::string& its_suffix, const std::string& begin,
                           const std::string& end) {
    return substitute(loop, {{"$RADIANCE", kernel}, {"$SUFFIX", its_suffix}, {"$BEGIN", begin}, {"$END", end}});
  };
  const bool is_zonal = gather.symmetry == Symmetry::zonal;
  const int emission_size = EvenEmission::size(gather.emission_bands);
  const std::string suffix = gather.part().suffix();
  std::string loops;
  if (gather.is_drawn) {
    loops = loop_of(gather.kernel(Horizon::none), suffix, "first", "first + clear_count") +
            loop_of(gather.kernel(), suffix, "first + clear_count", "first + clear_count + across_count");
  } else {
    for (const ShellNeed& need : gather_needs(gather, bands)) {
      loops += loop_of(need.function, need.part.suffix(), "0u", "light_count");
    }
  }
  return substitute(
      text,
      {{"$LOOPS", loops},
       {"$LIGHTS", gather.is_drawn ? "lights drawn in place of all cause, from the first on those clear of the "
                                     "horizon, then\n// those across it; see DrawnLights "
                                     "(zonal/many_lights/drawn_lights.hpp)"
                                   : "all virtual lights cause; see gather (zonal/gather/hvl.hpp)"},
       {"$COUNT", gather.is_drawn ? "$uint first, $uint clear_count, $uint across_count,\n   " : "$uint light_count,"},
       {"$WHICH", is_zonal
                      ? "`material` is F of m = 0."
                      : "`material` is F of m >= 0 at the\n// outgoing direction, which lies in the plane of normal "
                        "and tangent."},
       {"$TANGENT", is_zonal ? "" : "$vec3 tangent, "},
       {"$OF", is_zonal ? "" : "tangent, "},
       {"$FIELDS", std::to_string(hvl_record_size(gather.emission_bands))},
       {"$SIZE", std::to_string(emission_size)},
       {"$EMISSION", load_light(emission_size)},
       {"$MATERIAL", std::to_string(gather.material_size(bands))},
       {"$NAME", gather.name() + "_$N" + suffix},
       {"$NE", std::to_string(gather.emission_bands)},
       {"$N", std::to_string(bands)}});
}
// ---- Materials ------------------------------------------------------------------------------------------------------

/// How a table is read: what it is called, what it gives, where its rows begin and where a coefficient stands in one.
inline std::string read_material_text(const std::string& name, const std::string& what, const std::string& skip,
                                      const std::string& place, int count) {
  const std::string text = R"(// $WHAT
// (zonal/material/material_table.hpp). `table` is the number of its first float.
void zonal_$NAME($uint table, $float cos_outgoing, $precise out $vec3 coefficients[$COUNT]) {
  $uint rows = uint(ZONAL_MATERIAL(table));
  $uint row_size = uint(ZONAL_MATERIAL(table + 1u));
  $precise $float row = zonal_material_row(cos_outgoing, float(rows));
  $uint below = uint(row);
  $uint above = min(below + 1u, rows - 1u);
  $precise $float t = row - float(below);
  $uint first = table + 2u$SKIP;
  for ($int i = 0; i < $COUNT; ++i) {
    coefficients[i] = vec3(0.0f);
    if ($PLACE < row_size) {
      $uint a = first + 3u * (below * row_size + $PLACE);
      $uint b = first + 3u * (above * row_size + $PLACE);
      coefficients[i] = zonal_material_between_rows(
          vec3(ZONAL_MATERIAL(a), ZONAL_MATERIAL(a + 1u), ZONAL_MATERIAL(a + 2u)),
          vec3(ZONAL_MATERIAL(b), ZONAL_MATERIAL(b + 1u), ZONAL_MATERIAL(b + 2u)), t);
    }
  }
}
)";
  return substitute(
      text, {{"$NAME", name}, {"$WHAT", what}, {"$SKIP", skip}, {"$PLACE", place}, {"$COUNT", std::to_string(count)}});
}
template <bool has_cosine>
std::string material_text(int bands) {
  const std::string name = has_cosine ? "with_cosine" : "without_cosine";
  return read_material_text(
      "material_" + name + "_" + std::to_string(bands),
      (has_cosine ? "F, the material with the cosine," : "F', the material without the cosine,") +
          std::string(" of m >= 0 at the outgoing direction of this cosine; see MaterialTable::") + name,
      has_cosine ? "" : " + 3u * rows * row_size", "uint(i)", even_index(bands, 0));
}
inline std::string material_about_axis_text(int bands) {
  return read_material_text(
      "material_about_axis_" + std::to_string(bands),
      "F, the material with the cosine, of m = 0 alone; see about_axis(MaterialTable::with_cosine)", "",
      "uint(i * (i + 1) / 2)", bands);
}
inline std::vector<ShellNeed> material_needs(int) {
  return {{kernels::MaterialRow::name}, {kernels::MaterialBetweenRows::name}};
}

// ---- The grid -------------------------------------------------------------------------------------------------------

template <bool is_reversed>
std::string sum_lights_text(int bands) {
  const std::string text =
      R"(// Coefficients and gradients at a vertex of all sphere lights, in colour channel 0, 1 or 2; see add_lights
// (zonal/grid/add_lights.hpp). A light is 7 floats: center, radius, colour. `cell` is the longest side of the grid's cells,
// which limits gradients (zonal/grid/gradient_limit.hpp).
void zonal_$NAME_$N($uint light_count, $uint channel, $vec3 vertex, $float cell, $precise out $float value[$COUNT],
    $precise out $vec3 gradient[$COUNT]) {
  $precise $float up[$UP];
  $precise $float down[$DOWN];
  zonal_clear_sums_$N(value, up, down);
$LOOPS  zonal_finish_sums_$N(up, down, gradient);
}
)";
  const std::string loop = R"(  for ($uint i = 0u; i < light_count; ++i) {
    $uint at = i * 7u;
    zonal_add_sphere_$N$SUFFIX(vec3(ZONAL_LIGHT(at), ZONAL_LIGHT(at + 1u), ZONAL_LIGHT(at + 2u)), ZONAL_LIGHT(at + 3u),
        ZONAL_LIGHT(at + 4u + channel), vertex, cell, value, up, down);
  }
)";
  return substitute(text, {{"$LOOPS", light_loops(loop, order_suffixes<kernels::AddSphere>(bands, is_reversed))},
                           {"$COUNT", std::to_string(bands * bands)},
                           {"$UP", std::to_string((bands + 1) * (bands + 1))},
                           {"$DOWN", std::to_string(bands > 1 ? (bands - 1) * (bands - 1) : 1)},
                           {"$NAME", is_reversed ? "sum_lights_reversed" : "sum_lights"},
                           {"$N", std::to_string(bands)}});
}
template <bool is_reversed>
std::vector<ShellNeed> sum_lights_needs(int bands) {
  std::vector<ShellNeed> needs = with_orders<kernels::AddSphere>(bands, is_reversed);
  needs.push_back({kernels::ClearSums::name});
  needs.push_back({kernels::FinishSums::name});
  return needs;
}

// From the cell and t in it to the end: what plain and visible interpolations have in common.
template <Interpolation method, bool is_visible>
std::string interpolate_text(int bands) {
  const std::string text = R"(// $WHAT
#ifndef ZONAL_GRID_BLOCKS  // of a vertex: value and gradient, or 1u of a grid of values alone
#define ZONAL_GRID_BLOCKS 4u
#endif
$SEENvoid zonal_$NAME_$N($vec3 position, $RECEIVER$vec3 low, $vec3 high, $uvec3 vertices,
    $precise out $vec3 sh[$COUNT]) {
  $vec3 place = zonal_cell_position(position, low, high, vec3(vertices));
  $uvec3 cell = min(uvec3(place), vertices - 2u);
  $vec3 t = place - vec3(cell);
  $vec3 cell_size = (high - low) / vec3(vertices - 1u);
  $uint first = cell.x + vertices.x * (cell.y + vertices.y * cell.z);
  $float weights[$WEIGHTS];
$HOW  for ($int i = 0; i < $COUNT; ++i) {
    $precise $vec3 sum = vec3(0.0f);
    for ($uint corner = 0u; corner < 8u; ++corner) {
      $uint vertex = first + (corner & 1u) + vertices.x * ((corner >> 1u & 1u) + vertices.y * (corner >> 2u));
      for ($uint block = 0u; block < $BLOCKSu; ++block) {
        $uint at = 3u * ((vertex * ZONAL_GRID_BLOCKS + block) * $COUNTu + uint(i));
        sum += weights[corner * $BLOCKSu + block] * vec3(ZONAL_GRID(at), ZONAL_GRID(at + 1u), ZONAL_GRID(at + 2u));
      }
    }
    sh[i] = sum;
  }
}
)";
  const std::string plain = R"(  zonal_$METHOD_weights(t.x, t.y, t.z, cell_size, weights);
)";
  const std::string visible = R"(  $float seen[8];
  for ($uint corner = 0u; corner < 8u; ++corner) {
    $uvec3 bits = uvec3(corner & 1u, corner >> 1u & 1u, corner >> 2u);
    seen[corner] = zonal_seen_of_vertex(first + bits.x + vertices.x * (bits.y + vertices.y * bits.z), t, cell_size,
        vec3(bits), normal);
  }
  zonal_visible_$METHOD_weights(t.x, t.y, t.z, cell_size, seen, weights);
)";
  const std::string seen = R"(#ifndef ZONAL_VISIBILITY_RINGS  // of the vertices' maps
#define ZONAL_VISIBILITY_RINGS 4u
#endif
#ifndef $GUARDSEEN_OF_VERTEX
#define $GUARDSEEN_OF_VERTEX
$float zonal_seen_of_vertex($uint vertex, $vec3 t, $vec3 cell_size, $vec3 corner, $vec3 normal) {
  $uint side = 2u * ZONAL_VISIBILITY_RINGS + 1u;
  $uint first = vertex * (4u + 2u * side * side);
  $vec3 offset = vec3(ZONAL_VISIBILITY(first), ZONAL_VISIBILITY(first + 1u), ZONAL_VISIBILITY(first + 2u));
  $precise $vec3 place = zonal_visibility_place(t, cell_size, corner, offset, normal, float(ZONAL_VISIBILITY_RINGS));
  $uint column = min(uint(abs(place.y)), ZONAL_VISIBILITY_RINGS - 1u);
  $uint row = min(uint(abs(place.z)), ZONAL_VISIBILITY_RINGS - 1u);
  $float mean[4];
  $float variance[4];
  for ($uint i = 0u; i < 4u; ++i) {
    $uint x = column + (i & 1u);
    $uint y = row + (i >> 1u);
    x = place.y < 0.0f ? ZONAL_VISIBILITY_RINGS - x : ZONAL_VISIBILITY_RINGS + x;
    y = place.z < 0.0f ? ZONAL_VISIBILITY_RINGS - y : ZONAL_VISIBILITY_RINGS + y;
    $uint node = first + 4u + 2u * (x + side * y);
    mean[i] = ZONAL_VISIBILITY(node);
    variance[i] = ZONAL_VISIBILITY(node + 1u);
  }
  $precise $float share = zonal_seen_share(place.x, mean, variance, abs(place.y) - float(column),
      abs(place.z) - float(row));
  return ZONAL_VISIBILITY(first + 3u) * share;
}
#endif
)";
  constexpr int blocks = blocks_read(method);
  const std::string name = method == Interpolation::hermite ? "hermite" : "trilinear";
  return substitute(
      text,
      {{"$WHAT", is_visible ? "Coefficients at a surface in a grid, of what it sees of the grid's vertices; see "
                              "interpolate\n// (zonal/grid/interpolate_visible.hpp). `normal` is unit, or 0."
                            : "Coefficients at a position in a grid; see interpolate (zonal/grid/interpolate.hpp)."},
       {"$SEEN", is_visible ? seen : ""},
       {"$RECEIVER", is_visible ? "$vec3 normal, " : ""},
       {"$HOW", is_visible ? visible : plain},
       {"$COUNT", std::to_string(bands * bands)},
       {"$WEIGHTS", std::to_string(8 * blocks)},
       {"$BLOCKS", std::to_string(blocks)},
       {"$METHOD", name},
       {"$NAME", (is_visible ? "interpolate_visible_" : "interpolate_") + name},
       {"$N", std::to_string(bands)}});
}
template <Interpolation method, bool is_visible>
std::vector<ShellNeed> interpolate_needs(int) {
  if (!is_visible) return {{kernels::CellPosition::name}, {kernels::CellWeightsOf<method>::name}};
  return {{kernels::CellPosition::name},
          {kernels::VisibilityPlace::name},
          {kernels::SeenShare::name},
          {kernels::VisibleWeightsOf<method>::name}};
}

// ---- The discontinuity filter ---------------------------------------------------------------------------------------

// The choice is that of FilterWindow::chosen, here pixel by pixel: a shader compares no more pixels than it needs, and
// kernels know no bits.
template <bool is_down>
std::string filter_text(int bands) {
  const std::string text = R"(// What a pixel sees, as SurfacePicture (zonal/screen/surface.hpp) holds it.
#ifndef $GUARDLOAD_SURFACE
#define $GUARDLOAD_SURFACE
struct zonal_Surface {
  $vec3 position;
  $vec3 normal;
  $float depth;
  $float mesh;
  $float material;
};
zonal_Surface zonal_load_surface($uint x, $uint y, $uint pitch) {
  $uint at = 9u * y * pitch + x;
  zonal_Surface surface;
  surface.position = vec3(ZONAL_SURFACE(at), ZONAL_SURFACE(at + pitch), ZONAL_SURFACE(at + 2u * pitch));
  surface.normal = vec3(ZONAL_SURFACE(at + 3u * pitch), ZONAL_SURFACE(at + 4u * pitch), ZONAL_SURFACE(at + 5u * pitch));
  surface.depth = ZONAL_SURFACE(at + 6u * pitch);
  surface.mesh = ZONAL_SURFACE(at + 7u * pitch);
  surface.material = ZONAL_SURFACE(at + 8u * pitch);
  return surface;
}
bool zonal_sees_surface(zonal_Surface a, $uint x, $uint y, $uint pitch, $float cos_normal, $float plane_distance) {
  zonal_Surface b = zonal_load_surface(x, y, pitch);
  return zonal_is_same_surface(a.position, a.normal, a.depth, a.mesh, a.material,
                               b.position, b.normal, b.depth, b.mesh, b.material, cos_normal, plane_distance) > 0.5f;
}
#endif
// The $WHICH pass of the filter of incident radiance at pixel (x, y); see filter (zonal/screen/filter.hpp). Rows of
// planes are `pitch` numbers apart; `length`, 1 to 16: the pattern's $SIDE.
void zonal_$NAME_$N($uint x, $uint y, $uint width, $uint height, $uint pitch, $uint length, $float cos_normal,
    $float plane_distance, $precise out $vec3 sh[$COUNT]) {
  zonal_Surface surface = zonal_load_surface(x, y, pitch);
  $uint reach = length - 1u;
  $uint chosen = 0u;  // bit reach + offset
  $uint count = 0u;
  if (surface.mesh >= 0.0f) {
    chosen = 1u << reach;
    count = 1u;
  }
  for ($uint d = 1u; d < length; ++d) {
    // Of two pixels that see lights of one set, that in the window, else the other. A place below 0 is beyond the end.
    $uint after = $AT + d;
    $uint before = after - length;
    $uint first = d <= length / 2u ? after : before;
    $uint second = d <= length / 2u ? before : after;
    bool is_first = first < $END && zonal_sees_surface(surface, $FIRST, pitch, cos_normal, plane_distance);
    if (is_first || (second < $END && zonal_sees_surface(surface, $SECOND, pitch, cos_normal, plane_distance))) {
      chosen |= 1u << (reach + (is_first ? first : second) - $AT);
      ++count;
    }
  }
  $precise $float weight = count > 0u ? 1.0f / float(count) : 0.0f;
  for ($int i = 0; i < $COUNT; ++i) {
    $precise $vec3 sum = vec3(0.0f);
    for ($uint bit = 0u; bit <= 2u * reach; ++bit) {
      if ((chosen >> bit & 1u) != 0u) {
        $uint place = $AT + bit - reach;
        $uint at = ($ROW * $PLANESu + 3u * uint(i)) * pitch + $COLUMN;
        sum += vec3(ZONAL_PIXEL(at), ZONAL_PIXEL(at + pitch), ZONAL_PIXEL(at + 2u * pitch));
      }
    }
    sh[i] = sum * weight;
  }
}
)";
  return substitute(text, {{"$WHICH", is_down ? "second" : "first"},
                           {"$SIDE", is_down ? "rows" : "columns"},
                           {"$AT", is_down ? "y" : "x"},
                           {"$END", is_down ? "height" : "width"},
                           {"$FIRST", is_down ? "x, first" : "first, y"},
                           {"$SECOND", is_down ? "x, second" : "second, y"},
                           {"$ROW", is_down ? "place" : "y"},
                           {"$COLUMN", is_down ? "x" : "place"},
                           {"$COUNT", std::to_string(bands * bands)},
                           {"$PLANES", std::to_string(3 * bands * bands)},
                           {"$NAME", is_down ? "filter_down" : "filter_across"},
                           {"$N", std::to_string(bands)}});
}
inline std::vector<ShellNeed> filter_needs(int) { return {{kernels::IsSameSurface::name}}; }

}  // namespace detail

/// A gather as a shell: by its kernel, in one loop or in one for each order, of all lights or of some that were drawn.
template <int NE, Horizon horizon = Horizon::smoothstep, Symmetry symmetry = Symmetry::mirror, bool is_drawn = false>
struct Gather {
  static constexpr kernels::JoinedName name =
      kernels::hvl_name(is_drawn ? "gather_drawn" : "gather", NE, horizon, symmetry);
  template <bool is_reversed>
  static detail::GatherLoop loop() {
    return {NE, horizon, symmetry, is_reversed, {}, is_drawn};
  }
  template <bool is_reversed = false>
  static constexpr Shell shell(std::string_view the_name, std::string_view summary) {
    return {the_name, summary, [](int bands) { return detail::gather_needs(loop<is_reversed>(), bands); },
            [](int bands) { return detail::gather_text(loop<is_reversed>(), bands); }};
  }
  static constexpr Shell shell() {
    return shell(name.text, symmetry == Symmetry::zonal ? (NE == 1 ? "Diffuse ones, at such a receiver."
                                                                   : "At a receiver whose material is the same about "
                                                                     "the normal.")
                            : NE == 1                   ? "All virtual lights at a receiver, diffuse emission."
                                                        : "All virtual lights at a receiver, 3 bands of emission.");
  }
};

inline constexpr Shell shells[] = {
    Gather<3>::shell(),
    Gather<3>::shell<true>("gather_reversed", "The same, order by order."),
    Gather<1>::shell(),
    Gather<1>::shell<true>("gather_diffuse_reversed", "The same, order by order."),
    Gather<3, Horizon::exact>::shell(),
    Gather<1, Horizon::exact>::shell(),
    Gather<3, Horizon::none>::shell(),
    Gather<1, Horizon::none>::shell(),
    Gather<3, Horizon::smoothstep, Symmetry::zonal>::shell(),
    Gather<1, Horizon::smoothstep, Symmetry::zonal>::shell(),
    Gather<3, Horizon::exact, Symmetry::zonal>::shell(),
    Gather<1, Horizon::exact, Symmetry::zonal>::shell(),
    Gather<3, Horizon::none, Symmetry::zonal>::shell(),
    Gather<1, Horizon::none, Symmetry::zonal>::shell(),
    Gather<3, Horizon::smoothstep, Symmetry::mirror, true>::shell("gather_drawn",
                                                                  "Lights that a cut has drawn of all."),
    Gather<1, Horizon::smoothstep, Symmetry::mirror, true>::shell("gather_drawn_diffuse",
                                                                  "The same, diffuse emission."),
    Gather<3, Horizon::smoothstep, Symmetry::zonal, true>::shell("gather_drawn_zonal", "The same at such a receiver."),
    Gather<1, Horizon::smoothstep, Symmetry::zonal, true>::shell("gather_drawn_zonal_diffuse", "The same of both."),
    {"material_with_cosine", "A material's F at an outgoing direction: what the gathers take.", detail::material_needs,
     detail::material_text<true>},
    {"material_about_axis", "Its F of m = 0 alone: what the zonal gathers take.", detail::material_needs,
     detail::material_about_axis_text},
    {"material_without_cosine", "Its F', what virtual lights are made of.", detail::material_needs,
     detail::material_text<false>},
    {"sum_lights", "All sphere lights at a vertex of a grid, with gradients.", detail::sum_lights_needs<false>,
     detail::sum_lights_text<false>},
    {"sum_lights_reversed", "The same, order by order.", detail::sum_lights_needs<true>, detail::sum_lights_text<true>},
    {"interpolate_trilinear", "Coefficients anywhere in a grid.",
     detail::interpolate_needs<Interpolation::trilinear, false>,
     detail::interpolate_text<Interpolation::trilinear, false>},
    {"interpolate_hermite", "The same, from values and gradients.",
     detail::interpolate_needs<Interpolation::hermite, false>, detail::interpolate_text<Interpolation::hermite, false>},
    {"interpolate_visible_trilinear", "Coefficients at a surface in a grid, of what it sees of the vertices.",
     detail::interpolate_needs<Interpolation::trilinear, true>,
     detail::interpolate_text<Interpolation::trilinear, true>},
    {"interpolate_visible_hermite", "The same, from values and gradients.",
     detail::interpolate_needs<Interpolation::hermite, true>, detail::interpolate_text<Interpolation::hermite, true>},
    {"filter_across", "The discontinuity filter's first pass at a pixel, along its row.", detail::filter_needs,
     detail::filter_text<false>},
    {"filter_down", "Its second pass, along the column of what the first has left.", detail::filter_needs,
     detail::filter_text<true>},
};

/// How the text calls the shell.
inline std::string shell_name(const Shell& shell, int bands, const TextOptions& options) {
  return options.prefix + std::string(shell.name) + "_" + std::to_string(bands);
}

namespace detail {
/// What depends on a dialect of GLSL. An integer needs its precision as well: by default it has 16 bits in a fragment
/// shader.
inline std::string in_dialect(std::string text, const Dialect& dialect, const TextOptions& options) {
  std::vector<Substitution> words;
  for (const std::string type : {"float", "vec3", "uvec3", "uint", "int"}) {
    words.push_back({"$" + type, std::string(dialect.precision) + type});
  }
  words.push_back({"$precise ", options.precise ? std::string(dialect.precise) : ""});
  words.push_back({"$GUARD", upper_case(options.prefix)});
  words.push_back({"zonal_", options.prefix});
  return substitute(std::move(text), words);
}
}  // namespace detail

/// A shell in a dialect of GLSL.
inline std::string shell_text(const Shell& shell, int bands, const Dialect& dialect, const TextOptions& options = {}) {
  return detail::in_dialect(shell.text(bands), dialect, options);
}

/// Its signature alone, without what ends it.
inline std::string signature_text(const Shell& shell, int bands, const Dialect& dialect,
                                  const TextOptions& options = {}) {
  const std::string text = shell_text(shell, bands, dialect, options);
  const std::size_t begin = text.rfind('\n', text.find(shell_name(shell, bands, options) + "(")) + 1;
  return text.substr(begin, text.find(") {", begin) + 1 - begin);
}

/// The shell of this name, or null.
constexpr const Shell* find_shell(std::string_view name) {
  for (const Shell& shell : shells) {
    if (shell.name == name) return &shell;
  }
  return nullptr;
}

}  // namespace shader
}  // namespace ZONAL_TARGET
}  // namespace zonal
