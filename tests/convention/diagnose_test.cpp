// The doctor against planted faults, the faults of public reports, and every named convention with noise.
#include <zonal/convention/convert.hpp>
#include <zonal/convention/diagnose.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "../catch.hpp"

namespace {

using namespace zonal;

struct Table {
  int bands;
  std::vector<Direction> directions;
  std::vector<double> values;
  int count() const { return bands * bands; }
  double& at(std::size_t k, int i) {
    return values[k * static_cast<std::size_t>(count()) + static_cast<std::size_t>(i)];
  }
};

template <int N>
Table table_of(const Convention& convention, double noise = 0) {
  Table table{N, diagnosis_directions(N), {}};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-noise, noise);
  for (const Direction& d : table.directions) {
    for (const double b : evaluate_in<N, double>(convention, d)) table.values.push_back(b + uniform(random));
  }
  return table;
}

Diagnosis diagnose(const Table& table) { return zonal::diagnose(table.bands, table.directions, table.values); }

bool has_fault(const Diagnosis& found, const std::string& text) {
  for (const std::string& fault : found.faults) {
    if (fault.find(text) != std::string::npos) return true;
  }
  return false;
}

std::string term(const Convention& convention, int bands, int index) {
  for (int l = 0; l < bands; ++l) {
    for (int m = -l; m <= l; ++m) {
      if (stored_index(convention.order, l, m) == index) {
        return "(" + std::to_string(l) + "," + std::to_string(m) + ")";
      }
    }
  }
  return "none";
}

// One of each kind; the rest differ from these in what is no matter here.
std::vector<Convention> kinds() {
  return {Convention{}, Convention{Phase::none}, find_convention("unity")->convention,
          find_convention("e3nn_norm")->convention, find_convention("fuma")->convention};
}

// All single faults of N bands: one sentence, which names the term.
template <int N>
void test_single_faults(const Convention& convention) {
  const Table right = table_of<N>(convention);
  for (int i = 0; i < N * N; ++i) {
    for (const double factor :
         {-1.0, std::sqrt(2.0), std::sqrt(0.5), 3.14159265358979, 1 / 3.14159265358979, 0.5, 2.0}) {
      Table wrong = right;
      for (std::size_t k = 0; k < wrong.directions.size(); ++k) wrong.at(k, i) *= factor;
      const Diagnosis found = diagnose(wrong);
      INFO(describe(convention) << "; " << N << " bands, " << term(convention, N, i) << " times " << factor << "; "
                                << describe(found));
      REQUIRE_FALSE(found.is_right);
      REQUIRE(found.names.empty());
      REQUIRE(found.faults.size() == 1);
      REQUIRE(has_fault(found, term(convention, N, i)));
      REQUIRE(has_fault(found, factor < 0 ? "wrong sign" : "of what it should be"));
    }
    for (int j = 0; j < i; ++j) {
      if (N == 5 && j != i - 1 && j != i * 7 % 11) continue;  // a share of them, for time
      Table wrong = right;
      for (std::size_t k = 0; k < wrong.directions.size(); ++k) std::swap(wrong.at(k, i), wrong.at(k, j));
      const Diagnosis found = diagnose(wrong);
      INFO(describe(convention) << "; " << N << " bands, exchanged " << term(convention, N, j) << " and "
                                << term(convention, N, i) << "; " << describe(found));
      REQUIRE_FALSE(found.is_right);
      REQUIRE(found.faults.size() == 1);
      REQUIRE(has_fault(found, "exchanged"));
      REQUIRE(has_fault(found, term(convention, N, i)));
      REQUIRE(has_fault(found, term(convention, N, j)));
    }
  }
}

}  // namespace

