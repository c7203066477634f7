// Mappings against what they say of themselves: axes, round trips, solid angles.
#include "catch.hpp"

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <zonal/environment/environment.hpp>

#include "environment/pictures.hpp"

using zonal::Mapping;

TEST_CASE("environment: a label at each axis stands where the mapping's description says") {
  // +x -x +y -y +z -z, in fractions of the width and height.
  struct Places {
    Mapping mapping;
    std::array<double, 2> at[6];
  };
  const double sixth = 1.0 / 6, twelfth = 1.0 / 12, root = std::sqrt(0.125);
  const Places expected[] = {
      {Mapping::equirectangular, {{0.5, 0.5}, {0, 0.5}, {0.25, 0.5}, {0.75, 0.5}, {-1, 0}, {-1, 1}}},
      {Mapping::vertical_cross,
       {{0.5, 0.375}, {0.5, 0.875}, {sixth, 0.375}, {1 - sixth, 0.375}, {0.5, 0.125}, {0.5, 0.625}}},
      {Mapping::horizontal_cross,
       {{0.375, 0.5}, {0.875, 0.5}, {0.125, 0.5}, {0.625, 0.5}, {0.375, sixth}, {0.375, 1 - sixth}}},
      {Mapping::vertical_faces,
       {{0.5, twelfth},
        {0.5, 3 * twelfth},
        {0.5, 5 * twelfth},
        {0.5, 7 * twelfth},
        {0.5, 9 * twelfth},
        {0.5, 11 * twelfth}}},
      {Mapping::horizontal_faces,
       {{twelfth, 0.5},
        {3 * twelfth, 0.5},
        {5 * twelfth, 0.5},
        {7 * twelfth, 0.5},
        {9 * twelfth, 0.5},
        {11 * twelfth, 0.5}}},
      // the normal is halfway between the direction and backward: at 45 degrees, sqrt(1/2) of the radius
      {Mapping::mirror_sphere,
       {{-1, -1}, {0.5, 0.5}, {0.5 - root, 0.5}, {0.5 + root, 0.5}, {0.5, 0.5 - root}, {0.5, 0.5 + root}}},
      {Mapping::angular_map, {{0.5, 0.5}, {-1, -1}, {0.25, 0.5}, {0.75, 0.5}, {0.5, 0.25}, {0.5, 0.75}}},
      {Mapping::octahedral, {{1, 0.5}, {0, 0.5}, {0.5, 1}, {0.5, 0}, {0.5, 0.5}, {-1, -1}}},
  };
  const double axes[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const Places& places : expected) {
    const auto [width, height] = picture_size(places.mapping, 60);
    zonal::visit_mapping(places.mapping, [&, w = width, h = height](auto tag) {
      const typename decltype(tag)::Type mapping(w, h);
      for (int i = 0; i < 6; ++i) {
        CAPTURE(mapping.name, i);
        const std::array<double, 2> at = places.at[i], found = mapping.texel(axes[i]);
        if (at[0] >= 0) CHECK(found[0] == Approx(at[0] * w).margin(1e-12));  // -1: on a whole line of the picture
        if (at[1] >= 0) CHECK(found[1] == Approx(at[1] * h).margin(1e-12));
        // and the texel there, or one beside it where that is beyond the edge, looks that way
        const double column = std::min(std::max(found[0], 0.5), w - 0.5),
                     row = std::min(std::max(found[1], 0.5), h - 0.5);
        const auto d = mapping.direction(column, row);
        CHECK(d[0] * axes[i][0] + d[1] * axes[i][1] + d[2] * axes[i][2] > 0.93);
      }
    });
  }
}

