//   same_bits                       the hashes of all kernels, as tests/data/same_bits.txt has them
//   same_bits --finite COUNT SEED   COUNT extreme inputs in range for each kernel: fails where a result is not finite
//   same_bits --hostile             the parameters whose NaN leaves no NaN in what a kernel gives
//   same_bits --write FILE          what each kernel gives in float, of inputs such as a renderer has
//   same_bits --compare FILE        how far this program's results are from those: of each kernel the greatest
//   difference
//                                   in ulps of the run's greatest number, or of the root mean square of all runs' if
//                                   that is larger; fails where one is none
//   same_bits --flush FILE          the same with denormal numbers taken for zero, on x86
#include "bits.hpp"
#include "kernel_runs.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace same_bits {
namespace {

void print_line(const KernelRuns& kernel) {
  Line<KernelRuns> line(kernel, kBands);
  line.add_packets<float, 4>();
  line.add_packets<float, 16>();
  line.add_packets<double, 4>();
  std::printf("%s\n", line.text().c_str());
}

template <class T>
bool is_finite(const KernelRuns& kernel, const char* scalar, const std::vector<double>& numbers) {
  const std::vector<T> inputs(numbers.begin(), numbers.end());
  for (const T output : kernel.run(inputs)) {
    if (std::isfinite(output)) continue;
    std::printf("%s in %s gives %g of", kernel.name, scalar, double(output));
    for (const T input : inputs) std::printf(" %.17g", double(input));
    std::printf("\n");
    return false;
  }
  return true;
}

bool is_finite(const KernelRuns& kernel, long count, unsigned seed) {
  InputSampler sampler(seed, kBands, Draw::extreme);
  for (long i = 0; i < count; ++i) {
    const std::vector<double> numbers = sampler.draw(kernel.parameters);
    if (!is_finite<float>(kernel, "float", numbers) || !is_finite<double>(kernel, "double", numbers)) return false;
  }
  return true;
}

// Of ordinary and hard inputs.
std::vector<float> usual_results(const KernelRuns& kernel) {
  Inputs inputs = inputs_of(kernel.parameters, kBands);
  const std::size_t size = inputs.numbers.size() / inputs.runs, usual = 256;
  inputs.runs = std::min(inputs.runs, usual);
  inputs.numbers.resize(size * inputs.runs);
  return results_of<float>(kernel, inputs);
}

void write(const KernelRuns& kernel, std::ofstream& file) {
  const std::vector<float> results = usual_results(kernel);
  file.write(reinterpret_cast<const char*>(results.data()), std::streamsize(results.size() * sizeof(float)));
}

bool compare(const KernelRuns& kernel, std::ifstream& file) {
  const std::vector<float> results = usual_results(kernel);
  std::vector<float> expected(results.size());
  file.read(reinterpret_cast<char*>(expected.data()), std::streamsize(expected.size() * sizeof(float)));
  double squares = 0;
  for (const float number : expected) squares += double(number) * double(number);
  const double typical = std::sqrt(squares / double(expected.size()));
  double worst = 0;
  bool good = true;
  for (std::size_t first = 0; first < results.size(); first += kernel.output_count) {
    double largest = typical, difference = 0;
    for (std::size_t i = first; i < first + kernel.output_count; ++i) {
      largest = std::max(largest, std::abs(double(expected[i])));
      difference = std::max(difference, std::abs(double(results[i]) - double(expected[i])));
      good = good && std::abs(results[i]) <= std::numeric_limits<float>::max();
    }
    if (difference > 0) worst = std::max(worst, difference / (double(std::numeric_limits<float>::epsilon()) * largest));
  }
  std::printf("%-45s %.2g\n", kernel.name, worst);
  return good;
}

bool has_nan(const std::vector<double>& numbers) {
  for (const double number : numbers) {
    if (std::isnan(number)) return true;
  }
  return false;
}

void print_lost(const KernelRuns& kernel) {
  InputSampler sampler(22, kBands, Draw::ordinary);
  const std::vector<double> base = sampler.draw(kernel.parameters);
  std::size_t k = 0;
  for (const Parameter& p : kernel.parameters) {
    if (p.direction == Direction::out) continue;
    bool is_lost = false;
    for (const std::size_t end = k + static_cast<std::size_t>(p.size()); k < end; ++k) {
      std::vector<double> numbers = base;
      numbers[k] = kHostile[0];
      is_lost = is_lost || !has_nan(kernel.run(numbers));
    }
    if (is_lost) std::printf("%s %s\n", kernel.name, p.name);
  }
}

}  // namespace
}  // namespace same_bits

int main(int count, char** arguments) {
  using namespace same_bits;
  const std::string mode = count > 1 ? arguments[1] : "";
  bool good = true;
  std::ifstream expected;
  std::ofstream written;
  if (mode == "--write" && count == 3) written.open(arguments[2], std::ios::binary);
  if ((mode == "--compare" || mode == "--flush") && count == 3) expected.open(arguments[2], std::ios::binary);
#if defined(__SSE2__)
  if (mode == "--flush") _mm_setcsr(_mm_getcsr() | 0x8040);  // flush to zero, and denormals are zeros
#endif
  for (const auto& list : {basis_kernels(), scene_kernels(), unwritten_kernels()}) {
    for (const KernelRuns& kernel : list) {
      if (mode == "--finite" && count == 4) {
        const long draws = std::atol(arguments[2]);
        const auto seed = static_cast<unsigned>(std::atol(arguments[3]));
        good = is_finite(kernel, draws, seed) && good;
      } else if (written.is_open()) {
        write(kernel, written);
      } else if (expected.is_open()) {
        good = compare(kernel, expected) && good;
      } else if (mode == "--hostile") {
        print_lost(kernel);
      } else if (mode.empty()) {
        print_line(kernel);
      } else {
        std::printf("same_bits [--finite COUNT SEED | --hostile | --write FILE | --compare FILE | --flush FILE]\n");
        return 2;
      }
    }
  }
  return good ? 0 : 1;
}
