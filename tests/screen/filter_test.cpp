// The discontinuity filter against its definition, pixel by pixel, and against what it is for: means over all sets.
#include <zonal/screen/filter.hpp>

#include <cmath>
#include <optional>
#include <random>
#include <stdexcept>
#include <thread>

#include "../accuracy.hpp"
#include "../catch.hpp"

namespace {

using zonal::InterleavedPattern;
using zonal::PlanePicture;
using zonal::SurfacePicture;
using zonal::SurfaceTests;

/// A floor that the eye looks down on at a slant: one plane, whose depth grows with y.
SurfacePicture plane_surfaces(int width, int height) {
  SurfacePicture surfaces(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float depth = 1 + 0.1F * float(y);
      surfaces.set_surface(x, y, {0.01F * depth * float(x), -1, -depth}, {0, 1, 0}, depth, 3, 5);
    }
  }
  return surfaces;
}

/// Steps, tilts, other meshes and materials, holes: whatever refuses.
SurfacePicture broken_surfaces(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return std::uniform_real_distribution<float>(0, 1)(random); };
  SurfacePicture surfaces(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (uniform() < 0.03F) continue;
      // A little tilted, one plane may hold the other's pixel and not the other way round.
      const float tilt = uniform() < 0.1F   ? 1.0F
                         : uniform() < 0.2F ? 0.3F
                                            : 0.0F,
                  step = uniform() < 0.1F ? 0.2F : 0.0F;
      const glm::vec3 normal(std::sin(tilt), std::cos(tilt), 0);
      const glm::vec3 position(0.01F * float(x), step + 0.001F * uniform(), 0.01F * float(y));
      surfaces.set_surface(x, y, position, normal, 5, uniform() < 0.1F ? 1 : 0, uniform() < 0.1F ? 1 : 0);
    }
  }
  return surfaces;
}

PlanePicture<float> noise(int width, int height, int planes, unsigned seed) {
  std::mt19937 random(seed);
  PlanePicture<float> picture(width, height, planes);
  for (int y = 0; y < height; ++y) {
    for (int plane = 0; plane < planes; ++plane) {
      for (int x = 0; x < width; ++x) picture.set(x, y, plane, std::uniform_real_distribution<float>(-1, 1)(random));
    }
  }
  return picture;
}

// ---- The definition -------------------------------------------------------------------------------------------------

bool is_same(const SurfacePicture& surfaces, int xa, int ya, int xb, int yb, const SurfaceTests& tests) {
  const auto a = surfaces.surface(xa, ya), b = surfaces.surface(xb, yb);
  if (a.mesh < 0 || b.mesh < 0 || a.mesh != b.mesh || a.material != b.material) return false;
  const glm::dvec3 na(a.normal[0], a.normal[1], a.normal[2]), nb(b.normal[0], b.normal[1], b.normal[2]);
  const glm::dvec3 step =
      glm::dvec3(b.position[0], b.position[1], b.position[2]) - glm::dvec3(a.position[0], a.position[1], a.position[2]);
  const double limit = double(tests.plane_distance) * double(std::min(a.depth, b.depth));
  return glm::dot(na, nb) >= double(tests.cos_normal) && std::abs(glm::dot(step, na)) <= limit &&
         std::abs(glm::dot(step, nb)) <= limit;
}

/// The offset, along one axis, of the pixel that stands for the sets `residue` further on; accepts(offset).
template <class Accepts>
std::optional<int> chosen_offset(int length, int residue, const Accepts& accepts) {
  const int in_window = residue <= length / 2 ? residue : residue - length;
  const int other = in_window > 0 ? in_window - length : in_window + length;
  if (accepts(in_window)) return in_window;
  if (in_window != 0 && accepts(other)) return other;
  return std::nullopt;
}

