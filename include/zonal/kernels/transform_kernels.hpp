// The registry's entries of the room `transform` (kernel_list.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include "../basis/evaluate.hpp"
#include "../lobe/lambert.hpp"
#include "../transform/convolve.hpp"
#include "../transform/dot.hpp"
#include "../transform/orient.hpp"
#include "../transform/product.hpp"
#include "../transform/reconstruct_adjoint.hpp"
#include "../transform/rotate.hpp"
#include "../transform/window.hpp"
#include "kernel_io.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

namespace detail {
// Not copied by a loop: it reads as a vector what was written number by number, and waits.
template <class Result, class T, std::size_t... I>
Result as_coefficients(const std::array<T, sizeof...(I)>& values, std::index_sequence<I...>) {
  return {{values[I]...}};
}
template <template <int, class> class Coefficients, int N, int Count, class Io>
auto take_coefficients(Io& io, const char* name, bool is_first) {
  return as_coefficients<Coefficients<N, typename Io::Scalar>>(io.template coefficients<Count>(name, is_first),
                                                               std::make_index_sequence<std::size_t{Count}>{});
}
template <int N, class Io>
auto take_sh(Io& io, const char* name, bool is_first = true) {
  return take_coefficients<Sh, N, N * N>(io, name, is_first);
}
template <int N, class Io>
auto take_even(Io& io, const char* name, bool is_first = true) {
  return take_coefficients<EvenSh, N, N*(N + 1) / 2>(io, name, is_first);
}
template <int N, class Io>
auto take_zonal(Io& io, const char* name, bool is_first = true) {
  return take_coefficients<Zh, N, N>(io, name, is_first);
}
}  // namespace detail

struct Orient : Kernel {
  static constexpr const char* name = "orient";
  static constexpr const char* summary = "A zonal lobe turned to an axis, a unit vector.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto zh = detail::take_zonal<N>(io, "zh");
    const auto axis = io.vector("axis", Domain::unit_vector);
    orient(zh, axis[0], axis[1], axis[2], ShOutput<T>{io.template output_sh<N>("sh")});
  }
};

struct RotateAboutZ : Kernel {
  static constexpr const char* name = "rotate_about_z";
  static constexpr const char* summary = "A function turned about z, from x towards y.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto sh = detail::take_sh<N>(io, "sh");
    const auto angle = io.cap("angle", Domain::angle);
    const auto result = io.template output_sh<N>("result");
    const auto turned = rotate_about_z(sh, angle.cos_angle, angle.sin_angle);
    unroll<0, N * N>([&](auto i) { result[i] = turned.values[i]; });
  }
};

namespace detail {
// Of m = 1, 2, ... of the three turns of a rotation (transform/rotate.hpp), one after the other: cosine and sine.
template <int N>
inline constexpr int turn_numbers = 6 * (N > 1 ? N - 1 : 1);
constexpr int turn_place(int bands, int turn, int m) { return 2 * ((bands > 1 ? bands - 1 : 1) * turn + m - 1); }
}  // namespace detail

struct PrepareRotation : Kernel {
  static constexpr const char* name = "prepare_rotation";
  static constexpr const char* summary =
      "What rotate takes: cosines and sines of m = 1, 2, ... of three turns. By a quaternion, w first, of any length "
      "but 0.";
  template <int N, class Io>
  static void run(Io& io) {
    constexpr int bands = N > 1 ? N : 2;
    const auto q = io.template numbers<4>("quaternion", Domain::coefficient);
    const auto turns = io.output("turns", detail::turn_numbers<N>);
    const auto rotation = Rotation<bands, typename Io::Scalar>::from_quaternion(q[0], q[1], q[2], q[3]);
    for (int turn = 0; turn < 3; ++turn) {
      for (int m = 1; m < bands; ++m) {
        turns[detail::turn_place(N, turn, m)] = rotation.turn(turn).cosine[m];
        turns[detail::turn_place(N, turn, m) + 1] = rotation.turn(turn).sine[m];
      }
    }
  }
};

