// A kernel of one's own, written once: as a function, with its derivative, with its rounding error, and as a shader.
// Standard library alone:
//
//   g++ -std=c++17 -O2 -Iinclude examples/pages/own_kernel.cpp -o own_kernel
#include <zonal/kernels/plain_io.hpp>
#include <zonal/scalar/dual.hpp>
#include <zonal/scalar/shadow.hpp>
#include <zonal/shader/file_text.hpp>
#include <zonal/zonal.hpp>

#include <cstdio>

// A glow, ((1 + cos theta) / 2)^power, about the z axis. Its zonal coefficients are z_l = sqrt(pi (2l+1)) I_l with
// I_0 = 2 / (power + 1), I_l = I_(l-1) (power - l + 1) / (power + l + 1).
struct Glow : zonal::kernels::Kernel {
  static constexpr const char* name = "glow";
  static constexpr const char* summary = "Zonal coefficients of ((1 + cos theta) / 2)^power.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const T power = io.number("power", zonal::kernels::Domain::exponent);
    const auto z = io.output("z", N);
    T integral = T(2) / (power + T(1));
    zonal::unroll<0, N>([&](auto l) {
      if constexpr (l > 0) integral = integral * (power - T(l - 1)) / (power + T(l + 1));
      constexpr auto scale = zonal::rounded<T>(zonal::constexpr_sqrt(zonal::kPi * (2 * l + 1)));
      z[l] = integral * T(scale);
    });
  }
};

// Its three bands for one input, in any scalar.
template <class T>
zonal::Zh<3, T> glow(const T& power) {
  zonal::Zh<3, T> z{};
  zonal::kernels::PlainIo<T> io(&power, z.values);
  Glow::run<3>(io);
  return z;
}

int main() {
  const auto plain = glow(4.0F);
  const auto with_derivative = glow(zonal::Dual<double, 1>::variable(4.0, 0));  // by the power
  const auto with_error = glow(zonal::Shadow<float, double>::input(4.0F));      // float, and double beside it
  for (int l = 0; l < 3; ++l) {
    std::printf("z_%d = %.5f, changes by %.5f, rounded off by less than 1e-6: %s\n", l, double(plain[l]),
                with_derivative[l].partial[0], std::abs(with_error[l].error()) < 1e-6 ? "yes" : "no");
  }
  const auto glsl = zonal::shader::find_dialect("glsl450");
  std::printf("%s", function_text(zonal::shader::record<Glow, 3>(), *glsl).c_str());
}

// It prints:
//   z_0 = 0.70898, changes by -0.14180, rounded off by less than 1e-6: yes
//   z_1 = 0.81866, changes by -0.09551, rounded off by less than 1e-6: yes
//   z_2 = 0.45295, changes by 0.03343, rounded off by less than 1e-6: yes
//   // Zonal coefficients of ((1 + cos theta) / 2)^power.
//   // 12 operations: 4 additions, 5 multiplications, 3 divisions, 0 square roots, 0 comparisons and choices.
//   void zonal_glow_3(float power, out float z[3]) {
//     float t0 = 2.0f / (power + 1.0f);
//     z[0] = t0 * 1.7724539f;
//     float t1 = t0 * power / (power + 2.0f);
//     z[1] = t1 * 3.0699801f;
//     z[2] = t1 * (power - 1.0f) / (power + 3.0f) * 3.9633274f;
//   }
