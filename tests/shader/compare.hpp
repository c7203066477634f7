// How a shader's numbers are compared with those of C++.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "../catch.hpp"

/// To the bit (a zero may have either sign: a record leaves out the addition of 0, which makes -0 to +0); or, where
/// hardware contracts and approximates, within 1e-5 of the largest number. `inputs` gives what to print on failure.
template <class Inputs>
void require_equal(const std::vector<float>& given, const std::vector<float>& expected, bool to_the_bit,
                   Inputs inputs) {
  REQUIRE(given.size() == expected.size());
  float largest = 0;
  for (const float value : expected) largest = std::max(largest, std::abs(value));
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const float tolerance = to_the_bit ? 0 : 1e-5F * largest;
    const bool is_same = given[i] == expected[i] || std::abs(given[i] - expected[i]) <= tolerance ||
                         (std::isnan(given[i]) && std::isnan(expected[i]));
    if (is_same) continue;
    CAPTURE(i, given[i], expected[i], largest, inputs());
    FAIL("a shader and C++ differ");
  }
}
