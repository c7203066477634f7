// A kernel of one's own, written once: as a function, with its derivative, with its rounding error, and as a shader.
// Standard library alone:
//
//   g++ -std=c++17 -O2 -Iinclude examples/pages/own_kernel.cpp -o own_kernel
#include <zonal/kernels/plain_io.hpp>
#include <zonal/scalar/dual.hpp>
#include <zonal/scalar/shadow.hpp>
#include <zonal/shader/file_text.hpp>
#include <zonal/zonal.hpp>

#include <cmath>
#include <cstdio>

// How fog scatters, after Henyey and Greenstein: (1 - g^2) / (4 pi (1 + g^2 - 2 g cos theta)^(3/2)), forward for g > 0.
// Its zonal coefficients are z_l = sqrt((2l+1) / 4pi) g^l.
struct Fog : zonal::kernels::Kernel {
  static constexpr const char* name = "fog";
  static constexpr const char* summary = "Zonal coefficients of Henyey and Greenstein's phase function.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const T g = io.number("g", zonal::kernels::Domain::cosine);
    const auto z = io.output("z", N);
    T power = T(1);
    zonal::unroll<0, N>([&](auto l) {
      constexpr auto scale = zonal::rounded<T>(zonal::constexpr_sqrt((2 * l + 1) / (4 * zonal::kPi)));
      z[l] = T(scale) * power;
      power = power * g;
    });
  }
};

// Its three bands for one input, in any scalar.
template <class T>
zonal::Zh<3, T> fog(const T& g) {
  zonal::Zh<3, T> z{};
  zonal::kernels::PlainIo<T> io(&g, z.values);
  Fog::run<3>(io);
  return z;
}

int main() {
  const auto plain = fog(0.6F);
  const auto with_derivative = fog(zonal::Dual<double, 1>::variable(0.6, 0));  // by g
  const auto with_error = fog(zonal::Shadow<float, double>::input(0.6F));      // float, and double beside it
  for (int l = 0; l < 3; ++l) {
    std::printf("z_%d = %.5f, changes by %.5f, rounded off by less than 1e-6: %s\n", l, double(plain[l]),
                with_derivative[l].partial[0], std::abs(with_error[l].error()) < 1e-6 ? "yes" : "no");
  }
  const auto glsl = zonal::shader::find_dialect("glsl450");
  std::printf("%s", function_text(zonal::shader::record<Fog, 3>(), *glsl).c_str());
}

// It prints:
//   z_0 = 0.28209, changes by 0.00000, rounded off by less than 1e-6: yes
//   z_1 = 0.29316, changes by 0.48860, rounded off by less than 1e-6: yes
//   z_2 = 0.22708, changes by 0.75694, rounded off by less than 1e-6: yes
//   // Zonal coefficients of Henyey and Greenstein's phase function.
//   // 3 operations: 0 additions, 3 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
//   void zonal_fog_3(float g, out float z[3]) {
//     z[0] = 0.2820948f;
//     z[1] = 0.48860252f * g;
//     z[2] = 0.63078314f * (g * g);
//   }
