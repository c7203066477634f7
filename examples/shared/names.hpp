#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <zonal/transform/window.hpp>

#include "image.hpp"
#include "scene.hpp"

namespace example {

/// What the values of an enumeration are called on the command line and in reports, in --help's order.
template <class Value>
using Names = std::vector<std::pair<std::string, Value>>;

template <class Value>
std::string name_of(const Names<Value>& names, Value value) {
  const auto found = std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.second == value; });
  return found->first;
}

inline const Names<ToneMap> tone_names{{"filmic", ToneMap::filmic}, {"clamp", ToneMap::clamp}};
inline const Names<AtriumFinish> atrium_names{{"atrium", AtriumFinish::mixed},
                                              {"atrium-diffuse", AtriumFinish::diffuse},
                                              {"atrium-glossy", AtriumFinish::glossy},
                                              {"atrium-bumped", AtriumFinish::bumped},
                                              {"atrium-bumped-glossy", AtriumFinish::bumped_glossy},
                                              {"courtyard", AtriumFinish::courtyard}};
inline const Names<UpAxis> up_names{{"y", UpAxis::y}, {"z", UpAxis::z}};
inline const Names<ViewPlace> place_names{
    {"auto", ViewPlace::automatic}, {"inside", ViewPlace::inside}, {"outside", ViewPlace::outside}};
inline const Names<zonal::Window> window_names{
    {"none", zonal::Window::none}, {"hann", zonal::Window::hann}, {"sinc", zonal::Window::sinc}};

}  // namespace example
