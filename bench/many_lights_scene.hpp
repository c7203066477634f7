// What the rows on the tree of many lights are called, for the benchmark and its table.
#pragma once

#include <array>

namespace zonal_bench {

struct TreeStep {
  const char *name, *title;
};
inline constexpr std::array<TreeStep, 5> tree_steps{{{"tree-build", "to build the tree, per light"},
                                                     {"tree-update-one", "one light has moved"},
                                                     {"tree-update-many", "one light in a hundred, each"},
                                                     {"tree-cut", "a cut for eight receivers, per cluster"},
                                                     {"tree-draw", "draws of it, per light drawn"}}};
inline constexpr int cut_bands = 5;
#ifdef ZONAL_QUICK
inline constexpr std::array<int, 2> tree_lights{1000, 10000};
#else
inline constexpr std::array<int, 2> tree_lights{10000, 1000000};
#endif

}  // namespace zonal_bench
