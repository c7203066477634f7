// expect-error: direction of integers
#include <array>
#include <zonal/zonal.hpp>

int main() {
#ifdef ZONAL_MUST_NOT_COMPILE
  const std::array<int, 3> direction{0, 0, 1};
#else
  const std::array<float, 3> direction{0.0f, 0.0f, 1.0f};
#endif
  const zonal::Sh<2, float> sh{};
  static_cast<void>(zonal::reconstruct(sh, direction));
}
