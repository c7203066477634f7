// A bound as a script for Gappa [1], which proves it by other means: a second, independent proof.
//
// Of one part of the domain, a box of the inputs: by plain intervals, so parts have to be small. No choices, no units
// that hang on the input.
//
// [1] Daumas and Melquiond, Certification of bounds on expressions involving rounded operators, ACM TOMS 37(1), 2010.
#pragma once

#include <string>

#include "prove.hpp"

namespace zonal_prove {

bool can_write_gappa(const Subject& subject);
/// That each output of the subject errs by `bound` units at most over the part.
std::string gappa_script(const Subject& subject, const Part& part, double bound);

}  // namespace zonal_prove
