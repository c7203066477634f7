// Visibility of vertices: what leaks through a thin wall, against paths, and what stays as it was.
#include <zonal/grid/interpolate_visible.hpp>
#include <zonal/grid/measure_visibility.hpp>
#include <zonal/grid/visibility_file.hpp>
#include <zonal/transform/convolve.hpp>
#include <zonal/zonal.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "../catch.hpp"
#include "../files.hpp"
#include "rooms.hpp"

namespace {

using namespace rooms_test;
using zonal::GridContent;
using zonal::GridVisibility;
using zonal::Interpolation;

constexpr int N = 3;
using Values = zonal::CoefficientGrid<N, GridContent::values>;
using Gradients = zonal::CoefficientGrid<N>;

/// Cells of 40 cm; the outermost vertices stand just outside of the walls, as on the box of a scene.
template <class Grid>
Grid grid_of_rooms() {
  return Grid(glm::vec3(-0.005F), Rooms::size + 0.005F, {12, 7, 9});
}

template <class Grid, class Visit>
void for_each_vertex(const Grid& grid, const Visit& visit) {
  const glm::ivec3 r = grid.resolution();
  TwoThreads()(r.x * r.y * r.z, [&](int i) { visit(glm::ivec3(i % r.x, i / r.x % r.y, i / r.x / r.y)); });
}

/// What arrives at the vertices, where they are or were moved to, by paths.
Values lit_grid(const Rooms& rooms, const GridVisibility& visibility) {
  auto grid = grid_of_rooms<Values>();
  for_each_vertex(grid, [&](const glm::ivec3& vertex) {
    constexpr int paths = 2048;
    const std::size_t number = grid.vertex_index(vertex);
    const glm::vec3 offset = visibility.empty() ? glm::vec3(0) : visibility.offset(number);
    Random random(static_cast<unsigned>(number));
    zonal::Sh<N, glm::vec3> sh{};
    for (int i = 0; i < paths; ++i) {
      const glm::vec3 w = spread_direction(i, paths);
      const float radiance = rooms.arriving(grid.position(vertex) + offset, w, random, true);
      sh += zonal::evaluate<N>(w) * glm::vec3(radiance * 4 * pi / paths);
    }
    grid.set(vertex, sh);
  });
  return grid;
}

struct Receiver {
  glm::vec3 position, normal;
  float irradiance = 0;
};
std::vector<Receiver> receivers_in(const Rooms& rooms, std::size_t count) {
  std::vector<Receiver> receivers(count);
  TwoThreads()(static_cast<int>(count), [&](int i) {
    Random random(1000 + static_cast<unsigned>(i));
    Met met;
    glm::vec3 origin, direction;
    do {
      origin = glm::vec3(0.1F) + (Rooms::size - 0.2F) * glm::vec3(random(), random(), random());
      direction = spread_direction(static_cast<int>(1000 * random()), 1000);
      met = rooms(origin, direction);
    } while (met.is_back_face);
    Receiver& receiver = receivers[static_cast<std::size_t>(i)];
    receiver = {origin + met.distance * direction, met.normal};
    receiver.irradiance = rooms.irradiance(receiver.position, receiver.normal, 1024, random);
  });
  return receivers;
}

/// Root mean squares of the error of E: in the dark room, and in the lit one.
struct Errors {
  double dark = 0, lit = 0;
};
template <class LookUp>
Errors errors_of(const Rooms& rooms, const std::vector<Receiver>& receivers, const LookUp& look_up) {
  Errors errors;
  int dark = 0;
  for (const Receiver& r : receivers) {
    const float given = pi * zonal::reconstruct_convolved(look_up(r), zonal::LambertLobe{}, r.normal).x;
    const auto error = static_cast<double>(std::max(given, 0.0F) - r.irradiance);
    (rooms.is_dark(r.position) ? errors.dark : errors.lit) += error * error;
    dark += rooms.is_dark(r.position);
  }
  return {std::sqrt(errors.dark / dark), std::sqrt(errors.lit / (static_cast<int>(receivers.size()) - dark))};
}

template <class Grid>
Grid random_grid(unsigned seed) {
  auto grid = grid_of_rooms<Grid>();
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::generate_n(grid.data(), grid.size(), [&] { return uniform(random); });
  return grid;
}

template <class Check>
void for_random_places(int count, const Check& check) {
  Random random(5);
  for (int i = 0; i < count; ++i) {
    const glm::vec3 p = glm::vec3(-0.2F) + (Rooms::size + 0.4F) * glm::vec3(random(), random(), random());
    check(p, spread_direction(i, count));
  }
}

bool is_same(const zonal::Sh<N, glm::vec3>& a, const zonal::Sh<N, glm::vec3>& b) {
  return std::memcmp(&a[0], &b[0], sizeof(glm::vec3) * N * N) == 0;
}

/// Where no two vertices see the same, and some are buried.
GridVisibility random_visibility(unsigned seed) {
  GridVisibility visibility(grid_of_rooms<Values>(), 3);
  Random random(seed);
  for (std::size_t vertex = 0; vertex < visibility.vertex_count(); ++vertex) {
    visibility.set_place(vertex, 0.1F * glm::vec3(random(), random(), random()) - 0.05F, random() < 0.2F);
    for (int node = 0; node < visibility.node_count(); ++node) {
      visibility.set_node(vertex, node, 4 * random(), 0.01F + random());
    }
  }
  return visibility;
}

template <Interpolation method, class Grid>
void check_plain(const Grid& grid, const GridVisibility& visibility) {
  for_random_places(2000, [&](const glm::vec3& p, const glm::vec3& normal) {
    CAPTURE(p.x, p.y, p.z);
    REQUIRE(is_same(zonal::interpolate<method>(grid, visibility, p, normal), zonal::interpolate<method>(grid, p)));
  });
}

}  // namespace

