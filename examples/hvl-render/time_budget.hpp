#pragma once

#include "gatherer.hpp"
#include "shared/ray_caster.hpp"

namespace example::hvl_render {

/// How many lights, a square number, the method can shoot and gather within the options' budget: by its time for some
/// of the picture's hits, at two numbers of lights and then at the one chosen. At least 1. `materials` are the
/// method's.
int lights_within_budget(const Scene& scene, const RayCaster& caster, const MaterialTables& materials,
                         const Options& options);

}  // namespace example::hvl_render
