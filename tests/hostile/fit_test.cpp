// Fits of samples, weights and smoothness that cannot be: what is no number is left out, and what comes out is one.
#include <zonal/fit/least_squares.hpp>
#include <zonal/transform/dot.hpp>

#include <cmath>
#include <vector>

#include "../catch.hpp"
#include "numbers.hpp"

namespace {

constexpr int N = 3;
using Vec3 = std::array<double, 3>;

zonal::Sh<N, double> truth() {
  zonal::Sh<N, double> sh{};
  for (int i = 0; i < N * N; ++i) sh.values[i] = 1.0 / (1 + i);
  return sh;
}

/// Directions all over the sphere, of a length.
std::vector<Vec3> directions(double length = 1) {
  std::vector<Vec3> all;
  for (int i = 0; i < 60; ++i) {
    const double z = (i + 0.5) / 30 - 1, r = std::sqrt(1 - z * z);
    all.push_back({length * (r * std::cos(2.4 * i)), length * (r * std::sin(2.4 * i)), length * z});
  }
  return all;
}

void add(zonal::SampleFitter<N, double>& fitter, double length = 1, double weight = 1) {
  const auto unit = directions(), all = directions(length);
  for (std::size_t i = 0; i < all.size(); ++i) fitter.add(all[i], zonal::reconstruct(truth(), unit[i]), weight);
}

double worst_difference(const zonal::Sh<N, double>& sh) {
  double worst = 0;
  for (int i = 0; i < N * N; ++i) {
    const double difference = std::abs(sh.values[i] - truth().values[i]);
    worst = difference <= worst ? worst : difference;  // NaN too
  }
  return worst;
}

}  // namespace

TEST_CASE("hostile: samples that are no numbers change no fit, and are counted") {
  for (const double x : hostile::numbers<double>()) {
    const bool is_number = std::abs(x) <= 1e100;
    CAPTURE(x);
    zonal::SampleFitter<N, double> values, weights, axes;
    for (auto* fitter : {&values, &weights, &axes}) add(*fitter);
    values.add({0, 0, 1}, x, 0.0);  // of no weight: it may not spoil the sum either
    weights.add({0, 0, 1}, zonal::reconstruct(truth(), Vec3{0, 0, 1}), x);
    axes.add({x, 0, 0}, zonal::reconstruct(truth(), Vec3{x < 0 ? -1.0 : 1.0, 0, 0}));
    CHECK(values.solve().left_out == (is_number ? 0 : 1));
    CHECK(weights.solve().left_out == (is_number && !(x < 0) ? 0 : 1));
    CHECK(axes.solve().left_out == (is_number && (x < 0 || 0 < x) ? 0 : 1));
    for (auto* fitter : {&values, &weights, &axes}) {
      CHECK(worst_difference(fitter->solve().sh) <= 1e-14);
      CHECK(std::isfinite(fitter->solve().residuals[0]));
    }
  }
}

TEST_CASE("hostile: directions of any length and weights of any size give the same fit") {
  for (const double length : {1e100, 1e-100, 1e-300, 1e-320}) {
    zonal::SampleFitter<N, double> fitter;
    add(fitter, length);
    const auto fit = fitter.solve();
    CAPTURE(length, fit.condition, fit.left_out);
    // 1e-320 is known to 2000 steps.
    CHECK(worst_difference(fit.sh) <= (length < 1e-310 ? 3e-3 : 1e-14));
  }
  // Of the least numbers there are, to the bit: the corners, edges and faces of a cube.
  zonal::SampleFitter<N, double> usual, least;
  for (int i = 0; i < 27; ++i) {
    const Vec3 d{double(i % 3 - 1), double(i / 3 % 3 - 1), double(i / 9 - 1)};
    const double tiny = std::numeric_limits<double>::denorm_min();
    usual.add(d, double(i * i % 7));
    least.add({tiny * d[0], tiny * d[1], tiny * d[2]}, double(i * i % 7));
  }
  CHECK(least.solve().left_out == 1);
  CHECK(least.solve().sh == usual.solve().sh);
  for (const double weight : {1e100, 1e-50, 1e-100}) {
    zonal::SampleFitter<N, double> fitter;
    add(fitter, 1, weight);
    const auto fit = fitter.solve();
    CAPTURE(weight, fit.condition, fit.residuals[0]);
    CHECK(fit.rank == N * N);
    CHECK(worst_difference(fit.sh) <= 1e-14);
  }
  for (const double weight : {1e-101, 1e-310, 5e-324}) {  // nothing
    zonal::SampleFitter<N, double> fitter;
    add(fitter, 1, weight);
    CAPTURE(weight);
    CHECK(fitter.solve().rank == 0);
    CHECK(fitter.solve().sh == zonal::Sh<N, double>{});
    add(fitter);
    CHECK(worst_difference(fitter.solve().sh) <= 1e-14);
  }
}

TEST_CASE("hostile: any smoothness gives a fit") {
  zonal::SampleFitter<N, double> fitter;
  add(fitter);
  for (const double smoothness : hostile::numbers<double>()) {
    const auto fit = fitter.solve(smoothness);
    CAPTURE(smoothness, fit.condition, fit.sh.values[0], fit.sh.values[1]);
    CHECK(fit.rank == N * N);
    CHECK(std::isfinite(fit.condition));
    CHECK(std::abs(fit.sh.values[0] - 1) <= (smoothness > 0 ? 1e-2 : 1e-14));  // samples are not quite even
    if (!(smoothness > 1e-300)) CHECK(worst_difference(fit.sh) <= 1e-14);
    if (smoothness > 1e14) CHECK(std::abs(fit.sh.values[1]) <= 1e-13);
  }
}
