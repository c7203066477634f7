// The visibility of a grid's vertices as a file.
//
// As grid_file.hpp, header, checks and all, but for
//
//   bytes   what
//   0-7     "ZONALVIS"
//   12-15   rings of the maps
//   60-     the floats, in the order of GridVisibility
//
// The numbers are taken as they stand: what is damaged the checksum tells.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "grid_file.hpp"
#include "visibility.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {
inline constexpr FileFormat visibility_file_format{"ZONALVIS", 1, grid_file_format.header_size, "visibility of a grid"};
}

/// Writes it. Throws FileError where it cannot, or where it is empty; the file is then what it was, or still not there.
inline void save_visibility(const std::filesystem::path& path, const GridVisibility& visibility) {
  if (visibility.empty()) throw FileError(path, "would hold the visibility of no grid");
  detail::WordWriter writer(path);
  const auto header = detail::header_words(detail::visibility_file_format,
                                           {static_cast<std::uint32_t>(visibility.rings()), visibility.resolution(),
                                            visibility.low(), visibility.high(), visibility.size()});
  writer.write(header.data(), header.size());
  writer.write_floats(visibility.data(), visibility.size());
  writer.finish();
}

/// Reads it. Throws FileError unless it is one, whole and undamaged. Whether it is of a grid: fits(grid).
inline GridVisibility load_visibility(const std::filesystem::path& path) {
  detail::BoxFileReader reader(path, detail::visibility_file_format);
  const detail::BoxFileHeader& box = reader.box();
  const std::uint64_t rings = box.number;
  if (rings < 1 || rings > 1024) reader.fail("is damaged: it says its maps have " + std::to_string(rings) + " rings");
  if (reader.count_of(4 + 2 * (2 * rings + 1) * (2 * rings + 1)) != box.count) {
    reader.fail("is damaged: its size is not what its header says");
  }
  try {
    GridVisibility visibility(box.low, box.high, box.resolution, static_cast<int>(rings));
    reader.read_floats(visibility.data(), visibility.size());
    reader.check_the_end();
    return visibility;
  } catch (const std::invalid_argument& error) {
    reader.fail(std::string("is damaged: ") + error.what());
  }
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
