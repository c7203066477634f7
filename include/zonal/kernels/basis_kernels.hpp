// The registry's entries of the room `basis` (kernel_list.hpp).
#pragma once

#include "../basis/evaluate.hpp"
#include "../basis/gradient.hpp"
#include "kernel_io.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

struct Evaluate : Kernel {
  static constexpr const char* name = "evaluate";
  static constexpr const char* summary = "Y_l^m at a unit vector, at l (l + 1) + m.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto v = io.vector("direction", Domain::unit_vector);
    evaluate<N>(v[0], v[1], v[2], ShOutput<T>{io.template output_sh<N>("y")});
  }
};

struct EvaluateEven : Kernel {
  static constexpr const char* name = "evaluate_even";
  static constexpr const char* summary = "Y_l^m, m >= 0, at a unit vector, at l (l + 1) / 2 + m.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto v = io.vector("direction", Domain::unit_vector);
    const auto y = io.output("y", even_index(N, 0));
    evaluate_even<N>(v[0], v[2], [&](auto l, auto m, const T& value) { y[even_index(l, m)] = value; });
  }
};

struct EvaluateZonal : Kernel {
  static constexpr const char* name = "evaluate_zonal";
  static constexpr const char* summary = "Y_l^0 at an angle from the axis.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const T cos_angle = io.number("cos_angle", Domain::cosine);
    evaluate_zonal<N>(cos_angle, ZonalOutput<T>{io.output("y", N)});
  }
};

struct EvaluateWithGradient : Kernel {
  static constexpr const char* name = "evaluate_with_gradient";
  static constexpr const char* summary = "Y_l^m and the gradient of Y_l^m(v / |v|) at a unit vector.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto v = io.vector("direction", Domain::unit_vector);
    const auto y = io.template output_sh<N>("y");
    const auto gradient = io.template output_gradient<N>("gradient");
    zonal::detail::evaluate_with_gradient_into<N, T>(v[0], v[1], v[2], y.values, gradient[0], gradient[1], gradient[2]);
  }
};

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