TEST_CASE("environment: neighbours on a cross are neighbours on the cube") {
  // Where two faces of the unfolded cube touch in the picture, directions go on smoothly.
  for (const Mapping kind : {Mapping::vertical_cross, Mapping::horizontal_cross}) {
    const auto [width, height] = picture_size(kind, 16);
    zonal::visit_mapping(kind, [&, w = width, h = height](auto tag) {
      const typename decltype(tag)::Type mapping(w, h);
      int steps = 0;
      for (int row = 0; row < h; ++row) {
        for (int column = 0; column < w; ++column) {
          for (const auto& [dx, dy] : {std::pair{1, 0}, std::pair{0, 1}}) {
            const int x = column + dx, y = row + dy;
            if (x >= w || y >= h || !mapping.has_direction(column, row) || !mapping.has_direction(x, y)) continue;
            const auto a = mapping.direction(column + 0.5, row + 0.5), b = mapping.direction(x + 0.5, y + 0.5);
            CHECK(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] > std::cos(2.01 / 16));
            ++steps;
          }
        }
      }
      CHECK(steps > 2 * 6 * 15 * 16);
    });
  }
}

TEST_CASE("environment: faces are addressed as graphics interfaces address them") {
  // The table of the OpenGL specification (4.6, table 8.19): s = (sc / |ma| + 1) / 2, t = (tc / |ma| + 1) / 2.
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const zonal::VerticalFaces vertical(32, 192);
  const zonal::HorizontalFaces horizontal(192, 32);
  for (int i = 0; i < 1000; ++i) {
    const double x = normal(random), y = normal(random), z = normal(random);
    const double ax = std::abs(x), ay = std::abs(y), az = std::abs(z);
    int face;
    double s, t, m;
    if (ax > ay && ax > az) {
      face = x > 0 ? 0 : 1, s = x > 0 ? -z : z, t = -y, m = ax;
    } else if (ay > az) {
      face = y > 0 ? 2 : 3, s = x, t = y > 0 ? z : -z, m = ay;
    } else {
      face = z > 0 ? 4 : 5, s = z > 0 ? x : -x, t = -y, m = az;
    }
    s = 16 * (s / m + 1), t = 16 * (t / m + 1);
    const std::array<double, 3> d{x, y, z};
    const auto v = vertical.texel(d), h = horizontal.texel(d);
    CHECK(std::abs(v[0] - s) + std::abs(v[1] - 32 * face - t) < 1e-12);
    CHECK(std::abs(h[0] - 32 * face - s) + std::abs(h[1] - t) < 1e-12);
  }
}

TEST_CASE("environment: texel to direction and back, in every mapping and size") {
  for_each_mapping({1, 2, 3, 4, 5, 8, 13, 64, 193}, [](const auto& mapping, int width, int height) {
    double worst = 0, length = 0, outside = 0;
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        if (!mapping.has_direction(column, row)) {
          outside = std::max(outside, mapping.solid_angle(column, row));
          continue;
        }
        for (const auto& [dx, dy] : {std::pair{0.5, 0.5}, std::pair{0.25, 0.9}}) {
          const auto d = mapping.direction(column + dx, row + dy);
          const double squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
          if (squared < 0.5) continue;  // a corner of a texel at the rim of a disc
          length = std::max(length, std::abs(squared - 1));
          const auto texel = mapping.texel(d);
          worst = std::max({worst, std::abs(texel[0] - column - dx), std::abs(texel[1] - row - dy)});
        }
      }
    }
    CAPTURE(mapping.name, width, height);
    CHECK(worst < 1e-13 * (width + height) + 1e-14);
    CHECK(length < 3e-15);
    CHECK(outside <= 0);
  });
}

