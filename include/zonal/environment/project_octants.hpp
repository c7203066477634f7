// Pictures that are mirror images of themselves: cubes, octahedra, discs. Each harmonic is even or odd in x, in y and
// in z, so that the basis is evaluated in one octant; the texels that mirror it are added up with each of the eight
// combinations of signs first (a Walsh-Hadamard transform: 24 additions for 8 texels), and a harmonic takes its own:
// N^2/8 multiply-adds a texel and channel. Discs have four mirror images. All from the directions on is double.
#pragma once

#include <cmath>
#include <cstddef>

#include "../basis/evaluate.hpp"
#include "environment.hpp"
#include "picture_sums.hpp"
#include "read_run.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace detail {

// As many floats as a register holds doubles. (No template: there GCC does not know the vectors' type.)
ZONAL_INLINE inline Lanes<double, native_lanes_v<double>> widened(const float* numbers) {
  constexpr int width = native_lanes_v<double>;
#if defined(__clang__) || (defined(__GNUC__) && __GNUC__ >= 9)
  typedef float Narrow __attribute__((vector_size(width * sizeof(float)), aligned(alignof(float)), may_alias));
  typedef double Wide __attribute__((vector_size(width * sizeof(double))));
  return Lanes<double, width>::from(__builtin_convertvector(*reinterpret_cast<const Narrow*>(numbers), Wide));
#else
  double wide[width];
  for (int i = 0; i < width; ++i) wide[i] = double(numbers[i]);
  return Lanes<double, width>::load(wide);
#endif
}

// Up to `capacity` directions, and what stands at them and at their mirror images.
struct OctantRun {
  static constexpr int capacity = 32;
  static constexpr auto size = static_cast<std::size_t>(capacity);

  int count = 0;
  double x[size], y[size], z[size], weight[size];
  float texels[8][3][size];  // by sign: bit 0 set where x is that of the mirror image, bit 1 y, bit 2 z
  bool has[8];               // whether there is such an image; else its texels are 0

  void clear(int directions) {
    count = directions;
    for (int s = 0; s < 8; ++s) has[s] = false;
    for (std::size_t i = 0; i < size; ++i) {
      x[i] = y[i] = z[i] = weight[i] = 0;
      for (int s = 0; s < 8; ++s) {
        for (int c = 0; c < 3; ++c) texels[s][c][i] = 0;
      }
    }
  }
  // Texels that are their own mirror images come twice: those from first_copy on are not counted again.
  template <class Element>
  void read(int sign, const Run<Element>& run, PictureFaults& faults, int first_copy, int end_of_copies) {
    float* const to[3] = {texels[sign][0], texels[sign][1], texels[sign][2]};
    PictureFaults found, again;
    read_run(run, count, to, found);
    if (found.total() != 0) read_texels(run, first_copy, end_of_copies, to, again);
    faults += found;
    faults -= again;
    has[sign] = true;
  }
};

template <int N>
class OctantSums {
  static constexpr int width = native_lanes_v<double>;
  static constexpr std::size_t size = OctantRun::size;
  using L = Lanes<double, width>;

  // Which combination a harmonic takes: bit 0 where it is odd in x, bit 1 in y, bit 2 in z.
  static constexpr int parity(int l, int m) {
    const bool is_sine = m < 0;
    return ((m & 1) ^ int(is_sine)) | (is_sine ? 2 : 0) | (is_even_in_z(l, m) ? 0 : 4);
  }

 public:
  void add(const OctantRun& run) {
    combine(run);
    for (std::size_t i = 0; i < size; ++i) {
      cosine_[i] = run.weight[i];
      sine_[i] = 0;
    }
    unroll<0, N>([&](auto m) {
      add_order<m>(run);
      next_power(run);
    });
  }

  void finish(PictureSums<N>& sums) const {
    for (int i = 0; i < N * N; ++i) {
      for (int c = 0; c < 3; ++c) sums.radiance[i][c] += sum(radiance_[i][c]);
      sums.one[i] += sum(one_[i]);
    }
  }

