#pragma once

#include <string>
#include <vector>

#include "shared/scene.hpp"

namespace example::hvl_render {

/// NAME=SPEC of --material: which of the scene's materials, * for all, becomes what.
struct MaterialChange {
  std::string name, spec;
};

/// What a spec can be, for --help and for errors.
std::string material_specs();

/// Throws InputError where there is no '='.
MaterialChange parse_material_change(const std::string& text);

/// In the order given. Throws InputError for a name the scene does not have, a spec that is none, and a file that
/// cannot be read.
void apply(const std::vector<MaterialChange>& changes, std::vector<Material>& materials);

}  // namespace example::hvl_render
