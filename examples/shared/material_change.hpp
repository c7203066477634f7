#pragma once

#include <string>
#include <vector>

#include "scene.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace example {

/// NAME=SPEC of --material: which of the scene's materials, * for all, becomes what.
struct MaterialChange {
  std::string name, spec;
};

/// What a spec can be, for --help and for errors.
std::string material_specs();

/// --material, which may be repeated.
CLI::Option* add_material_option(CLI::App& app, std::vector<MaterialChange>& changes);

/// Throws InputError where there is no '='.
MaterialChange parse_material_change(const std::string& text);

/// In the order given. Throws InputError for a name the scene does not have, a spec that is none, and a file that
/// cannot be read.
void apply(const std::vector<MaterialChange>& changes, std::vector<Material>& materials);

}  // namespace example