struct Rotate : Kernel {
  static constexpr const char* name = "rotate";
  static constexpr const char* summary = "A function rotated, as prepare_rotation prepares it.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto sh = detail::take_sh<N>(io, "sh");
    const auto numbers = io.template numbers<detail::turn_numbers<N>>("turns", Domain::cosine);
    const auto turn = [&](int i) {
      TurnAboutZ<N, T> turned(T(1), T(0));
      for (int m = 1; m < N; ++m) {
        const auto place = static_cast<std::size_t>(detail::turn_place(N, i, m));
        turned.cosine[m] = numbers[place], turned.sine[m] = numbers[place + 1];
      }
      return turned;
    };
    const auto result = io.template output_sh<N>("result");
    const auto rotated = rotate(sh, Rotation<N, T>(turn(0), turn(1), turn(2)));
    unroll<0, N * N>([&](auto i) { result[i] = rotated.values[i]; });
  }
};

struct Reconstruct : Kernel {
  static constexpr const char* name = "reconstruct";
  static constexpr const char* summary = "A function's value in a direction: basis and sum fused.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto sh = detail::take_sh<N>(io, "sh");
    const auto direction = io.vector("direction", Domain::unit_vector);
    io.output("value", 0)[0] = reconstruct(sh, direction);
  }
};

struct ReconstructEven : Kernel {
  static constexpr const char* name = "reconstruct_even";
  static constexpr const char* summary = "The value of a function that is even in phi, coefficients of m >= 0.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto sh = detail::take_even<N>(io, "sh");
    const auto v = io.vector("direction", Domain::unit_vector);
    io.output("value", 0)[0] = dot(sh, evaluate_even<N>(v[0], v[2]));
  }
};

struct ReconstructZonal : Kernel {
  static constexpr const char* name = "reconstruct_zonal";
  static constexpr const char* summary = "A zonal function's value at an angle from its axis.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto zh = detail::take_zonal<N>(io, "zh");
    const auto cos_angle = io.number("cos_angle", Domain::cosine);
    io.output("value", 0)[0] = reconstruct_zonal(zh, cos_angle);
  }
};

struct ReconstructAlong : Kernel {
  static constexpr const char* name = "reconstruct_along";
  static constexpr const char* summary = "A function's value in a direction of any length but 0.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto sh = detail::take_sh<N>(io, "sh");
    const auto direction = io.vector("direction", Domain::position);
    io.output("value", 0)[0] = reconstruct_along(sh, direction);
  }
};

struct Splat : Kernel {
  static constexpr const char* name = "splat";
  static constexpr const char* summary =
      "A splat's colour as a camera sees it: the value, and half more, and at least 0 [Kerbl et al. 2023].";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto sh = detail::take_sh<N>(io, "sh");
    const auto position = io.vector("position", Domain::light_position);
    const auto camera = io.vector("camera", Domain::position);
    const std::array<T, 3> direction{position[0] - camera[0], position[1] - camera[1], position[2] - camera[2]};
    io.output("value", 0)[0] = reconstruct_along<ColourRule::splat>(sh, direction);
  }
};

/// Value and derivatives of a colour in one. The reverse sweep of the record of `reconstruct_along_colour` gives the
/// same numbers, up to rounding.
template <ColourRule rule>
struct ReconstructWithAdjoint : Kernel {
  static constexpr const char* name = rule == ColourRule::splat ? "splat_with_adjoint" : "reconstruct_with_adjoint";
  static constexpr const char* summary =
      rule == ColourRule::splat
          ? "A splat's colour in the direction from the camera, and a loss's derivatives, given those by the colour."
          : "A colour in a direction of any length but 0, and a loss's derivatives, given those by the colour.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto sh = io.template triples<N * N>("sh", Domain::coefficient);
    const auto direction = io.vector("direction", Domain::position);
    const auto by_value = io.vector("by_value", Domain::coefficient);
    const auto value = io.output_triples("value", 0), by_sh = io.output_triples("by_sh", N * N),
               by_direction = io.output_triples("by_direction", 0);
    T colour[3], slope[3];
    zonal::detail::reconstruct_with_adjoint<N, rule, 3, T>(
        {direction[0], direction[1], direction[2]}, [&](auto i, auto c) { return sh[std::size_t{3 * i + c}]; },
        {by_value[0], by_value[1], by_value[2]}, colour, slope,
        [&](auto i, auto c, const T& derivative) { by_sh[i][c] = derivative; });
    value.set(0, colour[0], colour[1], colour[2]);
    by_direction.set(0, slope[0], slope[1], slope[2]);
  }
};

