// expect-error: at least one band
#include <array>
#include <zonal/zonal.hpp>

int main() {
  const std::array<float, 3> direction{0.0f, 0.0f, 1.0f};
#ifdef ZONAL_MUST_NOT_COMPILE
  static_cast<void>(zonal::evaluate<0>(direction));
#else
  static_cast<void>(zonal::evaluate<1>(direction));
#endif
}
