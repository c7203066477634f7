#pragma once

#include "gatherer.hpp"
#include "shared/ray_caster.hpp"

namespace example::hvl_render {

/// How many lights, a square number, the method can shoot and gather within the options' budget: the most that keep it
/// by the time taken for some of the picture's hits. At least 1. `materials` are the method's.
int lights_within_budget(const Scene& scene, const RayCaster& caster, const MaterialTables& materials,
                         const Options& options);

}  // namespace example::hvl_render
