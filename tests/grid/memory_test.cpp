// What filling a grid allocates: every allocation of this program goes through the counters below.
#include <zonal/grid/add_lights.hpp>
#include <zonal/grid/add_polygons.hpp>
#include <zonal/light/sphere.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#include "../catch.hpp"

namespace {

struct Counters {
  std::size_t now = 0, peak = 0;
};
Counters counters;  // the tests run on one thread

// Not inlined: GCC would take the two for a mismatched pair.
constexpr std::size_t header = alignof(std::max_align_t) * 4;  // in front of each block, for its size

[[gnu::noinline]] void* allocate(std::size_t size, std::size_t alignment) {
  const std::size_t room = std::max(header, alignment);
  void* block = std::aligned_alloc(std::max(alignment, alignof(std::max_align_t)), (size + 2 * room - 1) / room * room);
  if (block == nullptr) throw std::bad_alloc();
  auto* result = static_cast<char*>(block) + room;
  reinterpret_cast<std::size_t*>(result)[-1] = size;
  reinterpret_cast<std::size_t*>(result)[-2] = room;
  counters.now += size;
  counters.peak = std::max(counters.peak, counters.now);
  return result;
}
[[gnu::noinline]] void release(void* pointer) {
  if (pointer == nullptr) return;
  counters.now -= static_cast<std::size_t*>(pointer)[-1];
  std::free(static_cast<char*>(pointer) - static_cast<std::size_t*>(pointer)[-2]);
}

/// The most that body() held at a time, beyond what was there before.
template <class Body>
std::size_t peak_of(const Body& body) {
  const std::size_t before = counters.now;
  counters.peak = before;
  body();
  return counters.peak - before;
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
// std::stable_sort asks for memory by it. All of them, so that none is another library's.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, alignof(std::max_align_t));
}
void operator delete(void* pointer) noexcept { release(pointer); }
void operator delete(void* pointer, const std::nothrow_t&) noexcept { release(pointer); }
void operator delete(void* pointer, std::size_t) noexcept { release(pointer); }
void operator delete(void* pointer, std::align_val_t) noexcept { release(pointer); }
void operator delete(void* pointer, std::size_t, std::align_val_t) noexcept { release(pointer); }

TEST_CASE("grid: building one takes hardly more memory than its data") {
  constexpr int N = 5;
  const std::size_t data = 512 * 4 * 3 * N * N * sizeof(float);
  const auto serially = [](int count, const auto& body) {
    for (int i = 0; i < count; ++i) body(i);
  };
  std::vector<zonal::ColouredLight<zonal::SphereLight<float>>> spheres;
  std::vector<zonal::ColouredLight<zonal::TriangleLight<float>>> triangles;
  for (int i = 0; i < 648; ++i) {
    const auto t = static_cast<float>(i);
    const glm::vec3 p(std::cos(t), std::sin(t), 2 + 0.001F * t), colour(1, 2, 3);
    spheres.push_back({{p, 0.05F}, colour});
    triangles.push_back({{{p, p + glm::vec3(0.1F, 0, 0), p + glm::vec3(0, 0.1F, 0)}}, colour});
  }
  const std::size_t with_spheres = peak_of([&] {
    zonal::CoefficientGrid<N> grid({-1, -1, -1}, {1, 1, 1}, {8, 8, 8});
    REQUIRE(grid.size() * sizeof(float) == data);
    zonal::add_lights(grid, spheres, serially);
  });
  const std::size_t with_triangles = peak_of([&] {
    zonal::CoefficientGrid<N> grid({-1, -1, -1}, {1, 1, 1}, {8, 8, 8});
    zonal::add_lights(grid, triangles, 1e-4, serially);
  });
  CAPTURE(data, with_spheres, with_triangles);
  CHECK(with_spheres >= data);
  CHECK(with_spheres <= data + data / 10);
  CHECK(with_triangles <= data + data / 2);  // the list of the lights' edges, and a side for each of a packet
}
