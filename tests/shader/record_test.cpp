// The records themselves: that they are what C++ computes, for colours too, and what is left when coefficients go.
#include <glm/vec3.hpp>
#include <zonal/convention/shader_forms.hpp>
#include <zonal/probe/nonlinear_l1.hpp>
#include <zonal/probe/zh3.hpp>
#include <zonal/shader/shells.hpp>
#include <zonal/transform/reconstruct_adjoint.hpp>
#include <zonal/zonal.hpp>

#include <functional>
#include <map>
#include <set>
#include <string>

#include "../catch.hpp"
#include "compare.hpp"
#include "cpp_functions.hpp"
#include "inputs.hpp"
#include "interpret.hpp"
#include "request.hpp"
#include "run_from_list.hpp"
#include "shader_functions.hpp"

namespace {

using zonal::shader::all_orders;
using zonal::shader::FunctionEntry;
using zonal::shader::RecordedFunction;

void check(const FunctionEntry& entry, int bands, int order) {
  const RecordedFunction function = entry.record(bands, order);
  INFO(function.name);
  InputSampler sampler(9, bands);
  for (int i = 0; i < 300; ++i) {
    const std::vector<float> inputs = sampler.draw(function.parameters);
    require_equal(interpret(function, inputs), kept_of(function, run_in_cpp(entry.name, bands, order, inputs)), true,
                  [&] { return inputs; });
  }
}

// ---- The functions of the library, called with colours --------------------------------------------------------------

constexpr int N = 3;
using Colour = glm::vec3;

/// Reads colours, numbers and vectors off a row of floats.
struct Row {
  const std::vector<float>& floats;
  std::size_t at = 0;

  float number() { return floats.at(at++); }
  Colour colour() {
    const float x = number(), y = number(), z = number();
    return {x, y, z};
  }
  template <class C>
  C read() {
    C result;
    for (auto& value : result) {
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, float>) {
        value = number();
      } else {
        value = colour();
      }
    }
    return result;
  }
};
template <class T>
using Sh = zonal::Sh<N, T>;
template <class T>
using EvenSh = zonal::EvenSh<N, T>;
template <class T>
using Zh = zonal::Zh<N, T>;

std::vector<float> flat(const Colour& c) { return {c.x, c.y, c.z}; }
template <class C>
std::vector<float> flat(const C& colours) {
  std::vector<float> all;
  for (const Colour& c : colours) all.insert(all.end(), {c.x, c.y, c.z});
  return all;
}

/// dot(A, B), A and B read in turn.
template <class A, class B>
std::vector<float> dot_of(Row row) {
  const A a = row.read<A>();
  return flat(zonal::dot(a, row.read<B>()));
}
/// product(A, B), A and B read in turn.
template <class A, class B>
std::vector<float> product_of(Row row) {
  const A a = row.read<A>();
  return flat(zonal::product(a, row.read<B>()));
}
template <class A>
std::vector<float> convolution_of(Row row) {
  const A a = row.read<A>();
  return flat(zonal::convolve(a, row.read<Zh<float>>()));
}
/// Of coefficients of numbers, channel by channel.
template <class Numbers, class Colours>
Numbers channel_of(const Colours& colours, int channel) {
  Numbers numbers;
  for (int i = 0; i < Colours::size(); ++i) numbers[i] = colours[i][channel];
  return numbers;
}
/// The library takes a kernel of numbers: one of colours is three.
template <class A, class ChannelOfA>
std::vector<float> convolution_by_channel(Row row) {
  A a = row.read<A>();
  const auto kernel = row.read<Zh<Colour>>();
  for (int channel = 0; channel < 3; ++channel) {
    const auto convolved = zonal::convolve(channel_of<ChannelOfA>(a, channel), channel_of<Zh<float>>(kernel, channel));
    for (int i = 0; i < A::size(); ++i) a[i][channel] = convolved[i];
  }
  return flat(a);
}
/// By the numbers of three turns: of m = 1, 2, ... cosine and sine.
std::vector<float> rotated(Row row) {
  const auto sh = row.read<Sh<Colour>>();
  const auto turn = [&row] {
    zonal::TurnAboutZ<N, float> result(1.0F, 0.0F);
    for (std::size_t m = 1; m < std::size_t{N}; ++m) {
      result.cosine[m] = row.number();
      result.sine[m] = row.number();
    }
    return result;
  };
  const auto first = turn(), second = turn(), third = turn();
  return flat(zonal::rotate(sh, zonal::Rotation<N, float>(first, second, third)));
}
std::vector<float> windowed(Row row, zonal::Window window) {
  const auto sh = row.read<Sh<Colour>>();
  return flat(zonal::apply_window(sh, window, static_cast<double>(row.number())));
}

