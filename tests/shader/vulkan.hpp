// A Vulkan driver without a window: compute shaders on buffers of floats, as driver.hpp has them for OpenGL.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

/// What a driver, or the compiler to SPIR-V, says of a shader or a call that it does not take.
struct VulkanError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Vulkan {
 public:
  /// Software first, which computes to the bit as C++ does. Null where there is none, and `reason` then says why.
  static std::unique_ptr<Vulkan> open(std::string& reason);
  ~Vulkan();
  Vulkan(const Vulkan&) = delete;
  Vulkan& operator=(const Vulkan&) = delete;

  /// The device's name of itself.
  const std::string& device() const { return device_; }
  bool is_software() const { return is_software_; }

  /// A compute shader of GLSL 4.50 as SPIR-V, by glslangValidator.
  static std::vector<std::uint32_t> compile(const std::string& compute_shader);

  /// What so many groups write to the buffer of binding 1, filled with NaN before, given that of binding 0. The
  /// shader's constant 0 is `constant`.
  std::vector<float> run(const std::vector<std::uint32_t>& shader, int constant, const std::vector<float>& numbers,
                         std::size_t result_count, unsigned groups);

 private:
  struct Functions;
  Vulkan();
  std::string start();  // the reason why not, or empty

  std::unique_ptr<Functions> vk_;
  std::string device_;
  bool is_software_ = false;
};
