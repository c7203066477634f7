// One list of functions, for run_in_cpp.
#pragma once

#include <zonal/shader/function_table.hpp>

#include <type_traits>
#include <utility>

#include "cpp_functions.hpp"

template <class Entry, int N>
std::vector<float> run_entry(int order, const std::vector<float>& inputs) {
  std::size_t next = 0;
  zonal::kernels::DescribingIo<float> io([&](const zonal::shader::Parameter&) { return inputs.at(next++); }, order);
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
