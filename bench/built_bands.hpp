// The numbers of bands that benchmarks and report are compiled for: all that the tables print, or, in the test
// command's short build, few.
#pragma once

#include <type_traits>
#include <utility>

#include <zonal/scalar/unroll.hpp>

namespace zonal_bench {

#ifdef ZONAL_QUICK
inline constexpr bool is_quick = true;
#else
inline constexpr bool is_quick = false;
#endif

template <int... N>
using Bands = std::integer_sequence<int, N...>;
template <class All, class Few>
using Built = std::conditional_t<is_quick, Few, All>;

/// body(zonal::Index<N>{}) for each.
template <int... N, class Body>
void for_bands(Bands<N...>, Body&& body) {
  (body(zonal::Index<N>{}), ...);
}

}  // namespace zonal_bench
