// What plans leave out, against sums over directions of what is left; and gathers by a plan against full ones.
#include <zonal/gather/hvl.hpp>
#include <zonal/material/anisotropic_table.hpp>
#include <zonal/material/custom.hpp>
#include <zonal/material/material_table.hpp>
#include <zonal/material/named.hpp>
#include <zonal/material/oren_nayar.hpp>
#include <zonal/plan/kept_table.hpp>
#include <zonal/plan/material_plan.hpp>
#include <zonal/scalar/quadrature.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "../accuracy.hpp"
#include "../catch.hpp"

namespace {

using zonal::CoefficientPlan;
using zonal::MaterialTable;
using zonal::Measure;
using zonal::Symmetry;

constexpr int N = 10;
constexpr double pi = 3.14159265358979323846;

struct Named {
  std::string name;
  MaterialTable table;
};

const std::vector<Named>& materials() {
  static const std::vector<Named> all = {
      {"Lambert", zonal::project_material(zonal::matte({0.8F, 0.4F, 0.2F}), N)},
      {"rough",
       zonal::project_material(zonal::Brdf{{zonal::custom(zonal::OrenNayarBrdf{{0.8F, 0.4F, 0.2F}, 0.35F})}}, N, 1e-3)},
      {"plastic", zonal::project_material(zonal::plastic({0.1F, 0.4F, 0.7F}, 0.5F), N, 1e-3)},
      {"metal", zonal::project_material(zonal::metal(*zonal::find_metal("gold"), 0.8F), N, 1e-3)}};
  return all;
}
const MaterialTable& lambert() { return materials().front().table; }

/// Directions and weights that integrate products of two functions of N bands: Gauss nodes in z, equal steps in phi.
struct Direction {
  glm::dvec3 towards;
  double solid_angle;
};
std::vector<Direction> all_directions() {
  const zonal::QuadratureRule rule = zonal::gauss_legendre(12);
  std::vector<Direction> result;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    const double z = rule.nodes[i], s = std::sqrt(1 - z * z);
    for (int k = 0; k < 24; ++k) {
      const double phi = 2 * pi * (k + 0.5) / 24;
      result.push_back({{s * std::cos(phi), s * std::sin(phi), z}, rule.weights[i] * 2 * pi / 24});
    }
  }
  return result;
}

/// The errors of a row in place of another as they are defined: of sums over directions, a light's cap of that sine.
using Row = zonal::EvenSh<N, glm::vec3>;
zonal::PlanError measured(const Row& row, const Row& other, int bands, double sine) {
  const auto cap = zonal::project<N>(zonal::SphericalCap<double>{std::sqrt(1 - sine * sine), sine});
  double square = 0, whole = 0, greatest = 0;
  for (const Direction& direction : all_directions()) {
    const auto y = zonal::evaluate<N>(direction.towards);
    glm::dvec3 full(0), planned(0);
    for (int l = 0; l < bands; ++l) {
      const double a = sine > 0 ? cap[l] / cap[0] / std::sqrt(2.0 * l + 1) : 1;
      for (int m = 0; m <= l; ++m) {
        full += a * y(l, m) * glm::dvec3(row(l, m));
        planned += a * y(l, m) * glm::dvec3(other(l, m));
      }
    }
    const double difference = glm::dot(full - planned, full - planned);
    square += direction.solid_angle * difference;
    whole += direction.solid_angle * glm::dot(full, full);
    greatest = std::max(greatest, difference);
  }
  return {std::sqrt(square / whole), std::sqrt(greatest / (whole / (4 * pi)))};
}

Row kept_of(Row row, const CoefficientPlan& plan) {
  for (int l = 0; l < N; ++l) {
    for (int m = 0; m <= l; ++m) {
      if (!plan.keeps(l, m)) row(l, m) = glm::vec3(0);
    }
  }
  return row;
}

