// The registry's entries of the room `material` (kernel_list.hpp): how a table is read. The loop over its coefficients
// that they stand in: shader/shells.hpp.
#pragma once

#include <cstddef>

#include "../material/table_rows.hpp"
#include "kernel_io.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

struct MaterialRow : Kernel {
  static constexpr const char* name = "material_row";
  static constexpr const char* summary =
      "The place of an outgoing direction among the rows of a material's table: 0 to rows - 1.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    const auto cos_outgoing = io.number("cos_outgoing", Domain::cosine);
    const auto rows = io.number("rows", Domain::row_count);
    io.output("row", 0)[0] = zonal::detail::row_position(cos_outgoing, rows);
  }
};

struct MaterialBetweenRows : Kernel {
  static constexpr const char* name = "material_between_rows";
  static constexpr const char* summary = "A material's coefficient at t from 0 to 1 between those of two rows.";
  static constexpr bool has_bands = false;
  template <int, class Io>
  static void run(Io& io) {
    const auto below = io.vector("below", Domain::coefficient), above = io.vector("above", Domain::coefficient);
    const auto t = io.number("t", Domain::cell_coordinate);
    const auto coefficient = io.output_triples("coefficient", 0);
    for (std::size_t c = 0; c < 3; ++c) coefficient[0][c] = zonal::detail::between_rows(below[c], above[c], t);
  }
};

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
