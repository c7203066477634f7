#pragma once

#include <vector>

#include <zonal/plan/material_plan.hpp>

#include "options.hpp"
#include "virtual_lights.hpp"

namespace example::hvl_render {

/// What a material needs, with its texture.
struct MaterialNeeds {
  zonal::CoefficientPlan receiving, emitting;
};

/// What the materials of a scene need. What is left out is next to nothing: the tolerance is for the lights.
struct ScenePlan {
  std::vector<MaterialNeeds> materials;
  int emission_bands = 1;  // of the one that needs most
};

ScenePlan plan_scene(const MaterialTables& tables, const Options& options);

}  // namespace example::hvl_render
