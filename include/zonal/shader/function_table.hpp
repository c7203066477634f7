// The table of functions (kernels/kernel_list.hpp) for names and numbers of bands known at run time.
#pragma once

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "../kernels/kernel_list.hpp"
#include "recorded_function.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace shader {

// To compile them takes time with the square.
#ifdef ZONAL_GLSL_MAX_BANDS
inline constexpr int max_bands = ZONAL_GLSL_MAX_BANDS;
#else
inline constexpr int max_bands = 10;
#endif

struct FunctionEntry {
  std::string_view name, summary;
  bool has_bands;
  int most_bands;
  int (*order_count)(int bands);
  RecordedFunction (*record)(int bands, const Part& part);
};

namespace detail {
template <class Entry, int... I>
RecordedFunction record_bands(int bands, const Part& part, std::integer_sequence<int, I...>) {
  static constexpr RecordedFunction (*of[])(const Part&) = {shader::record<Entry, 1 + I>...};
  return of[bands - 1](part);
}
}  // namespace detail

/// An entry of the table, written down with 1 to max_bands bands, or as many as it has; nothing with others.
template <class Entry>
inline constexpr int most_bands_of = (std::min)(Entry::most_bands, max_bands);
template <class Entry>
RecordedFunction record_bands(int bands, const Part& part) {
  if constexpr (!Entry::has_bands) return record<Entry, 1>(part);
  if (bands < 1 || bands > most_bands_of<Entry>) return {};
  return detail::record_bands<Entry>(bands, part, std::make_integer_sequence<int, most_bands_of<Entry>>{});
}

/// Appends a list of entries, in its order.
template <class List>
void append_functions(std::vector<FunctionEntry>& entries) {
  kernels::for_each_kernel(List{}, [&](auto entry) {
    using Entry = decltype(entry);
    entries.push_back(
        {Entry::name, Entry::summary, Entry::has_bands, most_bands_of<Entry>, Entry::order_count, record_bands<Entry>});
  });
}

}  // namespace shader
}  // namespace ZONAL_TARGET
}  // namespace zonal