TEST_CASE("visibility: less than a tenth leaks through a thin wall, and the rest is no worse") {
  for (const float wall : {2.23F, 2.33F, 2.1F}) {
    const Rooms rooms(wall);
    const auto visibility = measure_visibility(grid_of_rooms<Values>(), rooms, TwoThreads());
    const Values unmoved = lit_grid(rooms, {}), grid = lit_grid(rooms, visibility);
    const auto receivers = receivers_in(rooms, 600);
    const Errors plain = errors_of(rooms, receivers, [&](const Receiver& r) {
      return zonal::interpolate<Interpolation::trilinear>(unmoved, r.position);
    });
    const Errors moved = errors_of(rooms, receivers, [&](const Receiver& r) {
      return zonal::interpolate<Interpolation::trilinear>(grid, r.position);
    });
    const Errors seen = errors_of(rooms, receivers, [&](const Receiver& r) {
      return zonal::interpolate<Interpolation::trilinear>(grid, visibility, r.position, r.normal);
    });
    CAPTURE(wall, plain.dark, moved.dark, seen.dark, plain.lit, moved.lit, seen.lit);
    CHECK(plain.dark > 0.1);
    CHECK(seen.dark <= plain.dark / 10);
    CHECK(seen.dark <= moved.dark / 10);
    CHECK(seen.lit <= 1.05 * plain.lit);
    CHECK(seen.lit <= 1.05 * moved.lit);
  }
}

TEST_CASE("visibility: where nothing is known, or nothing stands in the way, interpolations are plain to the bit") {
  const auto values = random_grid<Values>(1);
  const auto gradients = random_grid<Gradients>(2);
  const auto check = [&](const GridVisibility& visibility) {
    check_plain<Interpolation::trilinear>(values, visibility);
    check_plain<Interpolation::taylor>(gradients, visibility);
    check_plain<Interpolation::hermite>(gradients, visibility);
  };
  check({});
  check(GridVisibility(values));
  check(measure_visibility(
      values, [](const glm::vec3&, const glm::vec3&) { return zonal::RayHit{}; }, TwoThreads()));
}

TEST_CASE("visibility: a field that is the same everywhere stays so, whatever is seen, by every interpolation") {
  Gradients gradients = random_grid<Gradients>(3);
  auto values = grid_of_rooms<Values>();
  const auto constant = random_grid<Values>(4).value({0, 0, 0});
  for_each_vertex(values, [&](const glm::ivec3& vertex) {
    values.set(vertex, constant);
    gradients.set(vertex, {constant, {}});
  });
  const GridVisibility visibility = random_visibility(6);
  for_random_places(2000, [&](const glm::vec3& p, const glm::vec3& normal) {
    const zonal::Sh<N, glm::vec3> given[] = {
        zonal::interpolate<Interpolation::trilinear>(values, visibility, p, normal),
        zonal::interpolate<Interpolation::taylor>(gradients, visibility, p, normal),
        zonal::interpolate<Interpolation::hermite>(gradients, visibility, p, normal)};
    for (const auto& sh : given) {
      for (int i = 0; i < N * N; ++i) {
        CAPTURE(p.x, p.y, p.z, i);
        for (int c = 0; c < 3; ++c) REQUIRE(std::abs(sh[i][c] - constant[i][c]) <= 2e-6F);
      }
    }
  });
}

