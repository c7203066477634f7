#include "cpp_functions.hpp"

#include <stdexcept>
#include <string>

// Each compiled apart: they take a while.
bool run_basis_function(std::string_view function, int bands, int order, const std::vector<float>& inputs,
                        std::vector<float>& outputs);
bool run_scene_function(std::string_view function, int bands, int order, const std::vector<float>& inputs,
                        std::vector<float>& outputs);

std::vector<float> run_in_cpp(std::string_view function, int bands, int order, const std::vector<float>& inputs) {
  std::vector<float> outputs;
  if (!run_basis_function(function, bands, order, inputs, outputs) &&
      !run_scene_function(function, bands, order, inputs, outputs)) {
    throw std::invalid_argument("no function " + std::string(function));
  }
  if (outputs.empty()) throw std::invalid_argument(std::string(function) + ": not at this number of bands");
  return outputs;
}
