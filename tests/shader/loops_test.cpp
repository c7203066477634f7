// A whole gather and a whole grid on the driver, by the compute shaders of docs/examples, against the same loops over
// the same kernels in C++.
#include <zonal/grid/add_lights.hpp>
#include <zonal/grid/interpolate.hpp>
#include <zonal/grid/interpolate_visible.hpp>
#include <zonal/lobe/lambert.hpp>
#include <zonal/lobe/phong.hpp>
#include <zonal/screen/shade.hpp>
#include <zonal/transform/convolve.hpp>

#include <algorithm>
#include <chrono>
#include <limits>
#include <random>
#include <type_traits>

#include "../catch.hpp"
#include "compare.hpp"
#include "cpp_functions.hpp"
#include "driver.hpp"
#include "example.hpp"
#include "scenes.hpp"
#include "shader_functions.hpp"

namespace {

using zonal::shader::all_orders;

/// The orders that a shell sums apart: all at once, or one after the other.
std::vector<int> orders_of(const std::string& shell, const char* function, int bands) {
  if (shell.find("reversed") == std::string::npos) return {all_orders};
  std::vector<int> orders;
  for (int m = 0; m < zonal_glsl::find_function(function)->order_count(bands); ++m) orders.push_back(m);
  return orders;
}

template <class Range>
void append(std::vector<float>& to, const Range& range) {
  to.insert(to.end(), std::begin(range), std::end(range));
}
std::vector<float> slice(const std::vector<float>& from, std::size_t first, std::size_t count) {
  return {from.begin() + static_cast<std::ptrdiff_t>(first), from.begin() + static_cast<std::ptrdiff_t>(first + count)};
}

/// What the shell's loop over lights gives at receiver number i: the kernel of the registry with the numbers of the
/// buffer, and the material as MaterialTable reads it.
std::vector<float> gather_in_cpp(const GatherScene& scene, const std::string& shell, int bands, std::size_t i) {
  constexpr std::size_t light_size = 22, emission_size = 4;
  const zonal::Receiver& receiver = scene.receivers[i];
  const glm::vec3 tangent = zonal::detail::tangent_towards(receiver.normal, receiver.outgoing);
  const auto material = scene.material_of(i).with_cosine<6>(glm::dot(receiver.normal, receiver.outgoing));
  std::vector<float> of_receiver;
  for (const glm::vec3& v : {receiver.position, receiver.normal, tangent}) SceneRandom::append(of_receiver, v);
  for (int k = 0; k < zonal::even_index(bands, 0); ++k) SceneRandom::append(of_receiver, material[k]);
  float sum[3] = {0, 0, 0};
  for (const int order : orders_of(shell, "hvl_radiance", bands)) {
    for (std::size_t light = 0; light < scene.light_count; ++light) {
      const std::size_t at = light * light_size;
      std::vector<float> inputs = slice(scene.lights, at, 10);
      for (std::size_t k = 0; k < emission_size; ++k) {
        for (std::size_t c = 0; c < 3; ++c) inputs.push_back(scene.lights[at + 10 + c * emission_size + k]);
      }
      append(inputs, of_receiver);
      const std::vector<float> radiance = run_in_cpp("hvl_radiance", bands, order, inputs);
      for (std::size_t c = 0; c < 3; ++c) sum[c] = sum[c] + radiance[c];
    }
  }
  return {std::max(sum[0], 0.0F), std::max(sum[1], 0.0F), std::max(sum[2], 0.0F)};
}

void check_gather(Driver& driver, const std::string& shell, int bands) {
  CAPTURE(shell, bands);
  const GatherScene scene(bands, 20, 100);
  const std::vector<float> image = run_gather(driver, scene, gather_example(bands, shell)).values;
  for (std::size_t i = 0; i < scene.receiver_count; ++i) {
    require_equal(slice(image, 3 * i, 3), gather_in_cpp(scene, shell, bands, i), driver.is_software(),
                  [&] { return slice(scene.places, 10 * i, 10); });
  }
}

/// Value and gradient at a vertex, in one colour channel: N*N numbers, and N*N triples.
std::vector<float> vertex_in_cpp(const GridScene& scene, const std::string& shell, int bands, const glm::vec3& vertex,
                                 std::size_t channel) {
  const auto size = [](int count) { return static_cast<std::size_t>(count); };
  const std::size_t value = size(bands * bands), up = size((bands + 1) * (bands + 1));
  const std::size_t down = size(std::max((bands - 1) * (bands - 1), 1));
  std::vector<float> sums(value + up + down);
  for (const int order : orders_of(shell, "add_sphere", bands)) {
    for (std::size_t light = 0; light < scene.light_count; ++light) {
      const std::size_t at = light * GridScene::light_size;
      std::vector<float> inputs = slice(scene.lights, at, 4);
      inputs.push_back(scene.lights[at + 4 + channel]);
      append(inputs, std::vector<float>{vertex.x, vertex.y, vertex.z, scene.cell()});
      append(inputs, sums);
      sums = run_in_cpp("add_sphere", bands, order, inputs);
    }
  }
  std::vector<float> result = slice(sums, 0, value);
  append(result, run_in_cpp("finish_sums", bands, all_orders, slice(sums, value, up + down)));
  return result;
}

void check_grid(Driver& driver, const std::string& shell, int bands) {
  CAPTURE(shell, bands);
  const GridScene scene(10, {3, 4, 2});
  const std::vector<float> grid = run_grid(driver, scene, bands, grid_example(bands, shell)).values;
  const auto count = static_cast<std::size_t>(bands * bands);
  for (std::size_t vertex = 0; vertex < scene.vertex_count(); ++vertex) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      std::vector<float> given(4 * count);
      for (std::size_t i = 0; i < count; ++i) {
        const auto block = [&](std::size_t b) { return grid[(vertex * 4 + b) * 3 * count + 3 * i + channel]; };
        given[i] = block(0);
        for (std::size_t axis = 0; axis < 3; ++axis) given[count + 3 * i + axis] = block(axis + 1);
      }
      require_equal(given, vertex_in_cpp(scene, shell, bands, scene.position(vertex), channel), driver.is_software(),
                    [&] {
                      return std::vector<std::size_t>{vertex, channel};
                    });
    }
  }
}