/// A colour of what a channel's numbers give.
template <class F>
std::vector<float> by_channel(const F& of_channel) {
  Colour colour(0);
  for (int channel = 0; channel < 3; ++channel) colour[channel] = of_channel(channel);
  return flat(colour);
}

const std::map<std::string, std::function<std::vector<float>(Row)>> with_colours = {
    {"orient_colour",
     [](Row row) {
       // A lobe of colours is three lobes.
       const auto zh = row.read<Zh<Colour>>();
       const Colour axis = row.colour();
       Sh<Colour> sh;
       for (int channel = 0; channel < 3; ++channel) {
         const Sh<float> oriented = zonal::orient(channel_of<Zh<float>>(zh, channel), axis);
         for (int i = 0; i < N * N; ++i) sh[i][channel] = oriented[i];
       }
       return flat(sh);
     }},
    {"reconstruct_colour",
     [](Row row) {
       const auto sh = row.read<Sh<Colour>>();
       return flat(zonal::reconstruct(sh, row.colour()));
     }},
    {"reconstruct_even_colour",
     [](Row row) {
       const auto sh = row.read<EvenSh<Colour>>();
       const Colour direction = row.colour();
       return flat(zonal::dot(sh, zonal::evaluate_even<N>(direction.x, direction.z)));
     }},
    {"reconstruct_zonal_colour",
     [](Row row) {
       const auto zh = row.read<Zh<Colour>>();
       return flat(zonal::reconstruct_zonal(zh, row.number()));
     }},
    {"reconstruct_lambert_colour",
     [](Row row) {
       const auto sh = row.read<Sh<Colour>>();
       return flat(zonal::reconstruct_convolved(sh, zonal::LambertLobe{}, row.colour()));
     }},
    {"reconstruct_convolved_colour",
     [](Row row) {
       const auto sh = row.read<Sh<Colour>>();
       const auto kernel = row.read<Zh<float>>();
       return flat(zonal::reconstruct_convolved(sh, kernel, row.colour()));
     }},
    {"reconstruct_along_colour",
     [](Row row) {
       const auto sh = row.read<Sh<Colour>>();
       return flat(zonal::reconstruct_along(sh, row.colour()));
     }},
    {"splat_colour",
     [](Row row) {
       const auto sh = row.read<Sh<Colour>>();
       const Colour position = row.colour();
       return flat(zonal::reconstruct_along<zonal::ColourRule::splat>(sh, position - row.colour()));
     }},
    {"convolve_colour", convolution_of<Sh<Colour>>},
    {"convolve_colours", convolution_by_channel<Sh<Colour>, Sh<float>>},
    {"convolve_zonal_colour", convolution_of<Zh<Colour>>},
    {"convolve_zonal_colours", convolution_by_channel<Zh<Colour>, Zh<float>>},
    {"dot_colour", dot_of<Sh<Colour>, Sh<float>>},
    {"dot_colours", dot_of<Sh<Colour>, Sh<Colour>>},
    {"dot_even_colour", dot_of<EvenSh<Colour>, EvenSh<float>>},
    {"dot_even_colours", dot_of<EvenSh<Colour>, EvenSh<Colour>>},
    {"dot_zonal_colour", dot_of<Zh<Colour>, Zh<float>>},
    {"dot_zonal_colours", dot_of<Zh<Colour>, Zh<Colour>>},
    {"rotate_about_z_colour",
     [](Row row) {
       const auto sh = row.read<Sh<Colour>>();
       const float cosine = row.number();
       return flat(zonal::rotate_about_z(sh, cosine, row.number()));
     }},
    {"rotate_colour", rotated},
    {"product_colour", product_of<Sh<Colour>, Sh<float>>},
    {"product_colours", product_of<Sh<Colour>, Sh<Colour>>},
    {"product_with_zonal_colour", product_of<Sh<Colour>, Zh<float>>},
    {"triple_product_colour",
     [](Row row) {
       const auto a = row.read<Sh<Colour>>();
       const auto b = row.read<Sh<float>>();
       return flat(zonal::triple_product(a, b, row.read<Sh<float>>()));
     }},
    {"apply_hann_window_colour", [](Row row) { return windowed(row, zonal::Window::hann); }},
    {"apply_sinc_window_colour", [](Row row) { return windowed(row, zonal::Window::sinc); }},
    {"reconstruct_nine_polynomials_colour",
     [](Row row) {
       const auto p = row.read<zonal::Sh<3, Colour>>();
       const Colour normal = row.colour();
       const zonal::NinePolynomials<Colour> nine{p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8]};
       return by_channel([&](int c) {
         const zonal::NinePolynomials<float> of_channel{nine.x[c],  nine.y[c],  nine.z[c],  nine.xx[c], nine.yy[c],
                                                        nine.zz[c], nine.yz[c], nine.zx[c], nine.xy[c]};
         return zonal::reconstruct(of_channel, normal);
       });
     }},
    {"reconstruct_polynomials_colour",
     [](Row row) {
       const auto p = row.read<zonal::Sh<3, Colour>>();
       const Colour normal = row.colour();
       return by_channel(
           [&](int c) { return zonal::reconstruct_polynomials(channel_of<zonal::Sh<3, float>>(p, c), normal); });
     }},
    {"hallucinate_zh3_colour",
     [](Row row) {
       const auto radiance = row.read<zonal::Sh<2, Colour>>();
       const Colour axis = row.colour();
       const float along[3] = {axis.x, axis.y, axis.z};
       return by_channel(
           [&](int c) { return zonal::hallucinated_zonal(channel_of<zonal::Sh<2, float>>(radiance, c), along); });
     }},
    {"irradiance_zh3_colour",
     [](Row row) {
       const auto radiance = row.read<zonal::Sh<2, Colour>>();
       const Colour of_degree_2 = row.colour(), axis = row.colour(), normal = row.colour();
       const float along[3] = {axis.x, axis.y, axis.z};
       return by_channel([&](int c) {
         return zonal::irradiance_zh3_over_pi(channel_of<zonal::Sh<2, float>>(radiance, c), of_degree_2[c], along,
                                              normal);
       });
     }},
    {"irradiance_nonlinear_colour",
     [](Row row) {
       const auto radiance = row.read<zonal::Sh<2, Colour>>();
       return flat(zonal::nonlinear_irradiance_over_pi(radiance, row.colour()));
     }},
};

}  // namespace

