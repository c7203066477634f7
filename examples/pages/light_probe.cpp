// A light probe in fewer bytes, and without negative light: windows, ZH3, non-linear L1, six floats, halves and bytes,
// and its sun taken out of it.
//
//   g++ -std=c++17 -O2 -Iinclude examples/pages/light_probe.cpp -o light_probe && ./light_probe
#include <zonal/environment/rgb.hpp>
#include <zonal/lobe/cap.hpp>
#include <zonal/probe/dering.hpp>
#include <zonal/probe/dominant_light.hpp>
#include <zonal/probe/nonlinear_l1.hpp>
#include <zonal/probe/six_floats.hpp>
#include <zonal/probe/storage.hpp>
#include <zonal/probe/zh3.hpp>
#include <zonal/zonal.hpp>

#include <array>
#include <cstdio>

using Rgb = zonal::Rgb<float>;  // or glm::vec3, Eigen::Vector3f
using Vec3 = std::array<float, 3>;

// Radiance on N bands of a blue half of the sky, brown ground, and a sun of 8 degrees across.
template <int N>
zonal::Sh<N, Rgb> outdoors(Vec3 sun) {
  const auto cap = [](float cosine, float sine) { return zonal::project<N>(zonal::SphericalCap<float>{cosine, sine}); };
  const auto half = cap(0, 1);
  return zonal::orient(half, Vec3{0, 0, 1}) * Rgb{0.3F, 0.5F, 0.9F} +
         zonal::orient(half, Vec3{0, 0, -1}) * Rgb{0.2F, 0.15F, 0.1F} +
         zonal::orient(cap(0.99756F, 0.06976F), sun) * Rgb{150, 130, 100};
}

int main() {
  const Vec3 sun{0.48F, 0.64F, 0.6F};
  const auto probe = outdoors<3>(sun);
  const auto truth = outdoors<15>(sun);  // 15 bands say what the irradiance is
  const auto linear = zonal::with_bands<2>(probe);

  // Radiance rings: 3 bands of a sun go below 0.
  const auto dering = zonal::dering(probe, {zonal::DeringWindow::laplacian, zonal::DeringOf::radiance});
  std::printf("least green %.3f, dered %.5f, for %.1f %% of irradiance\n", dering.channels[1].least_before,
              dering.channels[1].least_after, 100 * dering.channels[1].irradiance_error);

  // What each form has for E / pi, green: at the normal that faces the sun, upwards, and away from the sun.
  const auto zh3 = zonal::solve_zh3(probe);
  const auto hallucinated = zonal::hallucinate_zh3(linear);
  const auto six = zonal::to_six_floats(linear);
  zonal::Sh<3, float> green{};
  for (int i = 0; i < 9; ++i) green[i] = probe[i].g;
  const auto halves = zonal::to_halves(green);
  const auto bytes = zonal::to_bytes(green);
  const auto print = [&](const char* name, int size, const auto& value) {
    std::printf("%-22s %3d bytes of RGB %8.3f %8.3f %8.3f\n", name, size, double(value(sun)),
                double(value(Vec3{0, 0, 1})), double(value(Vec3{-sun[0], -sun[1], -sun[2]})));
  };
  const zonal::LambertLobe lambert;
  print("15 bands", 2700, [&](Vec3 n) { return zonal::reconstruct_convolved(truth, lambert, n).g; });
  print("3 bands", 108, [&](Vec3 n) { return zonal::reconstruct_convolved(probe, lambert, n).g; });
  print("in halves", 54, [&](Vec3 n) { return zonal::irradiance_over_pi(halves, n); });
  print("in bytes", 33, [&](Vec3 n) { return zonal::irradiance_over_pi(bytes, n); });
  print("ZH3", 60, [&](Vec3 n) { return zonal::irradiance_over_pi(zh3, n).g; });
  print("ZH3, hallucinated", 48, [&](Vec3 n) { return zonal::irradiance_over_pi(hallucinated, n).g; });
  print("2 bands", 48, [&](Vec3 n) { return zonal::reconstruct_convolved(linear, lambert, n).g; });
  print("2 bands, non-linear", 48, [&](Vec3 n) { return zonal::nonlinear_irradiance_over_pi(linear, n).g; });
  print("six floats", 24, [&](Vec3 n) { return zonal::irradiance_over_pi<Rgb>(six, n).g; });

  // The sun as a light of its own, and what is left of the probe: nowhere negative.
  const auto taken = zonal::extract_light(probe);
  std::printf("a light of E = %.2f %.2f %.2f from %.2f %.2f %.2f, %.0f %% of what fits best\n",
              double(taken.light.irradiance.r), double(taken.light.irradiance.g), double(taken.light.irradiance.b),
              double(taken.light.direction[0]), double(taken.light.direction[1]), double(taken.light.direction[2]),
              100 * taken.share);
}

// It prints:
//   least green -0.198, dered 0.07338, for 16.0 % of irradiance
//   15 bands               2700 bytes of RGB    1.066    0.880    0.224
//   3 bands                108 bytes of RGB    1.102    0.856    0.259
//   in halves               54 bytes of RGB    1.102    0.856    0.259
//   in bytes                33 bytes of RGB    1.103    0.857    0.258
//   ZH3                     60 bytes of RGB    1.092    0.869    0.226
//   ZH3, hallucinated       48 bytes of RGB    1.008    0.907    0.166
//   2 bands                 48 bytes of RGB    0.905    0.848    0.062
//   2 bands, non-linear     48 bytes of RGB    1.024    0.921    0.180
//   six floats              24 bytes of RGB    0.895    0.853    0.072
//   a light of E = 2.36 2.59 3.09 from 0.35 0.47 0.81, 100 % of what fits best