struct ReconstructLambert : Kernel {
  static constexpr const char* name = "reconstruct_lambert";
  static constexpr const char* summary = "Radiance convolved with the clamped cosine: irradiance over pi at a normal.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto radiance = detail::take_sh<N>(io, "radiance");
    const auto normal = io.vector("normal", Domain::unit_vector);
    io.output("value", 0)[0] = reconstruct_convolved(radiance, LambertLobe{}, normal);
  }
};

struct ReconstructConvolved : Kernel {
  static constexpr const char* name = "reconstruct_convolved";
  static constexpr const char* summary = "The value in a direction of a convolution with a zonal kernel.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto sh = detail::take_sh<N>(io, "sh");
    const auto kernel = detail::take_zonal<N>(io, "kernel", false);
    const auto direction = io.vector("direction", Domain::unit_vector);
    io.output("value", 0)[0] = reconstruct_convolved(sh, kernel, direction);
  }
};

struct Convolve : Kernel {
  static constexpr const char* name = "convolve";
  static constexpr const char* summary = "Convolution with a zonal kernel.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto sh = detail::take_sh<N>(io, "sh");
    const auto kernel = detail::take_zonal<N>(io, "kernel", false);
    const auto result = io.template output_sh<N>("result");
    const auto convolved = convolve(sh, kernel);
    for (int i = 0; i < N * N; ++i) result[i] = convolved[i];
  }
};

struct ConvolveZonal : Kernel {
  static constexpr const char* name = "convolve_zonal";
  static constexpr const char* summary = "Convolution of a zonal function with a zonal kernel.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto zh = detail::take_zonal<N>(io, "zh"), kernel = detail::take_zonal<N>(io, "kernel", false);
    const auto result = io.output("result", N);
    const auto convolved = convolve(zh, kernel);
    for (int l = 0; l < N; ++l) result[l] = convolved[l];
  }
};

/// The sum of the products of coefficients; `take` reads an operand.
template <class Entry>
struct DotOf : Kernel {
  template <int N, class Io>
  static void run(Io& io) {
    const auto a = Entry::template take<N>(io, "a", true), b = Entry::template take<N>(io, "b", false);
    io.output("value", 0)[0] = dot(a, b);
  }
};

struct Dot : DotOf<Dot> {
  static constexpr const char* name = "dot";
  static constexpr const char* summary = "The integral of a product: the sum of the products of coefficients.";
  template <int N, class Io>
  static auto take(Io& io, const char* parameter, bool is_first) {
    return detail::take_sh<N>(io, parameter, is_first);
  }
};

struct DotEven : DotOf<DotEven> {
  static constexpr const char* name = "dot_even";
  static constexpr const char* summary = "The integral of a product of functions even in phi, coefficients of m >= 0.";
  template <int N, class Io>
  static auto take(Io& io, const char* parameter, bool is_first) {
    return detail::take_even<N>(io, parameter, is_first);
  }
};

struct DotZonal : DotOf<DotZonal> {
  static constexpr const char* name = "dot_zonal";
  static constexpr const char* summary = "The integral of a product of zonal functions about one axis.";
  template <int N, class Io>
  static auto take(Io& io, const char* parameter, bool is_first) {
    return detail::take_zonal<N>(io, parameter, is_first);
  }
};

