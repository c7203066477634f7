#include <zonal/material/material_table.hpp>
#include <zonal/material/zonal_table.hpp>

#include <type_traits>

#include "../catch.hpp"
#include "support.hpp"

using namespace material_test;

namespace {

template <int N>
zonal::BrdfProjection<N> project(const zonal::Brdf& brdf, double degrees, double tolerance = 1e-5) {
  static const zonal::ProjectionQuadrature quadrature;
  const auto function = [&](const glm::dvec3& wi, const glm::dvec3& wo) { return evaluate(brdf, wi, wo); };
  return zonal::project_brdf<N>(function, std::cos(degrees * pi / 180.0), tolerance, quadrature);
}

float cos_degrees(double degrees) { return float(std::cos(degrees * pi / 180.0)); }

struct Difference {
  double with_cosine, without_cosine;  // relative to the largest coefficient
};

template <int N>
Difference difference(const zonal::MaterialTable& table, const zonal::Brdf& brdf, double degrees) {
  const auto exact = project<N>(brdf, degrees);
  const float cosine = cos_degrees(degrees);
  return {largest_difference(table.with_cosine<N>(cosine), exact.with_cosine) / largest_coefficient(exact.with_cosine),
          largest_difference(table.without_cosine<N>(cosine), exact.without_cosine) /
              largest_coefficient(exact.without_cosine)};
}

}  // namespace

TEST_CASE("table: rows are the projections, and half-way between them the stated bound holds") {
  std::vector<Named> list{{"Phong 1000", {{zonal::PhongBrdf{glm::vec3(0.5F), 1000.0F}}}}};
  for (const float roughness : {0.01F, 0.05F, 0.2F, 1.0F}) {
    list.push_back({"gold " + std::to_string(roughness), ggx(roughness, gold())});
  }
  for (const auto& [name, brdf] : list) {
    const zonal::MaterialTable table = project_material(brdf, 21);
    CHECK(table.achieved_error() <= 1e-4);
    CHECK(table.angles() == 90);
    for (int degrees = 0; degrees < 89; degrees += 4) {
      CAPTURE(name, degrees);
      const Difference on_row = difference<21>(table, brdf, degrees);
      // the row's own error, and a float cosine's: it is off by up to 0.02 degrees next to the normal
      CHECK(std::max(on_row.with_cosine, on_row.without_cosine) <= (degrees < 85 ? 5e-4 : 2e-3));

      const double middle = degrees + 0.5;
      const Difference at_5 = difference<5>(table, brdf, middle);
      const Difference at_10 = difference<10>(table, brdf, middle);
      const Difference at_21 = difference<21>(table, brdf, middle);
      const bool grazing = middle > 85.0;
      CHECK(at_5.with_cosine <= (grazing ? 3e-2 : 3e-3));
      CHECK(at_10.with_cosine <= (grazing ? 3e-2 : 5e-3));
      CHECK(at_21.with_cosine <= (grazing ? 3e-2 : 1.4e-2));
      CHECK(at_5.without_cosine <= (grazing ? 3e-2 : 1e-2));
      CHECK(at_10.without_cosine <= (grazing ? 3e-2 : 1e-2));
      CHECK(at_21.without_cosine <= (grazing ? 3e-2 : 1.4e-2));
    }
  }
}

TEST_CASE("table: the first bands of a large table are the small table") {
  const zonal::Brdf brdf = materials()[5].brdf;
  const zonal::MaterialTable small = project_material(brdf, 5), large = project_material(brdf, 8);
  CHECK(small.row_size() == 15);
  CHECK(large.with_cosine_rows().size() == 90 * 36);
  for (const double degrees : {0.0, 0.3, 44.7, 88.9, 90.0}) {
    CAPTURE(degrees);
    const float cosine = cos_degrees(degrees);
    CHECK(largest_difference(small.with_cosine<5>(cosine), large.with_cosine<5>(cosine)) == 0.0);
    CHECK(largest_difference(small.without_cosine<5>(cosine), large.without_cosine<5>(cosine)) == 0.0);
    CHECK(largest_difference(small.with_cosine<3>(cosine), large.with_cosine<3>(cosine)) == 0.0);
  }
}

TEST_CASE("table: bands that a table does not have are zero, rows that were not given too, and no number is a row") {
  const zonal::MaterialTable full = project_material(ggx(0.3F, gold()), 3);
  const auto read = [](const zonal::MaterialTable& table, float cosine) { return table.with_cosine<21>(cosine); };
  for (const float cosine : {1.0F, 0.7F, 0.0F, -1.0F, 1e30F, -1e30F, std::nanf(""), INFINITY, -INFINITY}) {
    const auto few = full.with_cosine<3>(cosine);
    const auto many = read(full, cosine);
    CAPTURE(cosine);
    for (int i = 0; i < many.size(); ++i) CHECK(many[i] == (i < few.size() ? few[i] : glm::vec3(0.0F)));
    CHECK(std::isfinite(few[0].x));
    CHECK(full.without_cosine<21>(cosine)(20, 20) == glm::vec3(0.0F));
  }
  CHECK(largest_difference(read(full, std::nanf("")), read(full, 0.0F)) == 0.0);

  const zonal::Brdf phong{{zonal::PhongBrdf{glm::vec3(0.5F), 20.0F}}};
  const zonal::ZonalTable zonal_table = zonal::project_zonal(phong, 4);
  const auto lobe = zonal_table.glossy<21>(0.5F);
  for (int l = 0; l < 21; ++l) CHECK((lobe[l] == glm::vec3(0.0F)) == (l >= 4));
  CHECK(std::isfinite(zonal_table.glossy<4>(std::nanf(""))[0].x));
}

