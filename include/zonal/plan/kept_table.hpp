// What a plan keeps of a material's table, and nothing else: for receivers, in 32 or 16 bits.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "../material/material_rows.hpp"
#include "../scalar/half.hpp"
#include "../scalar/index.hpp"
#include "material_plan.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// F of a material at its outgoing directions, as MaterialTable has it, of the coefficients that a plan keeps. With 16
/// bits they are half floats, whose error half_error tells.
class KeptTable {
 public:
  KeptTable(const MaterialTable& table, const CoefficientPlan& receiving, int bits = 32)
      : bands_((std::min)(receiving.bands, table.bands())), angles_(table.angles()) {
    for (int l = 0; l < bands_; ++l) {
      for (int m = 0; m <= l; ++m) {
        if (receiving.keeps(l, m)) places_.push_back(std::uint16_t(even_index(l, m)));
      }
    }
    for (int row = 0; row < angles_; ++row) {
      for (const int place : places_) {
        const glm::vec3& f = table.with_cosine_rows()[std::size_t(row * table.row_size() + place)];
        for (int c = 0; c < 3; ++c) {
          if (bits == 16) {
            halves_.push_back(to_half(f[c]));
          } else {
            floats_.push_back(f[c]);
          }
        }
      }
    }
  }

  int bands() const { return bands_; }
  /// Rows: 90, or 1.
  int angles() const { return angles_; }
  /// Coefficients in a row.
  int row_size() const { return int(places_.size()); }
  /// Where each of these stands among those of all degrees and orders: even_index(l, m).
  const std::vector<std::uint16_t>& places() const { return places_; }
  /// Bytes that the rows take.
  std::size_t bytes() const { return sizeof(float) * floats_.size() + sizeof(Half) * halves_.size(); }

  /// F at the outgoing direction whose z is cos_outgoing, as MaterialTable::with_cosine; what is not kept is zero.
  template <int N>
  EvenSh<N, glm::vec3> with_cosine(float cos_outgoing) const {
    return floats_.empty() ? between<N>(halves_, cos_outgoing) : between<N>(floats_, cos_outgoing);
  }

  /// All rows, one after the other, RGB innermost: angles() * row_size() * 3 numbers.
  std::vector<float> rows() const {
    std::vector<float> numbers = floats_;
    for (const Half half : halves_) numbers.push_back(to_float(half));
    return numbers;
  }

 private:
  template <int N, class Number>
  EvenSh<N, glm::vec3> between(const std::vector<Number>& rows, float cos_outgoing) const {
    constexpr int most = EvenSh<N, glm::vec3>::size();
    const float position = detail::row_position(cos_outgoing, float(angles_));
    const int below = detail::index_below(position, angles_ - 1), above = (std::min)(below + 1, angles_ - 1);
    const float t = position - float(below);
    const int count = (std::min)(row_size(), most);
    const Number *const a = rows.data() + 3 * below * row_size(), *const b = rows.data() + 3 * above * row_size();
    float numbers[std::size_t{3 * most}];
    for (int i = 0; i < 3 * count; ++i) numbers[i] = detail::between_rows(to_float(a[i]), to_float(b[i]), t);
    EvenSh<N, glm::vec3> result{};
    for (int i = 0; i < count && places_[std::size_t(i)] < most; ++i) {
      result[places_[std::size_t(i)]] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
    }
    return result;
  }

  int bands_, angles_;
  std::vector<std::uint16_t> places_;
  std::vector<float> floats_;  // or
  std::vector<Half> halves_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
