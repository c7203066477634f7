// expect-error: exponent of type int
#include <zonal/zonal.hpp>

int main() {
#ifdef ZONAL_MUST_NOT_COMPILE
  using T = int;
#else
  using T = float;
#endif
  static_cast<void>(zonal::project<3>(zonal::PhongLobe<T>{5}));
}
