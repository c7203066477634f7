#include "lighting_bands.hpp"

template class example::grid_render::LightingOf<5>;
