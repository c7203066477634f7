// The coefficients of an anisotropic material by both angles of the outgoing direction, as gathers read them.
// anisotropic_table.hpp says in which frame, and projects them.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "../basis/sh.hpp"
#include "../scalar/constexpr_math.hpp"
#include "../scalar/function_ref.hpp"
#include "../scalar/index.hpp"
#include "../scalar/scalar.hpp"
#include "../transform/window.hpp"
#include "brdf_projection.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

struct Brdf;

/// F (with cosine) and F' (without), RGB, of an anisotropic material, one row per degree of the outgoing angle, 0 to
/// 89, and one for each of `azimuths` of its azimuths, 1 to 360, equally spaced; bilinear between rows, beyond 89
/// degrees constant.
///
/// Rows are projected when they are first asked for. Any number of threads may ask at once; two that need the same new
/// row may both project it, and one result is kept: the BRDF must bear being called from several threads.
class AnisotropicTable {
 public:
  static constexpr int max_bands = 21, angles = 90, max_azimuths = 360;

  /// These two are in anisotropic_table.hpp. brdf in 1/sr, of unit vectors in the local frame; 1 to 21 bands; see
  /// project_brdf for the tolerance.
  AnisotropicTable(BrdfFunction brdf, int bands, double tolerance = 1e-4, int azimuths = max_azimuths);
  /// Of a sum of lobes, in the surface's own frame. A measured lobe with a quadrature of its own is projected by it.
  AnisotropicTable(Brdf brdf, int bands, double tolerance = 1e-4, int azimuths = max_azimuths);
  ~AnisotropicTable() {
    for (auto& row : rows_) delete row.load(std::memory_order_relaxed);
  }
  AnisotropicTable(const AnisotropicTable&) = delete;
  AnisotropicTable& operator=(const AnisotropicTable&) = delete;

  int bands() const { return bands_; }

  /// F at the outgoing direction, a unit vector of z in [0, 1]; in the frame turned with it. N bands, of which those
  /// beyond bands() are zero.
  template <int N>
  Sh<N, glm::vec3> with_cosine(const glm::vec3& outgoing) const {
    return interpolate<N>(0, outgoing);
  }
  /// F', the same.
  template <int N>
  Sh<N, glm::vec3> without_cosine(const glm::vec3& outgoing) const {
    return interpolate<N>(1, outgoing);
  }

  /// From now on degree l is multiplied by the window's factor: F by that of receiver_width, F' by that of
  /// emitter_width, the numbers of bands that they will be read with. Not while others read.
  void set_windows(Window window, double receiver_width, double emitter_width) {
    for (int l = 0; l < bands_; ++l) {
      factors_[0][std::size_t(l)] = float(window_factor(window, l, receiver_width));
      factors_[1][std::size_t(l)] = float(window_factor(window, l, emitter_width));
    }
  }

  /// Rows projected so far, of angles * azimuths.
  int rows_built() const {
    return int(std::count_if(rows_.begin(), rows_.end(), [](const auto& row) { return row.load() != nullptr; }));
  }

 private:
  using Row = std::vector<glm::vec3>;  // F, then F', bands^2 coefficients each

  AnisotropicTable(int bands, int azimuths)
      : bands_(std::clamp(bands, 1, max_bands)),
        azimuths_(std::clamp(azimuths, 1, max_azimuths)),
        rows_(std::size_t(angles * azimuths_)) {
    for (auto& row : rows_) row.store(nullptr, std::memory_order_relaxed);
    for (auto& kind : factors_) kind.fill(1.0F);
  }

  template <int N>
  Sh<N, glm::vec3> interpolate(int kind, const glm::vec3& outgoing) const {
    static_assert(1 <= N && N <= max_bands, "bands out of range: 1 <= N <= 21");
    const double degree = double(kPi) / 180.0, x = double(outgoing.x), y = double(outgoing.y), z = double(outgoing.z);
    const double tilt = std::atan2(std::hypot(x, y), z) / degree;
    const double azimuth = (std::atan2(y, x) / (2.0 * double(kPi)) + 1.0) * azimuths_;
    const double angle = tilt > 0.0 ? (std::min)(tilt, double(angles - 1)) : 0.0;
    const double turn = azimuth > 0.0 ? azimuth : 0.0;
    const int low = detail::index_below(angle, angles - 2), first = detail::index_below(turn, 2 * azimuths_);
    const auto s = float(angle - low), t = float(turn - first);
    Sh<N, glm::vec3> sum{};
    const int read = (std::min)(N, bands_);
    const auto add = [&](int row, int place, float weight) {
      if (detail::is_equal(weight, 0.0F)) return;
      const glm::vec3* coefficient = this->row(row, place % azimuths_).data() + kind * bands_ * bands_;
      for (int i = 0; i < read * read; ++i) sum[i] += coefficient[i] * weight;
    };
    add(low, first, (1.0F - s) * (1.0F - t));
    add(low, first + 1, (1.0F - s) * t);
    add(low + 1, first, s * (1.0F - t));
    add(low + 1, first + 1, s * t);
    for (int l = 0; l < read; ++l) {
      for (int m = -l; m <= l; ++m) sum(l, m) *= factors_[std::size_t(kind)][std::size_t(l)];
    }
    return sum;
  }

  const Row& row(int angle, int azimuth) const {
    std::atomic<const Row*>& place = rows_[std::size_t(angle * azimuths_ + azimuth)];
    const Row* present = place.load(std::memory_order_acquire);
    if (present != nullptr) return *present;
    std::unique_ptr<const Row> mine = project_row(angle, azimuth);
    if (place.compare_exchange_strong(present, mine.get(), std::memory_order_acq_rel)) return *mine.release();
    return *present;  // another thread was faster
  }

  std::unique_ptr<const Row> project_row(int angle, int azimuth) const {
    const auto exact =
        project_(std::cos(double(kPi) / 180.0 * angle), 2.0 * double(kPi) * double(azimuth) / double(azimuths_));
    auto row = std::make_unique<Row>();
    for (const auto* kind : {&exact.with_cosine, &exact.without_cosine}) {
      for (int i = 0; i < bands_ * bands_; ++i) row->push_back(glm::vec3((*kind)[i]));
    }
    return row;
  }

  int bands_, azimuths_;
  SharedFunction<AnisotropicProjection<max_bands>(double cos_outgoing, double azimuth)> project_;
  std::array<std::array<float, std::size_t(max_bands)>, 2> factors_{};
  mutable std::vector<std::atomic<const Row*>> rows_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