TEST_CASE("visibility: a buried corner lends nothing, and a cell of buried corners is plain") {
  auto grid = random_grid<Gradients>(7);
  GridVisibility visibility(grid);
  const glm::vec3 p = grid.position({4, 3, 2}) + 0.3F * grid.spacing();
  const auto look_up = [&] {
    return zonal::interpolate<Interpolation::hermite>(grid, visibility, p, glm::vec3(0, 0, 1));
  };
  for (int c = 0; c < 8; ++c) {
    const auto before = look_up();
    const std::size_t vertex = grid.vertex_index(glm::ivec3(4 + (c & 1), 3 + (c >> 1 & 1), 2 + (c >> 2)));
    visibility.set_place(vertex, glm::vec3(0), true);
    const auto after = look_up();
    CAPTURE(c);
    CHECK(!is_same(before, after));
    if (c == 7) break;
    float* const numbers = grid.data() + vertex * Gradients::vertex_size;
    std::for_each(numbers, numbers + Gradients::vertex_size, [](float& x) { x = 1e6F - x; });
    CHECK(is_same(look_up(), after));
    std::for_each(numbers, numbers + Gradients::vertex_size, [](float& x) { x = 0; });
  }
  check_plain<Interpolation::hermite>(grid, [&] {
    for (std::size_t vertex = 0; vertex < visibility.vertex_count(); ++vertex) {
      visibility.set_place(vertex, glm::vec3(0.01F), true);
    }
    return visibility;
  }());
}

TEST_CASE("visibility: a wall is where the map has it, at every angle, and what lies before it is seen") {
  // Alone in space, solid beneath. Where it sinks below the horizon the map has a kink, hence 57 degrees.
  const glm::vec3 normal = glm::normalize(glm::vec3(0.6F, 0.2F, -0.5F));
  const float distance = 0.3F;  // from the vertex in the middle
  const zonal::CoefficientGrid<1, GridContent::values> grid(glm::vec3(-1), glm::vec3(1), glm::ivec3(3));
  const auto visibility = measure_visibility(
      grid,
      [&](const glm::vec3& origin, const glm::vec3& direction) {
        const float height = glm::dot(origin, normal) + distance, fall = -glm::dot(direction, normal);
        const float t = height / fall;
        return t > 0 ? zonal::RayHit{t, height < 0} : zonal::RayHit{};
      },
      TwoThreads());
  const std::size_t middle = grid.vertex_index({1, 1, 1});
  REQUIRE(visibility.offset(middle) == glm::vec3(0));
  REQUIRE(!visibility.is_buried(middle));
  CHECK(visibility.is_buried(grid.vertex_index({0, 0, 2})));
  int hidden = 0, seen = 0;
  for (int i = 0; i < 3000; ++i) {
    const glm::vec3 w = spread_direction(i, 3000);
    const float wall = -distance / glm::dot(w, normal);
    if (!(wall > 0 && wall < 0.55F)) continue;
    for (const float share : {0.98F, 1.1F}) {
      const glm::vec3 at = share * wall * w;
      const float to_receiver[3] = {at.x, at.y, at.z};
      const float given = zonal::detail::share_of(visibility, middle, to_receiver);
      CAPTURE(w.x, w.y, w.z, wall, share, given);
      if (share < 1) {
        ++seen;
        REQUIRE(given == 1);
      } else {
        ++hidden;
        REQUIRE(given < 1e-2F);
      }
    }
  }
  CHECK((hidden > 300 && seen > 300));
}

