// The kernels as shader functions: the one table that the program, the tests and the documentation read.
//
// An entry has a name, a line that says what it gives, and itself: run<N>(io) for any scalar (function_io.hpp). A new
// function is one entry here and its name in a list at the end.
//
// Some take part in a loop over lights for a sum over all orders m, "forward", or order by order, "reversed"
// [1, section 5.1]: in a loop over m around the loop over lights, few sums are alive at a time. With an order they take
// or give the coefficients of m and -m alone.
//
// [1] Mezieres et al., Recursive analytic spherical harmonics gradient for spherical lights, CGF 41(2), 2022.
#pragma once

#include "../gather/hvl.hpp"
#include "../grid/interpolation_weights.hpp"
#include "../grid/light_sums.hpp"
#include "../light/sphere.hpp"
#include "../zonal.hpp"
#include "function_io.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace glsl {

/// What most entries share.
struct Function {
  static constexpr bool has_bands = true;              // whether the number of bands matters
  static constexpr int order_count(int) { return 0; }  // the length of the loop over orders it takes part in
};

// ---- Basis ----------------------------------------------------------------------------------------------------------

struct Evaluate : Function {
  static constexpr const char* name = "evaluate";
  static constexpr const char* summary = "Y_l^m at a unit vector, at l (l + 1) + m.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto v = io.vector("direction", Domain::unit_vector);
    const auto y = io.output("y", N * N);
    evaluate<N>(v[0], v[1], v[2], [&](auto l, auto m, const T& value) { y[sh_index(l, m)] = value; });
  }
};

struct EvaluateEven : Function {
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

struct EvaluateZonal : Function {
  static constexpr const char* name = "evaluate_zonal";
  static constexpr const char* summary = "Y_l^0 at an angle from the axis.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const T cos_angle = io.number("cos_angle", Domain::cosine);
    const auto y = io.output("y", N);
    evaluate_zonal<N>(cos_angle, [&](auto l, const T& value) { y[l] = value; });
  }
};

struct EvaluateWithGradient : Function {
  static constexpr const char* name = "evaluate_with_gradient";
  static constexpr const char* summary = "Y_l^m and the gradient of Y_l^m(v / |v|) at a unit vector.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto v = io.vector("direction", Domain::unit_vector);
    const auto y = io.output("y", N * N);
    const auto gradient = io.output_triples("gradient", N * N);
    evaluate_with_gradient<N>(v[0], v[1], v[2],
                              [&](auto l, auto m, const T& value, const T& gx, const T& gy, const T& gz) {
                                y[sh_index(l, m)] = value;
                                gradient.set(sh_index(l, m), gx, gy, gz);
                              });
  }
};

// ---- Lobes ----------------------------------------------------------------------------------------------------------

struct Cap : Function {
  static constexpr const char* name = "cap";
  static constexpr const char* summary = "Zonal coefficients of a spherical cap, by cosine and sine of its half angle.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const SphericalCap<T> cap = io.cap("cap", Domain::angle);
    const auto z = io.output("z", N);
    project<N>(cap, [&](auto l, const T& value) { z[l] = value; });
  }
};

struct HemisphereCap : Function {
  static constexpr const char* name = "cap_up_to_hemisphere";
  static constexpr const char* summary = "The same up to the hemisphere, in fewer operations.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const SphericalCap<T> cap = io.cap("cap", Domain::half_angle);
    const auto z = io.output("z", N);
    project_up_to_hemisphere<N>(cap, [&](auto l, const T& value) { z[l] = value; });
  }
};

struct SphereCap : Function {
  static constexpr const char* name = "sphere_cap";
  static constexpr const char* summary = "Zonal coefficients of the cap that a sphere covers, seen from a distance.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const T distance = io.number("distance", Domain::length), radius = io.number("radius", Domain::length);
    const auto z = io.output("z", N);
    project_up_to_hemisphere<N>(SphericalCap<T>::from_sphere(distance, radius),
                                [&](auto l, const T& value) { z[l] = value; });
  }
};