TEST_CASE("table: rows over the upper hemisphere are converted, and are taken in no other way") {
  using Rows = std::vector<glm::vec3>;
  static_assert(!std::is_constructible_v<zonal::MaterialTable, int, int, double, Rows, Rows>);
  static_assert(!std::is_convertible_v<Rows, zonal::MirroredRows>);
  for (const zonal::Brdf& brdf : {materials()[0].brdf, materials()[5].brdf, ggx(0.4F, gold())}) {
    const zonal::MaterialTable table = project_material(brdf, 5);
    // F' of the paper, by its definition: zero below the horizon.
    Rows upper;
    for (int row = 0; row < table.angles(); ++row) {
      zonal::EvenSh<5, glm::dvec3> sum{};
      if (row % 30 == 0) {
        const glm::dvec3 wo = outgoing(row);
        midpoint_hemisphere(400, 400, [&](const glm::dvec3& wi, double solid_angle) {
          const auto basis = zonal::evaluate<5>(wi);
          const glm::dvec3 weighted = evaluate(brdf, wi, wo) * solid_angle;
          for (int l = 0; l < 5; ++l) {
            for (int m = 0; m <= l; ++m) sum(l, m) += weighted * basis(l, m);
          }
        });
      }
      for (int i = 0; i < sum.size(); ++i) upper.push_back(glm::vec3(sum[i]));
    }
    const zonal::MaterialTable converted(5, table.angles(), 0.0, table.with_cosine_rows(),
                                         zonal::MirroredRows::from_upper_hemisphere(upper, 5));
    for (int row = 0; row < table.angles(); row += 30) {
      double difference = 0.0, scale = 0.0;
      for (std::size_t i = std::size_t(15 * row); i < std::size_t(15 * (row + 1)); ++i) {
        const glm::dvec3 got(converted.without_cosine_rows()[i]), expected(table.without_cosine_rows()[i]);
        difference = std::fmax(difference, largest(got - expected));
        scale = std::fmax(scale, largest(expected));
      }
      CAPTURE(row, difference, scale);
      CHECK(difference <= 2e-3 * scale);
    }
  }
}

TEST_CASE("table: diffuse materials are one row, and are shared by the others") {
  const zonal::Brdf diffuse{{zonal::LambertBrdf{{0.7F, 0.5F, 0.2F}}}};
  const zonal::MaterialTable table = project_material(diffuse, 6);
  CHECK(table.angles() == 1);
  CHECK(table.with_cosine_rows().size() == 21);
  CHECK(largest_difference(table.with_cosine<6>(1.0F), table.with_cosine<6>(0.01F)) == 0.0);
  CHECK(double(table.with_cosine<6>(0.5F)(0, 0).x) == Approx(0.7 * 0.28209479177387814).epsilon(1e-6));

  for (const int index : {5, 6}) {  // the mixtures of the list
    const zonal::Brdf brdf = materials()[std::size_t(index)].brdf;
    const zonal::MaterialTable mixture = project_material(brdf, 10);
    CHECK(mixture.achieved_error() <= 2e-4);
    for (const double degrees : {0.0, 30.0, 80.0}) {
      CAPTURE(index, degrees);
      const Difference d = difference<10>(mixture, brdf, degrees);
      CHECK(std::max(d.with_cosine, d.without_cosine) < 2e-4);
    }
  }
  CHECK(project_material(zonal::Brdf{}, 3).achieved_error() == 0.0);
}

TEST_CASE("table: cosines out of range are the nearest row") {
  const zonal::MaterialTable table = project_material(ggx(0.3F, gold()), 4);
  const auto same = [&](float a, float b) {
    return largest_difference(table.with_cosine<4>(a), table.with_cosine<4>(b)) == 0.0;
  };
  CHECK(same(1.0F, 1.0000001F));
  CHECK(same(0.0F, cos_degrees(89.5)));
  CHECK(same(-0.3F, 0.0F));
  CHECK_FALSE(same(1.0F, 0.5F));
}

TEST_CASE("table: a window scales each degree") {
  const zonal::MaterialTable table = project_material(ggx(0.3F, gold()), 8);
  const auto raw = table.with_cosine<6>(0.8F);
  for (const zonal::Window window : {zonal::Window::none, zonal::Window::hann, zonal::Window::sinc}) {
    for (const double width : {6.0, 8.0}) {
      const zonal::MaterialTable smooth = width == 8.0 ? table.windowed(window) : table.windowed(window, width);
      CAPTURE(int(window), width);
      CHECK(largest_difference(smooth.with_cosine<6>(0.8F), zonal::apply_window(raw, window, width)) < 1e-6);
      const auto without = zonal::apply_window(table.without_cosine<6>(0.8F), window, width);
      CHECK(largest_difference(smooth.without_cosine<6>(0.8F), without) < 1e-6);
    }
  }
}

TEST_CASE("table: the caller's loop and a function in place of a Brdf give the same table") {
  const zonal::Brdf brdf = ggx(0.4F, gold());
  const zonal::MaterialTable table = project_material(brdf, 5);
  int calls = 0;
  const auto backwards = [&](int count, const auto& body) {
    for (int i = count; i-- > 0; ++calls) body(i);
  };
  const zonal::MaterialTable other = project_material(brdf, 5, 1e-4, backwards);
  CHECK(calls == 90);
  CHECK(other.with_cosine_rows() == table.with_cosine_rows());

  const auto function = [&](const glm::dvec3& wi, const glm::dvec3& wo) { return evaluate(brdf, wi, wo); };
  CHECK(zonal::project_material(function, 5).without_cosine_rows() == table.without_cosine_rows());
}
