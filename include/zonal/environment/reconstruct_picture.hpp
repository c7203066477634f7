// Coefficients to pictures of all directions.
#pragma once

#include <string>
#include <type_traits>
#include <vector>

#include "../scalar/for_each.hpp"
#include "../transform/reconstruct_batch.hpp"
#include "environment.hpp"
#include "project_rows.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

template <int N, class T, class C>
Sh<N, Rgb<T>> as_rgb(const Sh<N, C>& sh) {
  Sh<N, Rgb<T>> r;
  for (int i = 0; i < N * N; ++i) r[i] = Rgb<T>{T(sh[i][0]), T(sh[i][1]), T(sh[i][2])};
  return r;
}

inline void set_element(float* element, float number) { *element = number; }
inline void set_element(Half* element, float number) { *element = to_half(number); }

template <class Element>
void set_texel(const Picture<Element>& picture, int column, int row, float r, float g, float b) {
  Element* const texel = picture.at(column, row);
  const float numbers[] = {r, g, b, 1.0F};
  for (int c = 0; c < picture.channels; ++c) set_element(texel + c * picture.channel_stride, numbers[c]);
}

// A row of an equirectangular picture: sum over m of a_m cos(m phi) + b_m sin(m phi), a_m and b_m being of the row.
// Their parts of even and of odd m, summed at a quarter of the columns, are those of the columns that mirror them as
// well.
template <int N, class Element>
void reconstruct_latitude(const Sh<N, Rgb<double>>& sh, const ColumnTable<N>& table, const Picture<Element>& picture,
                          int row) {
  using Sums = LatitudeSums<N>;
  constexpr int lanes = native_lanes_v<float>;
  using L = Lanes<float, lanes>;
  float factors[static_cast<std::size_t>(Sums::moments)][3];
  const double theta = double(kPi) * (row + 0.5) / picture.height, z = std::cos(theta), sine = std::sin(theta);
  double power = 1;
  unroll<0, N>([&](auto m) {
    Rgb<double> even{}, odd{};  // of the cosine, of the sine
    legendre_column<N, m>(z, z * z, [&](auto l, double q) {
      even += sh[sh_index(l, m)] * q;
      odd += sh[sh_index(l, -m)] * q;
    });
    for (int c = 0; c < 3; ++c) {
      factors[Sums::moment(m, false)][c] = static_cast<float>(power * even[c]);
      if constexpr (m > 0) factors[Sums::moment(m, true)][c] = static_cast<float>(power * odd[c]);
    }
    power *= sine;
  });

  for (int begin = 0; begin < table.columns; begin += lanes) {
    float part[4][3][static_cast<std::size_t>(lanes)];  // by the table's combinations
    for (int combination = 0; combination < 4; ++combination) {
      L sum[3] = {L(0), L(0), L(0)};
      const int first = Sums::first_of(combination), end = first + Sums::count_of(combination);
      for (int k = first; k < end; ++k) {
        const L wave = L::load(table.row(k) + begin);
        for (int c = 0; c < 3; ++c) sum[c].add_product(wave, L(factors[k][c]));
      }
      for (int c = 0; c < 3; ++c) sum[c].store(part[combination][c]);
    }
    const int left = table.columns - begin, count = left < lanes ? left : lanes, half = picture.width / 2;
    for (int i = 0; i < count; ++i) {
      const auto set = [&](int column, float odd_cosine, float odd_sine, float even_sine) {
        float value[3];
        for (int c = 0; c < 3; ++c) {
          value[c] = (part[Sums::cosine_even][c][i] + odd_cosine * part[Sums::cosine_odd][c][i]) +
                     (odd_sine * part[Sums::sine_odd][c][i] + even_sine * part[Sums::sine_even][c][i]);
        }
        set_texel(picture, column, row, value[0], value[1], value[2]);
      };
      const int column = begin + i;
      set(column, 1, 1, 1);
      if (table.folds == 1) continue;
      set(half - 1 - column, -1, 1, -1);           // pi - phi
      set(half + column, -1, -1, 1);               // phi + pi
      set(picture.width - 1 - column, 1, -1, -1);  // -phi
    }
  }
}

// A row of any other.
template <int N, class Element, class M>
void reconstruct_row(const Sh<N, Rgb<float>>& sh, const M& mapping, const Picture<Element>& picture, int row) {
  const auto width = static_cast<std::size_t>(picture.width);
  std::vector<float> directions(3 * width);
  std::vector<Rgb<float>> values(width);
  for (int column = 0; column < picture.width; ++column) {
    float* const to = directions.data() + 3 * static_cast<std::size_t>(column);
    to[2] = 1;  // any, where there is none
    if (!mapping.has_direction(column, row)) continue;
    const auto d = mapping.direction(column + 0.5, row + 0.5);
    for (std::size_t i = 0; i < 3; ++i) to[i] = static_cast<float>(d[i]);
  }
  reconstruct(sh, DirectionSpan<float>::triples(directions.data(), width), values.data());
  for (int column = 0; column < picture.width; ++column) {
    Rgb<float> value = values[static_cast<std::size_t>(column)];
    if (!mapping.has_direction(column, row)) value = {0, 0, 0};
    set_texel(picture, column, row, value.r, value.g, value.b);
  }
}

}  // namespace detail

/// The value of the coefficients at the middle of every texel, to `target`, a picture of 3 or 4 channels (alpha is 1)
/// in a mapping; black where texels have no direction. In the unit of the coefficients; few bands of a bright light may
/// leave it below 0. Greatest error: that of evaluate() in float. for_each(count, body) as of project(). Throws
/// std::invalid_argument where there can be no such picture; without exceptions it ends the program (refuse.hpp).
template <int N, class C, class Element, class ForEach = SerialForEach>
void reconstruct(const Sh<N, C>& sh, Mapping kind, const Picture<Element>& target, ForEach&& for_each = {}) {
  static_assert(!std::is_const_v<Element>, "the picture is written");
  if (target.channels == 1) detail::refuse("a picture of 1 channel for coefficients of colours");
  const Environment<Element> environment(target, kind);  // refuses what is none
  environment.visit([&](const auto& mapping) {
    if constexpr (std::is_same_v<std::decay_t<decltype(mapping)>, Equirectangular>) {
      const detail::ColumnTable<N> table(target.width);
      const Sh<N, Rgb<double>> coefficients = detail::as_rgb<N, double>(sh);
      for_each(target.height, [&](int row) { detail::reconstruct_latitude<N>(coefficients, table, target, row); });
    } else {
      const Sh<N, Rgb<float>> coefficients = detail::as_rgb<N, float>(sh);
      for_each(target.height, [&](int row) { detail::reconstruct_row<N>(coefficients, mapping, target, row); });
    }
  });
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