struct CapDerivative : Function {
  static constexpr const char* name = "cap_derivative";
  static constexpr const char* summary = "Derivatives of the cap's coefficients by its half angle.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const SphericalCap<T> cap = io.cap("cap", Domain::angle);
    const auto z = io.output("z", N);
    project_derivative<N>(cap, [&](auto l, const T& value) { z[l] = value; });
  }
};

struct Lambert : Function {
  static constexpr const char* name = "lambert";
  static constexpr const char* summary = "Zonal coefficients of the clamped cosine over pi.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto z = io.output("z", N);
    project<N, T>(LambertLobe{}, [&](auto l, const T& value) { z[l] = value; });
  }
};

struct Phong : Function {
  static constexpr const char* name = "phong";
  static constexpr const char* summary = "Zonal coefficients of the cosine power that integrates to 1.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const T exponent = io.number("exponent", Domain::exponent);
    const auto z = io.output("z", N);
    project<N>(PhongLobe<T>{exponent}, [&](auto l, const T& value) { z[l] = value; });
  }
};

struct Gaussian : Function {
  static constexpr const char* name = "spherical_gaussian";
  static constexpr const char* summary = "Zonal coefficients of exp(sharpness (cos theta - 1)).";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const T sharpness = io.number("sharpness", Domain::exponent);
    const auto z = io.output("z", N);
    project<N>(SphericalGaussian<T>{sharpness}, [&](auto l, const T& value) { z[l] = value; });
  }
};

// ---- Transforms -----------------------------------------------------------------------------------------------------

namespace detail {
template <template <int, class> class Coefficients, int N, int Count, class Io>
auto take_coefficients(Io& io, const char* name) {
  const auto values = io.template numbers<Count>(name, Domain::coefficient);
  Coefficients<N, typename Io::Scalar> result{};
  for (int i = 0; i < Count; ++i) result[i] = values[static_cast<std::size_t>(i)];
  return result;
}
template <int N, class Io>
auto take_sh(Io& io, const char* name) {
  return take_coefficients<Sh, N, N * N>(io, name);
}
template <int N, class Io>
auto take_even(Io& io, const char* name) {
  return take_coefficients<EvenSh, N, N*(N + 1) / 2>(io, name);
}
template <int N, class Io>
auto take_zonal(Io& io, const char* name) {
  return take_coefficients<Zh, N, N>(io, name);
}
}  // namespace detail

struct Orient : Function {
  static constexpr const char* name = "orient";
  static constexpr const char* summary = "A zonal lobe turned to an axis, a unit vector.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto zh = detail::take_zonal<N>(io, "zh");
    const auto axis = io.vector("axis", Domain::unit_vector);
    const auto sh = io.output("sh", N * N);
    orient(zh, axis[0], axis[1], axis[2], [&](auto l, auto m, const T& value) { sh[sh_index(l, m)] = value; });
  }
};

struct Reconstruct : Function {
  static constexpr const char* name = "reconstruct";
  static constexpr const char* summary = "A function's value in a direction: basis and sum fused.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto sh = detail::take_sh<N>(io, "sh");
    const auto direction = io.vector("direction", Domain::unit_vector);
    io.output("value", 0)[0] = reconstruct(sh, direction);
  }
};

struct ReconstructEven : Function {
  static constexpr const char* name = "reconstruct_even";
  static constexpr const char* summary = "The value of a function that is even in phi, coefficients of m >= 0.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto sh = detail::take_even<N>(io, "sh");
    const auto v = io.vector("direction", Domain::unit_vector);
    io.output("value", 0)[0] = dot(sh, evaluate_even<N>(v[0], v[2]));
  }
};

struct ReconstructZonal : Function {
  static constexpr const char* name = "reconstruct_zonal";
  static constexpr const char* summary = "A zonal function's value at an angle from its axis.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto zh = detail::take_zonal<N>(io, "zh");
    const auto cos_angle = io.number("cos_angle", Domain::cosine);
    io.output("value", 0)[0] = reconstruct_zonal(zh, cos_angle);
  }
};