TEST_CASE("doctor: every named convention is recognised, with noise of 1e-5 too") {
  const auto test = [](const NamedConvention& named, auto bands) {
    constexpr int N = decltype(bands)::value;
    if (named.bands != 0 && N > named.bands) return;
    for (const double noise : {0.0, 1e-7, 1e-5}) {
      const Diagnosis found = diagnose(table_of<N>(named.convention, noise));
      INFO(named.name << ", " << N << " bands, noise " << noise << "\n" << describe(found));
      CHECK(found.is_right);
      CHECK(std::count(found.names.begin(), found.names.end(), named.name) == 1);
      CHECK(found.faults.empty());
      // Nothing is taken for what it is not.
      for (const std::string_view name : found.names) {
        const Convention& other = find_convention(name)->convention;
        for (const Direction& d : {Direction{0.6, 0, 0.8}, Direction{2.0 / 3, -1.0 / 3, 2.0 / 3}}) {
          const auto a = evaluate_in<N, double>(named.convention, d), b = evaluate_in<N, double>(other, d);
          for (int i = 0; i < N * N; ++i) CHECK(std::abs(a[i] - b[i]) < 1e-14);
        }
      }
    }
  };
  for (const NamedConvention& named : kConventions) {
    test(named, std::integral_constant<int, 2>{});
    test(named, std::integral_constant<int, 3>{});
    test(named, std::integral_constant<int, 4>{});
  }
  test(*find_convention("zonal"), std::integral_constant<int, 10>{});
}

TEST_CASE("doctor: every sign, every exchange of two terms, every lost factor is found and named") {
  for (const Convention& convention : kinds()) test_single_faults<3>(convention);
  test_single_faults<5>(Convention{});
}

TEST_CASE("doctor: every system of axes is told") {
  for (const Axes& axes : detail::doctor::all_axes()) {
    Convention convention;
    convention.axes = axes;
    const Diagnosis found = diagnose(table_of<3>(convention));
    INFO(describe(convention) << "\n" << describe(found));
    CHECK(found.is_right == !detail::doctor::is_mirrored(axes));
    // Half a turn about the polar axis is the phase.
    const Axes turned{-axes.x, -axes.y, axes.z};
    const bool is_same = found.convention.axes == axes && found.convention.phase == Phase::condon_shortley;
    const bool is_by_phase = found.convention.axes == turned && found.convention.phase == Phase::none;
    CHECK((is_same || is_by_phase));
    CHECK(has_fault(found, "left-handed") == detail::doctor::is_mirrored(axes));
  }
}

TEST_CASE("doctor: one wrong term in 25, whatever it mixes with") {
  const Table right = table_of<5>(Convention{});
  for (int i = 0; i < 25; ++i) {
    for (int j = i % 8; j < 25; j += 8) {
      if (i == j) continue;
      Table wrong = right;
      for (std::size_t k = 0; k < wrong.directions.size(); ++k) {
        wrong.at(k, i) = 0.96 * wrong.at(k, i) + 0.28 * right.values[k * 25 + static_cast<std::size_t>(j)];
      }
      const Diagnosis found = diagnose(wrong);
      INFO(describe(found));
      REQUIRE(found.faults.size() == 1);
      REQUIRE(has_fault(found, term(Convention{}, 5, i) + " mixes harmonics: it is 0.96 " + term(Convention{}, 5, i) +
                                   " + 0.28 " + term(Convention{}, 5, j)));
    }
  }
}

