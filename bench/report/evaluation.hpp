// The error and the time of kernels (../kernels.hpp), for every scalar.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <zonal/scalar/scalar.hpp>

#include "../run_kernel.hpp"
#include "timing.hpp"

namespace zonal_report {

/// Inputs that are hard: every second direction lies at 1e-1 to 1e-7 from a pole, every second cap has a half angle of
/// 1e-1 to 1e-4.
template <class Domain>
auto draw_hard(zonal_bench::Random& random, int index) {
  auto numbers = Domain::draw(random);
  if (index % 2 == 0) return numbers;
  std::uniform_real_distribution<double> uniform;
  const double decades = Domain::inputs == 2 ? 3 : 6;
  const double angle = std::pow(10.0, -1 - decades * uniform(random)), phi = 2 * double(zonal::kPi) * uniform(random);
  if constexpr (Domain::inputs == 2) {
    numbers = {std::cos(angle), std::sin(angle)};
  } else {
    numbers[0] = std::sin(angle) * std::cos(phi);
    numbers[1] = std::sin(angle) * std::sin(phi);
    numbers[2] = std::cos(angle) * (index % 4 == 1 ? 1 : -1);
  }
  return numbers;
}

/// What a kernel should give. In long double the kernel itself; of a cap the stable form, for all that the other forms
/// know of a small cap is lost with its cosine's last digits.
template <class Kernel>
struct ReferenceOf {
  using Type = Kernel;
};
template <int N>
struct ReferenceOf<zonal_bench::LegendreCap<N>> {
  using Type = zonal_bench::StableCap<N>;
};
template <int N>
struct ReferenceOf<zonal_bench::ClosedFormCap<N>> {
  using Type = zonal_bench::StableCap<N>;
};

/// The greatest error, in units of the largest value: of a cap's largest coefficient, else of the degree's, values and
/// gradients apart.
class ErrorByDegree {
 public:
  explicit ErrorByDegree(int bands) : bands_(bands), errors_(std::size_t(2 * bands)), units_(errors_) {}

  template <class Result>
  void add(const Result& exact, const std::vector<double>& got) {
    const bool is_zonal = got.size() == std::size_t(bands_);
    double largest = 1;  // of a cap: its own unit
    if (is_zonal) largest = double(std::abs(*std::max_element(exact.begin(), exact.end(), by_size)));
    auto value = exact.begin();
    for (std::size_t i = 0; i < got.size(); ++i, ++value) {
      const std::size_t k = is_zonal ? i : group(i);
      errors_[k] = std::max(errors_[k], double(std::abs(static_cast<long double>(got[i]) - *value)) / largest);
      units_[k] = std::max(units_[k], is_zonal ? 1.0 : double(std::abs(*value)));
    }
  }

  double greatest() const {
    double result = 0;
    for (std::size_t k = 0; k < errors_.size(); ++k) {
      if (units_[k] > 0) result = std::max(result, errors_[k] / units_[k]);
    }
    return result;
  }

 private:
  static bool by_size(long double a, long double b) { return std::abs(a) < std::abs(b); }

  // The degree; of a gradient, which follows the values, another one for each.
  std::size_t group(std::size_t i) const {
    const auto size = std::size_t(bands_ * bands_);
    const auto degree = std::size_t(std::sqrt(double(i % size) + 0.5));
    return i < size ? degree : degree + std::size_t(bands_);
  }

  int bands_;
  std::vector<double> errors_, units_;
};

/// Runs the kernel on one input in every lane's scalar, and hands on lane 0.
template <class Kernel, class T, class Numbers>
void add_error(const Numbers& numbers, ErrorByDegree& error) {
  using Lane = zonal::lane_t<T>;
  std::array<T, Kernel::inputs> input;
  std::array<long double, Kernel::inputs> exact_input;
  for (std::size_t i = 0; i < Kernel::inputs; ++i) {
    input[i] = T(static_cast<Lane>(numbers[i]));
    exact_input[i] = static_cast<Lane>(numbers[i]);  // the input counts as exact
  }
  const auto result = Kernel::run(input);
  std::vector<double> got;
  for (const T& x : result) {
    if constexpr (zonal::is_builtin_scalar_v<T>) {
      got.push_back(double(x));
    } else {
      got.push_back(double(x[0]));
    }
  }
  error.add(ReferenceOf<Kernel>::Type::run(exact_input), got);
}

template <class Kernel, class T>
double greatest_error(int samples) {
  zonal_bench::Random random(2);
  ErrorByDegree error(Kernel::bands);
  for (int i = 0; i < samples; ++i) {
    add_error<Kernel, T>(draw_hard<typename Kernel::Domain>(random, i), error);
  }
  return error.greatest();
}

/// Collects kernels, then times them all together.
class KernelTable {
 public:
  KernelTable(const char* quantity, Effort effort) : quantity_(quantity), effort_(effort) {}

  template <class Kernel>
  void add() {
    add<Kernel, float>();
    add<Kernel, double>();
    add<Kernel, zonal::Packet<float, zonal::kNativeLanes>>();
  }

  void print() const {
    std::vector<Body> bodies;
    for (const Entry& entry : entries_) bodies.push_back(entry.body);
    const auto seconds = median_seconds(bodies, repetitions(effort_));
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const Entry& e = entries_[i];
      print_row(quantity_, e.form, e.scalar, e.lanes, e.bands, 1e9 * seconds[i] / double(e.items), e.error);
    }
  }

 private:
  struct Entry {
    const char *form, *scalar;
    std::size_t lanes, items;
    int bands;
    double error;
    Body body;
  };

  template <class Kernel, class T>
  void add() {
    using Scalar = zonal_bench::Scalar<T>;
    const auto inputs = std::make_shared<const decltype(zonal_bench::random_inputs<typename Kernel::Domain, T>())>(
        zonal_bench::random_inputs<typename Kernel::Domain, T>());
    entries_.push_back({Kernel::name, Scalar::name, Scalar::lanes, inputs->size() * Scalar::lanes, Kernel::bands,
                        greatest_error<Kernel, T>(choose(effort_, 100, 4000, 40000)),
                        [inputs] { zonal_bench::run_on_all<Kernel>(*inputs); }});
  }

  const char* quantity_;
  Effort effort_;
  std::vector<Entry> entries_;
};

void print_basis(Effort effort);
void print_gradient(Effort effort);
void print_lobes(Effort effort);

}  // namespace zonal_report