/// Both passes against the library's filter, and the shading against the kernels of C++ on what that leaves.
template <int N>
void check_screen(Driver& driver, int width, int height, zonal::InterleavedPattern pattern) {
  CAPTURE(N, width, height, pattern.columns, pattern.rows);
  const ScreenScene<N> scene(width, height, static_cast<unsigned>(width + pattern.sets()));
  const auto where = [&] { return std::vector<int>{width, height}; };
  // A pattern of one row leaves the second pass nothing to do.
  zonal::RadiancePicture<N> across = scene.radiance, filtered = scene.radiance;
  zonal::filter(across, scene.surfaces, {pattern.columns, 1});
  zonal::filter(filtered, scene.surfaces, pattern);
  std::vector<float> averages =
      run_screen(driver, scene, pattern, screen_example(N, 1), shader_buffer(scene.radiance), across.size()).values;
  // Beside the rows nobody writes.
  for (std::size_t i = 0; i < averages.size(); ++i) {
    if (i % across.pitch() >= static_cast<std::size_t>(width)) averages[i] = 0;
  }
  require_equal(averages, shader_buffer(across), driver.is_software(), where);

  const auto pixel_count = static_cast<std::size_t>(width * height);
  const std::vector<float> image =
      run_screen(driver, scene, pattern, screen_example(N, 2), averages, 3 * pixel_count).values;
  std::vector<float> expected;
  for (std::size_t i = 0; i < pixel_count; ++i) {
    const float* const f = &scene.shading[ScreenScene<N>::shading_size * i];
    const glm::vec3 normal(f[0], f[1], f[2]), outgoing(f[3], f[4], f[5]);
    const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
    const auto sh = filtered.at(x, y);
    const glm::vec3 mirror = zonal::mirror_direction(normal, outgoing);
    const auto lobe = zonal::project<N>(zonal::PhongLobe<float>{f[12]});
    const glm::vec3 diffuse = zonal::reconstruct_convolved(sh, zonal::LambertLobe{}, normal);
    const glm::vec3 glossy = zonal::reconstruct_convolved(sh, lobe, mirror);
    SceneRandom::append(expected, glm::vec3(f[6], f[7], f[8]) * glm::max(diffuse, glm::vec3(0)) +
                                      glm::vec3(f[9], f[10], f[11]) * glm::max(glossy, glm::vec3(0)));
  }
  require_equal(image, expected, driver.is_software(), where);
}

}  // namespace

