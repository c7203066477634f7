// Loops whose index is known at compile time.
#pragma once

#include <type_traits>
#include <utility>

#include "scalar.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

template <int I>
using Index = std::integral_constant<int, I>;

namespace detail {
// Compilers nest a fold expression as deep as it is long, and stop at 256.
inline constexpr int longest_sequence = 128;

template <int Begin, class F, int... I>
ZONAL_INLINE constexpr void unroll_sequence(F&& body, std::integer_sequence<int, I...>) {
  (body(Index<Begin + I>{}), ...);
}
}  // namespace detail

/// body(Index<Begin>{}), ..., body(Index<End - 1>{}): inside, the argument is a constant expression.
template <int Begin, int End, class F>
ZONAL_INLINE constexpr void unroll(F&& body) {
  if constexpr (End - Begin > detail::longest_sequence) {
    unroll<Begin, Begin + detail::longest_sequence>(body);
    unroll<Begin + detail::longest_sequence, End>(body);
  } else if constexpr (Begin < End) {
    detail::unroll_sequence<Begin>(body, std::make_integer_sequence<int, End - Begin>{});
  }
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
