#pragma once

#include "options.hpp"
#include "shared/names.hpp"

namespace example::grid_render {

inline const Names<Method> method_names{{"none", std::nullopt},
                                        {"trilinear", zonal::Interpolation::trilinear},
                                        {"taylor", zonal::Interpolation::taylor},
                                        {"hermite", zonal::Interpolation::hermite}};

inline const Names<Shape> shape_names{
    {"spheres", Shape::spheres}, {"triangles", Shape::triangles}, {"triangle-spheres", Shape::triangle_spheres}};

}  // namespace example::grid_render
