#include "gather_bands.hpp"

namespace example::hvl_render {

template std::unique_ptr<Gatherer> make_gatherer_with<zonal::Horizon::smoothstep>(
    const std::vector<zonal::VirtualLight>& lights, int bands, int emission_bands);

}  // namespace example::hvl_render
