#pragma once

#include "options.hpp"
#include "shared/names.hpp"

namespace example::igi_render {

inline const Names<Filter> filter_names{{"radiance", Filter::radiance},
                                        {"irradiance", Filter::irradiance},
                                        {"irradiance-strict", Filter::irradiance_strict},
                                        {"sg", Filter::gaussian},
                                        {"l1", Filter::first_degree},
                                        {"none", Filter::none}};

inline const Names<Lighting> lighting_names{
    {"spot", Lighting::spot}, {"three", Lighting::three}, {"area", Lighting::area}, {"probe", Lighting::probe}};

}  // namespace example::igi_render
