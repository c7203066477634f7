// Bounds of zonal/accuracy.hpp that are said to be proved, and the worst inputs found, which stay as cases.
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <zonal/kernels/basis_kernels.hpp>
#include <zonal/kernels/lobe_kernels.hpp>
#include <zonal/kernels/plain_io.hpp>
#include <zonal/kernels/sampler.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../accuracy.hpp"
#include "../catch.hpp"
#include "../files.hpp"
#include "gappa.hpp"
#include "prove.hpp"
#include "replay.hpp"

namespace {

using namespace zonal_prove;
using Exact = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<40>, boost::multiprecision::et_off>;

/// Those of which there is a trace, and how that is to be bounded.
template <class Visit>
void for_each_row(Visit visit) {
  for (const Accuracy& row : zonal::accuracy::kKernels) {
    for (const Provable& provable : find_provables(row.function, row.scalar, row.bands)) {
      CAPTURE(row.function, row.scalar, row.bands);
      visit(row, provable);
    }
  }
}
template <class Visit>
void for_each_proved(Visit visit) {
  for_each_row([&](const Accuracy& row, const Provable& provable) {
    if (row.ground == zonal::Ground::proved) visit(row, provable);
  });
}

template <class T>
std::vector<T> numbers(std::string_view text) {
  std::vector<T> result;
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) result.push_back(static_cast<T>(std::strtod(word.c_str(), nullptr)));
  return result;
}

template <class T>
double error_at_worst(const Subject& subject, std::string_view inputs) {
  Replay<T, Exact> replay(subject);
  replay.run(numbers<T>(inputs));
  return replay.error();
}

}  // namespace

// Of 21 bands a fixed share; whole: zonal-prove.
TEST_CASE("proof: no error is beyond the bound, over the whole range") {
  for_each_proved([](const Accuracy& row, const Provable& provable) {
    const long stride = row.bands > 10 ? 499 : 1;
    const Check check = check_bound(provable.subject(), provable.greatest, row.bound, 40, stride, stride / 2);
    CAPTURE(check.failed.cell.low[0], check.failed.cell.high[0], check.failed.cell.low[1], check.failed.cell.high[1]);
    CHECK(check.holds);
    CHECK(check.parts > 0);
  });
}

TEST_CASE("proof: a bound that is too low is refused") {
  for_each_proved([](const Accuracy& row, const Provable& provable) {
    if (row.bands <= 5) CHECK_FALSE(check_bound(provable.subject(), provable.greatest, row.worst, 8).holds);
  });
}

TEST_CASE("proof: the worst inputs found have the errors that are said, by 40 digits") {
  for_each_row([](const Accuracy& row, const Provable& provable) {
    const Subject subject = provable.subject();
    const double error = row.scalar == "float" ? error_at_worst<float>(subject, row.worst_input)
                                               : error_at_worst<double>(subject, row.worst_input);
    CHECK(error <= 1.001 * row.worst);
    CHECK(error >= 0.999 * row.worst);
    if (row.bands <= 10) CHECK(row.bound <= 8 * row.worst);
  });
}

namespace {

/// Whether gappa proves it.
bool is_proved_by_gappa(const std::string& script) {
  const file_test::Folder folder;
  file_test::write(folder.path / "script.g", script);
  return std::system(("gappa " + (folder.path / "script.g").string() + " >/dev/null 2>&1").c_str()) == 0;
}

}  // namespace

// Some parts of the range; the others: zonal-prove --gappa.
TEST_CASE("proof: gappa proves the same bounds") {
  if (std::system("command -v gappa >/dev/null 2>&1") != 0) {
    WARN("skipped: no gappa");
    return;
  }
  const auto check = [](const char* function, const std::vector<std::size_t>& places) {
    const Subject subject = find_provables(function, "float", 5).front().subject();
    const double bound = accuracy_bound(function, "float", 5);
    REQUIRE(can_write_gappa(subject));
    const std::vector<Part> parts = whole_domain(subject, 0);
    for (const std::size_t place : places) {
      CAPTURE(function, place, parts.size());
      CHECK(is_proved_by_gappa(gappa_script(subject, parts.at(place), bound)));
    }
  };
  check("evaluate_zonal", {0, 1, 2, 3, 4, 5, 6, 7});
  check("evaluate_even", {9});
  check("evaluate", {0, 60});
}

