#include "lighting_bands.hpp"

template class example::grid_render::LightGridOf<7>;
template class example::grid_render::LightingOf<7, example::grid_render::Sphere>;
