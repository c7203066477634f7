// One list of functions, for run_in_cpp.
#pragma once

#include <zonal/shader/function_table.hpp>

#include <type_traits>
#include <utility>

#include "cpp_functions.hpp"

/// Hands over numbers in their order.
inline zonal::kernels::DescribingIo<float>::Source one_by_one(const std::vector<float>& numbers) {
  return [&numbers, next = std::size_t{0}](const zonal::shader::Parameter&) mutable { return numbers.at(next++); };
}

template <class Entry, int N>
std::vector<float> run_entry(int order, const std::vector<float>& inputs) {
  zonal::kernels::DescribingIo<float> io(one_by_one(inputs), order);
  Entry::template run<N>(io);
  return io.outputs();
}

template <int... Bands, class Visit>
void for_each_of(std::integer_sequence<int, Bands...>, const Visit& visit) {
  (visit(std::integral_constant<int, Bands>{}), ...);
}

/// Whether the list has the function; if so, with its outputs.
template <class List>
bool run_from_list(std::string_view function, int bands, int order, const std::vector<float>& inputs,
                   std::vector<float>& outputs) {
  bool found = false;
  zonal::kernels::for_each_kernel(List{}, [&](auto entry) {
    using Entry = decltype(entry);
    if (Entry::name != function) return;
    found = true;
    if constexpr (!Entry::has_bands) {
      outputs = run_entry<Entry, 1>(order, inputs);
    } else {
      for_each_of(cpp_bands, [&](auto n) {
        if (bands == n) outputs = run_entry<Entry, n>(order, inputs);
      });
    }
  });
  return found;
}