struct Product : Kernel {
  static constexpr const char* name = "product";
  static constexpr const char* summary = "The product of two functions, of which the first bands are kept.";
  static constexpr int most_bands = 6;
  template <int N, class Io>
  static void run(Io& io) {
    const auto a = detail::take_sh<N>(io, "a"), b = detail::take_sh<N>(io, "b", false);
    const auto result = io.template output_sh<N>("result");
    const auto values = product(a, b);
    for (int i = 0; i < N * N; ++i) result[i] = values[i];
  }
};

struct ProductZonal : Kernel {
  static constexpr const char* name = "product_with_zonal";
  static constexpr const char* summary =
      "The product with a function that is zonal about z, of which the first bands are kept.";
  template <int N, class Io>
  static void run(Io& io) {
    const auto sh = detail::take_sh<N>(io, "sh");
    const auto zh = detail::take_zonal<N>(io, "zh", false);
    const auto result = io.template output_sh<N>("result");
    const auto values = product(sh, zh);
    for (int i = 0; i < N * N; ++i) result[i] = values[i];
  }
};

struct TripleProduct : Kernel {
  static constexpr const char* name = "triple_product";
  static constexpr const char* summary = "The integral of the product of three functions.";
  static constexpr int most_bands = Product::most_bands;
  template <int N, class Io>
  static void run(Io& io) {
    const auto a = detail::take_sh<N>(io, "a"), b = detail::take_sh<N>(io, "b", false);
    const auto c = detail::take_sh<N>(io, "c", false);
    io.output("value", 0)[0] = triple_product(a, b, c);
  }
};

template <Window window>
struct WindowFactors : Kernel {
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

template <Window window>
struct ApplyWindow : Kernel {
  static constexpr const char* name = window == Window::hann ? "apply_hann_window" : "apply_sinc_window";
  static constexpr const char* summary = window == Window::hann
                                             ? "Each degree times its factor, (1 + cos(pi l / width)) / 2."
                                             : "Each degree times its factor, sin(pi l / width) / (pi l / width).";
  template <int N, class Io>
  static void run(Io& io) {
    const auto sh = detail::take_sh<N>(io, "sh");
    const auto width = io.number("width", Domain::window_width);
    const auto result = io.template output_sh<N>("result");
    for (int l = 0; l < N; ++l) {
      const auto factor = window_factor(window, l, width);
      for (int m = -l; m <= l; ++m) result[sh_index(l, m)] = sh(l, m) * factor;
    }
  }
};

// ---- The same for colours -------------------------------------------------------------------------------------------

namespace detail {
constexpr std::size_t text_length(const char* text) { return std::string_view(text).size(); }

/// Two texts in one, ended by 0.
template <std::size_t Size>
constexpr std::array<char, Size + 1> join_texts(std::string_view a, std::string_view b) {
  std::array<char, Size + 1> text{};
  for (std::size_t i = 0; i < Size; ++i) text[i] = i < a.size() ? a[i] : b[i - a.size()];
  return text;
}
}  // namespace detail

/// A function of colours, made of that of numbers: its coefficients and results are triples.
template <class Entry, Colours colours = Colours::first>
struct OfColours : Kernel {
  static constexpr bool is_coloured = true;
  static constexpr bool has_bands = Entry::has_bands;
  static constexpr int most_bands = Entry::most_bands;
  template <int N, class Io>
  static void run(Io& io) {
    for (int channel = 0; channel < 3; ++channel) {
      io.start_channel(colours, channel);
      Entry::template run<N>(io);
    }
  }

 private:
  static constexpr const char* suffix = colours == Colours::first ? "_colour" : "_colours";
  static constexpr const char* remark = colours == Colours::first ? " For colours." : " For colours by colours.";
  static constexpr auto joined_name =
      detail::join_texts<detail::text_length(Entry::name) + detail::text_length(suffix)>(Entry::name, suffix);
  static constexpr auto joined_summary =
      detail::join_texts<detail::text_length(Entry::summary) + detail::text_length(remark)>(Entry::summary, remark);

 public:
  static constexpr const char* name = joined_name.data();
  static constexpr const char* summary = joined_summary.data();
};

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