struct ReconstructLambert : Function {
  static constexpr const char* name = "reconstruct_lambert";
  static constexpr const char* summary = "Radiance convolved with the clamped cosine: irradiance over pi at a normal.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto radiance = detail::take_sh<N>(io, "radiance");
    const auto normal = io.vector("normal", Domain::unit_vector);
    io.output("value", 0)[0] = reconstruct_convolved(radiance, LambertLobe{}, normal);
  }
};

struct Convolve : Function {
  static constexpr const char* name = "convolve";
  static constexpr const char* summary = "Convolution with a zonal kernel.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto sh = detail::take_sh<N>(io, "sh");
    const auto kernel = detail::take_zonal<N>(io, "kernel");
    const auto result = io.output("result", N * N);
    const auto convolved = convolve(sh, kernel);
    for (int i = 0; i < N * N; ++i) result[i] = convolved[i];
  }
};

struct Dot : Function {
  static constexpr const char* name = "dot";
  static constexpr const char* summary = "The integral of a product: the sum of the products of coefficients.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto a = detail::take_sh<N>(io, "a"), b = detail::take_sh<N>(io, "b");
    io.output("value", 0)[0] = dot(a, b);
  }
};

template <Window window>
struct WindowFactors : Function {
  static constexpr const char* name = window == Window::hann ? "hann_window" : "sinc_window";
  static constexpr const char* summary = window == Window::hann
                                             ? "The factor of each degree, (1 + cos(pi l / width)) / 2."
                                             : "The factor of each degree, sin(pi l / width) / (pi l / width).";
  template <int N, class Io>
  static void run(Io& io) {
    const auto width = io.number("width", Domain::window_width);
    const auto factor = io.output("factor", N);
    for (int l = 0; l < N; ++l) factor[l] = window_factor(window, l, width);
  }
};

// ---- Lights ---------------------------------------------------------------------------------------------------------

namespace detail {
template <class Io>
SphereLight<typename Io::Scalar> take_sphere(Io& io) {
  const auto center = io.vector("center", Domain::position);
  return {{center[0], center[1], center[2]}, io.number("radius", Domain::length)};
}
}  // namespace detail

struct Sphere : Function {
  static constexpr const char* name = "project_sphere";
  static constexpr const char* summary = "A sphere light of radiance 1, seen from a receiver.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto light = detail::take_sphere(io);
    const auto x = io.vector("receiver", Domain::position);
    const auto sh = io.output("sh", N * N);
    project<N>(light, x[0], x[1], x[2], [&](auto l, auto m, const T& value) { sh[sh_index(l, m)] = value; });
  }
};

struct SphereWithGradient : Function {
  static constexpr const char* name = "project_sphere_with_gradient";
  static constexpr const char* summary = "The same, and the gradient by the receiver's position, per unit of length.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto light = detail::take_sphere(io);
    const auto x = io.vector("receiver", Domain::position);
    const auto sh = io.output("sh", N * N);
    const auto gradient = io.output_triples("gradient", N * N);
    project_with_gradient<N>(light, x[0], x[1], x[2],
                             [&](auto l, auto m, const T& value, const T& gx, const T& gy, const T& gz) {
                               sh[sh_index(l, m)] = value;
                               gradient.set(sh_index(l, m), gx, gy, gz);
                             });
  }
};

// ---- Grid -----------------------------------------------------------------------------------------------------------

template <Interpolation method>
struct CellWeightsOf : Function {
  static constexpr const char* name = method == Interpolation::hermite ? "hermite_weights" : "trilinear_weights";
  static constexpr const char* summary =
      "Weights of the blocks of a cell's 8 corners, corner by corner; bits 0, 1 and 2 of its number are x, y and z.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    AxisWeights<T> axis[3];
    const T t[3] = {io.number("tx", Domain::cell_coordinate), io.number("ty", Domain::cell_coordinate),
                    io.number("tz", Domain::cell_coordinate)};
    const auto size = io.vector("cell_size", Domain::length);
    for (std::size_t a = 0; a < 3; ++a) axis[a] = axis_weights<method>(t[a], size[a]);
    const auto weights = cell_weights<method>(axis[0], axis[1], axis[2]);
    constexpr int blocks = blocks_read(method);
    const auto result = io.output("weights", 8 * blocks);
    for (int i = 0; i < 8 * blocks; ++i) result[i] = weights.corner[i / blocks][i % blocks];
  }
};

