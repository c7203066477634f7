// min and max are macros here, as by windows.h, after all other headers, as a user includes them.
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <fstream>
#include <functional>
#include <glm/glm.hpp>
#include <iostream>
#include <limits>
#include <locale>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <variant>
#include <vector>
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#include "all_headers.hpp"

float value_with_macros();

float value_with_macros() {
  const auto sh = zonal::evaluate<4>(std::array<float, 3>{0.0f, 0.6f, 0.8f});
  return zonal::dot(sh, sh);
}