/// One plane of the picture, filtered in double.
std::vector<double> filter_plainly(const PlanePicture<float>& picture, int plane, const SurfacePicture& surfaces,
                                   InterleavedPattern pattern, const SurfaceTests& tests) {
  const int width = picture.width(), height = picture.height();
  const auto at = [&](int x, int y) { return std::size_t(y * width + x); };
  std::vector<double> rows(std::size_t(width * height)), result(rows.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      int count = 0;
      for (int residue = 0; residue < pattern.columns; ++residue) {
        const auto offset = chosen_offset(pattern.columns, residue, [&](int d) {
          return 0 <= x + d && x + d < width && is_same(surfaces, x, y, x + d, y, tests);
        });
        if (offset) sum += double(picture.get(x + *offset, y, plane)), ++count;
      }
      rows[at(x, y)] = count > 0 ? sum / count : 0;
    }
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      int count = 0;
      for (int residue = 0; residue < pattern.rows; ++residue) {
        const auto offset = chosen_offset(pattern.rows, residue, [&](int d) {
          return 0 <= y + d && y + d < height && is_same(surfaces, x, y, x, y + d, tests);
        });
        if (offset) sum += rows[at(x, y + *offset)], ++count;
      }
      result[at(x, y)] = count > 0 ? sum / count : 0;
    }
  }
  return result;
}

constexpr double unit_roundoff = 0x1p-24;

void check_against_definition(int width, int height, InterleavedPattern pattern, const SurfacePicture& surfaces,
                              unsigned seed, Met& met) {
  const SurfaceTests tests;
  const PlanePicture<float> picture = noise(width, height, 2, seed);
  PlanePicture<float> filtered(width, height, 2);
  zonal::filter(picture, filtered, surfaces, pattern, tests);
  for (int plane = 0; plane < 2; ++plane) {
    const std::vector<double> expected = filter_plainly(picture, plane, surfaces, pattern, tests);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const double given = double(filtered.get(x, y, plane)), truth = expected[std::size_t(y * width + x)];
        if (met.meet(std::abs(given - truth) / (2 * unit_roundoff))) continue;
        CAPTURE(width, height, pattern.columns, pattern.rows, seed, plane, x, y, given, truth);
        FAIL("not what the definition gives");
      }
    }
  }
}

}  // namespace

TEST_CASE("the filter does what it says, on surfaces broken anyhow") {
  Met met("screen", "filter");
  unsigned seed = 1;
  for (const auto& [width, height] : {std::pair(1, 1), {17, 9}, {64, 70}, {33, 131}, {100, 64}}) {
    for (const InterleavedPattern pattern : {InterleavedPattern{1, 1}, {2, 3}, {4, 4}, {5, 1}, {8, 8}, {16, 16}}) {
      if (!pattern.what_is_wrong(width, height).empty()) continue;
      check_against_definition(width, height, pattern, broken_surfaces(width, height, seed), seed, met);
      check_against_definition(width, height, pattern, plane_surfaces(width, height), seed, met);
      ++seed;
    }
  }
  CHECK_WORST_MET(met);
}

TEST_CASE("on one plane every pixel becomes the mean of all sets, at every pattern and at the edges") {
  for (int columns = 1; columns <= 8; ++columns) {
    for (int rows = 1; rows <= 8; ++rows) {
      const InterleavedPattern pattern{columns, rows};
      for (const auto& [width, height] : {std::pair(columns, rows), {columns + 1, rows}, {37, 71}}) {
        std::mt19937 random(unsigned(8 * columns + rows));
        std::vector<float> of_set(std::size_t(pattern.sets()));
        double mean = 0, largest = 0;
        for (float& number : of_set) {
          number = std::uniform_real_distribution<float>(0, 100)(random);
          mean += double(number) / pattern.sets();
          largest = std::max(largest, double(number));
        }
        PlanePicture<float> picture(width, height, 1);
        for (int y = 0; y < height; ++y) {
          for (int x = 0; x < width; ++x) picture.set(x, y, 0, of_set[std::size_t(pattern.set_of(x, y))]);
        }
        zonal::filter(picture, plane_surfaces(width, height), pattern);
        for (int y = 0; y < height; ++y) {
          for (int x = 0; x < width; ++x) {
            const double given = double(picture.get(x, y, 0));
            if (std::abs(given - mean) <= (columns + rows) * unit_roundoff * largest) continue;
            CAPTURE(columns, rows, width, height, x, y, given, mean);
            FAIL("not the mean of all sets");
          }
        }
      }
    }
  }
}

