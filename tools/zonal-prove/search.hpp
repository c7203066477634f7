// The worst input, by hill climbing.
#pragma once

#include <vector>

#include "subject.hpp"

namespace zonal_prove {

struct WorstInput {
  double error = 0;  // in the subject's unit
  std::vector<double> inputs;
  long tried = 0;
  long not_numbers = 0;  // inputs of which an output was infinite or no number
};

/// From random inputs and then, of each climb's best, to neighbours: a few ulp to the side, or a small turn. The same
/// for the same seed and as many climbs. Exact is long double.
WorstInput search(const Subject& subject, double greatest, unsigned seed, int climbs, int steps);

}  // namespace zonal_prove
