// The functions as SPIR-V, by glslangValidator, on a Vulkan driver, against their records: to the bit where the driver
// computes on the CPU, as lavapipe does.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "../catch.hpp"
#include "function_shader.hpp"
#include "shader_functions.hpp"
#include "vulkan.hpp"

// Those for colours repeat the others' operations, three times.
TEST_CASE("Every function, at 2 bands, is in SPIR-V on a Vulkan driver what its record is") {
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
  for (const zonal::shader::FunctionEntry& entry : zonal_glsl::shader_functions()) {
    if (entry.name.find("_colour") != std::string_view::npos) continue;
    const int bands = std::min(2, entry.most_bands);
    const auto function = entry.record(bands, zonal::shader::all_orders);
    check_as_recorded(function, bands, vulkan->is_software(), [&](const std::vector<float>& numbers) {
      return vulkan->run(Vulkan::compile(function_shader(function, options)), numbers,
                         sample_count * static_cast<std::size_t>(output_count(function)), sample_groups);
    });
  }
}
