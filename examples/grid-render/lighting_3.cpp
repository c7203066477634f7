#include "lighting_bands.hpp"

template class example::grid_render::LightGridOf<3>;
template class example::grid_render::LightingOf<3, example::grid_render::Sphere>;
