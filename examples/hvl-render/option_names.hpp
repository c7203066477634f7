#pragma once

#include "options.hpp"
#include "shared/names.hpp"

namespace example::hvl_render {

inline const Names<Method> method_names{{"vpl", Method::vpl},   {"vsl", Method::vsl},
                                        {"vsgl", Method::vsgl}, {"vsgl-2024", Method::vsgl_2024},
                                        {"hvl", Method::hvl},   {"hvl-zonal", Method::hvl_zonal},
                                        {"path", Method::path}};
/// What --visibility says, as centre_visibility.
inline const Names<bool> visibility_names{{"none", false}, {"centre", true}};
inline const Names<HorizonRule> horizon_names{
    {"none", HorizonRule::none}, {"smoothstep", HorizonRule::smoothstep}, {"exact", HorizonRule::exact}};

}  // namespace example::hvl_render
