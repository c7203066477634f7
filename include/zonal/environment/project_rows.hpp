// Equirectangular pictures row by row. Y_l^m = q_l^m(z) Re or Im (x + iy)^m separates: a row is summed against cos and
// sin of m phi, 2N - 1 moments a channel, and these against q_l^m(z) sin^m(theta), N^2 a row.
//
// The columns at phi, pi - phi, phi + pi and -phi have the same cosines and sines but for their signs, so their sums
// and differences are formed first, eight additions, and a moment costs a multiply-add for four texels: (2N - 1) / 4 a
// texel and channel, 2.25 at 5 bands, 9.75 at 20. At 5 bands that is less than reading the picture takes.
//
// Moments are float, of two rows at once so that the table of cosines is read half as often; partial sums of
// chunk_steps products each are added up in turn, which keeps 1e-6 however wide the picture; from rows on all is
// double.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "../basis/evaluate.hpp"
#include "environment.hpp"
#include "picture_sums.hpp"
#include "read_run.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// The sums of rows, W of them at a time in the lanes of doubles.
template <int N>
class LatitudeSums {
  static constexpr int width = native_lanes_v<double>;
  using L = Lanes<double, width>;

 public:
  static constexpr int rows = width;
  static constexpr int moments = 2 * N - 1;
  // Moments in the order in which they are computed: by the four combinations of columns.
  enum Combination { cosine_even, cosine_odd, sine_odd, sine_even };
  static constexpr int count_of(int combination) {
    return combination == cosine_even ? (N + 1) / 2 : combination == sine_even ? (N - 1) / 2 : N / 2;
  }
  static constexpr int first_of(int combination) {
    return combination == 0 ? 0 : first_of(combination - 1) + count_of(combination - 1);
  }
  static constexpr int moment(int m, bool is_sine) {
    const int combination = is_sine ? (m % 2 == 0 ? sine_even : sine_odd) : (m % 2 == 0 ? cosine_even : cosine_odd);
    return first_of(combination) + (combination == sine_even ? m / 2 - 1 : m / 2);
  }

  // The moments of a row, of lane `lane`; a lane without a row has weight 0.
  void set_row(int lane, double z, double sine, double weight) {
    z_[lane] = z;
    sine_[lane] = sine;
    weight_[lane] = weight;
  }
  void set_moment(int lane, int moment_index, int channel, double value) {
    moments_[moment_index][channel][lane] = value;
  }

  void add_rows() {
    const L z = L::load(z_), sine = L::load(sine_);
    const L z2 = z * z;
    L power = L::load(weight_);
    unroll<0, N>([&](auto m) {
      add_order<m>(z, z2, power);
      power = power * sine;
    });
    for (double& weight : weight_) weight = 0;
  }

  // `moments_of_one`: of a row of ones.
  void finish(const double (&moments_of_one)[std::size_t{moments}], PictureSums<N>& sums) const {
    for (int l = 0; l < N; ++l) {
      for (int m = -l; m <= l; ++m) {
        const int i = sh_index(l, m);
        for (int c = 0; c < 3; ++c) sums.radiance[i][c] += sum(radiance_[i][c]);
        sums.one[i] += sum(one_[even_index(l, m < 0 ? -m : m)]) * moments_of_one[moment(m < 0 ? -m : m, m < 0)];
      }
    }
  }

 private:
  template <int m>
  void add_order(const L& z, const L& z2, const L& power) {
    L cosine[3], sine[3];
    for (int c = 0; c < 3; ++c) {
      cosine[c] = power * L::load(moments_[moment(m, false)][c]);
      if constexpr (m > 0) sine[c] = power * L::load(moments_[moment(m, true)][c]);
    }
    legendre_column<N, m>(z, z2, [&](auto l, const L& q) ZONAL_INLINE {
      for (int c = 0; c < 3; ++c) {
        radiance_[sh_index(l, m)][c].add_product(q, cosine[c]);
        if constexpr (m > 0) radiance_[sh_index(l, -m)][c].add_product(q, sine[c]);
      }
      one_[even_index(l, m)].add_product(q, power);
    });
  }
  static double sum(const L& lanes) {
    double numbers[static_cast<std::size_t>(width)], total = 0;
    lanes.store(numbers);
    for (const double number : numbers) total += number;
    return total;
  }

  double z_[static_cast<std::size_t>(width)] = {}, sine_[static_cast<std::size_t>(width)] = {};
  double weight_[static_cast<std::size_t>(width)] = {};
  double moments_[static_cast<std::size_t>(moments)][3][static_cast<std::size_t>(width)] = {};
  L radiance_[static_cast<std::size_t>(N * N)][3] = {};
  L one_[static_cast<std::size_t>(N * (N + 1) / 2)] = {};
};

