// The error and the time of kernels (../kernels.hpp), for every scalar.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <zonal/scalar/scalar.hpp>

#include "../kernels.hpp"
#include "../run_kernel.hpp"
#include "timing.hpp"

namespace zonal_report {

/// What an entry should give. In long double the entry itself; of a cap the stable form, for all that the other forms
/// know of a small cap is lost with its cosine's last digits.
template <class Entry>
struct ReferenceOf {
  using Type = Entry;
};
template <>
struct ReferenceOf<zonal_bench::LegendreCap> {
  using Type = zonal_bench::kernels::Cap;
};
template <>
struct ReferenceOf<zonal_bench::ClosedFormCap> {
  using Type = zonal_bench::kernels::Cap;
};

/// The greatest error, in units of the largest value: of a cap's largest coefficient, else of the degree's, values and
/// gradients apart.
class ErrorByDegree {
 public:
  explicit ErrorByDegree(int bands) : bands_(bands), errors_(std::size_t(2 * bands)), units_(errors_) {}

  void add(const std::vector<long double>& exact, const std::vector<double>& got) {
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
template <class Kernel, class T>
void add_error(const std::vector<double>& numbers, std::size_t output_count, ErrorByDegree& error) {
  using Lane = zonal::lane_t<T>;
  using Entry = typename Kernel::Entry;
  std::vector<T> input, output(output_count);
  std::vector<long double> exact_input, exact(output_count);
  for (const double number : numbers) {
    input.push_back(T(static_cast<Lane>(number)));
    exact_input.push_back(static_cast<Lane>(number));  // the input counts as exact
  }
  zonal::kernels::run_plainly<Entry, Kernel::bands>(input.data(), output.data());
  zonal::kernels::run_plainly<typename ReferenceOf<Entry>::Type, Kernel::bands>(exact_input.data(), exact.data());
  std::vector<double> got;
  for (const T& x : output) {
    if constexpr (zonal::is_builtin_scalar_v<T>) {
      got.push_back(double(x));
    } else {
      got.push_back(double(x[0]));
    }
  }
  error.add(exact, got);
}

template <class Kernel, class T>
double greatest_error(const zonal_bench::KernelFacts& facts, std::size_t output_count, int samples) {
  zonal::kernels::InputSampler sampler(2, Kernel::bands, zonal::kernels::Draw::hard);
  ErrorByDegree error(Kernel::bands);
  for (int i = 0; i < samples; ++i) add_error<Kernel, T>(sampler.draw(facts.parameters), output_count, error);
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
    const auto& facts = zonal_bench::find_facts(Kernel::name, Kernel::bands);
    const auto data = std::make_shared<zonal_bench::KernelData<T>>(zonal_bench::draw_data<T>(facts, Kernel::bands));
    const double error = greatest_error<Kernel, T>(facts, data->outputs.size(), choose(effort_, 100, 4000, 40000));
    entries_.push_back({Kernel::name, Scalar::name, Scalar::lanes, data->runs * Scalar::lanes, Kernel::bands, error,
                        [data] { zonal_bench::run_on_all<typename Kernel::Entry, Kernel::bands>(*data); }});
  }

  const char* quantity_;
  Effort effort_;
  std::vector<Entry> entries_;
};

void print_basis(Effort effort);
void print_gradient(Effort effort);
void print_lobes(Effort effort);

}  // namespace zonal_report
