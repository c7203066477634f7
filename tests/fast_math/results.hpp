// What some kernels of the registry give in float, by units compiled with -ffast-math, with contraction and with
// neither. Numbers alone pass between them: each has its types in a namespace of its own.
#pragma once

#include <string>
#include <vector>

/// One run after the other: inputs.size() / runs numbers each, and results likewise.
struct KernelResults {
  std::string name;
  std::vector<float> results;
};

/// `inputs` has those of each kernel.
std::vector<KernelResults> plain_results(const std::vector<std::vector<float>>& inputs, int runs);
std::vector<KernelResults> fast_results(const std::vector<std::vector<float>>& inputs, int runs);
std::vector<KernelResults> contracted_results(const std::vector<std::vector<float>>& inputs, int runs);
