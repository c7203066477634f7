// The promises of zonal/accuracy.hpp for functions that are no kernels of the registry: in float against themselves in
// double, at the same inputs, of random size and with fixed seeds.
#include <zonal/basis/gradient.hpp>
#include <zonal/basis/polynomial.hpp>
#include <zonal/lobe/gaussian_horizon.hpp>
#include <zonal/lobe/gaussian_product.hpp>
#include <zonal/material/fresnel.hpp>
#include <zonal/material/ggx.hpp>
#include <zonal/material/oren_nayar.hpp>
#include <zonal/probe/nonlinear_l1.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string_view>
#include <vector>

#include "../accuracy.hpp"
#include "../catch.hpp"

namespace {

class Numbers {
 public:
  float uniform(double low, double high) {
    return static_cast<float>(std::uniform_real_distribution<double>(low, high)(random_));
  }
  /// Of any size between.
  float any(double low, double high) {
    return static_cast<float>(std::exp(double(uniform(std::log(low), std::log(high)))));
  }
  /// A unit vector with z > 0; every second one grazes.
  std::array<float, 3> above() {
    const double z = count_++ % 2 == 0 ? double(uniform(0.01, 1)) : double(any(1e-4, 1));
    const double phi = double(uniform(0, 6.2831853)), s = std::sqrt((1 - z) * (1 + z));
    return {static_cast<float>(s * std::cos(phi)), static_cast<float>(s * std::sin(phi)), static_cast<float>(z)};
  }

 private:
  std::mt19937 random_{7};
  int count_ = 0;
};

template <class T>
glm::vec<3, T> vector(const float* v) {
  return {static_cast<T>(v[0]), static_cast<T>(v[1]), static_cast<T>(v[2])};
}

/// draw(numbers) gives inputs, run(T(), inputs) outputs; the greatest error of an output, in epsilons of the largest.
template <class Draw, class Run>
void check(std::string_view function, const Draw& draw, const Run& run) {
  const Accuracy promise = accuracy_of(function, "float", 0);
  Numbers numbers;
  double worst = 0;
  std::vector<float> worst_inputs;
  for (int i = 0; i < 20000; ++i) {
    const auto inputs = draw(numbers);
    const auto found = run(float(), inputs.data());
    const auto exact = run(double(), inputs.data());
    double largest = promise.unit == zonal::accuracy::kUlpOfOne ? 1 : 0, error = 0;
    for (std::size_t k = 0; k < exact.size(); ++k) {
      if (promise.unit != zonal::accuracy::kUlpOfOne) largest = std::max(largest, std::abs(exact[k]));
      const double e = std::abs(static_cast<double>(found[k]) - exact[k]);
      error = std::isnan(e) ? std::numeric_limits<double>::infinity() : std::max(error, e);
    }
    const double ulps = error > 0 ? error / largest / static_cast<double>(std::numeric_limits<float>::epsilon()) : 0;
    if (ulps > worst) worst = ulps, worst_inputs.assign(inputs.begin(), inputs.end());
  }
  CAPTURE(function, worst, worst_inputs);
  CHECK(worst <= promise.bound);
  CHECK(worst <= 1.02 * promise.worst);  // another library's roots of random numbers may differ a little
  CHECK(worst >= 0.5 * promise.worst);
}

using Inputs1 = std::array<float, 1>;
using Inputs2 = std::array<float, 2>;

std::array<float, 7> two_directions(Numbers& n, double low, double high) {
  const auto a = n.above(), b = n.above();
  return {a[0], a[1], a[2], b[0], b[1], b[2], n.any(low, high)};
}

template <class Model>
void check_model(std::string_view function, double low, double high, Model model_of) {
  check(
      function, [&](Numbers& n) { return two_directions(n, low, high); },
      [&](auto t, const float* in) {
        using T = decltype(t);
        const auto f = evaluate(model_of(in[6]), vector<T>(in), vector<T>(in + 3));
        return std::array<T, 3>{f.x, f.y, f.z};
      });
}

}  // namespace