/// Where a position lies in the grid, in cells, 0 to the number of vertices less one on each axis.
struct CellPosition : Function {
  static constexpr const char* name = "cell_position";
  static constexpr const char* summary =
      "A position in units of cells, in a grid of so many vertices from low to high.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    const auto x = io.vector("position", Domain::position);
    const auto low = io.vector("low", Domain::position), high = io.vector("high", Domain::position);
    const auto vertices = io.vector("vertices", Domain::vertex_count);
    const auto cells = io.output_triples("cells", 0);
    for (std::size_t a = 0; a < 3; ++a) {
      cells[0][a] = zonal::detail::cell_position(x[a], low[a], zonal::detail::cell_rate(low[a], high[a], vertices[a]),
                                                 vertices[a]);
    }
  }
};

// The loop over lights that fills a grid, for one colour channel: three take a third of the registers at a time, and
// few operations more.
struct AddSphere : Function {
  static constexpr const char* name = "add_sphere";
  static constexpr const char* summary = "Adds a sphere light to the sums at a vertex, in one colour channel.";
  static constexpr int order_count(int bands) { return bands + 1; }  // the gradient needs one degree more
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto light = detail::take_sphere(io);
    const T radiance[3] = {io.number("radiance", Domain::coefficient), T(0), T(0)};
    const auto x = io.vector("receiver", Domain::position);
    const auto value = io.sums("value", value_count<N>);
    const auto up = io.sums("up", up_count<N>), down = io.sums("down", down_count<N>);
    LightSums<N, T> sums;
    sums.add(light, radiance, x[0], x[1], x[2]);
    sums.for_each([&](int l, int m, int channel, const T& v, const T& u, const T& d) {
      if (channel != 0 || !io.keeps(m)) return;
      const int i = sh_index(l, m);
      if (l < N) value[i] = value[i] + v;
      if (l > 0) up[i] = up[i] + u;
      if (l + 1 < N) down[i] = down[i] + d;
    });
  }

  // How many sums there are of each kind; an array has at least one element.
  template <int N>
  static constexpr int value_count = N* N;
  template <int N>
  static constexpr int up_count = (N + 1) * (N + 1);
  template <int N>
  static constexpr int down_count = N > 1 ? (N - 1) * (N - 1) : 1;
};

struct ClearSums : Function {
  static constexpr const char* name = "clear_sums";
  static constexpr const char* summary = "Sums of no light.";
  template <int N, class Io>
  static void run(Io& io) {
    io.output("value", AddSphere::value_count<N>);
    io.output("up", AddSphere::up_count<N>);
    io.output("down", AddSphere::down_count<N>);
  }
};

struct FinishSums : Function {
  static constexpr const char* name = "finish_sums";
  static constexpr const char* summary =
      "The gradient from the sums that add_sphere leaves; the value is their `value`.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto up = io.template numbers<AddSphere::up_count<N>>("up", Domain::coefficient);
    const auto down = io.template numbers<AddSphere::down_count<N>>("down", Domain::coefficient);
    const auto gradient = io.output_triples("gradient", N * N);
    LightSums<N, T> sums;
    sums.for_each([&](int l, int m, int channel, T&, T& u, T& d) {
      const auto i = static_cast<std::size_t>(sh_index(l, m));
      if (channel == 0 && l > 0) u = up[i];
      if (channel == 0 && l + 1 < N) d = down[i];
    });
    sums.finish([&](auto l, auto m, int channel, const T&, const T& x, const T& y, const T& z) {
      if (channel == 0) gradient.set(sh_index(l, m), x, y, z);
    });
  }
};

// ---- Virtual lights -------------------------------------------------------------------------------------------------