/// The greatest of all rows.
zonal::PlanError measured(const MaterialTable& table, int bands, const CoefficientPlan& plan, double sine = 0) {
  zonal::PlanError error;
  for (int angle = 0; angle<table.angles(); angle += sine> 0 ? 11 : 1) {
    Row row{};
    for (int i = 0; i < row.size(); ++i) row[i] = table.with_cosine_rows()[std::size_t(angle * table.row_size() + i)];
    const zonal::PlanError of_row = measured(row, kept_of(row, plan), bands, sine);
    error.mean = std::max(error.mean, of_row.mean);
    error.worst = std::max(error.worst, of_row.worst);
  }
  return error;
}

int count(const CoefficientPlan& plan) { return zonal::coefficient_count(plan.symmetry, plan.bands); }

/// As `mean` is, in single precision: the measured numbers are sums of rounded coefficients.
constexpr double rounding = 1e-6;

}  // namespace

TEST_CASE(
    "plan: the mean error is what a sum over directions gives, the worst is not exceeded, both within tolerance") {
  Met met("plan", "plan_receiver");
  for (const Named& material : materials()) {
    for (const double tolerance : {0.3, 0.1, 0.02}) {
      for (const Measure measure : {Measure::mean, Measure::worst}) {
        const CoefficientPlan plan = plan_receiver(material.table, {N, tolerance, measure});
        const zonal::PlanError seen = measured(material.table, N, plan);
        CAPTURE(material.name, tolerance, int(measure), int(plan.symmetry), plan.bands, plan.kept_count());
        CAPTURE(plan.error.mean, seen.mean, plan.error.worst, seen.worst);
        CHECK(plan.error.by(measure) <= tolerance);
        CHECK(met.meet(std::abs(plan.error.mean - seen.mean)));
        CHECK(seen.worst <= plan.error.worst + rounding);
        CHECK(plan.error.worst <= 6 * seen.worst + rounding);  // the bound says something
      }
    }
  }
  CHECK_WORST_MET(met);
}

TEST_CASE("plan: the worst error is reached where all that is left out is one coefficient of m = 0") {
  std::vector<glm::vec3> row(15, glm::vec3(0));
  row[0] = {3, 0, 4};
  row[std::size_t(zonal::even_index(3, 0))] = {0, 0.5F, 0};
  const MaterialTable table(5, 1, 0, row, zonal::MirroredRows(row));
  const CoefficientPlan plan = plan_receiver(table, {5, 0.2});
  REQUIRE(plan.bands == 1);
  const double whole = std::sqrt(25.25 / (4 * pi)), at_pole = 0.5 * std::sqrt(7 / (4 * pi));
  CHECK(plan.error.worst == Catch::Approx(at_pole / whole).epsilon(1e-9));
  CHECK(plan.error.mean == Catch::Approx(0.5 / std::sqrt(25.25)).epsilon(1e-9));
}

TEST_CASE("plan: with lights of a class no light exceeds what its errors say") {
  const zonal::CapClass classes[] = {{0, 0.25}, {0.25, 0.5}, {0.5, 0.75}, {0.75, 1}};
  for (const Named& material : materials()) {
    for (const zonal::CapClass& caps : classes) {
      const CoefficientPlan plan = plan_receiver(material.table, {N, 0.1, Measure::mean, caps});
      for (const double part : {0.001, 0.3, 0.77, 1.0}) {
        const double sine = caps.least_sine + part * (caps.greatest_sine - caps.least_sine);
        const zonal::PlanError seen = measured(material.table, N, plan, sine);
        CAPTURE(material.name, sine, plan.bands, plan.error.mean, seen.mean, plan.error.worst, seen.worst);
        CHECK(plan.error.mean <= 0.1);
        CHECK(seen.mean <= plan.error.mean + rounding);
        CHECK(seen.worst <= plan.error.worst + rounding);
      }
    }
  }
}