 private:
  // combined_[p] = sum over the signs s of (-1)^(bits that s and p share) texels[s], and the same of ones.
  void combine(const OctantRun& run) {
    constexpr int lanes = native_lanes_v<float>;
    using F = Lanes<float, lanes>;
    for (int c = 0; c < 3; ++c) {
      for (int i = 0; i < OctantRun::capacity; i += lanes) {
        F sums[8];
        unroll<0, 8>([&](auto s) ZONAL_INLINE { sums[s] = F::load(run.texels[s][c] + i); });
        unroll<0, 3>([&](auto bit) ZONAL_INLINE {
          unroll<0, 8>([&](auto s) ZONAL_INLINE {
            if constexpr ((s & (1 << bit)) == 0) {
              const F a = sums[s], b = sums[s | (1 << bit)];
              sums[s] = a + b;
              sums[s | (1 << bit)] = a - b;
            }
          });
        });
        unroll<0, 8>([&](auto p) ZONAL_INLINE {
          float numbers[static_cast<std::size_t>(lanes)];
          sums[p].store(numbers);
          for (int k = 0; k < lanes; k += width) widened(numbers + k).store(combined_[p][c] + i + k);
        });
      }
    }
    for (int p = 0; p < 8; ++p) {
      ones_[p] = 0;
      for (int s = 0; s < 8; ++s) {
        const int shared = s & p, is_odd = (shared ^ (shared >> 1) ^ (shared >> 2)) & 1;
        if (run.has[s]) ones_[p] += is_odd != 0 ? -1 : 1;
      }
    }
  }

  // Re and Im of (x + iy)^m times the weight, from those of m - 1.
  void next_power(const OctantRun& run) {
    for (std::size_t i = 0; i < size; i += width) {
      const L x = L::load(run.x + i), y = L::load(run.y + i), c = L::load(cosine_ + i), s = L::load(sine_ + i);
      (x * c - y * s).store(cosine_ + i);
      (x * s + y * c).store(sine_ + i);
    }
  }

  template <int m>
  void add_order(const OctantRun& run) {
    for (int i = 0; i < run.count; i += width) {
      const L z = L::load(run.z + i), cosine = L::load(cosine_ + i), sine = L::load(sine_ + i);
      L cosine_part[2][3], sine_part[2][3];  // of harmonics that are even in z, and odd
      for (int is_odd = 0; is_odd < 2; ++is_odd) {
        for (int c = 0; c < 3; ++c) {
          cosine_part[is_odd][c] = cosine * L::load(combined_[parity(m + is_odd, m)][c] + i);
          if constexpr (m > 0) sine_part[is_odd][c] = sine * L::load(combined_[parity(m + is_odd, -m)][c] + i);
        }
      }
      legendre_column<N, m>(z, z * z, [&](auto l, const L& q) ZONAL_INLINE {
        constexpr int is_odd = (l - m) % 2;
        for (int c = 0; c < 3; ++c) {
          radiance_[sh_index(l, m)][c].add_product(q, cosine_part[is_odd][c]);
          if constexpr (m > 0) radiance_[sh_index(l, -m)][c].add_product(q, sine_part[is_odd][c]);
        }
        add_one<l, m>(q, cosine);
        if constexpr (m > 0) add_one<l, -m>(q, sine);
      });
    }
  }
  template <int l, int m>
  ZONAL_INLINE void add_one(const L& q, const L& power) {
    constexpr int p = parity(l, m);
    // Ones vanish in all others: cubes have mirror images in all axes, discs in y and z, octahedra at least in x and y.
    if constexpr (p == 0 || p == 1 || p == 4) one_[sh_index(l, m)].add_product(q, L(ones_[p]) * power);
  }
  static double sum(const L& lanes) {
    double numbers[static_cast<std::size_t>(width)], total = 0;
    lanes.store(numbers);
    for (const double number : numbers) total += number;
    return total;
  }

  double combined_[8][3][size], cosine_[size], sine_[size], ones_[8];
  L radiance_[static_cast<std::size_t>(N * N)][3] = {};
  L one_[static_cast<std::size_t>(N * N)] = {};
};

// A side of `size` texels from the middle outwards: texel k, 0 to (size + 1) / 2 - 1, and its mirror image. In an odd
// number the middle one is its own, and counts half.
struct HalfSide {
  int size;
  int count() const { return (size + 1) / 2; }
  int texel(int k, bool is_mirrored) const { return is_mirrored ? size - 1 - (size / 2 + k) : size / 2 + k; }
  double share(int k) const { return size % 2 != 0 && k == 0 ? 0.5 : 1.0; }
};

