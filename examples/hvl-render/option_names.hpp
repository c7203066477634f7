#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "options.hpp"

namespace hvl_render {

/// What the values of an enumeration are called on the command line and in reports, in --help's order.
template <class Value>
using Names = std::vector<std::pair<std::string, Value>>;

inline const Names<Method> method_names{{"hvl", Method::hvl}, {"path", Method::path}};
inline const Names<HorizonRule> horizon_names{{"smoothstep", HorizonRule::smoothstep}, {"exact", HorizonRule::exact}};
inline const Names<WindowRule> window_names{
    {"none", WindowRule::none}, {"hann", WindowRule::hann}, {"sinc", WindowRule::sinc}};
inline const Names<ToneMap> tone_names{{"filmic", ToneMap::filmic}, {"clamp", ToneMap::clamp}};

template <class Value>
std::string name_of(const Names<Value>& names, Value value) {
  const auto found = std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.second == value; });
  return found->first;
}

}  // namespace hvl_render
