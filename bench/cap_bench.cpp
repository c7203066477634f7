// The spherical cap's zonal coefficients in three forms, which HVL Fig. 6 compares.

#include <zonal/lobe/cap.hpp>
#include <zonal/lobe/cap_closed_form.hpp>
#include <zonal/lobe/cap_reference.hpp>

#include <cmath>

#include "bench.hpp"

namespace zonal_bench {
namespace {

// Cosine and sine of half angles from 0 to 90 degrees, what a sphere covers seen from outside.
struct OfCap {
  static constexpr int inputs = 2;
  static std::array<double, 2> draw(Random& random) {
    const double angle = std::uniform_real_distribution<double>(0, static_cast<double>(zonal::kPi) / 2)(random);
    return {std::cos(angle), std::sin(angle)};
  }
};

template <int N>
struct Stable : OfCap {
  template <class T>
  static auto run(const std::array<T, 2>& cap) {
    return zonal::project<N>(zonal::SphericalCap<T>{cap[0], cap[1]});
  }
};

template <int N>
struct Legendre : OfCap {
  template <class T>
  static auto run(const std::array<T, 2>& cap) {
    return zonal::reference::project_cap_legendre<N>(cap[0]);
  }
};

template <int N>
struct ClosedForm : OfCap {
  template <class T>
  static auto run(const std::array<T, 2>& cap) {
    return zonal::reference::project_cap_closed_form<N>(cap[0]);
  }
};

}  // namespace

void register_cap(const Effort& effort) {
  register_kernels<Stable, 10>("cap-stable", effort);
  register_kernels<Legendre, 10>("cap-legendre", effort);
  register_kernels<ClosedForm, 10>("cap-closed-form", effort);
}

}  // namespace zonal_bench
