// What the benchmarks include of others, parsed once in the quick build (ZONAL_QUICK). A file includes what it needs all
// the same, as the release build shows.
#pragma once

#include <benchmark/benchmark.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>