TEST_CASE("functions: spherical Gaussians and horizons") {
  const auto sharpness = [](Numbers& n) { return Inputs1{n.any(1e-3, 1e5)}; };
  check("gaussian_integral", sharpness, [](auto t, const float* in) {
    using T = decltype(t);
    return std::array{zonal::detail::gaussian_integral(static_cast<T>(in[0]))};
  });
  check("gaussian_mean_length", sharpness, [](auto t, const float* in) {
    using T = decltype(t);
    return std::array{zonal::detail::gaussian_mean_length(static_cast<T>(in[0]))};
  });
  check(
      "gaussian_above_horizon",
      [](Numbers& n) {
        return Inputs2{n.uniform(-1, 1), n.any(1e-3, 1e5)};
      },
      [](auto t, const float* in) {
        using T = decltype(t);
        const auto above = zonal::detail::gaussian_above_horizon(static_cast<T>(in[0]), static_cast<T>(in[1]));
        return std::array{above.share, above.cosine};
      });
  check(
      "gaussian_product", [](Numbers& n) { return two_directions(n, 1e-2, 1e4); },
      [](auto t, const float* in) {
        using T = decltype(t);
        const T a[3] = {static_cast<T>(in[0]), static_cast<T>(in[1]), static_cast<T>(in[2])};
        const T b[3] = {static_cast<T>(in[3]), static_cast<T>(in[4]), static_cast<T>(in[5])};
        const auto both = zonal::detail::product(a, T(3), b, static_cast<T>(in[6]));
        return std::array{both.axis[0], both.axis[1], both.axis[2]};
      });
}

TEST_CASE("functions: reflectance and materials") {
  const auto cosine = [](Numbers& n) { return Inputs1{n.any(1e-4, 1)}; };
  const auto fresnel = [&](std::string_view name, const auto& model) {
    check(name, cosine, [&](auto t, const float* in) {
      using T = decltype(t);
      const auto f = zonal::reflectance(model, static_cast<T>(in[0]));
      return std::array<T, 3>{f.x, f.y, f.z};
    });
  };
  fresnel("reflectance_conductor", zonal::ConductorFresnel{glm::vec3(0.2F, 0.9F, 1.1F), glm::vec3(3.9F, 2.4F, 2.3F)});
  fresnel("reflectance_dielectric", zonal::DielectricFresnel{1.5F});
  fresnel("reflectance_schlick", zonal::SchlickFresnel{glm::vec3(0.04F, 0.5F, 0.9F)});
  check_model("evaluate_ggx", 0.02, 1, [](float roughness) {
    return zonal::GgxBrdf{roughness, zonal::SchlickFresnel{glm::vec3(0.04F, 0.5F, 0.9F)}};
  });
  check_model("evaluate_oren_nayar", 0.02, 1, [](float roughness) {
    return zonal::OrenNayarBrdf{glm::vec3(0.2F, 0.5F, 0.9F), roughness};
  });
}

TEST_CASE("functions: other forms of the basis") {
  const auto direction = [](Numbers& n) { return n.above(); };
  check("evaluate_polynomial", direction, [](auto t, const float* in) {
    using T = decltype(t);
    const auto y = zonal::reference::evaluate_polynomial<5>(
        std::array<T, 3>{static_cast<T>(in[0]), static_cast<T>(in[1]), static_cast<T>(in[2])});
    std::array<T, 25> all;
    for (std::size_t i = 0; i < 25; ++i) all[i] = y.values[i];
    return all;
  });
  check("evaluate_with_hessian", direction, [](auto t, const float* in) {
    using T = decltype(t);
    const auto y = zonal::evaluate_with_hessian<5>(
        std::array<T, 3>{static_cast<T>(in[0]), static_cast<T>(in[1]), static_cast<T>(in[2])});
    std::array<T, 150> all;
    for (std::size_t k = 0; k < 6; ++k) {
      for (std::size_t i = 0; i < 25; ++i) all[25 * k + i] = y.hessian[k].values[i];
    }
    return all;
  });
}

TEST_CASE("functions: probes") {
  const auto light = [](Numbers& n) {  // its direction, the normal, and how much of the light comes from there
    const auto a = n.above(), b = n.above();
    return std::array<float, 8>{a[0], a[1], a[2], b[0], b[1], b[2], n.uniform(-1, 1), n.uniform(0, 1)};
  };
  check("nonlinear_irradiance_over_pi", light, [](auto t, const float* in) {
    using T = decltype(t);
    zonal::Sh<2, T> sh{};
    sh[0] = static_cast<T>(3.5449077F);  // a mean of 1
    const T size = static_cast<T>(in[7]) * static_cast<T>(6.1399603F);
    sh[1] = -size * static_cast<T>(in[1]), sh[2] = size * static_cast<T>(in[2]), sh[3] = -size * static_cast<T>(in[0]);
    const T sign = in[6] < 0 ? T(-1) : T(1);
    const std::array<T, 3> normal{sign * static_cast<T>(in[3]), sign * static_cast<T>(in[4]),
                                  sign * static_cast<T>(in[5])};
    return std::array{zonal::nonlinear_irradiance_over_pi(sh, normal)};
  });
}