TEST_CASE("The screen's filter and its shading on the driver are those of C++") {
  Driver* driver = driver_or_skip();
  if (driver == nullptr) return;
  for (const auto& [columns, rows] : {std::pair(1, 1), {3, 5}, {4, 4}, {8, 8}}) {
    check_screen<2>(*driver, 37, 23, {columns, rows});
  }
  check_screen<3>(*driver, 9, 17, {4, 4});
  check_screen<1>(*driver, 16, 16, {16, 16});
}

TEST_CASE("A gather of virtual lights on the driver is that of C++") {
  Driver* driver = driver_or_skip();
  if (driver == nullptr) return;
  for (const int bands : {1, 3, 6}) {
    for (const char* shell : {"gather", "gather_reversed"}) check_gather(*driver, shell, bands);
  }
}

TEST_CASE("A gather of virtual lights on the driver is that of the cache and the table, to rounding") {
  Driver* driver = driver_or_skip();
  if (driver == nullptr) return;
  constexpr int N = 4;
  const GatherScene scene(N, 20, 100);
  std::vector<float> expected;
  for (std::size_t i = 0; i < scene.receiver_count; ++i) {
    SceneRandom::append(expected, zonal::gather<N>(scene.cache, scene.receivers[i], scene.material_of(i)));
  }
  require_equal(run_gather(*driver, scene, gather_example(N, "gather")).values, expected, false, [] { return N; });
}

TEST_CASE("A grid filled on the driver is that of C++") {
  Driver* driver = driver_or_skip();
  if (driver == nullptr) return;
  for (const int bands : {1, 2, 6}) {
    for (const char* shell : {"sum_lights", "sum_lights_reversed"}) check_grid(*driver, shell, bands);
  }
}

TEST_CASE("A grid filled on the driver is that of add_lights, limited gradients and all, to rounding") {
  Driver* driver = driver_or_skip();
  if (driver == nullptr) return;
  constexpr int N = 4;
  const GridScene scene(10, {3, 4, 2});
  std::vector<zonal::ColouredLight<zonal::SphereLight<float>>> lights;
  for (std::size_t i = 0; i < scene.light_count; ++i) {
    const float* f = &scene.lights[i * GridScene::light_size];
    lights.push_back({{{f[0], f[1], f[2]}, f[3]}, {f[4], f[5], f[6]}});
  }
  zonal::CoefficientGrid<N> grid(scene.low, scene.high, scene.resolution);
  zonal::add_lights(grid, lights, [](int count, const auto& body) {
    for (int i = 0; i < count; ++i) body(i);
  });
  const std::vector<float> given = run_grid(*driver, scene, N, grid_example(N, "sum_lights_reversed")).values;
  const std::vector<float> expected(grid.data(), grid.data() + grid.size());
  require_equal(given, expected, false, [] { return N; });
}

