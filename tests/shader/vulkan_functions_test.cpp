// The functions as SPIR-V, by glslangValidator, on a Vulkan driver, against their records: to the bit where the driver
// computes on the CPU, as lavapipe does.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string_view>
#include <vector>

#include "../catch.hpp"
#include "function_shader.hpp"
#include "shader_functions.hpp"
#include "vulkan.hpp"

// Those for colours repeat the others' operations, three times.
TEST_CASE("Every function, at 2 bands, is in SPIR-V on a Vulkan driver what its record is") {
  constexpr int bands = 2;
  std::string reason;
  const auto vulkan = Vulkan::open(reason);
  if (vulkan == nullptr) {
    std::printf("skipped: no Vulkan driver: %s\n", reason.c_str());
    return;
  }
  if (std::system("glslangValidator --version > /dev/null 2>&1") != 0) {
    std::printf("skipped: no glslangValidator (Debian package: glslang-tools)\n");
    return;
  }
  INFO(vulkan->device());
  zonal::shader::TextOptions options;
  options.precise = true;
  std::vector<zonal::shader::RecordedFunction> functions;
  for (const zonal::shader::FunctionEntry& entry : zonal_glsl::shader_functions()) {
    if (entry.name.find("_colour") != std::string_view::npos) continue;
    functions.push_back(entry.record(std::min(bands, entry.most_bands), zonal::shader::all_orders));
  }
  // Several to a shader, as the compiler takes long to start: each is the pipeline of another constant. The driver
  // reads all of the shader for each.
  constexpr std::size_t together = 6;
  for (std::size_t first = 0; first < functions.size(); first += together) {
    std::vector<std::reference_wrapper<const zonal::shader::RecordedFunction>> some;
    for (std::size_t i = first; i < std::min(first + together, functions.size()); ++i) some.push_back(functions[i]);
    const auto shader = Vulkan::compile("#version 450\nlayout(constant_id = 0) const int which = 0;\n" +
                                        function_shader(some, "which", options));
    for (std::size_t i = 0; i < some.size(); ++i) {
      check_as_recorded(some[i], bands, vulkan->is_software(), [&](const std::vector<float>& numbers) {
        return vulkan->run(shader, static_cast<int>(i), numbers,
                           sample_count * static_cast<std::size_t>(output_count(some[i])), sample_groups);
      });
    }
  }
}
