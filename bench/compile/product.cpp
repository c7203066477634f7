// product
#include <zonal/transform/product.hpp>

zonal::Sh<BANDS, float> both(const zonal::Sh<BANDS, float>& a, const zonal::Sh<BANDS, float>& b) {
  return zonal::product(a, b);
}
