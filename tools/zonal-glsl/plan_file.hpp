#pragma once

#include <string>

#include <zonal/shader/planned_shells.hpp>

namespace zonal_glsl {

/// The plan of a JSON file, or of a report that has one as "plan"; docs/rooms/plan.md says what is in it. RequestError
/// for what is none, with its place, and for what shaders have no functions for.
zonal::shader::PlannedMaterials read_plan(const std::string& path);

}  // namespace zonal_glsl
