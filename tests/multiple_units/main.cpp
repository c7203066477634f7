// Every header in two translation units: a definition that is not inline breaks the link.
#include <array>
#include <cstdio>
#include <functional>

#include "all_headers.hpp"

float value_with_macros();

int main() {
  const auto sh = zonal::evaluate<4>(std::array<float, 3>{0.0f, 0.6f, 0.8f});
  if (std::equal_to<float>{}(value_with_macros(), zonal::dot(sh, sh))) return 0;
  std::puts("the two translation units disagree");
  return 1;
}
