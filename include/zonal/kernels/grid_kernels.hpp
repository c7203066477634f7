// The registry's entries of the room `grid` (kernel_list.hpp).
//
// The loop over lights that fills a grid takes part order by order, as the gather's does (gather_kernels.hpp).
#pragma once

#include <cstddef>

#include "../grid/gradient_limit.hpp"
#include "../grid/interpolation_weights.hpp"
#include "../grid/light_sums.hpp"
#include "../grid/visibility_weights.hpp"
#include "kernel_io.hpp"
#include "light_kernels.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

template <Interpolation method>
struct CellWeightsOf : Kernel {
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
struct CellPosition : Kernel {
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

struct VisibilityPlace : Kernel {
  static constexpr const char* name = "visibility_place";
  static constexpr const char* summary =
      "Where to read the visibility of a cell's corner (0 or 1 on each axis): nearness, column and row.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto take = [&](const char* parameter, Domain domain, T(&vector)[3]) {
      const auto numbers = io.vector(parameter, domain);
      for (std::size_t a = 0; a < 3; ++a) vector[a] = numbers[a];
    };
    T t[3], size[3], corner[3], offset[3], normal[3], to_receiver[3];
    take("t", Domain::cell_coordinate, t);
    take("cell_size", Domain::length, size);
    take("corner", Domain::cell_coordinate, corner);
    take("offset", Domain::position, offset);
    take("normal", Domain::unit_vector, normal);
    const T rings = io.number("rings", Domain::row_count);
    from_corner(t, size, corner, offset, normal, to_receiver);
    const MapPlace<T> at = map_place(to_receiver, rings);
    const auto place = io.output_triples("place", 0);
    place[0][0] = at.nearness, place[0][1] = at.column, place[0][2] = at.row;
  }
};

struct SeenShare : Kernel {
  static constexpr const char* name = "seen_share";
  static constexpr const char* summary =
      "How much of a corner is seen at a nearness, from the four nodes about the place in its map.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const T nearness = io.number("nearness", Domain::radius);
    T mean[4], variance[4];
    const auto means = io.template numbers<4>("mean", Domain::radius);
    const auto variances = io.template numbers<4>("variance", Domain::radius);
    for (std::size_t i = 0; i < 4; ++i) mean[i] = means[i], variance[i] = variances[i];
    const T x = io.number("x", Domain::cell_coordinate), y = io.number("y", Domain::cell_coordinate);
    io.output("share", 0)[0] = zonal::seen_share(nearness, mean, variance, x, y);
  }
};

template <Interpolation method>
struct VisibleWeightsOf : Kernel {
  static constexpr const char* name =
      method == Interpolation::hermite ? "visible_hermite_weights" : "visible_trilinear_weights";
  static constexpr const char* summary = "The same of corners of which so much is seen, 0 to 1 each.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    AxisWeights<T> axis[3];
    const T t[3] = {io.number("tx", Domain::cell_coordinate), io.number("ty", Domain::cell_coordinate),
                    io.number("tz", Domain::cell_coordinate)};
    const auto size = io.vector("cell_size", Domain::length);
    const auto shares = io.template numbers<8>("seen", Domain::cell_coordinate);
    T seen[8];
    for (std::size_t c = 0; c < 8; ++c) seen[c] = shares[c];
    for (std::size_t a = 0; a < 3; ++a) axis[a] = axis_weights<method>(t[a], size[a]);
    const auto weights = visible_weights(cell_weights<method>(axis[0], axis[1], axis[2]), axis, seen);
    constexpr int blocks = blocks_read(method);
    const auto result = io.output("weights", 8 * blocks);
    for (int i = 0; i < 8 * blocks; ++i) result[i] = weights.corner[i / blocks][i % blocks];
  }
};

// The loop over lights that fills a grid, for one colour channel: three take a third of the registers at a time, and
// few operations more.
struct AddSphere : Kernel {
  static constexpr const char* name = "add_sphere";
  static constexpr const char* summary =
      "Adds a sphere light to the sums at a vertex, in one colour channel; cell: the longest side of a cell.";
  static constexpr int order_count(int bands) { return bands + 1; }  // the gradient needs one degree more
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto light = detail::take_sphere(io);
    const T radiance[3] = {io.number("radiance", Domain::coefficient), T(0), T(0)};
    const auto x = io.vector("receiver", Domain::position);
    const T cell = io.number("cell", Domain::length);
    const auto value = io.sums("value", value_count<N>);
    const auto up = io.sums("up", up_count<N>), down = io.sums("down", down_count<N>);
    LightSums<N, T> sums;
    sums.add(see_limited<N>(light, x[0], x[1], x[2], gradient_limit(light, cell)), radiance);
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

struct ClearSums : Kernel {
  static constexpr const char* name = "clear_sums";
  static constexpr const char* summary = "Sums of no light.";
  template <int N, class Io>
  static void run(Io& io) {
    io.output("value", AddSphere::value_count<N>);
    io.output("up", AddSphere::up_count<N>);
    io.output("down", AddSphere::down_count<N>);
  }
};

struct FinishSums : Kernel {
  static constexpr const char* name = "finish_sums";
  static constexpr const char* summary =
      "The gradient from the sums that add_sphere leaves; the value is their `value`.";
  template <int N, class Io>
  static void run(Io& io) {
    using T = typename Io::Scalar;
    const auto up = io.template numbers<AddSphere::up_count<N>>("up", Domain::coefficient);
    const auto down = io.template numbers<AddSphere::down_count<N>>("down", Domain::coefficient);
    const auto gradient = io.template output_gradient<N>("gradient");
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

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
