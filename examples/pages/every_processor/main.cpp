// Takes the best kernels that the processor has, and holds all that it has against the plainest.
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "kernels.hpp"

namespace {

struct Variant {
  const char* name;
  bool runs;
  const Kernels* kernels;
};

std::vector<float> reconstructed(const Kernels& kernels) {
  std::mt19937 random(1);
  std::normal_distribution<float> normal;
  float coefficients[75];
  for (float& coefficient : coefficients) coefficient = normal(random);
  std::vector<float> directions(3 * 1001), values(directions.size());  // in no width are all registers full
  for (std::size_t k = 0; k < directions.size(); k += 3) {
    const float x = normal(random), y = normal(random), z = normal(random), length = std::sqrt(x * x + y * y + z * z);
    directions[k] = x / length, directions[k + 1] = y / length, directions[k + 2] = z / length;
  }
  kernels.reconstruct(coefficients, directions.data(), directions.size() / 3, values.data());
  return values;
}

std::vector<float> floor_values(const Kernels& kernels) {
  std::vector<float> places(2 * 1001), values(places.size() / 2);
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = 0.003F * float(i);
  kernels.light_floor(2.0F, 0.5F, places.data(), values.size(), values.data());
  return values;
}

// The greatest difference, of the greatest value.
float difference(const std::vector<float>& a, const std::vector<float>& b) {
  float greatest = 0, apart = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    greatest = std::fmax(greatest, std::fabs(b[i]));
    apart = a[i] - b[i] < 0 ? std::fmax(apart, b[i] - a[i]) : std::fmax(apart, a[i] - b[i]);
    if (!(std::fabs(a[i]) < 1e6F)) return 1;  // no number
  }
  return apart / greatest;
}

}  // namespace

int main() {
  __builtin_cpu_init();
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
  const Variant variants[] = {
      {"sse2", true, &kernels_sse2}, {"avx2", avx2, &kernels_avx2}, {"avx512", avx512, &kernels_avx512}};

  const Variant* best = variants;
  bool agree = true;
  for (const Variant& variant : variants) {
    if (!variant.runs) {
      std::fprintf(stderr, "skipped: this processor has no %s\n", variant.name);
      continue;
    }
    best = &variant;
    const float apart[] = {difference(reconstructed(*variant.kernels), reconstructed(kernels_sse2)),
                           difference(floor_values(*variant.kernels), floor_values(kernels_sse2))};
    std::fprintf(stderr, "%s: %.1e and %.1e from sse2\n", variant.name, double(apart[0]), double(apart[1]));
    agree = agree && apart[0] < 1e-6F && apart[1] < 1e-6F;
  }
  std::fprintf(stderr, "taken: %s\n", best->name);
  std::printf("below the lamp %.4f; all that run agree within 1e-6: %s\n", double(floor_values(*best->kernels)[0]),
              agree ? "yes" : "no");
  return agree ? 0 : 1;
}

// It prints:
//   below the lamp 0.0610; all that run agree within 1e-6: yes