namespace {

/// The numbers that the kernel gives, and those of its trace, to the bit.
template <class Entry>
void check_trace() {
  constexpr int N = 5;
  const Subject subject = find_provables(Entry::name, "float", N).back().subject();
  Replay<float, double> replay(subject);
  zonal::kernels::InputSampler sampler(1, N, zonal::kernels::Draw::extreme);
  for (int i = 0; i < 200; ++i) {
    std::vector<float> inputs, outputs(subject.trace.outputs.size());
    for (const double input : sampler.draw(subject.parameters)) inputs.push_back(static_cast<float>(input));
    zonal::kernels::run_plainly<Entry, N>(inputs.data(), outputs.data());
    outputs = zonal::kernels::with_triples(subject.parameters, outputs);
    replay.run(inputs);
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      CAPTURE(Entry::name, inputs, k);
      REQUIRE(!(replay.output(k) < outputs[k] || replay.output(k) > outputs[k]));
    }
  }
}

}  // namespace

TEST_CASE("proof: traces are what the kernels compute, to the bit") {
  using namespace zonal::kernels;
  check_trace<Evaluate>();
  check_trace<EvaluateEven>();
  check_trace<EvaluateZonal>();
  check_trace<EvaluateWithGradient>();
  check_trace<Cap>();
  check_trace<HemisphereCap>();
  check_trace<CapDerivative>();
  check_trace<Phong>();
  check_trace<Gaussian>();
}

namespace {

/// Y_l^m by its definition, m >= 0: the associated Legendre function by its sum, and (x + iy)^m.
Exact harmonic(int l, int m, const Exact& x, const Exact& y, const Exact& z) {
  const auto factorial = [](int n) {
    Exact product = 1;
    for (int k = 2; k <= n; ++k) product *= k;
    return product;
  };
  Exact sum = 0;  // the m-th derivative of P_l, which is the l-th of (z^2 - 1)^l / (2^l l!)
  for (int k = 0; 2 * k <= l - m; ++k) {
    const int power = l - m - 2 * k;
    Exact term = factorial(2 * l - 2 * k) / (factorial(k) * factorial(l - k) * factorial(power));
    for (int i = 0; i < power; ++i) term *= z;
    sum += (k % 2 == 0 ? term : -term);
  }
  Exact c = 1, s = 0;
  for (int i = 0; i < m; ++i) {
    const Exact next = x * c - y * s;
    s = x * s + y * c;
    c = next;
  }
  Exact scale = 1;
  for (int i = 0; i < l; ++i) scale /= 2;
  const Exact pi = boost::math::constants::pi<Exact>();
  const Exact norm = sqrt((2 * l + 1) / (4 * pi) * factorial(l - m) / factorial(l + m)) * (m > 0 ? sqrt(Exact(2)) : 1);
  return (m % 2 == 0 ? 1 : -1) * norm * scale * sum * c;
}

}  // namespace

// The kernel in long double against its definition: every constant, to a change in the last place that a double has.
TEST_CASE("proof: every constant of the basis is right to the last place of a double") {
  constexpr int N = 10;
  if (std::numeric_limits<long double>::digits < 64) return;
  double worst = 0;
  for (const auto& [x, y] : {std::pair(0.6L, 0.3L), {0.25L, -0.5L}, {-0.125L, 0.0625L}, {0.75L, 0.625L}}) {
    const long double z = std::sqrt(1 - x * x - y * y);
    const auto sh = zonal::evaluate<N>(std::array{x, y, z});
    for (int l = 0; l < N; ++l) {
      for (int m = 0; m <= l; ++m) {
        const double difference = std::abs(static_cast<double>(Exact(sh(l, m)) - harmonic(l, m, x, y, z)));
        const double unit = unit_of_degree(Unit::of_the_degree, l);
        CAPTURE(l, m, difference / unit);
        worst = std::max(worst, difference / unit);
        CHECK(difference / unit <= 4e-18);
      }
    }
  }
  CAPTURE(worst);
  CHECK(worst > 1e-20);
}
