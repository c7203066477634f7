// Directions drawn in proportion to a picture's luminance: constant over each texel, so the density of a direction is
// its texel's luminance over the integral of all.
//
// A row is found by the sums of the rows, a texel by the sums of blocks of 16 in it, and within its block by the
// picture itself: a prepared picture takes half a byte a texel. Within a texel directions are uniform in solid angle,
// by rejection where the mapping stretches it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <variant>
#include <vector>

#include "../scalar/for_each.hpp"
#include "../scalar/luminance.hpp"
#include "../transform/sample.hpp"
#include "environment.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

/// Uniform numbers in [0, 1) that follow from a first one, for rejection (SplitMix64).
class FurtherUniform {
 public:
  FurtherUniform(double u, double v) : state_(bits(u) * 0x9e3779b97f4a7c15U ^ bits(v)) {}
  double operator()() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

 private:
  static std::uint64_t bits(double u) { return static_cast<std::uint64_t>(u * 0x1p53); }  // of [0, 1)
  std::uint64_t state_;
};

/// Where `target` falls among sums[first], ..., sums[last - 1], which do not decrease, from `below` on: the first that
/// is larger; where rounding left none, the last that is larger than the one before.
inline std::size_t find_share(const std::vector<double>& sums, std::size_t first, std::size_t last, double target) {
  const auto begin = sums.begin() + std::ptrdiff_t(first), end = sums.begin() + std::ptrdiff_t(last);
  auto found = std::upper_bound(begin, end, target);
  if (found == end) found = std::lower_bound(begin, end, *(end - 1));
  return std::size_t(found - sums.begin());
}

}  // namespace detail

/// Draws directions in proportion to luminance (ITU-R BT.709). The picture must outlive it, and not change. Directions
/// that no texel holds whole are not drawn: a disc's rim and its dead angle. A picture that is black, or too bright to
/// be summed, gives uniform directions.
template <class Element>
class EnvironmentSampler {
 public:
  /// for_each: see scalar/for_each.hpp.
  template <class ForEach = SerialForEach>
  explicit EnvironmentSampler(const Environment<Element>& environment, ForEach&& for_each = {})
      : environment_(environment),
        mapping_(environment.visit([](const auto& mapping) { return AnyMapping(mapping); })),
        blocks_((std::size_t(environment.width()) + block_ - 1) / block_),
        row_sums_(std::size_t(environment.height())),
        block_sums_(blocks_ * row_sums_.size()) {
    sum_rows(for_each);
    is_uniform_ = !(total_ > 0 && total_ <= (std::numeric_limits<double>::max)());
    if (is_uniform_) sum_rows(for_each);
  }

  /// The picture was black, or not finite: all directions are alike.
  bool is_uniform() const { return is_uniform_; }
  /// The integral of luminance over the directions that can be drawn, sr times the picture's unit; uniform, their solid
  /// angle.
  double integral() const { return total_; }

  /// u and v in [0, 1), uniform and independent; others are taken for the nearest such number, NaN for 0.
  DirectionSample<double> sample(double u, double v) const {
    return visit([&](const auto& mapping) { return sample(mapping, share(u, 1), share(v, 1)); });
  }

  /// The density, 1/sr, of a unit vector.
  template <class Direction>
  double pdf(const Direction& direction) const {
    return visit([&](const auto& mapping) {
      const std::array<double, 2> place = mapping.texel(direction);
      return pdf_of(mapping, int(place[0]), int(place[1]));
    });
  }

 private:
  using AnyMapping = std::variant<Equirectangular, VerticalCross, HorizontalCross, VerticalFaces, HorizontalFaces,
                                  MirrorSphere, AngularMap, Octahedral>;
  static constexpr int block_ = 16;

  template <class Visit>
  auto visit(const Visit& visit) const {
    return std::visit(visit, mapping_);
  }
  // Of what is no number, 0.
  static double share(double part, double whole) {
    return part / whole > 0 ? (std::min)(part / whole, 1 - 0x1p-53) : 0;
  }

  double luminance(int column, int row) const {
    if (is_uniform_) return 1;
    PictureFaults faults;
    const Rgb<float> c = environment_.radiance(column, row, faults);
    return kLuminanceWeights[0] * double(c.r) + kLuminanceWeights[1] * double(c.g) + kLuminanceWeights[2] * double(c.b);
  }
  template <class M>
  double weight(const M& mapping, int column, int row) const {
    if (!mapping.is_whole(column, row)) return 0;
    const double brightness = luminance(column, row);
    return brightness > 0 ? brightness * mapping.solid_angle(column, row) / mapping.solid_angle_scale() : 0;
  }
  template <class M>
  double pdf_of(const M& mapping, int column, int row) const {
    return mapping.is_whole(column, row) ? luminance(column, row) / total_ : 0;
  }

  template <class ForEach>
  void sum_rows(ForEach&& for_each) {
    visit([&](const auto& mapping) {
      for_each(environment_.height(), [&](int row) {
        double sum = 0;
        for (std::size_t block = 0; block < blocks_; ++block) {
          const int first = int(block) * block_, end = (std::min)(first + block_, environment_.width());
          for (int column = first; column < end; ++column) sum += weight(mapping, column, row);
          block_sums_[std::size_t(row) * blocks_ + block] = sum;
        }
        row_sums_[std::size_t(row)] = sum;
      });
    });
    total_ = 0;
    for (double& sum : row_sums_) sum = total_ += sum;
  }

  template <class M>
  DirectionSample<double> sample(const M& mapping, double u, double v) const {
    const std::size_t row = detail::find_share(row_sums_, 0, row_sums_.size(), u * total_);
    const double above = row > 0 ? row_sums_[row - 1] : 0.0;
    const double in_row = share(u * total_ - above, row_sums_[row] - above);

    const std::size_t first = row * blocks_;
    const double target = v * block_sums_[first + blocks_ - 1];
    const std::size_t block = detail::find_share(block_sums_, first, first + blocks_, target);
    double before = block > first ? block_sums_[block - 1] : 0.0, chosen_weight = 0;
    int chosen = 0;
    for (int i = 0; i < block_; ++i) {
      const int column = int(block - first) * block_ + i;
      if (column == environment_.width()) break;
      const double here = weight(mapping, column, int(row));
      if (!(here > 0)) continue;
      before += chosen_weight;
      chosen = column, chosen_weight = here;
      if (target < before + here) break;
    }
    return within(mapping, chosen, int(row), share(target - before, chosen_weight), in_row);
  }

  /// Uniform in solid angle over the texel.
  template <class M>
  DirectionSample<double> within(const M& mapping, int column, int row, double u, double v) const {
    detail::FurtherUniform further(u, v);
    const double densest = mapping.densest(column, row);
    const auto in_texel = [](int first, double share) { return detail::within(first + share, first, first + 1); };
    double x = in_texel(column, u), y = in_texel(row, v);
    while (mapping.density(x, y) < densest * further()) {
      x = in_texel(column, further()), y = in_texel(row, further());
    }
    const std::array<double, 3> d = mapping.direction(x, y);
    return {d[0], d[1], d[2], pdf_of(mapping, column, row)};
  }

  Environment<Element> environment_;
  AnyMapping mapping_;
  std::size_t blocks_;              // of a row
  std::vector<double> row_sums_;    // of each row and those above
  std::vector<double> block_sums_;  // of each block and those before it in its row
  double total_ = 0;
  bool is_uniform_ = false;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
