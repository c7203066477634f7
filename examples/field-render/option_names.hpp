#pragma once

#include <zonal/grid/interpolation_weights.hpp>

#include "shared/names.hpp"

namespace example::field_render {

inline const Names<zonal::Interpolation> interpolation_names{{"trilinear", zonal::Interpolation::trilinear},
                                                             {"hermite", zonal::Interpolation::hermite}};

}  // namespace example::field_render
