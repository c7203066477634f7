// The generated functions are the library's.
#include <array>
#include <cmath>
#include <cstdio>
#include <zonal/zonal.hpp>

// They have evaluate in common, in either order.
#include "basis.inl"
#include "light.inl"

float value_elsewhere(const float (&direction)[3]);

int main() {
  const float direction[3] = {0.48f, -0.6f, 0.64f};
  float y[9];
  zonal_evaluate_3(direction, y);
  const auto expected = zonal::evaluate<3>(std::array<float, 3>{0.48f, -0.6f, 0.64f});
  float difference = std::fabs(value_elsewhere(direction) - expected[8]);
  for (int i = 0; i < 9; ++i) difference = std::fmax(difference, std::fabs(y[i] - expected[i]));
  std::printf("largest difference: %g\n", static_cast<double>(difference));
  return difference < 1e-6f ? 0 : 1;
}
