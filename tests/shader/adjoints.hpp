// The adjoints of the table's functions.
#pragma once

#include <zonal/shader/adjoint_function.hpp>
#include <zonal/shader/function_table.hpp>

#include <algorithm>
#include <optional>

/// By all inputs, at so many bands or as many as it has; nothing where there is none.
inline std::optional<zonal::shader::RecordedFunction> adjoint_of(const zonal::shader::FunctionEntry& entry, int bands) {
  try {
    return adjoint_function(entry.record(std::min(bands, entry.most_bands), zonal::shader::all_orders));
  } catch (const zonal::shader::NoAdjoint&) {
    return {};
  }
}