// Runs of a square picture about its middle, by the signs of two of the axes: the one of its columns and the one of its
// rows. `first` and `row` are as HalfSide counts them.
template <class Element>
void read_mirrored(OctantRun& run, const Picture<const Element>& picture, int first, int row, int column_bit,
                   int row_bit, int other_bits, PictureFaults& faults) {
  const HalfSide side{picture.width};
  for (int s = 0; s < 4; ++s) {
    const bool left = (s & 1) != 0, above = (s & 2) != 0;
    const Run<Element> texels{picture.at(side.texel(first, left), side.texel(row, above)),
                              left ? -picture.column_stride : picture.column_stride, picture.channel_stride,
                              picture.channels};
    const bool is_odd = side.size % 2 != 0;
    const int copies = is_odd && above && row == 0 ? run.count : is_odd && left && first == 0 ? 1 : 0;
    run.read((left ? column_bit : 0) | (above ? row_bit : 0) | other_bits, texels, faults, 0, copies);
  }
}

// The same texels with columns and rows that go where they are told to: each backwards, and then one for the other.
template <class Element>
Picture<const Element> turned(Picture<const Element> picture, bool left, bool up, bool is_transposed) {
  if (left) {
    picture.data += (picture.width - 1) * picture.column_stride;
    picture.column_stride = -picture.column_stride;
  }
  if (up) {
    picture.data += (picture.height - 1) * picture.row_stride;
    picture.row_stride = -picture.row_stride;
  }
  if (is_transposed) {
    const std::ptrdiff_t stride = picture.column_stride;
    picture.column_stride = picture.row_stride;
    picture.row_stride = stride;
  }
  return picture;
}

// add_octants(environment, mapping, begin, end, sums): the rows [begin, end), from the middle outwards. Of a cube:
template <int N, class Element, class Layout>
void add_octants(const Environment<Element>& environment, const Cube<Layout>& mapping, int begin, int end,
                 PictureSums<N>& sums) {
  const int n = mapping.size;
  const HalfSide side{n};
  OctantSums<N> octants;
  OctantRun run;
  for (int row = begin; row < end; ++row) {
    for (int first = 0; first < side.count(); first += OctantRun::capacity) {
      const int left = side.count() - first, count = left < OctantRun::capacity ? left : OctantRun::capacity;
      double u[OctantRun::size], v[OctantRun::size], w[OctantRun::size], weight[OctantRun::size];
      for (int i = 0; i < count; ++i) {
        const int column = side.texel(first + i, false), line = side.texel(row, false);
        const double p = (2.0 * column + 1 - n) / n, q = (2.0 * line + 1 - n) / n;
        w[i] = 1 / std::sqrt(1 + p * p + q * q);
        u[i] = p * w[i];
        v[i] = q * w[i];
        weight[i] = side.share(first + i) * side.share(row) * mapping.face_solid_angle(column, line);
      }
      for (int a = 0; a < 3; ++a) {  // the faces at both ends of an axis, with b to their right and c downwards
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        run.clear(count);
        double* const axes[3] = {run.x, run.y, run.z};
        for (int i = 0; i < count; ++i) {
          axes[a][i] = w[i];
          axes[b][i] = u[i];
          axes[c][i] = v[i];
          run.weight[i] = weight[i];
        }
        for (int end_of_axis = 0; end_of_axis < 2; ++end_of_axis) {
          const CubeFace& f = Layout::faces[2 * a + end_of_axis];
          const auto face = turned(environment.template face<Layout>(2 * a + end_of_axis), f.right < 0, f.down < 0,
                                   axis_of(f.right) != b);
          read_mirrored(run, face, first, row, 1 << b, 1 << c, end_of_axis << a, sums.faults);
        }
        octants.add(run);
      }
    }
  }
  octants.finish(sums);
}