TEST_CASE("What interpolates a grid and what reconstructs colours fit together, as in C++ to rounding") {
  Driver* driver = driver_or_skip();
  if (driver == nullptr) return;
  constexpr int N = 2;
  const GridScene scene(10, {3, 4, 2});
  zonal::CoefficientGrid<N> grid(scene.low, scene.high, scene.resolution);
  SceneRandom random(13);
  for (std::size_t i = 0; i < grid.size(); ++i) grid.data()[i] = random.uniform(-1, 1);
  // Positions within the grid and some outside, and normals.
  constexpr std::size_t count = 64;
  std::vector<float> places;
  for (std::size_t i = 0; i < count; ++i) {
    SceneRandom::append(places, random.vector(-1.2F, 1.2F));
    SceneRandom::append(places, random.direction());
  }
  const auto check = [&](const std::string& method, auto interpolation, const auto& the_grid,
                         const std::string& defines) {
    zonal_glsl::Request request;
    request.functions = {"interpolate_" + method, "reconstruct_lambert_colour", "reconstruct_colour@1"};
    request.bands = N;
    const std::string source =
        "#version 450\nlayout(local_size_x = 64) in;\n"
        "layout(std430, binding = 0) readonly buffer Grid { float grid[]; };\n"
        "layout(std430, binding = 1) readonly buffer Places { float places[]; };\n"
        "layout(std430, binding = 2) writeonly buffer Results { float results[]; };\n"
        "#define ZONAL_GRID(i) grid[i]\n" +
        defines + zonal_glsl::shader_file(request, *zonal::shader::find_dialect("glsl450")) +
        "void main() {\n"
        "  uint i = 6u * gl_GlobalInvocationID.x;\n"
        "  vec3 position = vec3(places[i], places[i + 1u], places[i + 2u]);\n"
        "  vec3 normal = vec3(places[i + 3u], places[i + 4u], places[i + 5u]);\n"
        "  vec3 sh[4];\n"
        "  zonal_interpolate_" +
        method +
        "_2(position, vec3(-1.0), vec3(1.0), uvec3(3u, 4u, 2u), sh);\n"
        "  vec3 reflected = zonal_reconstruct_lambert_colour_2(sh, normal);\n"
        "  vec3 smooth_ = zonal_reconstruct_colour_1(vec3[1](sh[0]), normal);\n"
        "  for (int c = 0; c < 3; ++c) {\n"
        "    results[i + uint(c)] = reflected[c];\n"
        "    results[i + 3u + uint(c)] = smooth_[c];\n"
        "  }\n"
        "}\n";
    const unsigned program = driver->compile(source);
    const unsigned in = driver->make_buffer(shader_buffer(the_grid));
    const unsigned where = driver->make_buffer(places);
    const unsigned out = driver->make_buffer(std::vector<float>(6 * count, std::numeric_limits<float>::quiet_NaN()));
    driver->run(program, {in, where, out}, 1);
    std::vector<float> expected;
    for (std::size_t i = 0; i < count; ++i) {
      const float* p = &places[6 * i];
      const auto sh = zonal::interpolate<decltype(interpolation)::value>(grid, glm::vec3(p[0], p[1], p[2]));
      const glm::vec3 normal(p[3], p[4], p[5]);
      const zonal::Sh<1, glm::vec3> smooth{{sh[0]}};
      SceneRandom::append(expected, zonal::reconstruct_convolved(sh, zonal::LambertLobe{}, normal));
      SceneRandom::append(expected, zonal::reconstruct(smooth, normal));
    }
    require_equal(driver->read_buffer(out, 6 * count), expected, false, [&] { return method; });
    for (const unsigned buffer : {in, where, out}) driver->delete_buffer(buffer);
    driver->delete_program(program);
  };
  const std::integral_constant<zonal::Interpolation, zonal::Interpolation::trilinear> trilinear;
  const std::integral_constant<zonal::Interpolation, zonal::Interpolation::hermite> hermite;
  check("trilinear", trilinear, grid, "");
  check("trilinear", trilinear, values_of(grid), "#define ZONAL_GRID_BLOCKS 1u\n");
  check("hermite", hermite, grid, "");
}