TEST_CASE("no light crosses from a white half to a black one: by mesh, material, depth or normal") {
  constexpr int width = 40, height = 30, edge = 19;
  for (int kind = 0; kind < 4; ++kind) {
    for (const bool is_column : {false, true}) {
      SurfacePicture surfaces(width, height);
      PlanePicture<float> picture(width, height, 1);
      const auto is_white = [&](int x, int y) { return (is_column ? x : y) < (is_column ? edge : edge - 4); };
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const bool white = is_white(x, y);
          const float other = white ? 0.0F : 1.0F;
          const float tilt = kind == 3 ? other : 0.0F, step = kind == 2 ? 0.1F * other : 0.0F;
          surfaces.set_surface(x, y, {0.01F * float(x), step, 0.01F * float(y)}, {std::sin(tilt), std::cos(tilt), 0},
                               10, kind == 0 && white ? 1 : 2, kind == 1 && white ? 1 : 2);
          picture.set(x, y, 0, white ? 1.0F : 0.0F);
        }
      }
      for (const InterleavedPattern pattern : {InterleavedPattern{4, 4}, {8, 8}, {3, 5}}) {
        PlanePicture<float> filtered(width, height, 1);
        zonal::filter(picture, filtered, surfaces, pattern);
        for (int y = 0; y < height; ++y) {
          for (int x = 0; x < width; ++x) {
            CAPTURE(kind, is_column, pattern.columns, pattern.rows, x, y);
            const float expected = is_white(x, y) ? 1.0F : 0.0F;
            REQUIRE(std::abs(filtered.get(x, y, 0) - expected) <= float(4 * unit_roundoff));
            if (!is_white(x, y)) REQUIRE(filtered.get(x, y, 0) == 0);
          }
        }
      }
    }
  }
}

TEST_CASE("the filter gives the same bits in place, out of it, and for any order of its bands") {
  constexpr int width = 77, height = 300;
  const SurfacePicture surfaces = broken_surfaces(width, height, 7);
  const PlanePicture<float> picture = noise(width, height, 3, 8);
  for (const InterleavedPattern pattern : {InterleavedPattern{4, 4}, {8, 16}}) {
    PlanePicture<float> out(width, height, 3), in_place = picture, backwards = picture, threaded = picture;
    zonal::filter(picture, out, surfaces, pattern);
    zonal::filter(in_place, surfaces, pattern);
    zonal::filter(backwards, surfaces, pattern, SurfaceTests{}, [](int count, const auto& body) {
      for (int i = count; i-- > 0;) body(i);
    });
    zonal::filter(threaded, surfaces, pattern, SurfaceTests{}, [](int count, const auto& body) {
      std::vector<std::thread> threads;
      for (int i = 0; i < count; ++i) threads.emplace_back([&body, i] { body(i); });
      for (std::thread& thread : threads) thread.join();
    });
    for (int y = 0; y < height; ++y) {
      for (int plane = 0; plane < 3; ++plane) {
        for (int x = 0; x < width; ++x) {
          CAPTURE(pattern.columns, pattern.rows, x, y, plane);
          const float given = out.get(x, y, plane);
          const bool is_equal = in_place.get(x, y, plane) == given && backwards.get(x, y, plane) == given &&
                                threaded.get(x, y, plane) == given;
          if (!is_equal) FAIL("other bits");
        }
      }
    }
  }
}

