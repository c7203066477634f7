// The coefficients of a material by outgoing direction, as gathers read them. material_table.hpp projects them.
//
// An isotropic material depends on the angle theta_o between the normal and the eye only: [1] Eq. 18 stores
// its coefficients at 90 angles, one degree apart. Here they are half as many, because in the frame where wo
// has phi = 0 the material is even in phi; and between two angles they are interpolated. Anisotropic
// materials need a second angle, and another table: anisotropic_rows.hpp.
//
// [1] Mezieres et al., Harmonics Virtual Lights, CGF 41(6), 2022, section 4.2.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "../basis/sh.hpp"
#include "../scalar/index.hpp"
#include "../transform/window.hpp"
#include "brdf_projection.hpp"
#include "table_rows.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

/// The first coefficients of the row at an outgoing angle, of a table with one row per degree (or one row in all):
/// linear in the angle, constant beyond the last row, which also answers what is no number. Where more are asked for
/// than a row holds, the rest stays as it is.
template <class Coefficients>
void interpolate_rows(const std::vector<glm::vec3>& table, int angles, float cos_outgoing, Coefficients& result) {
  const float position = row_position(cos_outgoing, float(angles));
  const int below = index_below(position, angles - 1), above = (std::min)(below + 1, angles - 1);
  const float t = position - float(below);
  const int row_size = int(table.size()) / angles;
  const glm::vec3* row_below = table.data() + below * row_size;
  const glm::vec3* row_above = table.data() + above * row_size;
  for (int i = 0; i < (std::min)(int(result.size()), row_size); ++i)
    result[i] = between_rows(row_below[i], row_above[i], t);
}

}  // namespace detail

/// F' as MaterialTable and HVL want it: of the BRDF mirrored at the surface, f(x, y, |z|), which doubles the
/// coefficients of even l + m and leaves none of odd. Projections that take f to be zero below the surface, as [1]
/// does, have to be converted: read as if they were mirrored they would give exactly half the light. Hence a type of
/// its own.
class MirroredRows {
 public:
  /// Rows of coefficients, each (l, m) at l (l + 1) / 2 + m, that are of the mirrored BRDF already.
  explicit MirroredRows(std::vector<glm::vec3> rows) : rows_(std::move(rows)) {}

  /// Rows of `bands` bands each, as [1] defines F': the integrals over the upper hemisphere alone. Exact.
  static MirroredRows from_upper_hemisphere(std::vector<glm::vec3> rows, int bands) {
    auto coefficient = rows.begin();
    while (coefficient != rows.end()) {
      for (int l = 0; l < (std::max)(bands, 1); ++l) {
        for (int m = 0; m <= l && coefficient != rows.end(); ++m) {
          *coefficient++ *= is_even_in_z(l, m) ? 2.0F : 0.0F;
        }
      }
    }
    return MirroredRows(std::move(rows));
  }

  const std::vector<glm::vec3>& rows() const& { return rows_; }
  std::vector<glm::vec3> rows() && { return std::move(rows_); }

 private:
  std::vector<glm::vec3> rows_;
};

/// F (with cosine) and F' (without), RGB, of an isotropic material: see projection.hpp for the two and for
/// their frame.
///
/// Row i is the outgoing angle of i degrees, i = 0 to 89; a material that looks the same from everywhere has
/// row 0 alone. A row holds bands (bands + 1) / 2 coefficients of m >= 0, (l, m) at l (l + 1) / 2 + m. Its
/// first N (N + 1) / 2 are thus the table of N bands: one table serves every N up to its own.
///
/// Between rows the coefficients are linear in the angle, beyond 89 degrees they are constant. For sharp
/// lobes that moves degree l by up to (l pi / 180)^2 / 8. Greatest error measured half-way between rows,
/// relative to the largest coefficient, GGX of roughness 0.01 to 1 and Phong up to 1000: F 3e-3 at 5 bands,
/// 5e-3 at 10, 1.4e-2 at 21; F' 1e-2, 1e-2, 1.4e-2; beyond 85 degrees, where materials change fast, 3e-2 for
/// both.
class MaterialTable {
 public:
  static constexpr int max_bands = 21;
  static constexpr int max_angles = 90;