TEST_CASE("A gather of 10 bands compiles in less than 10 s") {
  Driver* driver = driver_or_skip();
  if (driver == nullptr) return;
  const auto start = std::chrono::steady_clock::now();
  run_gather(*driver, GatherScene(10, 1, 1), gather_example(10, "gather"));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  CHECK(seconds < 10);
}

namespace {

/// What visible look-ups give in C++ by the kernels of the registry, operation by operation as the shell has them: the
/// look-ups themselves are compiled to melt into their callers, where products may be fused.
template <int N, zonal::Interpolation method>
std::vector<float> visible_in_cpp(const zonal::CoefficientGrid<N>& grid, const zonal::GridVisibility& visibility,
                                  const float* place) {
  const std::vector<float> p(place, place + 3), normal(place + 3, place + 6);
  std::vector<float> inputs = p;
  SceneRandom::append(inputs, grid.low());
  SceneRandom::append(inputs, grid.high());
  SceneRandom::append(inputs, glm::vec3(grid.resolution()));
  const std::vector<float> cells = run_in_cpp("cell_position", 1, all_orders, inputs);
  const glm::vec3 size = (grid.high() - grid.low()) / glm::vec3(grid.resolution() - 1);
  glm::ivec3 cell;
  glm::vec3 t;
  for (int a = 0; a < 3; ++a) {
    cell[a] = std::min(static_cast<int>(cells[static_cast<std::size_t>(a)]), grid.resolution()[a] - 2);
    t[a] = cells[static_cast<std::size_t>(a)] - static_cast<float>(cell[a]);
  }
  const auto rings = static_cast<float>(visibility.rings());
  std::vector<float> weigh{t.x, t.y, t.z, size.x, size.y, size.z};
  std::size_t vertices[8];
  for (int c = 0; c < 8; ++c) {
    const glm::ivec3 corner(c & 1, c >> 1 & 1, c >> 2);
    const std::size_t vertex = vertices[c] = grid.vertex_index(cell + corner);
    const float* const numbers = visibility.data() + vertex * visibility.vertex_size();
    inputs = slice(weigh, 0, 6);
    SceneRandom::append(inputs, glm::vec3(corner));
    SceneRandom::append(inputs, visibility.offset(vertex));
    append(inputs, normal);
    inputs.push_back(rings);
    const std::vector<float> at = run_in_cpp("visibility_place", 1, all_orders, inputs);
    const zonal::detail::MapNodes nodes(at[1], at[2], visibility.rings());
    inputs = {at[0]};
    for (const int number : {4, 5}) {
      for (const int node : nodes.node) inputs.push_back(numbers[number + 2 * node]);
    }
    inputs.insert(inputs.end(), {nodes.x, nodes.y});
    weigh.push_back(numbers[3] * run_in_cpp("seen_share", 1, all_orders, inputs)[0]);
  }
  constexpr int blocks = zonal::blocks_read(method);
  const std::vector<float> weights =
      run_in_cpp(blocks == 1 ? "visible_trilinear_weights" : "visible_hermite_weights", 1, all_orders, weigh);
  std::vector<float> sh;
  for (std::size_t i = 0; i < grid.block_size; ++i) {
    float sum = 0;
    for (std::size_t c = 0; c < 8; ++c) {
      for (std::size_t b = 0; b < blocks; ++b) {
        sum = sum + weights[c * blocks + b] * grid.data()[vertices[c] * grid.vertex_size + b * grid.block_size + i];
      }
    }
    sh.push_back(sum);
  }
  return sh;
}

template <zonal::Interpolation method>
void check_visible(Driver& driver, const std::string& name) {
  constexpr int N = 2;
  const glm::vec3 low(-1), high(1);
  zonal::CoefficientGrid<N> grid(low, high, {3, 4, 2});
  SceneRandom random(14);
  for (std::size_t i = 0; i < grid.size(); ++i) grid.data()[i] = random.uniform(-1, 1);
  zonal::GridVisibility visibility(grid, 3);
  for (std::size_t vertex = 0; vertex < visibility.vertex_count(); ++vertex) {
    visibility.set_place(vertex, random.vector(-0.1F, 0.1F), random.uniform(0, 1) < 0.25F);
    for (int node = 0; node < visibility.node_count(); ++node) {
      visibility.set_node(vertex, node, random.uniform(0, 3), random.uniform(0.01F, 1));
    }
  }
  constexpr std::size_t count = 256, size = 3 * N * N;
  std::vector<float> places;
  for (std::size_t i = 0; i < count; ++i) {
    SceneRandom::append(places, random.vector(-1.2F, 1.2F));
    SceneRandom::append(places, i == 0 ? glm::vec3(0) : random.direction());
  }
  zonal_glsl::Request request;
  request.functions = {"interpolate_visible_" + name};
  request.bands = N;
  request.text.precise = true;
  const unsigned program = driver.compile(
      "#version 450\nlayout(local_size_x = 64) in;\n"
      "layout(std430, binding = 0) readonly buffer Grid { float grid[]; };\n"
      "layout(std430, binding = 1) readonly buffer Visibility { float visibility[]; };\n"
      "layout(std430, binding = 2) readonly buffer Places { float places[]; };\n"
      "layout(std430, binding = 3) writeonly buffer Results { float results[]; };\n"
      "#define ZONAL_GRID(i) grid[i]\n#define ZONAL_VISIBILITY(i) visibility[i]\n"
      "#define ZONAL_VISIBILITY_RINGS 3u\n" +
      zonal_glsl::shader_file(request, *zonal::shader::find_dialect("glsl450")) +
      "void main() {\n"
      "  uint i = gl_GlobalInvocationID.x;\n"
      "  vec3 position = vec3(places[6u * i], places[6u * i + 1u], places[6u * i + 2u]);\n"
      "  vec3 normal = vec3(places[6u * i + 3u], places[6u * i + 4u], places[6u * i + 5u]);\n"
      "  vec3 sh[4];\n"
      "  zonal_interpolate_visible_" +
      name +
      "_2(position, normal, vec3(-1.0), vec3(1.0), uvec3(3u, 4u, 2u), sh);\n"
      "  for (uint k = 0u; k < 12u; ++k) results[12u * i + k] = sh[k / 3u][k % 3u];\n"
      "}\n");
  const unsigned buffers[] = {driver.make_buffer(shader_buffer(grid)), driver.make_buffer(shader_buffer(visibility)),
                              driver.make_buffer(places),
                              driver.make_buffer(std::vector<float>(count * size, -1000.0F))};
  driver.run(program, {buffers[0], buffers[1], buffers[2], buffers[3]}, count / 64);
  const std::vector<float> given = driver.read_buffer(buffers[3], count * size);
  for (std::size_t i = 0; i < count; ++i) {
    const float* const p = &places[6 * i];
    const std::vector<float> of_one = slice(given, i * size, size);
    require_equal(of_one, visible_in_cpp<N, method>(grid, visibility, p), driver.is_software(), [&] { return i; });
    const auto looked_up =
        zonal::interpolate<method>(grid, visibility, glm::vec3(p[0], p[1], p[2]), glm::vec3(p[3], p[4], p[5]));
    std::vector<float> expected;
    for (int k = 0; k < N * N; ++k) SceneRandom::append(expected, looked_up[k]);
    require_equal(of_one, expected, false, [&] { return i; });
  }
  for (const unsigned buffer : buffers) driver.delete_buffer(buffer);
  driver.delete_program(program);
}

}  // namespace

TEST_CASE("A look-up in a grid by what is seen of its vertices, on the driver, is that of C++") {
  Driver* driver = driver_or_skip();
  if (driver == nullptr) return;
  check_visible<zonal::Interpolation::trilinear>(*driver, "trilinear");
  check_visible<zonal::Interpolation::hermite>(*driver, "hermite");
}
