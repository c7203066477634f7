#pragma once

#include <cstddef>
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
  int emission_bands = 1;     // of the one that needs most
  int coefficient_bits = 32;  // in receivers' tables: 16 where that adds a twentieth of the tolerance at most,
  double half_error = 0;      // this much of it
};

/// Bytes that materials' tables take: as planned, and before.
struct TableBytes {
  std::size_t planned = 0, full = 0;
};

ScenePlan plan_scene(const MaterialTables& tables, const Options& options);

/// Leaves the tables what the plan keeps.
TableBytes keep_planned(MaterialTables& tables, const ScenePlan& plan);

}  // namespace example::hvl_render
