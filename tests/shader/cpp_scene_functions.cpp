#include "run_from_list.hpp"

bool run_scene_function(std::string_view function, int bands, int order, const std::vector<float>& inputs,
                        std::vector<float>& outputs);

bool run_scene_function(std::string_view function, int bands, int order, const std::vector<float>& inputs,
                        std::vector<float>& outputs) {
  return run_from_list<zonal::kernels::SceneKernels>(function, bands, order, inputs, outputs);
}
