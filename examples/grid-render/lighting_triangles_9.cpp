#include "lighting_bands.hpp"

template class example::grid_render::LightingOf<9, example::grid_render::Triangle>;
