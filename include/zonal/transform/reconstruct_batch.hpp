// A function's values in many directions at once: basis/batch.hpp, and nothing of the basis stored.
#pragma once

#include <cstddef>

#include "../basis/batch.hpp"
#include "dot.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// values[k] = reconstruct(sh, direction k), in the unit of the coefficients. C is T or a colour that is an array of T
/// in memory: glm::vec3, Eigen::Vector3f, a struct of three floats with c[i].
template <int N, class T, class C>
void reconstruct(const Sh<N, C>& sh, const DirectionSpan<T>& directions, C* values, Stores stores = Stores::by_size) {
  static_assert(sizeof(C) % sizeof(T) == 0 && std::is_same_v<detail::number_t<C>, T>, "a T, or some of them");
  constexpr int channels = static_cast<int>(sizeof(C) / sizeof(T));
  const T* const numbers = static_cast<const T*>(static_cast<const void*>(sh.values));
  T* const target = static_cast<T*>(static_cast<void*>(values));
  detail::run_batch<channels>(
      directions, CoefficientRows<T>{target}, stores, [numbers](const auto& v, auto sink) ZONAL_INLINE {
        using L = std::decay_t<decltype(v[0])>;
        detail::Accumulator<N * N, L> totals[static_cast<std::size_t>(channels)];
        evaluate<N>(v[0], v[1], v[2], [&](auto l, auto m, const L& y) ZONAL_INLINE {
          constexpr int i = sh_index(l, m);
          unroll<0, channels>([&](auto c)
                                  ZONAL_INLINE { totals[c].add(Index<i>{}, L(numbers[i * channels + c]) * y); });
        });
        unroll<0, channels>([&](auto c) ZONAL_INLINE { sink(c, totals[c].sum()); });
      });
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
