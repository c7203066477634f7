// Grids as files.
//
// All little-endian: a header of 60 bytes, then every float of the grid in the order of CoefficientGrid, then a
// checksum.
//
//   bytes   what
//   0-7     "ZONALGRD", or "ZONALGRH" where numbers are of 16 bits
//   8-11    version of the format, 1
//   12-15   bands N
//   16-27   vertices along x, y and z
//   28-51   the box: low x, y, z, then high x, y, z, as floats
//   52-59   how many numbers follow
//   60-     the numbers: 12 N*N per vertex, or 3 N*N without gradients. Floats; or half floats, two to a word, the
//   first in
//           its lower half, the last of an odd number beside 0
//   last 8  FNV-1a of everything before, 64 bits, taken four bytes at a time
//
// A file is written beside its place and moved there when it is whole. Loading checks all of the above, and the size of
// the file before any memory is asked for, so that a file which is no grid, or a damaged one, costs nothing but an
// error.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <glm/vec3.hpp>

#include "../file/checked_file.hpp"
#include "../scalar/half.hpp"
#include "coefficient_grid.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What is wrong with a grid's file: its name, and why, in one line.
using GridFileError = FileError;

/// How numbers stand in a file; in memory they are floats. Half floats take half the space, are rounded to 11 bits, and
/// reach to 65504.
enum class GridNumbers { floats, halves };

/// What a grid's file says of it before the data.
struct GridFileHeader {
  int bands;
  GridContent content;
  GridNumbers numbers;
  glm::ivec3 resolution;
  glm::vec3 low, high;
};

namespace detail {

inline constexpr FileFormat grid_file_format{"ZONALGRD", 1, 60, "grid"};
inline constexpr FileFormat half_grid_file_format{"ZONALGRH", 1, 60, "grid"};

constexpr const FileFormat& grid_file_format_of(GridNumbers numbers) {
  return numbers == GridNumbers::floats ? grid_file_format : half_grid_file_format;
}
constexpr std::size_t numbers_in_word(GridNumbers numbers) { return numbers == GridNumbers::floats ? 1 : 2; }

// What the formats of a box of vertices have in common (visibility_file.hpp is the other): the header's words after the
// version. `number` says how much a vertex holds.
struct BoxFileHeader {
  std::uint32_t number;
  glm::ivec3 resolution;
  glm::vec3 low, high;
  std::uint64_t count;  // of numbers
};
using BoxFileWords = std::array<std::uint32_t, grid_file_format.header_size / 4>;

inline BoxFileWords header_words(const FileFormat& format, const BoxFileHeader& header) {
  BoxFileWords words{};
  format.begin(words.data());
  words[3] = header.number;
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    words[4 + axis] = static_cast<std::uint32_t>(header.resolution[a]);
    words[7 + axis] = to_word(header.low[a]);
    words[10 + axis] = to_word(header.high[a]);
  }
  to_words(header.count, &words[13]);
  return words;
}

// An open file of such a format.
class BoxFileReader : public WordReader {
 public:
  BoxFileReader(const std::filesystem::path& path, const FileFormat& format, std::size_t in_word = 1)
      : WordReader(path, format), in_word_(in_word) {
    BoxFileWords words;
    read_header(words.data());
    box_.number = words[3];
    for (int a = 0; a < 3; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      if (words[4 + axis] < 2 || words[4 + axis] > 0x7FFFFFFF) fail_of_resolution();
      box_.resolution[a] = static_cast<int>(words[4 + axis]);
      box_.low[a] = from_word(words[7 + axis]);
      box_.high[a] = from_word(words[10 + axis]);
    }
    box_.count = from_words(&words[13]);
    const std::uint64_t words_of_numbers = box_.count / in_word_ + box_.count % in_word_;
    if (size() != format.header_size + 4 * words_of_numbers + FileFormat::checksum_size || box_.count > size()) {
      fail("is damaged: its size is not what its header says");
    }
  }

  const BoxFileHeader& box() const { return box_; }

