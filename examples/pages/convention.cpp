// Light from one engine to another, and whether one's own harmonics are what one thinks they are.
//
//   g++ -std=c++17 -Iinclude examples/pages/convention.cpp -o convention && ./convention
#include <zonal/convention/convert.hpp>
#include <zonal/convention/diagnose.hpp>
#include <zonal/convention/named.hpp>

#include <array>
#include <cstdio>

namespace {

// Somebody's basis, to be tested: one sign is wrong.
std::array<float, 9> my_basis(double x, double y, double z) {
  const double b[9] = {0.282095,
                       0.488603 * y,
                       0.488603 * z,
                       0.488603 * x,
                       1.092548 * x * y,
                       1.092548 * y * z,
                       0.315392 * (3 * z * z - 1),
                       -1.092548 * x * z,
                       0.546274 * (x * x - y * y)};
  std::array<float, 9> r{};
  for (std::size_t i = 0; i < 9; ++i) r[i] = static_cast<float>(b[i]);
  return r;
}

}  // namespace

int main() {
  // Radiance as three.js' LightProbe holds it (one channel): light from above, where y is up.
  const zonal::Sh<3, float> in_threejs{{1.0F, 0.8F, 0.1F, 0.2F, 0.1F, 0.05F, -0.2F, 0.1F, -0.3F}};
  const zonal::NamedConvention& threejs = *zonal::find_convention("threejs");
  const zonal::NamedConvention& unity = *zonal::find_convention("unity");

  // To this library's convention, from its right-handed world into Unity's left-handed one, and to Unity's numbers,
  // which are of irradiance / pi and of plain polynomials.
  const zonal::Sh<3, float> ours = zonal::convert(in_threejs, threejs.convention, zonal::Convention{});
  const zonal::Sh<3, float> turned = zonal::change_frame(ours, threejs.frame, unity.frame);
  const zonal::Sh<3, float> in_unity = zonal::convert(turned, zonal::Convention{}, unity.convention);
  std::printf("Unity's nine:");
  for (const float c : in_unity) std::printf(" %.4f", static_cast<double>(c));

  std::printf("\n%s", zonal::describe(zonal::diagnose(3, my_basis)).c_str());
}

// It prints:
//   Unity's nine: 0.2821 0.2606 -0.0326 0.0651 0.0273 -0.0137 -0.0158 -0.0273 -0.0410
//   nearest: without phase, orders -l to l, orthonormal, polar axis z
//   wrong: (2,1) has the wrong sign
