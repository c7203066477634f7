// evaluate_with_gradient
#include <zonal/basis/gradient.hpp>

struct Direction {
  float x, y, z;
};
zonal::ShGradient<BANDS, float> gradient(const Direction& direction) {
  return zonal::evaluate_with_gradient<BANDS>(direction);
}