TEST_CASE("halves are filtered as floats are, and rounded once") {
  constexpr int width = 50, height = 40;
  const SurfacePicture surfaces = broken_surfaces(width, height, 3);
  PlanePicture<zonal::Half> halves(width, height, 2);
  PlanePicture<float> floats(width, height, 2);
  const PlanePicture<float> numbers = noise(width, height, 2, 4);
  for (int y = 0; y < height; ++y) {
    for (int plane = 0; plane < 2; ++plane) {
      for (int x = 0; x < width; ++x) {
        halves.set(x, y, plane, numbers.get(x, y, plane));
        floats.set(x, y, plane, halves.get(x, y, plane));
      }
    }
  }
  zonal::filter(halves, surfaces, {4, 4});
  zonal::filter(floats, surfaces, {4, 4});
  for (int y = 0; y < height; ++y) {
    for (int plane = 0; plane < 2; ++plane) {
      for (int x = 0; x < width; ++x) {
        CAPTURE(x, y, plane);
        REQUIRE(halves.get(x, y, plane) == to_float(zonal::to_half(floats.get(x, y, plane))));
      }
    }
  }
}

TEST_CASE("a wire of one pixel keeps to itself, and the wall behind it sees every set") {
  constexpr int width = 24, height = 24, wire = 11;
  SurfacePicture surfaces(width, height);
  PlanePicture<float> picture(width, height, 1);
  const InterleavedPattern pattern{4, 4};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      surfaces.set_surface(x, y, {0.01F * float(x), 0.01F * float(y), 0}, {0, 0, 1}, 5, x == wire ? 1 : 0, 0);
      picture.set(x, y, 0, float(pattern.set_of(x, y)));
    }
  }
  zonal::filter(picture, surfaces, pattern);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      CAPTURE(x, y);
      // Of the wire's column of sets, 3, 7, 11 and 15; of all, 0 to 15.
      REQUIRE(std::abs(picture.get(x, y, 0) - (x == wire ? 9.0F : 7.5F)) < 1e-5F);
    }
  }
}

TEST_CASE("a picture that cannot be filtered is refused") {
  const auto refuses = [](int width, int height, InterleavedPattern pattern) {
    PlanePicture<float> picture(8, 6, 1);
    REQUIRE_THROWS_AS(zonal::filter(picture, SurfacePicture(width, height), pattern), std::invalid_argument);
  };
  refuses(8, 6, {0, 4});
  refuses(8, 6, {4, -1});
  refuses(8, 6, {9, 1});
  refuses(8, 6, {1, 7});
  refuses(8, 6, {17, 1});
  refuses(8, 7, {2, 2});
  REQUIRE_THROWS_AS(PlanePicture<float>(0, 4, 3), std::invalid_argument);
  PlanePicture<float> one(8, 6, 1), two(8, 6, 2);
  REQUIRE_THROWS_AS(zonal::filter(one, two, SurfacePicture(8, 6), {2, 2}), std::invalid_argument);
  REQUIRE_THROWS_AS(SurfacePicture(2, 2).set_surface(0, 0, {0, 0, 0}, {0, 1, 0}, 1, (1U << 24U) + 1, 0),
                    std::invalid_argument);
}

TEST_CASE("what is no surface gives nothing and becomes black") {
  constexpr int size = 9;
  const float infinite = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  SurfacePicture surfaces = plane_surfaces(size, size);
  surfaces.set_surface(0, 0, {nan, 0, 0}, {0, 1, 0}, 1, 3, 5);
  surfaces.set_surface(1, 0, {0, infinite, 0}, {0, 1, 0}, 1, 3, 5);
  surfaces.set_surface(2, 0, {0, 0, 0}, {0, 0, 0}, 1, 3, 5);
  surfaces.set_surface(3, 0, {0, 0, 0}, {0, nan, 0}, 1, 3, 5);
  surfaces.set_surface(4, 0, {0, 0, 0}, {0, 1, 0}, 0, 3, 5);
  surfaces.set_surface(5, 0, {0, 0, 0}, {0, 1, 0}, nan, 3, 5);
  surfaces.clear(6, 0);
  PlanePicture<float> picture(size, size, 1);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) picture.set(x, y, 0, surfaces.has_surface(x, y) ? 1.0F : nan);
  }
  zonal::filter(picture, surfaces, {3, 3});
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      CAPTURE(x, y);
      const bool is_there = y > 0 || x > 6;
      REQUIRE(surfaces.has_surface(x, y) == is_there);
      REQUIRE(std::abs(picture.get(x, y, 0) - (is_there ? 1.0F : 0.0F)) < 1e-6F);
    }
  }
}