template <Horizon method>
struct HorizonOf : Function {
  static constexpr const char* name = method == Horizon::exact ? "horizon_exact" : "horizon_smoothstep";
  static constexpr const char* summary = "How much of a cap, up to the hemisphere, stands above the horizon: 0 to 1.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    const auto cap = io.cap("cap", Domain::half_angle);
    const auto cos_angle = io.number("cos_angle", Domain::cosine);
    io.output("share", 0)[0] = horizon<method>(cap, cos_angle);
  }
};

template <int NE>
struct HvlRadiance : Function {
  static constexpr const char* name = NE == 1 ? "hvl_radiance_diffuse" : "hvl_radiance";
  static constexpr const char* summary =
      NE == 1 ? "The outgoing radiance that a diffuse virtual light causes: one band of emission."
              : "The outgoing radiance that a virtual light causes: three bands of emission.";
  static constexpr int order_count(int bands) { return bands; }
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    using Record = HvlRecord<NE, T>;
    Record light;
    take(io, "light_position", Domain::position, light.position);
    take(io, "light_normal", Domain::unit_vector, light.normal);
    take(io, "light_tangent", Domain::unit_vector, light.tangent);
    light.radius = io.number("light_radius", Domain::length);
    const auto emission = io.template triples<Record::emission_size>("light_emission", Domain::coefficient);
    for (int i = 0; i < 3 * Record::emission_size; ++i) {
      light.emission[i % 3][i / 3] = emission[static_cast<std::size_t>(i)];
    }
    ReceiverFrame<T> receiver;
    take(io, "position", Domain::position, receiver.position);
    take(io, "normal", Domain::unit_vector, receiver.normal);
    take(io, "tangent", Domain::unit_vector, receiver.tangent);

    constexpr int material_size = even_index(N, 0);
    const auto coefficients = io.template triples<material_size>("material", Domain::coefficient);
    EvenSh<N, glm::vec<3, T>> material;
    for (int l = 0; l < N; ++l) {
      for (int m = 0; m <= l; ++m) {
        for (int c = 0; c < 3; ++c) {
          const T coefficient = coefficients[static_cast<std::size_t>(3 * even_index(l, m) + c)];
          material(l, m)[c] = io.keeps(m) ? coefficient : T(0);
        }
      }
    }
    T radiance[3];
    hvl_radiance<N, NE, Horizon::smoothstep>(light, receiver, material, radiance);
    io.output_triples("radiance", 0).set(0, radiance[0], radiance[1], radiance[2]);
  }

 private:
  template <class Io, class T>
  static void take(Io& io, const char* parameter, Domain domain, T (&vector)[3]) {
    const auto values = io.vector(parameter, domain);
    for (std::size_t i = 0; i < 3; ++i) vector[i] = values[i];
  }
};

// ---- The table ------------------------------------------------------------------------------------------------------

template <class... Entries>
struct FunctionList {};

using BasisFunctions =
    FunctionList<Evaluate, EvaluateEven, EvaluateZonal, EvaluateWithGradient,                 // basis
                 Cap, HemisphereCap, SphereCap, CapDerivative, Lambert, Phong, Gaussian,      // lobes
                 Orient, Reconstruct, ReconstructEven, ReconstructZonal, ReconstructLambert,  // transforms
                 Convolve, Dot, WindowFactors<Window::hann>, WindowFactors<Window::sinc>>;
using SceneFunctions = FunctionList<Sphere, SphereWithGradient,                                               // lights
                                    CellPosition, CellWeightsOf<Interpolation::trilinear>,                    // grid
                                    CellWeightsOf<Interpolation::hermite>, ClearSums, AddSphere, FinishSums,  //
                                    HorizonOf<Horizon::smoothstep>, HorizonOf<Horizon::exact>,  // virtual lights
                                    HvlRadiance<1>, HvlRadiance<3>>;

/// visit(Entry{}) for each entry of the table, in its order.
template <class Visit, class... Entries>
void for_each_function(FunctionList<Entries...>, Visit&& visit) {
  (visit(Entries{}), ...);
}

}  // namespace glsl
}  // namespace ZONAL_TARGET
}  // namespace zonal
