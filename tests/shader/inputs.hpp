// Inputs of a shader function: random, and the ends of their domains.
#pragma once

#include <zonal/kernels/sampler.hpp>

#include <vector>

class InputSampler {
 public:
  InputSampler(unsigned seed, int bands) : sampler_(seed, bands, zonal::kernels::Draw::extreme) {}

  /// One value for every number of the function's inputs.
  std::vector<float> draw(const std::vector<zonal::kernels::Parameter>& parameters) {
    std::vector<float> numbers;
    for (const double value : sampler_.draw(parameters)) numbers.push_back(static_cast<float>(value));
    return numbers;
  }

 private:
  zonal::kernels::InputSampler sampler_;
};
