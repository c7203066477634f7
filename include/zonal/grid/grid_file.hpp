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
//   60-     the floats: 12 N*N per vertex
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
  glm::ivec3 resolution;
  glm::vec3 low, high;
};

namespace detail {

inline constexpr FileFormat grid_file_format{"ZONALGRD", 1, 60, "grid"};

using GridFileHeaderWords = std::array<std::uint32_t, grid_file_format.header_size / 4>;

template <int N>
GridFileHeaderWords header_words(const CoefficientGrid<N>& grid) {
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
    // No product below can overflow: 12 * 1024^2 * 2^31, then counted down.
    if (words[3] < 1 || words[3] > 1024) fail("is damaged: it says it has " + std::to_string(words[3]) + " bands");
    std::uint64_t floats = std::uint64_t{12} * words[3] * words[3];
    for (std::size_t a = 0; a < 3; ++a) {
      const std::uint32_t count = words[4 + a];
      if (count < 2 || count > 0x7FFFFFFF || floats > (size() / 4 + 1) / count) {
        fail("is damaged: its resolution does not go with its size");
      }
      floats *= count;
    }
    if (from_words(&words[13]) != floats ||
        size() != grid_file_format.header_size + 4 * floats + FileFormat::checksum_size) {
      fail("is damaged: its size is not what its header says");
    }
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
template <int N>
void save_grid(const std::filesystem::path& path, const CoefficientGrid<N>& grid) {
  detail::WordWriter writer(path);
  const auto header = detail::header_words(grid);
  writer.write(header.data(), header.size());
  writer.write_floats(grid.data(), grid.size());
  writer.finish();
}

/// What stands in the file, without its data: for the number of bands to load it with. Throws GridFileError.
inline GridFileHeader read_grid_header(const std::filesystem::path& path) {
  return detail::GridFileReader(path).header();
}

/// Reads a grid of N bands. Throws GridFileError unless it is one, whole and undamaged.
template <int N>
CoefficientGrid<N> load_grid(const std::filesystem::path& path) {
  detail::GridFileReader reader(path);
  const GridFileHeader& header = reader.header();
  if (header.bands != N) {
    reader.fail("has " + std::to_string(header.bands) + " bands, not " + std::to_string(N));
  }
  try {
    CoefficientGrid<N> grid(header.low, header.high, header.resolution);
    reader.read_floats(grid.data(), grid.size());
    reader.check_the_end();
    return grid;
  } catch (const std::invalid_argument& error) {
    reader.fail(std::string("is damaged: ") + error.what());
  }
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
