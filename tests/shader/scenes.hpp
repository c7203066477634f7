// What the compute shaders of docs/examples take, of any size, and how they are run.
#pragma once

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <zonal/screen/filter.hpp>
#include <zonal/shader/buffers.hpp>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
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
  /// On the normal's side.
  glm::vec3 direction_above(const glm::vec3& normal) {
    const glm::vec3 v = direction();
    return glm::dot(v, normal) < 0 ? -v : v;
  }
  static void append(std::vector<float>& to, const glm::vec3& v) { to.insert(to.end(), {v.x, v.y, v.z}); }

 private:
  std::mt19937 random_;
};

/// A material of random coefficients: of 90 rows, or of one.
inline zonal::MaterialTable random_material(SceneRandom& random, int bands, int rows) {
  std::vector<glm::vec3> f[2];
  for (auto& coefficients : f) {
    for (int i = 0; i < rows * bands * (bands + 1) / 2; ++i) coefficients.push_back(random.vector(-0.2F, 1));
  }
  return {bands, rows, 0.0, std::move(f[0]), zonal::MirroredRows(std::move(f[1]))};
}

/// Virtual lights and receivers in a box, in turn of two materials: one of `bands` bands, and one of 3 and a single
/// row.
struct GatherScene {
  GatherScene(int bands, std::size_t light_count_, std::size_t receiver_count_)
      : light_count(light_count_), receiver_count(receiver_count_) {
    SceneRandom random(11);
    tables.push_back(random_material(random, bands, zonal::MaterialTable::max_angles));
    tables.push_back(random_material(random, 3, 1));
    std::vector<zonal::VirtualLight> virtual_lights(light_count);
    for (std::size_t i = 0; i < light_count; ++i) {
      zonal::VirtualLight& light = virtual_lights[i];
      light.position = random.vector(-1, 1);
      light.normal = random.direction();
      light.to_primary = random.direction_above(light.normal);
      light.radius = random.uniform(0.02F, 1.5F);
      light.flux = random.vector(0.1F, 1) * (light.radius * light.radius);
      light.material = &tables[i % 2];
    }
    cache = zonal::HvlCache<3>(virtual_lights);
    lights = shader_buffer(cache);

    std::size_t begins[2];
    for (std::size_t i = 0; i < 2; ++i) {
      begins[i] = materials.size();
      const std::vector<float> floats = shader_buffer(tables[i]);
      materials.insert(materials.end(), floats.begin(), floats.end());
    }
    for (std::size_t i = 0; i < receiver_count; ++i) {
      zonal::Receiver& receiver = receivers.emplace_back();
      receiver.position = random.vector(-1, 1);
      receiver.normal = random.direction();
      receiver.outgoing = random.direction_above(receiver.normal);
      for (const auto& v : {receiver.position, receiver.normal, receiver.outgoing}) SceneRandom::append(places, v);
      places.push_back(static_cast<float>(begins[i % 2]));
    }
  }

  const zonal::MaterialTable& material_of(std::size_t receiver) const { return tables[receiver % 2]; }

  std::size_t light_count, receiver_count;
  std::vector<zonal::MaterialTable> tables;
  zonal::HvlCache<3> cache;
  std::vector<zonal::Receiver> receivers;
  std::vector<float> lights, materials, places;  // what the shader reads
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
  /// The longest side of a cell.
  float cell() const { return std::max({spacing().x, spacing().y, spacing().z}); }
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

/// Pixels with steps, tilts, other meshes and materials, and holes, and what they are shaded by.
template <int N>
struct ScreenScene {
  static constexpr std::size_t shading_size = 13;

  ScreenScene(int width, int height, unsigned seed) : surfaces(width, height), radiance(width, height) {
    SceneRandom random(seed);
    const auto rarely = [&] { return random.uniform(0, 1) < 0.1F; };
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        zonal::Sh<N, glm::vec3> sh;
        for (int i = 0; i < N * N; ++i) sh[i] = random.vector(-1, 1);
        radiance.set_at(x, y, sh);
        const glm::vec3 normal = random.direction();
        for (const auto& v : {normal, random.direction_above(normal), random.vector(0, 1), random.vector(0, 1)}) {
          SceneRandom::append(shading, v);
        }
        shading.push_back(random.uniform(1, 50));
        const float tilt = rarely() ? 1.0F : 0.0F, step = rarely() ? 0.2F : 0.0F;
        const glm::vec3 place(0.01F * float(x), step + random.uniform(0, 0.001F), 0.01F * float(y));
        const std::uint32_t mesh = rarely() ? 1 : 0, material = rarely() ? 1 : 0;
        if (rarely()) continue;
        surfaces.set_surface(x, y, place, {std::sin(tilt), std::cos(tilt), 0}, 5, mesh, material);
      }
    }
  }

  zonal::SurfacePicture surfaces;
  zonal::RadiancePicture<N> radiance;
  std::vector<float> shading;
};

