#pragma once

#include <type_traits>

namespace example::grid_render {

/// Numbers of bands known at compile time.
template <int... N>
struct BandList {
  static constexpr int numbers[] = {N...};

  /// Calls body(std::integral_constant<int, N>()) for the N that is `bands`.
  template <class Body>
  static void dispatch(int bands, const Body& body) {
    const auto try_one = [&](auto n) {
      if (n == bands) body(n);
    };
    (try_one(std::integral_constant<int, N>()), ...);
  }
};
using AllBands = BandList<3, 5, 7, 9>;
using TriangleBands = BandList<5, 9>;

}  // namespace example::grid_render
