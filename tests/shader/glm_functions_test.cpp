// The GLSL text as C++, through GLM: two compilers, one text.
#include <glm/glm.hpp>

#include <map>
#include <string>
#include <vector>

#include "../catch.hpp"
#include "caller.hpp"
#include "compare.hpp"
#include "inputs.hpp"
#include "interpret.hpp"
#include "shader_functions.hpp"

namespace as_glsl {

const float* numbers;
float* results;

// An array of C++ is a reference to its elements, as out and inout are.
#define in
#define out
#define inout
using namespace glm;
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif
#include "glm_functions.inl"
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
#undef in
#undef out
#undef inout

}  // namespace as_glsl

TEST_CASE("The GLSL text compiled as C++ is to the bit what the kernels are") {
  for (const auto& entry : zonal_glsl::shader_functions()) {
    for (const int bands : {1, 2, 4}) {
      if (!entry.has_bands && bands > 1) continue;
      const auto function = entry.record(bands, zonal::shader::all_orders);
      INFO(function.name);
      InputSampler sampler(8, bands);
      for (int i = 0; i < 300; ++i) {
        const std::vector<float> inputs = sampler.draw(function.parameters);
        std::vector<float> given(static_cast<std::size_t>(output_count(function)));
        as_glsl::numbers = inputs.data();
        as_glsl::results = given.data();
        as_glsl::callers.at(function.name)(0, 0);
        require_equal(given, interpret(function, inputs), true, [&] { return inputs; });
      }
    }
  }
}
