// expect-error: at least one band
#include <zonal/zonal.hpp>

int main() {
#ifdef ZONAL_MUST_NOT_COMPILE
  zonal::Sh<0, float> sh{};
#else
  zonal::Sh<1, float> sh{};
#endif
  static_cast<void>(sh);
}
