#pragma once

#include "options.hpp"
#include "shared/names.hpp"

namespace example::hvl_render {

inline const Names<Method> method_names{{"hvl", Method::hvl}, {"path", Method::path}};
inline const Names<HorizonRule> horizon_names{{"smoothstep", HorizonRule::smoothstep}, {"exact", HorizonRule::exact}};

}  // namespace example::hvl_render
