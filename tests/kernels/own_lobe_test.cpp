// A lobe of one's own, in one file: as an entry of the registry's form it runs in every scalar, has a record, a text in
// every dialect, an operation count and a row of the benchmarks, and is held to a bound, which has a row of
// docs/accuracy.md, with no edit anywhere else.
#include <zonal/basis/normalisation.hpp>
#include <zonal/kernels/kernel_io.hpp>
#include <zonal/scalar/quadrature.hpp>
#include <zonal/scalar/unroll.hpp>
#include <zonal/shader/file_text.hpp>

#include <cmath>
#include <cstdlib>
#include <string>

#include "../accuracy_document.hpp"
#include "../files.hpp"
#include "kernel_checks.hpp"
#if defined(ZONAL_HAS_BENCH)
#include "../../bench/run_kernel.hpp"
#endif

namespace {

/// ((1 + cos theta) / 2)^power: a glow that goes all around. By Rodrigues' formula the integral of it and P_l over u is
/// I_l = I_(l-1) (power - l + 1) / (power + l + 1), I_0 = 2 / (power + 1), for any power >= 0.
struct Glow : zonal::kernels::Kernel {
  static constexpr const char* name = "glow";
  static constexpr const char* summary = "Zonal coefficients of ((1 + cos theta) / 2)^power.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const T power = io.number("power", zonal::kernels::Domain::exponent);
    const auto z = io.output("z", N);
    T integral = T(2) / (power + T(1));
    zonal::unroll<0, N>([&](auto l) {
      if constexpr (l > 0) integral = integral * (power - T(l - 1)) / (power + T(l + 1));
      z[l] = integral * T(zonal::rounded<T>(2 * zonal::kPi * zonal::detail::zonal_normalisation<l>));
    });
  }
};

constexpr Accuracy glow_promise = zonal::accuracy::in_any_scalar("lobe", Glow::name, 6, 6, 1);

RecordedFunction glow_record() { return zonal::shader::record<Glow, run_bands>(); }

/// Whether a shell can run the program; the command otherwise has to succeed.
bool is_there(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

void require_compiles(const char* dialect, const std::string& program, const std::string& options,
                      const std::string& before, const std::string& after) {
  if (!is_there(program)) {
    WARN("no " << program);
    return;
  }
  const file_test::Folder folder;
  const std::string path = std::string(dialect) + ".txt", inside = "cd '" + folder.path.string() + "' && ";
  std::vector<RecordedFunction> functions;
  functions.push_back(glow_record());
  const std::string text = zonal::shader::file_text(functions, {}, *zonal::shader::find_dialect(dialect), "", {});
  for (const bool is_broken : {false, true}) {  // lest the compiler takes all
    file_test::write(folder.path / path, before + text + (is_broken ? "nonsense(" : "") + after);
    const int status = std::system((inside + program + " " + options + " " + path + " >log 2>&1").c_str());
    INFO(dialect << ": " << program << " " << options << " " << path);
    CHECK((status == 0) == !is_broken);
  }
}

}  // namespace

TEST_CASE("A lobe of one's own is the integral that it should be") {
  const zonal::QuadratureRule rule = zonal::gauss_legendre(16);
  for (const double power : {0.0, 1.0, 2.0, 4.0, 9.0, 20.0}) {
    double z[run_bands];
    zonal::kernels::run_plainly<Glow, run_bands>(&power, z);
    for (int l = 0; l < run_bands; ++l) {
      double sum = 0;
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double u = rule.nodes[i];
        sum += rule.weights[i] * std::pow((1 + u) / 2, power) * std::legendre(static_cast<unsigned>(l), u);
      }
      const double pi = std::acos(-1.0);
      const double expected = 2 * pi * std::sqrt((2 * l + 1) / (4 * pi)) * sum;
      CAPTURE(power, l);
      CHECK(std::abs(z[l] - expected) <= 1e-13);
    }
  }
}

TEST_CASE("A lobe of one's own in every scalar, within its bound, recorded to the bit") {
  const KernelRuns runs = runs_of<Glow>();
  const Subject subject(runs, glow_record(), glow_promise);
  check_builtin<float>(subject);
  check_builtin<double>(subject);
  check_packet<float, 8>(subject);
  check_packet<double, 4>(subject);
  check_dual(subject);
  check_shadow(subject);
  check_record(subject);
}

TEST_CASE("A lobe of one's own has an operation count") {
  // 2 / (power + 1) and its factor; for each further band two sums, two products and a division, but power - 0 none.
  const zonal::OperationCount count = glow_record().count();
  CHECK(count.divisions == run_bands);
  CHECK(count.multiplications == 1 + 2 * (run_bands - 1));
  CHECK(count.additions == 1 + 2 * (run_bands - 1) - 1);
}

TEST_CASE("A lobe of one's own has a row of docs/accuracy.md") {
  const Accuracy promises[] = {glow_promise};
  CHECK(accuracy_rows<Glow>(promises) == accuracy_row(glow_promise, Glow::summary));
  CHECK(file_test::contains(accuracy_rows<Glow>(promises),
                            "| `glow` | lobe | Zonal coefficients of ((1 + cos theta) / 2)^power. "
                            "| any | 4 | such as a renderer has | 6 (6) | ulp of "));
}

#if defined(ZONAL_HAS_BENCH)
TEST_CASE("A lobe of one's own has rows of the benchmarks") {
  struct Rows : benchmark::ConsoleReporter {
    Rows() : ConsoleReporter(OO_None) {}
    void ReportRuns(const std::vector<Run>& reported) override {
      benchmark::ConsoleReporter::ReportRuns(reported);
      runs.insert(runs.end(), reported.begin(), reported.end());
    }
    std::vector<Run> runs;
  };
  const zonal_bench::Effort least{1e-6, 1};
  zonal_bench::register_kernel<Glow, run_bands, float>(zonal_bench::facts_of<Glow, run_bands>, least);
  zonal_bench::register_kernel<Glow, run_bands, FloatPacket>(zonal_bench::facts_of<Glow, run_bands>, least);
  Rows rows;
  benchmark::RunSpecifiedBenchmarks(&rows);
  REQUIRE(rows.runs.size() == 2);
  CHECK(rows.runs[0].run_name.function_name == "glow/4/float");
  CHECK(rows.runs[1].run_name.function_name == "glow/4/packet");
  for (const auto& run : rows.runs) {
    CHECK(double(run.counters.at(zonal_bench::time_counter)) > 0);
    CHECK(double(run.counters.at("div")) == run_bands);
  }
}
#else
TEST_CASE("A lobe of one's own has rows of the benchmarks") { WARN("skipped: for want of Google Benchmark"); }
#endif

TEST_CASE("A lobe of one's own is a function of every dialect") {
  for (const auto& dialect : zonal::shader::dialects) {
    CHECK(function_text(glow_record(), dialect).find("zonal_glow_4") != std::string::npos);
  }
  const std::string main = "void main() {}\n";
  require_compiles("glsl450", "glslangValidator", "-V -S comp -o own_lobe.spv",
                   "#version 450\nlayout(local_size_x = 1) in;\n", main);
  require_compiles("glsles300", "glslangValidator", "-S frag", "#version 300 es\n", main);
  require_compiles("hlsl", "glslangValidator", "-D -V -S comp -e main -o own_lobe.spv", "",
                   "[numthreads(1, 1, 1)]\n" + main);
  require_compiles("cpp", "c++", "-std=c++17 -fsyntax-only -x c++", "", "int main() {}\n");
}
