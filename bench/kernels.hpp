// What is measured and counted: the one list, for times and for operation counts.
//
// A kernel is a struct with
//   name, bands    constants
//   Domain         what it takes: `inputs` numbers, such as draw(random) gives as an array of double
//   run(numbers)   what it makes of an array of them, for any scalar: anything with begin and end
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>

#include <zonal/basis/angular_gradient.hpp>
#include <zonal/basis/evaluate.hpp>
#include <zonal/basis/gradient.hpp>
#include <zonal/basis/polynomial.hpp>
#include <zonal/basis/polynomial_gradient.hpp>
#include <zonal/lobe/cap.hpp>
#include <zonal/lobe/cap_closed_form.hpp>
#include <zonal/lobe/cap_reference.hpp>
#include <zonal/scalar/unroll.hpp>
#include <zonal/transform/orient.hpp>

#include "built_bands.hpp"

namespace zonal_bench {

using Random = std::mt19937;

/// A unit vector, as likely any as another.
inline std::array<double, 3> random_direction(Random& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random);
  const double length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

struct Directions {
  using Domain = Directions;
  static constexpr std::size_t inputs = 3;
  static auto draw(Random& random) { return random_direction(random); }
};

template <int N>
struct Evaluate : Directions {
  static constexpr const char* name = "evaluate";
  static constexpr int bands = N;
  template <class T>
  static auto run(const std::array<T, 3>& direction) {
    return zonal::evaluate<N>(direction);
  }
};

template <int N>
struct Polynomial : Directions {
  static constexpr const char* name = "polynomial";
  static constexpr int bands = N;
  template <class T>
  static auto run(const std::array<T, 3>& direction) {
    return zonal::reference::evaluate_polynomial<N>(direction);
  }
};

// ---- Value and gradient

// What a kernel gives, as one run of numbers: of the structures below, Sh after Sh.
template <int N, class T, std::size_t Size, class Structure>
struct Numbers : Structure {
  const T* begin() const { return reinterpret_cast<const T*>(static_cast<const Structure*>(this)); }
  const T* end() const { return begin() + Size * std::size_t{N * N}; }
};
template <int N, class T>
using GradientNumbers = Numbers<N, T, 4, zonal::ShGradient<N, T>>;
template <int N, class T>
using AngularNumbers = Numbers<N, T, 3, zonal::reference::AngularGradient<N, T>>;

template <int N>
struct Gradient : Directions {
  static constexpr const char* name = "gradient";
  static constexpr int bands = N;
  template <class T>
  static auto run(const std::array<T, 3>& direction) {
    return GradientNumbers<N, T>{zonal::evaluate_with_gradient<N>(direction)};
  }
};

template <int N>
struct PolynomialGradient : Directions {
  static constexpr const char* name = "polynomial-gradient";
  static constexpr int bands = N;
  template <class T>
  static auto run(const std::array<T, 3>& direction) {
    return GradientNumbers<N, T>{zonal::reference::evaluate_polynomial_with_gradient<N>(direction)};
  }
};

template <int N>
struct SloanLikeAngular : Directions {
  static constexpr const char* name = "sloan-like-angular";
  static constexpr int bands = N;
  template <class T>
  static auto run(const std::array<T, 3>& direction) {
    return AngularNumbers<N, T>{zonal::reference::angular_gradient_sloan_like<N>(direction)};
  }
};

template <int N>
struct SloanLike : Directions {
  static constexpr const char* name = "sloan-like";
  static constexpr int bands = N;
  template <class T>
  static auto run(const std::array<T, 3>& v) {
    using namespace zonal::reference;
    return GradientNumbers<N, T>{to_cartesian(angular_gradient_sloan_like<N>(v), v)};
  }
};

template <int N>
struct DirectAngular : Directions {
  static constexpr const char* name = "direct-angular";
  static constexpr int bands = N;
  template <class T>
  static auto run(const std::array<T, 3>& direction) {
    return AngularNumbers<N, T>{zonal::reference::angular_gradient_direct<N>(direction)};
  }
};

template <int N>
struct Direct : Directions {
  static constexpr const char* name = "direct";
  static constexpr int bands = N;
  template <class T>
  static auto run(const std::array<T, 3>& v) {
    using namespace zonal::reference;
    return GradientNumbers<N, T>{to_cartesian(angular_gradient_direct<N>(v), v)};
  }
};

// ---- Lobes

// Cosine and sine of half angles from 0 to 90 degrees: what a sphere covers, seen from outside.
struct Caps {
  using Domain = Caps;
  static constexpr std::size_t inputs = 2;
  static std::array<double, 2> draw(Random& random) {
    const double angle = std::uniform_real_distribution<double>(0, double(zonal::kPi) / 2)(random);
    return {std::cos(angle), std::sin(angle)};
  }
};

template <int N>
struct StableCap : Caps {
  static constexpr const char* name = "cap-stable";
  static constexpr int bands = N;
  template <class T>
  static auto run(const std::array<T, 2>& cap) {
    return zonal::project<N>(zonal::SphericalCap<T>{cap[0], cap[1]});
  }
};

template <int N>
struct LegendreCap : Caps {
  static constexpr const char* name = "cap-legendre";
  static constexpr int bands = N;
  template <class T>
  static auto run(const std::array<T, 2>& cap) {
    return zonal::reference::project_cap_legendre<N>(cap[0]);
  }
};

template <int N>
struct ClosedFormCap : Caps {
  static constexpr const char* name = "cap-closed";
  static constexpr int bands = N;
  template <class T>
  static auto run(const std::array<T, 2>& cap) {
    return zonal::reference::project_cap_closed_form<N>(cap[0]);
  }
};

// An axis, then ten zonal coefficients.
struct Lobes {
  using Domain = Lobes;
  static constexpr std::size_t inputs = 3 + 10;
  static auto draw(Random& random) {
    std::array<double, inputs> numbers;
    const auto axis = random_direction(random);
    std::copy(axis.begin(), axis.end(), numbers.begin());
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::generate(numbers.begin() + 3, numbers.end(), [&] { return uniform(random); });
    return numbers;
  }
};

template <int N>
struct Orient : Lobes {
  static constexpr const char* name = "orient";
  static constexpr int bands = N;
  template <class T>
  static auto run(const std::array<T, inputs>& numbers) {
    zonal::Zh<N, T> zh{};
    std::copy_n(numbers.begin() + 3, N, zh.begin());
    return zonal::orient(zh, numbers);
  }
};

/// visit(Kernel<1>{}), ..., visit(Kernel<10>{}): the rows of the table, and as far as the polynomials go.
template <template <int> class Kernel, class Visit>
void for_ten_bands(Visit&& visit) {
  for_bands(Built<Bands<1, 2, 3, 4, 5, 6, 7, 8, 9, 10>, Bands<1, 5, 10>>{}, [&](auto n) { visit(Kernel<n>{}); });
}

template <class Visit>
void for_evaluate_kernels(Visit&& visit) {
  for_ten_bands<Evaluate>(visit);
  visit(Evaluate<16>{});
  for_ten_bands<Polynomial>(visit);
}
template <class Visit>
void for_cap_kernels(Visit&& visit) {
  for_ten_bands<StableCap>(visit);
  for_ten_bands<LegendreCap>(visit);
  for_ten_bands<ClosedFormCap>(visit);
}
template <class Visit>
void for_orient_kernels(Visit&& visit) {
  for_ten_bands<Orient>(visit);
}

/// The bands of the gradient paper's Table 1.
using GradientBands = Built<Bands<3, 4, 5, 6, 8, 10>, Bands<3>>;

template <class Visit>
void for_gradient_kernels(Visit&& visit) {
  for_bands(GradientBands{}, [&](auto n) {
    visit(Gradient<n>{});
    visit(PolynomialGradient<n>{});
    visit(SloanLikeAngular<n>{});
    visit(SloanLike<n>{});
    visit(DirectAngular<n>{});
    visit(Direct<n>{});
  });
}

}  // namespace zonal_bench
