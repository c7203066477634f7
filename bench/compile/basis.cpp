// evaluate
#include <zonal/basis/evaluate.hpp>

struct Direction {
  float x, y, z;
};
zonal::Sh<BANDS, float> values(const Direction& direction) { return zonal::evaluate<BANDS>(direction); }