// cos and sin of m phi at the middles of columns: at a quarter of them where these stand for all.
template <int N>
class ColumnTable {
 public:
  using Sums = LatitudeSums<N>;
  static constexpr int lanes = native_lanes_v<float>;

  explicit ColumnTable(int width)
      : folds(width % 4 == 0 ? 4 : 1),
        columns(width / folds),
        stride((columns + lanes - 1) / lanes * lanes),
        values_(static_cast<std::size_t>(Sums::moments) * static_cast<std::size_t>(stride)) {
    for (int i = 0; i < columns; ++i) {
      const double phi = double(kPi) * (1 - (2.0 * i + 1) / width), cosine = std::cos(phi), sine = std::sin(phi);
      double c = 1, s = 0;
      for (int m = 0; m < N; ++m) {
        at(Sums::moment(m, false), i) = static_cast<float>(c);
        if (m > 0) at(Sums::moment(m, true), i) = static_cast<float>(s);
        const double next = c * cosine - s * sine;
        s = c * sine + s * cosine;
        c = next;
      }
    }
    for (int k = 0; k < Sums::moments; ++k) {
      const bool vanishes = folds == 4 && k >= Sums::count_of(Sums::cosine_even);
      double sum = 0;
      for (int i = 0; i < columns; ++i) sum += double(at(k, i));
      moments_of_one[k] = vanishes ? 0 : folds * sum;
    }
  }

  const float* row(int moment) const {
    return values_.data() + static_cast<std::size_t>(moment) * static_cast<std::size_t>(stride);
  }

  int folds, columns, stride;
  double moments_of_one[static_cast<std::size_t>(Sums::moments)];

 private:
  float& at(int moment, int i) {
    return values_[static_cast<std::size_t>(moment) * static_cast<std::size_t>(stride) + static_cast<std::size_t>(i)];
  }
  std::vector<float> values_;
};

// The moments of two rows.
template <int N, class Element>
class RowMoments {
  using Sums = LatitudeSums<N>;
  static constexpr int lanes = native_lanes_v<float>;
  using L = Lanes<float, lanes>;
  static constexpr int chunk_steps = 16, chunk = chunk_steps * lanes;
  static constexpr int planes = 6;                                      // two rows of three channels
  static constexpr int together = native_lanes_v<float> >= 16 ? 4 : 2;  // moments at once: what the registers hold

 public:
  RowMoments(const Picture<const Element>& picture, const ColumnTable<N>& table) : picture_(picture), table_(table) {}

  // Of `row` and the one below it; the second is black if there is none.
  void compute(int row, PictureFaults& faults) {
    for (auto& sum : sums_) sum = L(0);
    for (int begin = 0; begin < table_.columns; begin += chunk) {
      const int left = table_.columns - begin, count = left < chunk ? left : chunk;
      const int steps = (count + lanes - 1) / lanes;
      for (int i = 0; i < 2; ++i) {
        if (row + i < picture_.height) {
          fold(row + i, begin, count, steps, i, faults);
        } else if (begin == 0) {
          for (auto& combination : folded_) {
            for (int c = 3; c < planes; ++c) {
              for (float& number : combination[c]) number = 0;
            }
          }
        }
      }
      add<Sums::cosine_even>(begin, steps);
      add<Sums::cosine_odd>(begin, steps);
      add<Sums::sine_odd>(begin, steps);
      add<Sums::sine_even>(begin, steps);
    }
  }

  // Of the first or second row.
  double value(int row, int moment, int channel) const {
    float numbers[static_cast<std::size_t>(lanes)];
    sums_[moment * planes + 3 * row + channel].store(numbers);
    double total = 0;
    for (const float number : numbers) total += double(number);
    return total;
  }

 private:
  Run<Element> run(int row, int column) const {
    return {picture_.at(column, row), picture_.column_stride, picture_.channel_stride, picture_.channels};
  }