  // How many numbers all vertices hold, at most as many as there are: no product can overflow.
  std::uint64_t count_of(std::uint64_t vertex_size) const {
    std::uint64_t numbers = vertex_size;
    for (int a = 0; a < 3; ++a) {
      const auto count = static_cast<std::uint64_t>(box_.resolution[a]);
      if (numbers > (size() / 4 * in_word_ + 1) / count) fail_of_resolution();
      numbers *= count;
    }
    return numbers;
  }

 private:
  [[noreturn]] void fail_of_resolution() const { fail("is damaged: its resolution does not go with its size"); }

  BoxFileHeader box_{};
  std::size_t in_word_;
};

// An open grid file whose header has been read and holds together with the file's size.
class GridFileReader : public BoxFileReader {
 public:
  explicit GridFileReader(const std::filesystem::path& path)
      : GridFileReader(path, has_mark(path, half_grid_file_format) ? GridNumbers::halves : GridNumbers::floats) {}

  const GridFileHeader& header() const { return header_; }

  void read_numbers(float* numbers, std::size_t count) {
    if (header_.numbers == GridNumbers::floats) return read_floats(numbers, count);
    for (std::size_t done = 0; done < count; done += 2) {
      std::uint32_t word = 0;
      read_words(&word, 1);
      numbers[done] = to_float(Half{static_cast<std::uint16_t>(word & 0xFFFFU)});
      if (done + 1 < count) numbers[done + 1] = to_float(Half{static_cast<std::uint16_t>(word >> 16U)});
    }
  }

 private:
  GridFileReader(const std::filesystem::path& path, GridNumbers numbers)
      : BoxFileReader(path, grid_file_format_of(numbers), numbers_in_word(numbers)) {
    const std::uint64_t bands = box().number;
    if (bands < 1 || bands > 1024) fail("is damaged: it says it has " + std::to_string(bands) + " bands");
    const std::uint64_t values = count_of(3 * bands * bands);
    if (box().count != values && box().count != 4 * values) {
      fail("is damaged: its size is not what its header says");
    }
    header_ = {static_cast<int>(bands),
               box().count == values ? GridContent::values : GridContent::values_and_gradients,
               numbers,
               box().resolution,
               box().low,
               box().high};
  }

  GridFileHeader header_{};
};

inline void write_halves(WordWriter& writer, const float* numbers, std::size_t count) {
  for (std::size_t done = 0; done < count; done += 2) {
    const std::uint32_t first = to_half(numbers[done]).bits,
                        second = done + 1 < count ? to_half(numbers[done + 1]).bits : 0;
    const std::uint32_t word = first | second << 16U;
    writer.write(&word, 1);
  }
}

}  // namespace detail

/// Writes the grid. Throws GridFileError where it cannot, also where a half float cannot hold a finite number; the file
/// is then what it was, or still not there.
template <int N, GridContent content>
void save_grid(const std::filesystem::path& path, const CoefficientGrid<N, content>& grid,
               GridNumbers numbers = GridNumbers::floats) {
  const auto is_beyond_half = [](float number) { return std::isfinite(number) && std::abs(number) >= 65520.0F; };
  if (numbers == GridNumbers::halves && std::any_of(grid.data(), grid.data() + grid.size(), is_beyond_half)) {
    throw GridFileError(path, "cannot be written in 16 bits, which hold numbers up to 65504 alone");
  }
  detail::WordWriter writer(path);
  const auto header = detail::header_words(detail::grid_file_format_of(numbers),
                                           {std::uint32_t(N), grid.resolution(), grid.low(), grid.high(), grid.size()});
  writer.write(header.data(), header.size());
  numbers == GridNumbers::floats ? writer.write_floats(grid.data(), grid.size())
                                 : detail::write_halves(writer, grid.data(), grid.size());
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
    reader.read_numbers(grid.data(), grid.size());
    reader.check_the_end();
    return grid;
  } catch (const std::invalid_argument& error) {
    reader.fail(std::string("is damaged: ") + error.what());
  }
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
