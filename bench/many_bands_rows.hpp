// What many_bands_bench.cpp times, and many_bands_table.cpp prints.
#pragma once

#include <array>

#include "built_bands.hpp"

namespace zonal_bench {

inline constexpr std::array many_bands_kernels{"basis", "gradient", "zonal-cap", "rotation"};
using UnrolledBands = Built<Bands<5, 10, 21>, Bands<5>>;
inline constexpr std::array<int, is_quick ? 2 : 6> looped_bands{
#ifdef ZONAL_QUICK
    5, 21
#else
    5,   10,  21, 100,
    190, 1000
#endif
};

}  // namespace zonal_bench
