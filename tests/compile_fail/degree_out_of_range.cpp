// expect-error: degree out of range
#include <zonal/zonal.hpp>

int main() {
  zonal::Sh<3, float> sh{};
#ifdef ZONAL_MUST_NOT_COMPILE
  static_cast<void>(zonal::get<3, 0>(sh));  // three bands: degrees 0 to 2
#else
  static_cast<void>(zonal::get<2, 0>(sh));
#endif
}
