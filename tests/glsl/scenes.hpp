// What the compute shaders of docs/examples take, of any size, and how they are run.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "driver.hpp"

class SceneRandom {
 public:
  explicit SceneRandom(unsigned seed) : random_(seed) {}
  float uniform(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random_); }
  glm::vec3 vector(float low, float high) {
    const float x = uniform(low, high), y = uniform(low, high), z = uniform(low, high);
    return {x, y, z};
  }
  glm::vec3 direction() {
    glm::vec3 v(0);
    while (!(glm::dot(v, v) > 0.01F)) v = vector(-1, 1);
    return glm::normalize(v);
  }
  /// A unit normal and a unit tangent.
  void append_frame(std::vector<float>& to) {
    const glm::vec3 normal = direction(), other = direction();
    const glm::vec3 flat = other - glm::dot(other, normal) * normal;
    append(to, normal);
    append(to, glm::dot(flat, flat) > 0 ? glm::normalize(flat) : glm::vec3(1, 0, 0));
  }
  static void append(std::vector<float>& to, const glm::vec3& v) { to.insert(to.end(), {v.x, v.y, v.z}); }

 private:
  std::mt19937 random_;
};

/// Virtual lights and receivers in a box, and a row of random coefficients for each receiver.
struct GatherScene {
  static constexpr std::size_t light_size = 22;  // of three bands of emission

  GatherScene(int bands, std::size_t lights_, std::size_t receivers_)
      : light_count(lights_), receiver_count(receivers_) {
    SceneRandom random(11);
    for (std::size_t i = 0; i < light_count; ++i) {
      SceneRandom::append(lights, random.vector(-1, 1));
      random.append_frame(lights);
      lights.push_back(random.uniform(0.02F, 1.5F));
      for (std::size_t k = 10; k < light_size; ++k) lights.push_back(random.uniform(-0.2F, 1));
    }
    for (std::size_t i = 0; i < receiver_count; ++i) {
      SceneRandom::append(receivers, random.vector(-1, 1));
      random.append_frame(receivers);
      for (int k = 0; k < 3 * bands * (bands + 1) / 2; ++k) materials.push_back(random.uniform(-0.2F, 1));
    }
  }

  std::size_t light_count, receiver_count;
  std::vector<float> lights, receivers, materials;
};

/// Sphere lights in and around a box of vertices.
struct GridScene {
  static constexpr std::size_t light_size = 7;

  GridScene(std::size_t lights_, const glm::ivec3& vertices) : light_count(lights_), resolution(vertices) {
    SceneRandom random(12);
    for (std::size_t i = 0; i < light_count; ++i) {
      SceneRandom::append(lights, random.vector(-3, 3));
      lights.push_back(random.uniform(0.01F, 1));
      SceneRandom::append(lights, random.vector(0, 1));
    }
  }

  glm::vec3 spacing() const { return (high - low) / glm::vec3(resolution - 1); }
  std::size_t vertex_count() const { return static_cast<std::size_t>(resolution.x * resolution.y * resolution.z); }
  glm::vec3 position(std::size_t vertex) const {
    const int v = static_cast<int>(vertex);
    return low +
           glm::vec3(v % resolution.x, v / resolution.x % resolution.y, v / (resolution.x * resolution.y)) * spacing();
  }

  glm::vec3 low{-1, -1, -1}, high{1, 1, 1};
  std::size_t light_count;
  glm::ivec3 resolution;
  std::vector<float> lights;
};

/// What a shader gave, and the least time it took of the times it was run.
struct ShaderRun {
  std::vector<float> values;
  double milliseconds;
};

namespace detail {
inline ShaderRun run_into(Driver& driver, unsigned program, const std::vector<std::vector<float>>& inputs,
                          std::size_t output_size, unsigned groups, int times) {
  std::vector<unsigned> buffers;
  for (const auto& values : inputs) buffers.push_back(driver.make_buffer(values));
  // Filled with what no shader writes.
  buffers.push_back(driver.make_buffer(std::vector<float>(output_size, std::numeric_limits<float>::quiet_NaN())));
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < times; ++i) {
    const double time = driver.run(program, buffers, groups);
    if (time < least) least = time;
  }
  ShaderRun result{driver.read_buffer(buffers.back(), output_size), least};
  for (const unsigned buffer : buffers) driver.delete_buffer(buffer);
  driver.delete_program(program);
  return result;
}
}  // namespace detail

/// docs/examples/gather.comp.
inline ShaderRun run_gather(Driver& driver, const GatherScene& scene, const std::string& source, int times = 1) {
  const unsigned program = driver.compile(source);
  driver.set_uniform(program, "light_count", static_cast<unsigned>(scene.light_count));
  driver.set_uniform(program, "receiver_count", static_cast<unsigned>(scene.receiver_count));
  return detail::run_into(driver, program, {scene.lights, scene.receivers, scene.materials}, 3 * scene.receiver_count,
                          static_cast<unsigned>((scene.receiver_count + 63) / 64), times);
}

/// docs/examples/grid.comp.
inline ShaderRun run_grid(Driver& driver, const GridScene& scene, int bands, const std::string& source, int times = 1) {
  const unsigned program = driver.compile(source);
  const glm::vec3 spacing = scene.spacing();
  driver.set_uniform(program, "light_count", static_cast<unsigned>(scene.light_count));
  driver.set_uniform(program, "vertices_x", static_cast<unsigned>(scene.resolution.x));
  driver.set_uniform(program, "vertices_y", static_cast<unsigned>(scene.resolution.y));
  driver.set_uniform(program, "vertices_z", static_cast<unsigned>(scene.resolution.z));
  driver.set_uniform(program, "low", scene.low.x, scene.low.y, scene.low.z);
  driver.set_uniform(program, "spacing", spacing.x, spacing.y, spacing.z);
  return detail::run_into(driver, program, {scene.lights},
                          12 * static_cast<std::size_t>(bands * bands) * scene.vertex_count(),
                          static_cast<unsigned>((scene.vertex_count() + 15) / 16), times);
}
