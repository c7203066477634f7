#include "cut_rule.hpp"

#include <algorithm>
#include <cmath>

namespace example::hvl_render {

Glance& Glance::operator+=(const Glance& other) {
  power += other.power, variance += other.variance, scaled += other.scaled;
  return *this;
}

CutRule find_cut_rule(double tolerance, int lights,
                      zonal::FunctionRef<Glance(const CutRule& rule, double exponent)> look) {
  constexpr int most_looks = 5;
  constexpr double margin = 0.97, near = 0.1;  // for the hits that are not looked at; of the variance
  // The variance is about as some power of that of one light: of very many lights 2/3, for the deviation is as one over
  // the lights that are drawn; of few more, for ever more of them are taken as they are.
  double exponent = 1.35 - 0.115 * std::log10(static_cast<double>(std::max(lights, 1)));
  const double first_exponent = 0.8 * exponent;
  CutRule rule{2.0f * static_cast<float>(tolerance)};
  double last = 0.0, last_variance = 0.0;
  for (int looks = 0; looks < most_looks; ++looks) {
    const Glance seen = look(rule, first_exponent);
    const double target = std::pow(margin * tolerance, 2) * seen.power;
    if (!(seen.variance > 0.0 && target > 0.0)) break;  // no cluster of more than one light adds anything
    if (looks == 0) {
      rule.of_one_light = std::pow(target / seen.scaled, 1.0 / first_exponent);
      continue;
    }
    if (last > 0.0) {
      const double seen_exponent = std::log(seen.variance / last_variance) / std::log(rule.of_one_light / last);
      if (seen_exponent > 0.0) exponent = std::clamp(seen_exponent, 0.3, 3.0);
    }
    last = rule.of_one_light, last_variance = seen.variance;
    rule.of_one_light *= std::pow(target / seen.variance, 1.0 / exponent);
    if (std::abs(seen.variance - target) < near * target) break;
  }
  rule.relative = static_cast<float>(tolerance);
  return rule;
}

}  // namespace example::hvl_render
