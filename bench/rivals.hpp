// What the library's kernels are compared with, as entries of the registry's form (zonal/kernels/kernel_list.hpp): the
// papers' ways, and explicit polynomials. They melt into the loop that times them, as the library's own kernels do:
// left to itself GCC calls some of them, and what they hand on goes through memory, at up to twice the time.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>

#include <zonal/basis/angular_gradient.hpp>
#include <zonal/basis/polynomial.hpp>
#include <zonal/basis/polynomial_gradient.hpp>
#include <zonal/kernels/kernel_io.hpp>
#include <zonal/lobe/cap_closed_form.hpp>
#include <zonal/lobe/cap_reference.hpp>

namespace zonal_bench {

namespace kernels = zonal::kernels;
using kernels::Domain;

namespace detail {
// What make() returns, constructed where the output lies: to copy it would take time too.
template <class T, class Make>
ZONAL_INLINE inline void put(const kernels::Numbers<T>& output, const Make& make) {
  using Result = decltype(make());
  static_assert(std::is_standard_layout_v<Result> && std::is_trivially_destructible_v<T> &&
                std::is_trivially_destructible_v<Result> && alignof(Result) == alignof(T));
  ::new (static_cast<void*>(output.values)) Result(make());
}
}  // namespace detail

/// A function of a direction that returns `Runs` runs of N*N numbers: Rival::of<N>(direction).
template <class Rival, int Runs>
struct OfDirection : kernels::Kernel {
  template <int N, class Io>
  static void run(Io& io) {
    const auto direction = io.vector("direction", Domain::unit_vector);
    detail::put(io.output("y", Runs * N * N), [&]() ZONAL_INLINE { return Rival::template of<N>(direction); });
  }
};

struct Polynomial : OfDirection<Polynomial, 1> {
  static constexpr const char* name = "polynomial";
  static constexpr const char* summary = "evaluate, from explicit polynomials.";
  template <int N, class Direction>
  ZONAL_INLINE static auto of(const Direction& direction) {
    return zonal::reference::evaluate_polynomial<N>(direction);
  }
};

struct PolynomialGradient : OfDirection<PolynomialGradient, 4> {
  static constexpr const char* name = "polynomial_gradient";
  static constexpr const char* summary = "Value and gradient, from differentiated polynomials.";
  template <int N, class Direction>
  ZONAL_INLINE static auto of(const Direction& direction) {
    return zonal::reference::evaluate_polynomial_with_gradient<N>(direction);
  }
};

struct SloanLikeAngular : OfDirection<SloanLikeAngular, 3> {
  static constexpr const char* name = "sloan_like_angular";
  static constexpr const char* summary = "Value and derivatives by theta and phi, by recurrences.";
  template <int N, class Direction>
  ZONAL_INLINE static auto of(const Direction& direction) {
    return zonal::reference::angular_gradient_sloan_like<N>(direction);
  }
};

struct SloanLike : OfDirection<SloanLike, 4> {
  static constexpr const char* name = "sloan_like";
  static constexpr const char* summary = "Value and gradient, by the same.";
  template <int N, class Direction>
  ZONAL_INLINE static auto of(const Direction& direction) {
    return zonal::reference::to_cartesian(SloanLikeAngular::of<N>(direction), direction);
  }
};

struct DirectAngular : OfDirection<DirectAngular, 3> {
  static constexpr const char* name = "direct_angular";
  static constexpr const char* summary =
      "Value and derivatives by theta and phi, from neighbouring Legendre functions.";
  template <int N, class Direction>
  ZONAL_INLINE static auto of(const Direction& direction) {
    return zonal::reference::angular_gradient_direct<N>(direction);
  }
};

struct Direct : OfDirection<Direct, 4> {
  static constexpr const char* name = "direct";
  static constexpr const char* summary = "Value and gradient, by the same.";
  template <int N, class Direction>
  ZONAL_INLINE static auto of(const Direction& direction) {
    return zonal::reference::to_cartesian(DirectAngular::of<N>(direction), direction);
  }
};

/// A function of a cap's cosine that returns N numbers: Rival::of<N>(cos_angle).
template <class Rival>
struct OfCap : kernels::Kernel {
  template <int N, class Io>
  static void run(Io& io) {
    const auto cap = io.cap("cap", Domain::angle);
    detail::put(io.output("z", N), [&]() ZONAL_INLINE { return Rival::template of<N>(cap.cos_angle); });
  }
};

struct LegendreCap : OfCap<LegendreCap> {
  static constexpr const char* name = "cap_legendre";
  static constexpr const char* summary = "A cap's zonal coefficients, from Legendre polynomials: HVL Eq. 14.";
  template <int N, class T>
  ZONAL_INLINE static auto of(const T& cos_angle) {
    return zonal::reference::project_cap_legendre<N>(cos_angle);
  }
};

struct ClosedFormCap : OfCap<ClosedFormCap> {
  static constexpr const char* name = "cap_closed_form";
  static constexpr const char* summary = "A cap's zonal coefficients, from explicit polynomials.";
  template <int N, class T>
  ZONAL_INLINE static auto of(const T& cos_angle) {
    return zonal::reference::project_cap_closed_form<N>(cos_angle);
  }
};

using Rivals = kernels::KernelList<Polynomial, PolynomialGradient, SloanLikeAngular, SloanLike, DirectAngular, Direct,
                                   LegendreCap, ClosedFormCap>;

}  // namespace zonal_bench