TEST_CASE("environment: any direction to a texel and back") {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  std::vector<std::array<double, 3>> directions;
  for (int i = 0; i < 300; ++i) directions.push_back(unit({normal(random), normal(random), normal(random)}));
  for (const double e : {0.0, 1e-300, 1e-20, 1e-9, 1e-3}) {  // next to axes, edges of cubes and of octahedrons
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {1.0, -1.0}) {
        std::array<double, 3> d{e, -e, e}, edge{sign, sign, sign};
        d[std::size_t(axis)] = sign;
        edge[std::size_t(axis)] = e;
        directions.push_back(unit(d));
        directions.push_back(unit(edge));
      }
    }
  }
  for_each_mapping({1, 16, 1000}, [&](const auto& mapping, int width, int height) {
    double worst = 0;
    for (const auto& d : directions) {
      const auto texel = mapping.texel(d);
      REQUIRE((texel[0] >= 0 && texel[0] < width && texel[1] >= 0 && texel[1] < height));
      auto back = mapping.direction(texel[0], texel[1]);
      if (std::abs(back[0]) + std::abs(back[1]) + std::abs(back[2]) < 0.5) {  // rounded beyond the rim of a disc
        const auto inwards = [](double x, int size) { return 0.5 * size + (x - 0.5 * size) * (1 - 1e-15); };
        back = mapping.direction(inwards(texel[0], width), inwards(texel[1], height));
      }
      for (std::size_t i = 0; i < 3; ++i) worst = std::max(worst, std::abs(back[i] - d[i]));
    }
    CAPTURE(mapping.name, width, height);
    CHECK(worst < (std::string(mapping.name) == "mirror sphere" ? 2e-7 : 2e-14));  // a square root at its rim
  });
}

TEST_CASE("environment: solid angles are those of the directions, and sum to 4 pi") {
  for_each_mapping({1, 2, 3, 4, 5, 7, 8, 16, 31, 64, 192, 193, 200}, [](const auto& mapping, int width, int height) {
    long double sum = 0;
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) sum += mapping.solid_angle(column, row);
    }
    CAPTURE(mapping.name, width, height);
    CHECK(std::abs(double(sum / (4 * zonal::kPi) - 1)) < 2e-15);
    CHECK(mapping.covered() == Approx(4 * double(zonal::kPi)).epsilon(1e-15));
  });
  // Against the area that the direction sweeps, by differences at the nodes of a rule: of texels inside of a disc.
  std::mt19937 random(3);
  for_each_mapping({3, 9, 16, 48}, [&](const auto& mapping, int width, int height) {
    for (int i = 0; i < 24; ++i) {
      const int column = int(random() % unsigned(width)), row = int(random() % unsigned(height));
      if (!mapping.has_direction(column, row)) continue;
      const double area = swept_area(mapping, column, row);
      if (area < 0) continue;  // reaches over a rim
      CAPTURE(mapping.name, width, height, column, row);
      // Discs share out what their rim leaves: exact only together.
      const std::string name = mapping.name;
      const double bound = name == "mirror sphere" ? std::min(6.0 / height, 0.9)
                           : name == "angular map" ? 2.0 / height / height
                                                   : 5e-5;  // the differences'
      CHECK(mapping.solid_angle(column, row) == Approx(area).epsilon(bound));
    }
  });
}

TEST_CASE("environment: a mirror sphere's dead angle") {
  for (const double angle : {0.0, 0.2, 1.0, 3.0}) {
    const zonal::MirrorSphere mapping(101, 101, angle);
    long double sum = 0;
    for (int row = 0; row < 101; ++row) {
      for (int column = 0; column < 101; ++column) {
        sum += mapping.solid_angle(column, row);
        if (mapping.has_direction(column, row)) CHECK(mapping.direction(column + 0.5, row + 0.5)[0] < std::cos(angle));
      }
    }
    CHECK(double(sum) == Approx(2 * double(zonal::kPi) * (1 + std::cos(angle))).epsilon(1e-13));
    CHECK(mapping.covered() == Approx(2 * double(zonal::kPi) * (1 + std::cos(angle))).epsilon(1e-13));
  }
}

TEST_CASE("environment: mappings have names") {
  for (int i = 0; i < zonal::kMappingCount; ++i) {
    Mapping found{};
    CHECK(zonal::find_mapping(zonal::mapping_name(Mapping(i)), found));
    CHECK(found == Mapping(i));
  }
  Mapping untouched = Mapping::octahedral;
  CHECK(!zonal::find_mapping("cylinder", untouched));
  CHECK(untouched == Mapping::octahedral);
}