// Directions and solid angles of texels of a mapping's square picture, that of texel i at column(i), row(i).
template <class M, class Column>
void set_directions(OctantRun& run, const M& mapping, const Column& column, int row, double share) {
  for (int i = 0; i < run.count; ++i) {
    const auto d = mapping.direction(column(i) + 0.5, row + 0.5);
    run.x[i] = d[0];
    run.y[i] = d[1];
    run.z[i] = d[2];
    run.weight[i] = share * mapping.solid_angle(column(i), row);
  }
}

// The same in lanes. Lanes beyond the last repeat it.
template <class Column>
void set_directions(OctantRun& run, const AngularMap& mapping, const Column& column, int row, double share) {
  constexpr int width = native_lanes_v<double>;
  using L = Lanes<double, width>;
  for (int i = 0; i < run.count; i += width) {
    double columns[static_cast<std::size_t>(width)];
    for (int lane = 0; lane < width; ++lane) columns[lane] = column(i + lane < run.count ? i + lane : run.count - 1);
    L direction[3], solid_angle(0);
    mapping.direction_and_solid_angle(L::load(columns), row, direction, solid_angle);
    direction[0].store(run.x + i);
    direction[1].store(run.y + i);
    direction[2].store(run.z + i);
    (L(share) * solid_angle).store(run.weight + i);
    for (int lane = run.count - i; lane < width; ++lane) run.weight[i + lane] = 0;
  }
}

// Of a disc, where columns go to the right, -y, and rows downwards, -z.
template <int N, class Element, class M>
void add_octants(const Environment<Element>& environment, const M& mapping, int begin, int end, PictureSums<N>& sums) {
  const int n = mapping.size;
  const HalfSide side{n};
  const auto picture = turned(environment.picture(), true, true, false);
  OctantSums<N> octants;
  OctantRun run;
  for (int row = begin; row < end; ++row) {
    const int line = n - 1 - side.texel(row, false);
    const auto column = [&](int i) { return n - 1 - side.texel(i, false); };
    int count = side.count();
    while (count > 0 && !mapping.has_direction(column(count - 1), line)) --count;
    for (int first = 0; first < count; first += OctantRun::capacity) {
      run.clear(count - first < OctantRun::capacity ? count - first : OctantRun::capacity);
      set_directions(
          run, mapping, [&](int i) { return column(first + i); }, line, side.share(row));
      if (first == 0) run.weight[0] *= side.share(0);
      read_mirrored(run, picture, first, row, 2, 4, 0, sums.faults);
      octants.add(run);
    }
  }
  octants.finish(sums);
}

// Of an octahedron, where columns go to +x and rows to +y. Of an even number of texels the lower half mirrors the
// upper: what is at (i, j) from the middle is at (h - 1 - j, h - 1 - i) below, h being half the side; on the diagonal
// the two are one.
template <int N, class Element>
void add_octants(const Environment<Element>& environment, const Octahedral& mapping, int begin, int end,
                 PictureSums<N>& sums) {
  const int n = mapping.size, half = n / 2;
  const HalfSide side{n};
  const auto& picture = environment.picture();
  const bool is_even = n % 2 == 0;
  OctantSums<N> octants;
  OctantRun run;
  for (int row = begin; row < end; ++row) {
    const int count = is_even ? half - row : side.count();
    for (int first = 0; first < count; first += OctantRun::capacity) {
      run.clear(count - first < OctantRun::capacity ? count - first : OctantRun::capacity);
      set_directions(
          run, mapping, [&](int i) { return side.texel(first + i, false); }, side.texel(row, false), side.share(row));
      if (first == 0) run.weight[0] *= side.share(0);
      read_mirrored(run, picture, first, row, 1, 2, 0, sums.faults);
      if (is_even) {
        const int on_diagonal = first + run.count == count ? run.count - 1 : run.count;
        if (on_diagonal < run.count) run.weight[on_diagonal] *= 0.5;
        for (int s = 0; s < 4; ++s) {
          const bool left = (s & 1) != 0, above = (s & 2) != 0;
          run.read(
              s | 4,
              Run<Element>{picture.at(side.texel(half - 1 - row, left), side.texel(half - 1 - first, above)),
                           above ? picture.row_stride : -picture.row_stride, picture.channel_stride, picture.channels},
              sums.faults, on_diagonal, run.count);
        }
      }
      octants.add(run);
    }
  }
  octants.finish(sums);
}

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
