// Compiled where long double is double.
#include "kernels.hpp"

static_assert(sizeof(long double) == sizeof(double));

void run_short(double x, double* values) {
  for (double value : kernels<double>(x)) *values++ = value;
}
