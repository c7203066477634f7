// Grids as files.
//
// All little-endian: a header of 60 bytes, then every float of the grid in the order of CoefficientGrid, then a
// checksum.
//
//   bytes   what
//   0-7     "ZONALGRD"
//   8-11    version of the format, 1
//   12-15   bands N
//   16-27   vertices along x, y and z
//   28-51   the box: low x, y, z, then high x, y, z, as floats
//   52-59   number of floats that follow
//   60-     the floats: 12 N*N per vertex, or 3 N*N without gradients
//   last 8  FNV-1a of everything before, 64 bits, taken four bytes at a time
//
// A file is written beside its place and moved there when it is whole. Loading checks all of the above, and the size of
// the file before any memory is asked for, so that a file which is no grid, or a damaged one, costs nothing but an
// error.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <glm/vec3.hpp>

#include "../file/checked_file.hpp"
#include "coefficient_grid.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What is wrong with a grid's file: its name, and why, in one line.
using GridFileError = FileError;

/// What a grid's file says of it before the data.
struct GridFileHeader {
  int bands;
  GridContent content;
  glm::ivec3 resolution;
  glm::vec3 low, high;
};

namespace detail {

inline constexpr FileFormat grid_file_format{"ZONALGRD", 1, 60, "grid"};

using GridFileHeaderWords = std::array<std::uint32_t, grid_file_format.header_size / 4>;

template <int N, GridContent content>
GridFileHeaderWords header_words(const CoefficientGrid<N, content>& grid) {
  GridFileHeaderWords words{};
  grid_file_format.begin(words.data());
  words[3] = static_cast<std::uint32_t>(N);
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    words[4 + axis] = static_cast<std::uint32_t>(grid.resolution()[a]);
    words[7 + axis] = to_word(grid.low()[a]);
    words[10 + axis] = to_word(grid.high()[a]);
  }
  to_words(static_cast<std::uint64_t>(grid.size()), &words[13]);
  return words;
}

// An open grid file whose header has been read and holds together with the file's size.
class GridFileReader : public WordReader {
 public:
  explicit GridFileReader(const std::filesystem::path& path) : WordReader(path, grid_file_format) {
    GridFileHeaderWords words;
    read_header(words.data());
    // No product below can overflow: 3 * 1024^2 * 2^31, then counted down.
    if (words[3] < 1 || words[3] > 1024) fail("is damaged: it says it has " + std::to_string(words[3]) + " bands");
    std::uint64_t values = std::uint64_t{3} * words[3] * words[3];
    for (std::size_t a = 0; a < 3; ++a) {
      const std::uint32_t count = words[4 + a];
      if (count < 2 || count > 0x7FFFFFFF || values > (size() / 4 + 1) / count) {
        fail("is damaged: its resolution does not go with its size");
      }
      values *= count;
    }
    const std::uint64_t floats = from_words(&words[13]);
    if ((floats != values && floats != 4 * values) ||
        size() != grid_file_format.header_size + 4 * floats + FileFormat::checksum_size) {
      fail("is damaged: its size is not what its header says");
    }
    header_.content = floats == values ? GridContent::values : GridContent::values_and_gradients;
    header_.bands = static_cast<int>(words[3]);
    for (int a = 0; a < 3; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      header_.resolution[a] = static_cast<int>(words[4 + axis]);
      header_.low[a] = from_word(words[7 + axis]);
      header_.high[a] = from_word(words[10 + axis]);
    }
  }

  const GridFileHeader& header() const { return header_; }

 private:
  GridFileHeader header_{};
};

}  // namespace detail

/// Writes the grid. Throws GridFileError where it cannot; the file is then what it was, or still not there.
template <int N, GridContent content>
void save_grid(const std::filesystem::path& path, const CoefficientGrid<N, content>& grid) {
  detail::WordWriter writer(path);
  const auto header = detail::header_words(grid);
  writer.write(header.data(), header.size());
  writer.write_floats(grid.data(), grid.size());
  writer.finish();
}

/// What stands in the file, without its data: for the number of bands, and the content, to load it with. Throws
/// GridFileError.
inline GridFileHeader read_grid_header(const std::filesystem::path& path) {
  return detail::GridFileReader(path).header();
}

/// Reads a grid of N bands, with gradients or without as the file has it. Throws GridFileError unless it is one, whole
/// and undamaged.
template <int N, GridContent content = GridContent::values_and_gradients>
CoefficientGrid<N, content> load_grid(const std::filesystem::path& path) {
  detail::GridFileReader reader(path);
  const GridFileHeader& header = reader.header();
  if (header.bands != N) {
    reader.fail("has " + std::to_string(header.bands) + " bands, not " + std::to_string(N));
  }
  if (header.content != content) {
    reader.fail(content == GridContent::values ? "has gradients as well; load it with them, and take its values_of"
                                               : "has values alone, no gradients");
  }
  try {
    CoefficientGrid<N, content> grid(header.low, header.high, header.resolution);
    reader.read_floats(grid.data(), grid.size());
    reader.check_the_end();
    return grid;
  } catch (const std::invalid_argument& error) {
    reader.fail(std::string("is damaged: ") + error.what());
  }
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
