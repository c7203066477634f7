// The kernels of double, compiled where long double is no longer, against themselves in a long double that is.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "kernels.hpp"

static_assert(sizeof(long double) > sizeof(double));

void run_short(double x, double* values);

int main() {
  // In units of 2^-52 of the value; of 1 for acos, sine and cosine; of the largest of all for harmonics and lobe.
  // 6, 2, 1.5 * 2 and 1.5 are what docs/accuracy.md and math.hpp state where long double is longer.
  const long double bounds[] = {6, 6, 2, 3, 1.5L, 1.5L, 5, 8};
  const char* const names[] = {"exp", "exp, small", "asin", "acos", "sine", "cosine", "evaluate", "Gaussian"};
  long double worst[8] = {}, at[8] = {};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 20000; ++trial) {
    const double x = uniform(random);
    double values[value_count];
    run_short(x, values);
    const auto exact = kernels<long double>(x);
    for (int i = 0; i < value_count; ++i) {
      const int kind = i < 6 ? i : i < 6 + bands * bands ? 6 : 7;
      const auto value = exact[std::size_t(i)];
      const long double unit = i < 3 ? std::abs(value) : i < 6 ? 1 : kind == 6 ? 1.5L : exact[6 + bands * bands];
      const long double error = std::abs(static_cast<long double>(values[i]) - value) / unit * 0x1p52L;
      if (error > worst[kind]) worst[kind] = error, at[kind] = x;
    }
  }
  bool good = true;
  for (int kind = 0; kind < 8; ++kind) {
    const bool is_good = worst[kind] <= bounds[kind];
    std::printf("%-12s %6.2Lf of at most %.1Lf, at %.17Lg%s\n", names[kind], worst[kind], bounds[kind], at[kind],
                is_good ? "" : "  WRONG");
    good = good && is_good;
  }
  return good ? 0 : 1;
}
