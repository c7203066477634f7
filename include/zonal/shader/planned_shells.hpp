// What a plan keeps, as shader functions: for each material what is read of its table and the gather that takes it, and
// one function around them that shades. In GLSL, as the other loops (shells.hpp), of whose macros they read
//
//   ZONAL_LIGHT(i)     float number i of the lights: shader_buffer(HvlCache<emission_bands>)
//   ZONAL_MATERIAL(i)  float number i of the materials: shader_buffer(KeptTable), one after the other
//
// or, where the plan has 16 bits for a coefficient, in place of the second
//
//   ZONAL_MATERIAL_PAIR(i)  unsigned integer number i of packed_halves(materials)
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "../plan/material_plan.hpp"
#include "shells.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace shader {

/// What shaders ask of a scene's plan. Of each material what receivers need of it; emission bands are 1 or 3, and no
/// material is without symmetry.
struct PlannedMaterials {
  std::vector<CoefficientPlan> receiving;
  int emission_bands = 3;
  Horizon horizon = Horizon::smoothstep;
  int coefficient_bits = 32;  // or 16
};

/// Texts, and the recorded functions that they call, each with its number of bands.
struct PlannedShells {
  struct Need {
    ShellNeed function;
    int bands;
  };
  std::vector<Need> needs;
  std::vector<NamedText> shells;
};

namespace detail {

/// A class of materials, of one plan.
struct PlannedClass {
  GatherLoop gather;
  int bands;

  /// What is kept, by coefficient_index; a material of which nothing is kept has its first coefficient, which is zero.
  PlannedClass(const PlannedMaterials& plan, const CoefficientPlan& receiving)
      : gather{plan.emission_bands, plan.horizon, receiving.symmetry}, bands(receiving.bands) {
    for (int l = 0; l < bands; ++l) {
      for (int m = 0; m <= l && has_order(receiving.symmetry, m); ++m) gather.kept.push_back(receiving.keeps(l, m));
    }
    if (gather.material_size(bands) == 0) gather.kept[0] = true;
  }
  int size() const { return gather.material_size(bands); }
  std::string name() const { return gather.name() + "_" + std::to_string(bands) + gather.part().suffix(); }
};

inline std::string planned_material_name(int size) { return "material_kept_" + std::to_string(size); }
inline std::string planned_material_text(int size) {
  return read_material_text(planned_material_name(size),
                            std::to_string(size) +
                                " coefficients that a plan keeps, at the outgoing direction of this "
                                "cosine; see MaterialTable::with_cosine",
                            "", "uint(i)", size);
}

inline std::string halves_text() {
  return R"(#ifndef ZONAL_MATERIAL
#define ZONAL_MATERIAL(i) (unpackHalf2x16(ZONAL_MATERIAL_PAIR((i) >> 1u))[(i) & 1u])
#endif
)";
}

/// if (material == 0u || material == 2u) ..., a class after the other; the last of them is for all others.
inline std::string planned_gather_text(const std::vector<PlannedClass>& classes,
                                       const std::vector<std::size_t>& class_of) {
  std::string choices;
  for (std::size_t k = 0; k < classes.size(); ++k) {
    std::string condition;
    for (std::size_t i = 0; i < class_of.size(); ++i) {
      if (class_of[i] == k) condition += (condition.empty() ? "" : " || ") + ("material == " + std::to_string(i) + "u");
    }
    const bool is_last = k + 1 == classes.size();
    const std::string choice = R"(  $IF{
    $vec3 f[$SIZE];
    zonal_$MATERIAL(table, cos_outgoing, f);
    return zonal_$GATHER(light_count, position, normal, $TANGENTf);
  }
)";
    const bool is_zonal = classes[k].gather.symmetry == Symmetry::zonal;
    choices += substitute(choice, {{"$IF", is_last ? "" : "if (" + condition + ") "},
                                   {"$SIZE", std::to_string(classes[k].size())},
                                   {"$MATERIAL", planned_material_name(classes[k].size())},
                                   {"$GATHER", classes[k].name()},
                                   {"$TANGENT", is_zonal ? "" : "zonal_tangent_towards(normal, to_eye), "}});
  }
  const std::string text =
      R"(// The outgoing radiance that all virtual lights cause at a surface of the material that has this number in the plan.
// `table` is the number of the first float of its table; see KeptTable and shader_buffer (zonal/shader/buffers.hpp).
$vec3 zonal_gather_planned($uint material, $uint table, $uint light_count, $vec3 position, $vec3 normal, $vec3 to_eye) {
  $precise $float cos_outgoing = normal.x * to_eye.x + normal.y * to_eye.y + normal.z * to_eye.z;
$CHOICES}
)";
  return substitute(text, {{"$CHOICES", choices}});
}

}  // namespace detail

/// The shells of a plan, of one material at least: `<prefix>gather_planned` calls the others.
inline PlannedShells planned_shells(const PlannedMaterials& plan, const Dialect& dialect,
                                    const TextOptions& options = {}) {
  std::vector<detail::PlannedClass> classes;
  std::vector<std::size_t> class_of;  // by material
  PlannedShells result;
  const auto add = [&](const std::string& name, const std::string& text) {
    for (const NamedText& shell : result.shells) {
      if (shell.name == options.prefix + name) return;
    }
    result.shells.push_back({options.prefix + name, detail::in_dialect(text, dialect, options)});
  };
  if (plan.coefficient_bits == 16) add("material_halves", detail::halves_text());
  for (const ShellNeed& need : detail::material_needs(0)) result.needs.push_back({need, 1});
  for (const CoefficientPlan& receiving : plan.receiving) {
    const detail::PlannedClass its(plan, receiving);
    std::size_t number = 0;
    while (number < classes.size() && classes[number].name() != its.name()) ++number;
    class_of.push_back(number);
    if (number < classes.size()) continue;
    classes.push_back(its);
    if (receiving.symmetry != Symmetry::zonal) result.needs.push_back({{kernels::TangentTowards::name}, 1});
    for (const ShellNeed& need : detail::gather_needs(its.gather, its.bands)) result.needs.push_back({need, its.bands});
    add(detail::planned_material_name(its.size()), detail::planned_material_text(its.size()));
    add(its.name(), detail::gather_text(its.gather, its.bands));
  }
  add("gather_planned", detail::planned_gather_text(classes, class_of));
  return result;
}

}  // namespace shader
}  // namespace ZONAL_TARGET
}  // namespace zonal