  // The four combinations of a chunk of columns and of those that mirror it.
  void fold(int row, int begin, int count, int steps, int which, PictureFaults& faults) {
    const int padded = steps * lanes;
    if (table_.folds == 1) {
      float* const to[3] = {folded_[0][3 * which], folded_[0][3 * which + 1], folded_[0][3 * which + 2]};
      read_run(run(row, begin), count, to, faults);
      for (float* plane : to) {
        for (int i = count; i < padded; ++i) plane[i] = 0;
      }
      return;
    }
    const int width = picture_.width, half = width / 2;
    // Runs of mirrored columns end where the chunk begins: they are kept from the end of the padded chunk backwards.
    read_part(0, run(row, begin), 0, count, padded, faults, 3 * chunk);
    read_part(1, run(row, half - begin - count), padded - count, count, padded, faults, -3 * chunk);
    read_part(2, run(row, half + begin), 0, count, padded, faults, 3 * chunk);
    read_part(3, run(row, width - begin - count), padded - count, count, padded, faults, -3 * chunk);
    for (int c = 0; c < 3; ++c) {
      const int plane = 3 * which + c;
      for (int i = 0; i < padded; i += lanes) {
        const L a = L::load(parts_[0][c] + i), b = reversed(L::load(parts_[1][c] + padded - lanes - i));
        const L p = L::load(parts_[2][c] + i), d = reversed(L::load(parts_[3][c] + padded - lanes - i));
        const L near = a + d, far = b + p, near_difference = a - d, far_difference = b - p;
        (near + far).store(folded_[Sums::cosine_even][plane] + i);
        (near - far).store(folded_[Sums::cosine_odd][plane] + i);
        (near_difference + far_difference).store(folded_[Sums::sine_odd][plane] + i);
        (near_difference - far_difference).store(folded_[Sums::sine_even][plane] + i);
      }
    }
  }
  void read_part(int part, const Run<Element>& run, int at, int count, int padded, PictureFaults& faults,
                 std::ptrdiff_t ahead) {
    float* const to[3] = {parts_[part][0] + at, parts_[part][1] + at, parts_[part][2] + at};
    read_run(run, count, to, faults, ahead);
    for (float(&plane)[std::size_t{chunk}] : parts_[part]) {
      for (int i = 0; i < at; ++i) plane[i] = 0;
      for (int i = at + count; i < padded; ++i) plane[i] = 0;
    }
  }

  template <int combination>
  void add(int begin, int steps) {
    constexpr int first = Sums::first_of(combination), count = Sums::count_of(combination), rest = count % together;
    const auto& folded = folded_[table_.folds == 1 ? 0 : combination];
    int moment = first;
    for (; moment + together <= first + count; moment += together) add<together>(folded, moment, begin, steps);
    if constexpr (rest != 0) add<rest>(folded, moment, begin, steps);
  }
  template <int size>
  void add(const float (&folded)[std::size_t{planes}][std::size_t{chunk}], int moment, int begin, int steps) {
    const float* const table = table_.row(moment) + begin;
    const std::ptrdiff_t stride = table_.stride;
    L total[static_cast<std::size_t>(size * planes)];
    unroll<0, size * planes>([&](auto k) ZONAL_INLINE { total[k] = L(0); });
    for (int i = 0; i < steps * lanes; i += lanes) {
      L factor[static_cast<std::size_t>(size)];
      unroll<0, size>([&](auto k) ZONAL_INLINE { factor[k] = L::load(table + k * stride + i); });
      unroll<0, planes>([&](auto plane) ZONAL_INLINE {
        const L number = L::load(folded[plane] + i);
        unroll<0, size>([&](auto k) ZONAL_INLINE { total[k * planes + plane].add_product(factor[k], number); });
      });
    }
    unroll<0, size * planes>([&](auto k) ZONAL_INLINE {
      L& sum = sums_[moment * planes + k];
      sum = sum + total[k];
    });
  }

  const Picture<const Element>& picture_;
  const ColumnTable<N>& table_;
  L sums_[static_cast<std::size_t>(Sums::moments * planes)];
  float parts_[4][3][std::size_t{chunk}];
  float folded_[4][std::size_t{planes}][std::size_t{chunk}];
};

// Rows [begin, end) of the picture.
template <int N, class Element>
void add_latitudes(const Environment<Element>& environment, const ColumnTable<N>& table, int begin, int end,
                   PictureSums<N>& sums) {
  using Latitudes = LatitudeSums<N>;
  const Equirectangular mapping(environment.width(), environment.height());
  Latitudes latitudes;
  RowMoments<N, Element> moments(environment.picture(), table);
  for (int first = begin; first < end; first += Latitudes::rows) {
    for (int lane = 0; lane < Latitudes::rows && first + lane < end; lane += 2) {
      moments.compute(first + lane, sums.faults);
      for (int i = 0; i < 2 && first + lane + i < end; ++i) {
        const int row = first + lane + i;
        const double theta = double(kPi) * (row + 0.5) / environment.height();
        latitudes.set_row(lane + i, std::cos(theta), std::sin(theta), mapping.solid_angle(0, row));
        for (int k = 0; k < Latitudes::moments; ++k) {
          for (int c = 0; c < 3; ++c) latitudes.set_moment(lane + i, k, c, moments.value(i, k, c));
        }
      }
    }
    latitudes.add_rows();
  }
  latitudes.finish(table.moments_of_one, sums);
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
