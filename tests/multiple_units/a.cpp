#include <array>

#include "all_headers.hpp"

float from_a() {
  const auto sh = zonal::evaluate<4>(std::array<float, 3>{0.0f, 0.6f, 0.8f});
  return zonal::dot(sh, sh);
}