TEST_CASE("visibility: vertices in walls and outside of rooms are moved out, within their cell") {
  const Rooms rooms(2.4F);  // vertices stand in the wall
  const auto grid = grid_of_rooms<Values>();
  const auto visibility = measure_visibility(grid, rooms, TwoThreads());
  int moved = 0, buried = 0;
  for (int k = 0; k < grid.resolution().z; ++k) {
    for (int j = 0; j < grid.resolution().y; ++j) {
      for (int i = 0; i < grid.resolution().x; ++i) {
        const std::size_t vertex = grid.vertex_index({i, j, k});
        const glm::vec3 offset = visibility.offset(vertex), p = grid.position({i, j, k}) + offset;
        CAPTURE(i, j, k, p.x, p.y, p.z);
        for (int a = 0; a < 3; ++a) CHECK(std::abs(offset[a]) <= 0.4501F * grid.spacing()[a]);
        moved += offset != glm::vec3(0);
        buried += visibility.is_buried(vertex);
        if (visibility.is_buried(vertex)) continue;
        for (int a = 0; a < 3; ++a) CHECK((0 < p[a] && p[a] < Rooms::size[a]));
        for (std::size_t b = 1; b < rooms.boxes.size(); ++b) {
          const Box& box = rooms.boxes[b];
          CHECK(!(glm::all(glm::greaterThan(p, box.low)) && glm::all(glm::lessThan(p, box.high))));
        }
      }
    }
  }
  CHECK(moved > 300);
  CHECK(buried < 10);
}

TEST_CASE("visibility: what is measured does not depend on threads") {
  const Rooms rooms;
  const auto grid = grid_of_rooms<Values>();
  const auto one = measure_visibility(grid, rooms, TwoThreads());
  const auto other = measure_visibility(grid, rooms, [](int count, const auto& body) {
    for (int i = count; i-- > 0;) body(i);
  });
  REQUIRE(one.size() == other.size());
  CHECK(std::memcmp(one.data(), other.data(), one.size() * sizeof(float)) == 0);
}

TEST_CASE("visibility: what is not a number, in position or normal, gives no number and touches no memory outside") {
  const auto grid = random_grid<Values>(8);
  const GridVisibility visibility = random_visibility(9);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool in_normal : {false, true}) {
      glm::vec3 p(1, 1.1F, 1.2F), normal(0, 0, 1);
      (in_normal ? normal : p)[axis] = nan;
      const auto sh = zonal::interpolate<Interpolation::trilinear>(grid, visibility, p, normal);
      CAPTURE(axis, in_normal);
      for (int i = 0; i < N * N; ++i) CHECK((std::isnan(sh[i].x) && std::isnan(sh[i].z)));
    }
  }
  for (const float far : {3e38F, std::numeric_limits<float>::infinity()}) {
    const auto sh =
        zonal::interpolate<Interpolation::trilinear>(grid, visibility, glm::vec3(far, -far, 1), glm::vec3(0, 0, 1));
    CHECK(std::isfinite(sh[0].x));
  }
}

TEST_CASE("visibility file: what is saved comes back to the bit, and nothing else is taken for it") {
  using namespace file_test;
  const Folder folder;
  const auto path = folder.path / "a.visibility";
  GridVisibility small({-1, 0, 2}, {1, 2, 4}, {2, 3, 2}, 1);
  const GridVisibility source = random_visibility(10);
  std::copy_n(source.data(), small.size(), small.data());
  zonal::save_visibility(path, small);
  CHECK(std::filesystem::file_size(path) == 60 + 4 * small.size() + 8);
  const auto loaded = zonal::load_visibility(path);
  CHECK((loaded.low() == small.low() && loaded.high() == small.high()));
  CHECK((loaded.resolution() == small.resolution() && loaded.rings() == 1));
  REQUIRE(loaded.size() == small.size());
  CHECK(std::memcmp(loaded.data(), small.data(), 4 * small.size()) == 0);

  const auto error_of = [&]() -> std::string {
    try {
      zonal::load_visibility(path);
    } catch (const zonal::FileError& error) {
      return error.what();
    }
    return {};
  };
  const std::string good = bytes_of(path);
  for_each_wrong_bit(good, 80, 37, [&](const std::string& bad, std::size_t place) {
    write(path, bad);
    CAPTURE(place);
    REQUIRE(contains(error_of(), path.string() + ": "));
  });
  for_each_wrong_length(good, 60, [&](const std::string& bad, std::size_t length) {
    write(path, bad);
    CAPTURE(length);
    REQUIRE(contains(error_of(), "is "));
  });
  CHECK_THROWS_AS(zonal::save_visibility(path, {}), zonal::FileError);
}