/// What a shader gave, and the least time it took of the times it was run.
struct ShaderRun {
  std::vector<float> values;
  double milliseconds;
};

namespace detail {
/// An unsigned integer among floats.
inline float as_float(unsigned value) { return std::bit_cast<float>(value); }

inline ShaderRun run_into(Driver& driver, unsigned program, const std::vector<std::vector<float>>& inputs,
                          const std::vector<float>& uniforms, std::size_t output_size, unsigned groups, int times) {
  std::vector<unsigned> buffers;
  for (const auto& values : inputs) buffers.push_back(driver.make_buffer(values));
  // Filled with what no shader writes.
  buffers.push_back(driver.make_buffer(std::vector<float>(output_size, std::numeric_limits<float>::quiet_NaN())));
  const unsigned uniform_buffer = driver.make_buffer(uniforms);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < times; ++i) {
    const double time = driver.run(program, buffers, groups, uniform_buffer);
    if (time < least) least = time;
  }
  ShaderRun result{driver.read_buffer(buffers.back(), output_size), least};
  for (const unsigned buffer : buffers) driver.delete_buffer(buffer);
  driver.delete_buffer(uniform_buffer);
  driver.delete_program(program);
  return result;
}
}  // namespace detail

/// docs/examples/gather.comp.
inline ShaderRun run_gather(Driver& driver, const GatherScene& scene, const std::string& source, int times = 1) {
  const unsigned program = driver.compile(source);
  const std::vector<float> uniforms{detail::as_float(static_cast<unsigned>(scene.light_count)),
                                    detail::as_float(static_cast<unsigned>(scene.receiver_count))};
  return detail::run_into(driver, program, {scene.lights, scene.materials, scene.places}, uniforms,
                          3 * scene.receiver_count, static_cast<unsigned>((scene.receiver_count + 63) / 64), times);
}

/// docs/examples/grid.comp.
inline ShaderRun run_grid(Driver& driver, const GridScene& scene, int bands, const std::string& source, int times = 1) {
  const unsigned program = driver.compile(source);
  // A vec3 begins at a multiple of four.
  std::vector<float> uniforms;
  for (int axis = 0; axis < 3; ++axis) {
    uniforms.push_back(detail::as_float(static_cast<unsigned>(scene.resolution[axis])));
  }
  uniforms.push_back(detail::as_float(static_cast<unsigned>(scene.light_count)));
  SceneRandom::append(uniforms, scene.low);
  uniforms.push_back(0);
  SceneRandom::append(uniforms, scene.spacing());
  uniforms.push_back(0);
  return detail::run_into(driver, program, {scene.lights}, uniforms,
                          12 * static_cast<std::size_t>(bands * bands) * scene.vertex_count(),
                          static_cast<unsigned>((scene.vertex_count() + 15) / 16), times);
}

/// A pass of docs/examples/screen.comp: the first leaves a buffer of coefficients, the second takes it and leaves RGB.
template <int N>
ShaderRun run_screen(Driver& driver, const ScreenScene<N>& scene, const zonal::InterleavedPattern& pattern,
                     const std::string& source, const std::vector<float>& pixels, std::size_t output_size) {
  const unsigned program = driver.compile(source);
  const zonal::SurfaceTests tests;
  const auto count = static_cast<unsigned>(scene.surfaces.width() * scene.surfaces.height());
  std::vector<float> uniforms;
  for (const auto size : {unsigned(scene.surfaces.width()), unsigned(scene.surfaces.height()),
                          unsigned(scene.surfaces.pitch()), unsigned(pattern.columns), unsigned(pattern.rows)}) {
    uniforms.push_back(detail::as_float(size));
  }
  uniforms.insert(uniforms.end(), {tests.cos_normal, tests.plane_distance, 0});
  return detail::run_into(driver, program, {shader_buffer(scene.surfaces), pixels, scene.shading}, uniforms,
                          output_size, (count + 63) / 64, 1);
}
