// The worst input found of every kernel, in float: kept in data/worst_inputs.csv, and its error checked. The search
// that found them is no part of the test command:
//   ZONAL_SEARCH_SECONDS=10 test_kernels "[search]"
// for each kernel; it begins with what is there, and keeps what is worse.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <string_view>

#include "../csv.hpp"
#include "subjects.hpp"

namespace {

const std::string path = ZONAL_TEST_DATA "/worst_inputs.csv";

using Inputs = std::vector<float>;

std::map<std::string, Inputs> kept_inputs() {
  std::map<std::string, Inputs> kept;
  for (const auto& row : read_csv_file(path)) {
    Inputs& inputs = kept[row.at(0)];
    if (row.size() < 2) continue;  // it takes none
    std::istringstream numbers(row[1]);
    for (std::string number; numbers >> number;) inputs.push_back(std::strtof(number.c_str(), nullptr));
  }
  return kept;
}

void keep(const std::map<std::string, Inputs>& all) {
  std::ofstream file(path);
  file << "kernel,inputs\n";
  for (const auto& [kernel, inputs] : all) {
    file << kernel << ',';
    const char* before = "";
    for (const float input : inputs) {
      char text[32];
      std::snprintf(text, sizeof text, "%a", static_cast<double>(input));
      file << before << text;
      before = " ";
    }
    file << '\n';
  }
}

/// The greatest error of the kernel's outputs in float, in epsilons of its unit.
double error_at(const Subject& subject, const Inputs& inputs) {
  std::vector<FloatShadow> shadows;
  for (const float input : inputs) shadows.push_back(FloatShadow::input(input));
  const std::vector<FloatShadow> outputs = subject.run(shadows);
  double largest = 0, error = 0;
  for (const FloatShadow& output : outputs) {
    largest = std::max(largest, std::abs(output.wide));
    error = std::max(error, std::abs(output.error()));
  }
  if (subject.promise.unit != zonal::accuracy::kUlpOfLargest) {
    largest = std::max(largest, static_cast<double>(subject.typical));
  }
  return error > 0 ? error / largest / epsilon<float> : 0;
}

class Search {
 public:
  Search(const Subject& subject, unsigned seed)
      : subject_(subject), random_(seed), sampler_(seed, run_bands, Draw::hard) {}

  Inputs run(Inputs best, double seconds) {
    const auto start = std::chrono::steady_clock::now();
    const auto elapsed = [&] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    if (best.empty()) best = fresh();
    double greatest = error_at(subject_, best);
    while (elapsed() < seconds) {
      Inputs inputs = fresh();
      double error = error_at(subject_, inputs);
      for (int since = 0; since < 400 && !is_singular() && elapsed() < seconds; ++since) {
        const Inputs other = neighbour(inputs);
        const double e = error_at(subject_, other);
        if (e > error) since = 0;
        if (e >= error) error = e, inputs = other;
      }
      if (error > greatest) greatest = error, best = inputs;
    }
    return best;
  }

 private:
  /// Whose error grows without bound towards inputs that have no answer: what random inputs come to is kept.
  bool is_singular() const {
    const std::string_view name = subject_.kernel.name;
    return name == "tangent_towards" || name == "visibility_place";
  }
  Inputs fresh() { return cast<float>(sampler_.draw(subject_.function.parameters)); }

  /// One parameter's numbers a little, or all the way, towards others of the domain.
  Inputs neighbour(Inputs inputs) {
    using zonal::kernels::Domain;
    if (inputs.empty()) return inputs;
    const Inputs others = fresh();
    std::uniform_real_distribution<double> uniform;
    const auto which = std::uniform_int_distribution<std::size_t>(0, inputs.size() - 1)(random_);
    std::size_t first = 0;
    for (const auto& p : subject_.function.parameters) {
      if (p.direction == zonal::kernels::Direction::out) continue;
      const auto size = static_cast<std::size_t>(p.size()), components = static_cast<std::size_t>(p.components);
      first += size;
      if (which >= first) continue;
      const bool is_unit =
          p.domain == Domain::unit_vector || p.domain == Domain::angle || p.domain == Domain::half_angle;
      const bool is_whole =
          p.domain == Domain::vertex_count || p.domain == Domain::row_count || p.domain == Domain::identity;
      const double share = is_whole || uniform(random_) < 0.1 ? 1 : std::pow(10, -7 * uniform(random_));
      const std::size_t element = first - size + (which - (first - size)) / components * components;
      double squares = 0;
      const auto mixed = [&](std::size_t i) {
        const double from = static_cast<double>(inputs[i]);
        return from + share * (static_cast<double>(others[i]) - from);
      };
      for (std::size_t c = 0; c < components; ++c) squares += mixed(element + c) * mixed(element + c);
      for (std::size_t c = 0; c < components; ++c) {
        if (!is_unit && components > 1 && uniform(random_) < 0.5) continue;
        inputs[element + c] = static_cast<float>(mixed(element + c) / (is_unit ? std::sqrt(squares) : 1));
      }
      break;
    }
    return inputs;
  }

  const Subject& subject_;
  std::mt19937 random_;
  InputSampler sampler_;
};

}  // namespace

TEST_CASE("Every kernel's worst input found has the error that is said, within the bound") {
  const auto kept = kept_inputs();
  for (const KernelRuns& kernel : all_kernels()) {
    CAPTURE(kernel.name);
    const Subject subject = subject_of(kernel);
    const auto inputs = kept.find(kernel.name);
    REQUIRE(inputs != kept.end());
    const double error = error_at(subject, inputs->second);
    CHECK(error <= 1.01 * subject.promise.worst);
    CHECK(error >= 0.99 * subject.promise.worst);
    CHECK(subject.promise.worst <= subject.promise.bound);
  }
  CHECK(kept.size() == all_kernels().size());
}

TEST_CASE("Search of every kernel's worst input", "[.][search]") {
  const char* seconds = std::getenv("ZONAL_SEARCH_SECONDS");
  auto kept = std::ifstream(path) ? kept_inputs() : std::map<std::string, Inputs>();
  unsigned seed = 1;
  for (const KernelRuns& kernel : all_kernels()) {
    const Subject subject = subject_of(kernel);
    Inputs& inputs = kept[kernel.name];
    inputs = Search(subject, ++seed).run(inputs, seconds ? std::atof(seconds) : 1);
    std::printf("%-44s bound %5.3g, worst %.4g\n", kernel.name, subject.promise.bound, error_at(subject, inputs));
    std::fflush(stdout);
    keep(kept);
  }
}
