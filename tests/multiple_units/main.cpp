// Every header in three translation units: a definition that is not inline breaks the link.
#include <array>
#include <cstdio>

#include "all_headers.hpp"

float from_a();
float from_b();

int main() {
  const auto sh = zonal::evaluate<4>(std::array<float, 3>{0.0f, 0.6f, 0.8f});
  const float here = zonal::dot(sh, sh);
  if (from_a() == here && from_b() == here) return 0;
  std::puts("the three translation units disagree");
  return 1;
}