  /// One projection per degree, or a single one; the first `bands` bands of each are kept, 1 to 21.
  MaterialTable(const std::vector<BrdfProjection<max_bands>>& projections, int bands)
      : bands_(std::clamp(bands, 1, max_bands)), angles_((std::max)(int(projections.size()), 1)) {
    assert(bands_ == bands);
    assert(projections.size() == 1 || projections.size() == max_angles);
    const auto append = [this](std::vector<glm::vec3>& table, const EvenSh<max_bands, glm::dvec3>& sh) {
      for (int i = 0; i < row_size(); ++i) table.push_back(glm::vec3(sh[i]));
    };
    for (const BrdfProjection<max_bands>& projection : projections) {
      append(with_cosine_, projection.with_cosine);
      append(without_cosine_, projection.without_cosine);
      achieved_error_ = (std::max)(achieved_error_, projection.error);
    }
    fill();
  }

  /// All rows as with_cosine_rows() and without_cosine_rows() return them, `angles` (90, or 1) times
  /// bands (bands + 1) / 2 coefficients, and the error that achieved_error() is to return: a table from a file. What is
  /// missing of the rows is zero.
  MaterialTable(int bands, int angles, double achieved_error, std::vector<glm::vec3> with_cosine,
                MirroredRows without_cosine)
      : bands_(std::clamp(bands, 1, max_bands)),
        angles_(std::clamp(angles, 1, max_angles)),
        achieved_error_(achieved_error),
        with_cosine_(std::move(with_cosine)),
        without_cosine_(std::move(without_cosine).rows()) {
    assert(bands_ == bands && angles_ == angles && (angles == 1 || angles == max_angles));
    assert(with_cosine_.size() == std::size_t(angles_ * row_size()) && without_cosine_.size() == with_cosine_.size());
    fill();
  }

  int bands() const { return bands_; }
  /// Rows: 90, or 1.
  int angles() const { return angles_; }
  /// Coefficients in a row: bands (bands + 1) / 2.
  int row_size() const { return even_index(bands_, 0); }
  /// The greatest error of a row's projection, relative to its largest coefficient: BrdfProjection::error
  /// over all rows.
  double achieved_error() const { return achieved_error_; }

  /// F at the outgoing direction whose z is cos_outgoing, in [-1, 1] up to rounding. Bands that the table does not have
  /// are zero.
  template <int N>
  EvenSh<N, glm::vec3> with_cosine(float cos_outgoing) const {
    return interpolate<N>(with_cosine_, cos_outgoing);
  }
  /// F', the same.
  template <int N>
  EvenSh<N, glm::vec3> without_cosine(float cos_outgoing) const {
    return interpolate<N>(without_cosine_, cos_outgoing);
  }

  /// All rows, one after the other: angles() * row_size() coefficients, for textures and files.
  const std::vector<glm::vec3>& with_cosine_rows() const { return with_cosine_; }
  const std::vector<glm::vec3>& without_cosine_rows() const { return without_cosine_; }

  /// The table with degree l multiplied by the window's factor. `width`, the degree where the window ends, is
  /// the number of bands that the table will be read with.
  MaterialTable windowed(Window window, double width) const {
    MaterialTable result = *this;
    for (std::vector<glm::vec3>* table : {&result.with_cosine_, &result.without_cosine_}) {
      auto coefficient = table->begin();
      for (int angle = 0; angle < angles_; ++angle) {
        for (int l = 0; l < bands_; ++l) {
          const auto factor = float(window_factor(window, l, width));
          for (int m = 0; m <= l; ++m) *coefficient++ *= factor;
        }
      }
    }
    return result;
  }
  MaterialTable windowed(Window window) const { return windowed(window, bands_); }

 private:
  /// Whatever was given, the rows are all there.
  void fill() {
    with_cosine_.resize(std::size_t(angles_ * row_size()), glm::vec3(0.0F));
    without_cosine_.resize(with_cosine_.size(), glm::vec3(0.0F));
  }

  template <int N>
  EvenSh<N, glm::vec3> interpolate(const std::vector<glm::vec3>& table, float cos_outgoing) const {
    static_assert(1 <= N && N <= max_bands, "bands out of range: 1 <= N <= 21");
    EvenSh<N, glm::vec3> result{};
    detail::interpolate_rows(table, angles_, cos_outgoing, result);
    return result;
  }

  int bands_, angles_;
  double achieved_error_ = 0.0;
  std::vector<glm::vec3> with_cosine_, without_cosine_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
