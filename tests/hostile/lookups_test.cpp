// Tables that are looked up by floats: nothing outside them is read, whatever the floats are. The sanitizers of the
// preset `debug` watch; what comes out is as docs/floating_point.md has it.
#include <zonal/environment/reconstruct_picture.hpp>
#include <zonal/environment/sample.hpp>
#include <zonal/field/direction_plane.hpp>
#include <zonal/grid/adaptive_grid.hpp>
#include <zonal/grid/interpolate_visible.hpp>
#include <zonal/material/material_rows.hpp>
#include <zonal/material/merl.hpp>
#include <zonal/scalar/index.hpp>
#include <zonal/transform/sample.hpp>

#include "../catch.hpp"
#include "numbers.hpp"

using hostile::numbers;

TEST_CASE("hostile: any float gives an index of the table") {
  for (const int last : {0, 1, 89, (1 << 24) + 1, 1 << 30}) {
    for (const float x : numbers<float>()) {
      const int i = zonal::detail::index_below(x, last);
      CAPTURE(x, last, i);
      CHECK((0 <= i && i <= last));
    }
    CHECK(zonal::detail::index_below(std::numeric_limits<double>::infinity(), last) == last);
    CHECK(zonal::detail::index_below(double(last) - 0.25, last) == std::max(last - 1, 0));
    CHECK(zonal::detail::index_below(double(last), last) == last);
  }
  CHECK(zonal::detail::index_below(std::numeric_limits<double>::quiet_NaN(), 7) == 0);
}

TEST_CASE("hostile: every direction has a texel of the picture, and every place a direction or none") {
  const std::vector<float> grey(48 * 48, 0.5F);
  for (int i = 0; i < zonal::kMappingCount; ++i) {
    const auto mapping = static_cast<zonal::Mapping>(i);
    const bool is_vertical = mapping == zonal::Mapping::vertical_cross;
    const bool is_faces = mapping == zonal::Mapping::vertical_faces || mapping == zonal::Mapping::horizontal_faces;
    int width = 12, height = 12;
    if (is_vertical) width = 9;
    if (mapping == zonal::Mapping::horizontal_cross) height = 9;
    if (is_faces) (mapping == zonal::Mapping::vertical_faces ? width : height) = 2;
    const zonal::Picture<const float> picture(grey.data(), width, height, 1);
    CAPTURE(zonal::mapping_name(mapping));
    REQUIRE(zonal::Environment<float>::what_is_wrong(picture, mapping) == "");
    const zonal::Environment<float> environment(picture, mapping);
    const zonal::EnvironmentSampler<float> sampler(environment);
    environment.visit([&](const auto& own) {
      for (const glm::vec3& v : hostile::vectors()) {
        const auto place = own.texel(v);
        CAPTURE(v.x, v.y, v.z, place[0], place[1]);
        CHECK((0 <= place[0] && place[0] < width && 0 <= place[1] && place[1] < height));
        CHECK(sampler.pdf(v) >= 0);
      }
      for (const double column : numbers<double>()) {
        for (const double row : numbers<double>()) own.direction(column, row);
      }
    });
    for (const double u : numbers<double>()) {
      for (const double v : numbers<double>()) CHECK(sampler.sample(u, v).pdf >= 0);
    }
  }
}

TEST_CASE("hostile: a grid gives NaN where the position is no number, and the nearest place's value elsewhere") {
  using zonal::Interpolation;
  zonal::CoefficientGrid<2> grid({0, 0, 0}, {1, 1, 1}, {3, 4, 5});
  for (std::size_t i = 0; i < grid.vertex_count() * decltype(grid)::vertex_size; ++i) grid.data()[i] = float(i % 7);
  const zonal::GridVisibility visibility(grid.low(), grid.high(), grid.resolution());
  const glm::vec3 up(0, 0, 1);
  const auto check = [](const glm::vec3& position, const auto& value) {
    CAPTURE(position.x, position.y, position.z, value[0].x);
    CHECK(std::isnan(value[0].x) == !hostile::is_number(position));
  };
  for (const glm::vec3& v : hostile::vectors()) {
    check(v, interpolate<Interpolation::trilinear>(grid, v));
    check(v, interpolate<Interpolation::hermite>(grid, v));
    check(v, interpolate<Interpolation::hermite>(grid, visibility, v, up));
    const auto on_surface = interpolate<Interpolation::trilinear>(grid, visibility, glm::vec3(0.4F), v);
    CHECK((hostile::is_number(v) || std::isnan(on_surface[0].x)));
  }
  zonal::CoefficientGrid<2, zonal::GridContent::values> values({0, 0, 0}, {1, 1, 1}, {3, 5, 5});
  const zonal::AdaptiveGrid<2> adaptive(values, 1, 50);
  for (const glm::vec3& v : hostile::vectors()) check(v, adaptive.interpolate(v));
}

TEST_CASE("hostile: materials give numbers by any cosine and direction") {
  const std::vector<glm::vec3> rows(90 * 3, glm::vec3(1));
  const zonal::MaterialTable table(2, 90, 0, rows, zonal::MirroredRows(rows));
  for (const float cosine : numbers<float>()) {
    const glm::vec3 first = table.with_cosine<2>(cosine)[0];
    CAPTURE(cosine, first.x);
    CHECK((hostile::is_number(first) || std::isnan(cosine)));
  }
  const zonal::MerlBrdf merl(std::vector<glm::vec3>(zonal::MerlBrdf::bins, glm::vec3(0.25F)));
  const glm::dvec3 above(0.6, 0, 0.8);
  for (const glm::vec3& v : hostile::vectors()) {
    CAPTURE(v.x, v.y, v.z);
    const glm::dvec3 f = merl(glm::dvec3(v), above), g = merl(above, glm::dvec3(v));
    CHECK((f.x == 0.25 || f.x == 0));
    CHECK((g.x == 0.25 || g.x == 0));
  }
}

TEST_CASE("hostile: directions are drawn by any two numbers") {
  zonal::Sh<4, double> f{};
  f(0, 0) = 1, f(1, 0) = 0.5, f(2, 1) = 0.1;
  const zonal::ShSampler<4, double> sampler(f);
  for (const double u : numbers<double>()) {
    for (const double v : numbers<double>()) {
      const auto drawn = sampler.sample(u, v);
      CAPTURE(u, v, drawn.z);
      CHECK((std::isnan(drawn.z) || std::abs(drawn.z) <= 1));
    }
  }
}

TEST_CASE("hostile: light probes in directions that are none, and at any place") {
  zonal::DirectionPlane plane;
  const glm::ivec3 resolution(4, 5, 6);
  for (const glm::vec3& direction : hostile::vectors()) {
    const auto visit = [](const auto& add) {
      for (const glm::vec3& position : hostile::vectors()) add(position, zonal::RadianceSample{1, 1, 1});
      add(glm::vec3(2), zonal::RadianceSample{1, 1, 1});
    };
    const bool is_made = plane.make(direction, resolution, {}, visit);
    const float length2 = glm::dot(direction, direction);
    CAPTURE(direction.x, direction.y, direction.z);
    CHECK(is_made == (length2 > 0 && std::isfinite(length2)));
    if (!is_made) continue;
    for (const float x : numbers<float>()) {
      for (const float y : numbers<float>()) plane.radiance(x, y);
    }
  }
}
