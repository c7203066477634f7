#include "lighting_bands.hpp"
#include "planned_lighting.hpp"

template class example::grid_render::LightGridOf<9, zonal::GridContent::values>;
template class example::grid_render::LightGridOf<9, zonal::GridContent::values_and_gradients>;
template class example::grid_render::LightingOf<9, example::grid_render::Sphere>;
template class example::grid_render::PlannedLightingOf<9>;
