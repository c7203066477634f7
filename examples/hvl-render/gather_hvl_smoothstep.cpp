#include "gather_hvl.hpp"
#include "planned_hvl.hpp"

namespace example::hvl_render {

template std::unique_ptr<Gatherer> make_hvl<zonal::Horizon::smoothstep>(const GatherInput& input);
template std::unique_ptr<PlannedGatherer> make_planned_hvl<zonal::Horizon::smoothstep>(const GatherInput& input,
                                                                                       const ScenePlan& plan);

}  // namespace example::hvl_render