TEST_CASE("plan: Lambert is zonal, of degrees 0, 1, 2, 4, and sends one band") {
  const CoefficientPlan plan = plan_receiver(lambert(), {5, 0.01});
  CHECK(plan.symmetry == Symmetry::zonal);
  CHECK(plan.bands == 5);
  for (int l = 0; l < 5; ++l) {
    for (int m = -l; m <= l; ++m) CHECK(plan.keeps(l, m) == (m == 0 && l != 3));
  }
  const CoefficientPlan sent = plan_emission(lambert(), {5, 0.01});
  CHECK(sent.bands == 1);
  CHECK(sent.error.worst < 1e-6);
}

TEST_CASE("plan: gloss is even in phi and no more; a tolerance of 0 keeps all; more tolerance keeps no more") {
  for (const Named& material : materials()) {
    const CoefficientPlan all = plan_receiver(material.table, {N, 0});
    CAPTURE(material.name);
    CHECK(all.symmetry == Symmetry::mirror);
    CHECK(all.kept_count() == N * (N + 1) / 2);
    int before = count(all);
    for (double tolerance = 1e-4; tolerance < 1; tolerance *= 1.5) {
      const CoefficientPlan plan = plan_receiver(material.table, {N, tolerance});
      CAPTURE(tolerance, before);
      CHECK(count(plan) <= before);
      before = count(plan);
    }
    CHECK(before < N);
  }
  CHECK(plan_receiver(materials()[3].table, {N, 0.01}).symmetry == Symmetry::mirror);
}

TEST_CASE("plan: emission by the rows that are read") {
  const MaterialTable& metal = materials()[3].table;
  const CoefficientPlan from_above = plan_emission(metal, {N, 0.1}, {1.0F, 0.99F}),
                        all = plan_emission(metal, {N, 0.1});
  CAPTURE(from_above.bands, all.bands, from_above.error.mean, all.error.mean);
  CHECK(from_above.bands < all.bands);
  for (int l = 0; l < all.bands; ++l) {  // even in z
    for (int m = -l; m <= l; ++m) CHECK((!all.keeps(l, m) || (l + m) % 2 == 0));
  }
}

TEST_CASE("plan: of anisotropic tables, what is isotropic is found to be") {
  const std::vector<glm::vec3> directions = {{0, 0, 1}, {0.6F, 0, 0.8F}, {0, 0.6F, 0.8F}, {-0.48F, 0.64F, 0.6F}};
  const zonal::AnisotropicTable white(zonal::matte({0.8F, 0.4F, 0.2F}), 5, 1e-3, 8);
  const zonal::AnisotropicTable metal(zonal::metal(*zonal::find_metal("gold"), 0.5F), 5, 1e-3, 8);
  const zonal::AnisotropicTable brushed(zonal::BrdfFunction([](const glm::dvec3& wi, const glm::dvec3& wo) {
                                          return glm::dvec3(std::pow(std::abs(wi.x + wo.x) / 2, 4) + 0.1) *
                                                 double(wi.z > 0 && wo.z > 0);
                                        }),
                                        5, 1e-3, 8);
  CHECK(plan_receiver(white, directions, {5, 0.01}).symmetry == Symmetry::zonal);
  CHECK(plan_receiver(metal, directions, {5, 0.01}).symmetry == Symmetry::mirror);
  CHECK(plan_receiver(brushed, directions, {5, 0.01}).symmetry == Symmetry::none);
  CHECK(plan_emission(white, directions, {5, 0.01}).bands == 1);
}

TEST_CASE("plan: a planned gather differs from the full one by what the plan says") {
  std::mt19937 engine(7);
  std::normal_distribution<float> normal;
  const auto direction = [&] {
    const float x = normal(engine), y = normal(engine);
    return glm::normalize(glm::vec3(x, y, normal(engine)));
  };
  const CoefficientPlan plan = plan_receiver(lambert(), {5, 0.1});
  REQUIRE(plan.symmetry == Symmetry::zonal);
  REQUIRE(plan.bands == 3);
  const auto full = lambert().with_cosine<5>(1);
  const auto planned = zonal::with_bands<3>(zonal::about_axis(full));
  double square = 0, whole = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    zonal::VirtualLight light;
    light.position = 10.0F * direction();
    light.normal = light.to_primary = -glm::normalize(light.position);
    light.flux = glm::vec3(1);
    light.radius = 0.1F;
    light.material = &lambert();
    const zonal::HvlCache<1> cache({light});
    const zonal::Receiver receiver{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
    const glm::dvec3 a(zonal::gather<5, 1, zonal::Horizon::none>(cache, receiver, full));
    const glm::dvec3 b(zonal::gather<3, 1, zonal::Horizon::none>(cache, receiver, planned));
    square += glm::dot(a - b, a - b);
    whole += glm::dot(a, a);
  }
  const double seen = std::sqrt(square / whole);
  CAPTURE(seen, plan.error.mean);
  CHECK(seen <= 1.03 * plan.error.mean);  // negative sums are cut; 4000 directions are a sample
  CHECK(seen >= plan.error.mean / 2);
}