TEST_CASE("doctor: what is no harmonic, no number, zero, or scaled as a whole") {
  const Table right = table_of<3>(Convention{});
  Table wrong = right;
  for (std::size_t k = 0; k < wrong.directions.size(); ++k) wrong.at(k, 2) = std::abs(wrong.at(k, 2));
  CHECK(has_fault(diagnose(wrong), "(1,0) is no sum of harmonics"));
  wrong = right;
  for (std::size_t k = 0; k < wrong.directions.size(); ++k) wrong.at(k, 7) = 0;
  CHECK(has_fault(diagnose(wrong), "(2,1) is zero"));
  wrong = right;
  wrong.at(3, 5) = std::nan("");
  CHECK(has_fault(diagnose(wrong), "term 5 is no number at 1 of 100 directions"));
  wrong = right;
  for (std::size_t k = 0; k < 7; ++k) wrong.at(k, 5) = k % 2 == 0 ? 1e300 : -1e300;
  CHECK(has_fault(diagnose(wrong), "term 5 is no number at 7 of 100 directions"));
  CHECK(std::isfinite(diagnose(wrong).noise));
  wrong = right;
  for (double& v : wrong.values) v *= 3.14159265358979;
  CHECK(has_fault(diagnose(wrong), "all terms are 3.1416 (pi)"));
  CHECK(diagnose(wrong).faults.size() == 1);
  // The square root of 2 of all orders but 0.
  wrong = right;
  for (std::size_t k = 0; k < wrong.directions.size(); ++k) {
    for (const int i : {1, 3, 4, 5, 7, 8}) wrong.at(k, i) *= std::sqrt(0.5);
  }
  CHECK(diagnose(wrong).faults.size() == 1);
  CHECK(has_fault(diagnose(wrong), "(1,-1), (1,1), (2,-2), (2,-1), (2,1) and (2,2) are 0.70711 (1/sqrt(2))"));
  // With a cosine's factors: not wrong, but said.
  wrong = right;
  for (std::size_t k = 0; k < wrong.directions.size(); ++k) {
    for (int i = 1; i < 9; ++i) wrong.at(k, i) *= i < 4 ? 2.0 / 3 : 0.25;
  }
  CHECK(diagnose(wrong).convention.quantity == Quantity::irradiance_over_pi);
  CHECK(diagnose(wrong).is_right);
}

TEST_CASE("doctor: faults of public reports") {
  // KHR_gaussian_splatting, "Calculating color": (3,0) as z(2z^2 - 3x - 3y), the squares lost.
  Table wrong = table_of<4>(Convention{});
  for (std::size_t k = 0; k < wrong.directions.size(); ++k) {
    const auto [x, y, z] = wrong.directions[k];
    wrong.at(k, 12) = 0.3731763325901154 * z * (2 * z * z - 3 * x - 3 * y);
  }
  Diagnosis found = diagnose(wrong);
  INFO(describe(found));
  CHECK(found.faults.size() == 1);
  CHECK(has_fault(found, "(3,0) mixes harmonics"));
  for (const char* part : {"(2,1)", "(2,-1)", "(1,0)", "(3,0)"}) CHECK(has_fault(found, part));
  // Its appendix: (2,-1) and (2,1) with a minus before the factor and another before the polynomial.
  wrong = table_of<4>(Convention{});
  for (std::size_t k = 0; k < wrong.directions.size(); ++k) wrong.at(k, 5) *= -1, wrong.at(k, 7) *= -1;
  CHECK(has_fault(diagnose(wrong), "(2,-1) and (2,1) have the wrong sign"));
  // Its table of constants: one row for (3,-2) and (3,2), whose factor is half as large.
  wrong = table_of<4>(Convention{});
  for (std::size_t k = 0; k < wrong.directions.size(); ++k) wrong.at(k, 14) *= 2;
  CHECK(has_fault(diagnose(wrong), "(3,2) is 2 of what it should be"));
  // A harmonic of degree 4 from a table with (7z^2 - 1) for (7z^2 - 3): it mixes with degree 2.
  wrong = table_of<5>(Convention{Phase::none});
  for (std::size_t k = 0; k < wrong.directions.size(); ++k) {
    const auto [x, y, z] = wrong.directions[k];
    wrong.at(k, 19) = 0.75 * std::sqrt(5 / (2 * 3.14159265358979)) * y * z * (7 * z * z - 1);
  }
  found = diagnose(wrong);
  CHECK(has_fault(found, "(4,-1) mixes harmonics: it is 1.2247 (2,-1) + 1 (4,-1)"));
  // (4,4) with 3/16 sqrt(35/(2 pi)) for 3/16 sqrt(35/pi).
  wrong = table_of<5>(Convention{Phase::none});
  for (std::size_t k = 0; k < wrong.directions.size(); ++k) wrong.at(k, 24) *= std::sqrt(0.5);
  CHECK(has_fault(diagnose(wrong), "(4,4) is 0.70711 (1/sqrt(2)) of what it should be"));
  // A degree 3 that is products of degrees 1 and 2.
  wrong = table_of<4>(Convention{});
  for (std::size_t k = 0; k < wrong.directions.size(); ++k) wrong.at(k, 13) = wrong.at(k, 3) + wrong.at(k, 7);
  CHECK(has_fault(diagnose(wrong), "(3,1) mixes harmonics: it is 1 (1,1) + 1 (2,1)"));
  // A copy of Unreal's SHBasisFunction3 in another engine, which lost the squares: 3z - 1 and x - y.
  wrong = table_of<3>(Convention{});
  for (std::size_t k = 0; k < wrong.directions.size(); ++k) {
    const auto [x, y, z] = wrong.directions[k];
    wrong.at(k, 6) = 0.315392 * (3 * z - 1);
    wrong.at(k, 8) = 0.546274 * (x - y);
  }
  found = diagnose(wrong);
  CHECK(found.faults.size() == 2);
  CHECK(has_fault(found, "(2,0) mixes harmonics: it is 1.9365 (1,0) + -1.118 (0,0)"));
  CHECK(has_fault(found, "(2,2) mixes harmonics: it is "));
  // Six-digit constants are no fault; 0.886277 for 0.886227 (Babylon.js' polynomial) is one.
  wrong = table_of<3>(Convention{});
  for (std::size_t k = 0; k < wrong.directions.size(); ++k) {
    wrong.at(k, 0) *= 0.282095 / 0.28209479177387814;
    wrong.at(k, 2) *= 0.488603 / 0.4886025119029199;
  }
  CHECK(diagnose(wrong).is_right);
  for (std::size_t k = 0; k < wrong.directions.size(); ++k) wrong.at(k, 0) *= 0.886277 / 0.886227;
  CHECK(has_fault(diagnose(wrong), "(0,0) is 1.0001 of what it should be"));
}

