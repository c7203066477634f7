#pragma once

#include <zonal/scalar/function_ref.hpp>

namespace example::hvl_render {

/// How finely the cuts of a slice are made: each by its own radiance, or, once it is known what a light may deviate by
/// for all to be within the tolerance, all by that, which costs less.
struct CutRule {
  float relative;
  double of_one_light = 0.0;
};

/// What the cuts of some hits show. Sums of squares, RGB added up.
struct Glance {
  double power = 0.0, variance = 0.0;
  double scaled = 0.0;  // the variance over that of one light to `exponent`

  Glance& operator+=(const Glance& other);
};

/// Looks at some hits by ever better rules, until all of them are within the tolerance, and not far. `lights` of a
/// tree.
CutRule find_cut_rule(double tolerance, int lights,
                      zonal::FunctionRef<Glance(const CutRule& rule, double exponent)> look);

}  // namespace example::hvl_render