TEST_CASE("Every record is to the bit what C++ computes") {
  for (const FunctionEntry& entry : zonal_glsl::shader_functions()) {
    for_each_of(cpp_bands, [&](auto bands) {
      if ((!entry.has_bands && bands > 1) || bands > entry.most_bands) return;
      check(entry, bands, all_orders);
      for (int m = 0; m < entry.order_count(bands); ++m) check(entry, bands, m);
    });
  }
}

TEST_CASE("The functions for colours are the library's, called with colours") {
  std::size_t count = 0;
  for (const FunctionEntry& entry : zonal_glsl::shader_functions()) {
    const std::string name(entry.name);
    if (name.find("_colour") == std::string::npos) continue;
    ++count;
    const RecordedFunction function = entry.record(N, all_orders);
    INFO(name);
    InputSampler sampler(10, N);
    for (int i = 0; i < 200; ++i) {
      const std::vector<float> inputs = sampler.draw(function.parameters);
      const std::vector<float> expected = with_colours.at(name)({inputs});
      // apply_window computes its factors in double.
      require_equal(interpret(function, inputs), expected, name.find("window") == std::string::npos,
                    [&] { return inputs; });
    }
  }
  CHECK(count == with_colours.size());
}

TEST_CASE("A selection of coefficients is those of the whole, in a shorter array") {
  constexpr int bands = 5;
  const auto check_selection = [](const FunctionEntry& entry, const std::string& selection, auto keep) {
    const RecordedFunction whole = entry.record(bands, all_orders);
    zonal_glsl::Request request;
    request.functions = {std::string(entry.name) + ":" + selection};
    const auto& glsl = *zonal::shader::find_dialect("glsl450");
    const auto selected = zonal_glsl::select(request, glsl);
    const RecordedFunction& part = selected.functions.at(0);
    INFO(part.name);
    InputSampler sampler(11, bands);
    const std::vector<float> inputs = sampler.draw(whole.parameters);
    const std::vector<float> all = interpret(whole, inputs);
    std::vector<float> expected;
    std::size_t at = 0;
    for (const auto& p : whole.parameters) {
      if (p.direction == zonal::shader::Direction::in) continue;
      for (int l = 0; l < bands; ++l) {
        for (int m = -l; m <= l; ++m) {
          for (int c = 0; c < p.components; ++c, ++at) {
            if (keep(l, m)) expected.push_back(all[at]);
          }
        }
      }
    }
    require_equal(interpret(part, inputs), expected, true, [&] { return inputs; });
    std::size_t size = 0;
    for (const auto& p : part.parameters) {
      if (p.direction == zonal::shader::Direction::in) continue;
      size += static_cast<std::size_t>(p.size());
      CHECK(function_text(part, glsl).find(" " + std::string(p.name) + "[" + std::to_string(p.count) + "]") !=
            std::string::npos);
    }
    CHECK(size == expected.size());
  };
  for (const char* name :
       {"evaluate", "evaluate_with_gradient", "project_sphere_with_gradient", "convolve_colour", "orient"}) {
    const FunctionEntry& entry = *zonal_glsl::find_function(name);
    check_selection(entry, "even", [](int, int m) { return m >= 0; });
    for (int degree = 0; degree < bands; ++degree) {
      check_selection(entry, "degree" + std::to_string(degree), [degree](int l, int) { return l == degree; });
    }
  }
}

TEST_CASE("No two functions have one name, nor one guard") {
  std::set<std::string> names;
  const auto add = [&](const std::string& name) { CHECK(names.insert(zonal::shader::upper_case(name)).second); };
  for (const FunctionEntry& entry : zonal_glsl::shader_functions()) {
    for (int bands = 1; bands <= (entry.has_bands ? 4 : 1); ++bands) {
      const RecordedFunction function = entry.record(bands, all_orders);
      add(function.name);
      zonal::shader::TextOptions flat_text;
      flat_text.flat = true;
      add(text_name(function, flat_text));
      for (int m = 0; m < entry.order_count(bands); ++m) add(entry.record(bands, m).name);
      for (const auto& p : function.parameters) {
        if (!p.has_orders) continue;
        add(function.name + "_even");
        for (int degree = 0; degree < bands; ++degree) add(function.name + "_degree" + std::to_string(degree));
        break;
      }
    }
  }
  for (const auto& shell : zonal::shader::shells) {
    for (int bands = 1; bands <= 4; ++bands) add(shell_name(shell, bands, {}));
  }
}