TEST_CASE("plan: a table of what is kept is the whole one without the rest, and of half floats within their error") {
  for (const Named& material : materials()) {
    for (const double tolerance : {0.0, 0.01, 0.1}) {
      const CoefficientPlan plan = plan_receiver(material.table, {N, tolerance});
      const zonal::KeptTable floats(material.table, plan), halves(material.table, plan, 16);
      const zonal::PlanError error = half_error(material.table, plan);
      CAPTURE(material.name, tolerance, plan.kept_count());
      CHECK(floats.row_size() == plan.kept_count());
      CHECK(floats.bytes() == std::size_t(12 * material.table.angles() * plan.kept_count()));
      CHECK(2 * halves.bytes() == floats.bytes());
      CHECK(error.mean <= 1.01 * 0x1p-11);
      zonal::PlanError greatest;
      for (float cosine = -0.05F; cosine < 1.05F; cosine += 0.013F) {
        const Row kept = kept_of(material.table.with_cosine<N>(cosine), plan);
        const Row given = floats.with_cosine<N>(cosine), rounded = halves.with_cosine<N>(cosine);
        for (int i = 0; i < kept.size(); ++i) CHECK(glm::length(given[i] - kept[i]) <= 1e-6F * glm::length(kept[0]));
        CHECK(floats.with_cosine<3>(cosine).values[5] == given[5]);  // the first bands are those of fewer
        const zonal::PlanError seen = measured(kept, rounded, N, 0);
        greatest.mean = std::max(greatest.mean, seen.mean);
        greatest.worst = std::max(greatest.worst, seen.worst);
      }
      CAPTURE(error.mean, greatest.mean, error.worst, greatest.worst);
      CHECK(greatest.mean <= error.mean + rounding);
      CHECK(greatest.worst <= error.worst + rounding);
      CHECK(error.mean <= 5 * greatest.mean);
    }
  }
}

TEST_CASE("plan: half floats do not hold what is beyond them, and keep what is nearly nothing to 2^-25") {
  const auto error_of = [](float first, float second) {
    const std::vector<glm::vec3> row = {{first, 0, 0}, {second, 0, 0}, {0, 0, 0}};
    const MaterialTable table(2, 1, 0, row, zonal::MirroredRows(row));
    return half_error(table, plan_receiver(table, {2, 0})).mean;
  };
  CHECK(std::isinf(error_of(1, 7e4F)));
  CHECK(error_of(1, 1e-7F) <= 1.001 * 0x1p-11);
  CHECK(error_of(1e-7F, 0) >= 0.19);  // 6e-8 or 1.2e-7
}

TEST_CASE("plan: 200 materials in milliseconds") {
  double best = 1e9;
  for (int run = 0; run < 5; ++run) {
    const auto start = std::chrono::steady_clock::now();
    int bands = 0;
    for (int i = 0; i < 200; ++i) {
      bands +=
          plan_receiver(materials()[3].table, {N, 0.01}).bands + plan_emission(materials()[3].table, {3, 0.01}).bands;
    }
    CHECK(bands > 0);
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  WARN("200 glossy materials of 10 bands, receivers and emission: " << best * 1e3 << " ms");
#ifdef NDEBUG
  CHECK(best < 0.1);
#endif
}
