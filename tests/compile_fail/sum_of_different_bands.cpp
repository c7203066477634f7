// expect-error: operator\+|invalid operands
#include <zonal/zonal.hpp>

int main() {
  zonal::Sh<3, float> three{};
#ifdef ZONAL_MUST_NOT_COMPILE
  zonal::Sh<4, float> other{};
#else
  zonal::Sh<3, float> other{};
#endif
  static_cast<void>(three + other);
}
