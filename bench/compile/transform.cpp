// rotate
#include <zonal/transform/rotate.hpp>

zonal::Sh<BANDS, float> rotated(const zonal::Sh<BANDS, float>& sh, const zonal::Rotation<BANDS, float>& rotation) {
  return zonal::rotate(sh, rotation);
}