TEST_CASE("doctor: directions of one's own, as many as there are terms, and refusals") {
  const Table right = table_of<3>(Convention{});
  const auto of = [&](std::size_t count, const std::vector<double>& values) {
    return zonal::diagnose(
        3,
        std::vector<Direction>(right.directions.begin(), right.directions.begin() + static_cast<std::ptrdiff_t>(count)),
        values);
  };
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  std::vector<Direction> drawn;
  std::vector<double> values;
  for (int k = 0; k < 14; ++k) {
    const double v[3] = {normal(random), normal(random), normal(random)}, length = std::hypot(v[0], v[1], v[2]);
    drawn.push_back({v[0] / length, v[1] / length, v[2] / length});
    for (const double b : evaluate_in<3, double>(find_convention("unity")->convention, drawn.back()))
      values.push_back(b);
  }
  const Diagnosis found = zonal::diagnose(3, drawn, values);
  CHECK(found.is_right);
  CHECK(std::count(found.names.begin(), found.names.end(), "unity") == 1);
  std::vector<Direction> rounded = drawn;  // to three digits, say
  for (std::size_t k = 0; k < rounded.size(); ++k) {
    for (double& component : rounded[k]) component *= k % 2 == 0 ? 1 + 9e-4 : 1 - 9e-4;
  }
  CHECK(zonal::diagnose(3, rounded, values).names == found.names);
  CHECK_THROWS_AS(of(8, std::vector<double>(72)), std::invalid_argument);
  CHECK_THROWS_AS(of(9, std::vector<double>(80)), std::invalid_argument);
  CHECK_THROWS_AS(zonal::diagnose(0, drawn, {}), std::invalid_argument);
  CHECK_THROWS_AS(zonal::diagnose(1, {{0, 0, 2}}, {1.0}), std::invalid_argument);
  const auto mine = [](double x, double y, double z) {
    return std::array<float, 4>{0.282095F, float(0.488603 * y), float(0.488603 * z), float(0.488603 * x)};
  };
  CHECK(zonal::diagnose(2, mine).is_right);
}
