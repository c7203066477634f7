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

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>

#include <glm/vec3.hpp>

#include "coefficient_grid.hpp"

namespace zonal {

/// What is wrong with a grid's file: its name, and why, in one line.
class GridFileError : public std::runtime_error {
 public:
  GridFileError(const std::filesystem::path& path, const std::string& what)
      : std::runtime_error(path.string() + ": " + what) {}
};

/// What a grid's file says of it before the data.
struct GridFileHeader {
  int bands;
  glm::ivec3 resolution;
  glm::vec3 low, high;
};

namespace detail {

inline constexpr char grid_file_mark[8] = {'Z', 'O', 'N', 'A', 'L', 'G', 'R', 'D'};
inline constexpr std::uint32_t grid_file_version = 1;
inline constexpr std::size_t grid_file_header_size = 60, grid_file_checksum_size = 8;

// 32-bit words on their way to or from a file, and their checksum.
class GridFileWords {
 public:
  static constexpr std::size_t block = 4096;

  std::uint64_t checksum() const { return checksum_; }

  void encode(const std::uint32_t* words, std::size_t count, unsigned char* bytes) {
    for (std::size_t i = 0; i < count; ++i) {
      add(words[i]);
      for (std::size_t b = 0; b < 4; ++b) bytes[4 * i + b] = static_cast<unsigned char>(words[i] >> (8 * b));
    }
  }
  void decode(const unsigned char* bytes, std::size_t count, std::uint32_t* words) {
    for (std::size_t i = 0; i < count; ++i) {
      words[i] = 0;
      for (std::size_t b = 0; b < 4; ++b) words[i] |= static_cast<std::uint32_t>(bytes[4 * i + b]) << (8 * b);
      add(words[i]);
    }
  }

 private:
  void add(std::uint32_t word) { checksum_ = (checksum_ ^ word) * 1099511628211U; }

  std::uint64_t checksum_ = 14695981039346656037U;
};

inline std::uint32_t to_word(float x) {
  std::uint32_t word;
  std::memcpy(&word, &x, sizeof word);
  return word;
}
inline float from_word(std::uint32_t word) {
  float x;
  std::memcpy(&x, &word, sizeof x);
  return x;
}

using GridFileHeaderWords = std::array<std::uint32_t, grid_file_header_size / 4>;

template <int N>
GridFileHeaderWords header_words(const CoefficientGrid<N>& grid) {
  GridFileHeaderWords words{};
  GridFileWords().decode(reinterpret_cast<const unsigned char*>(grid_file_mark), 2, words.data());
  words[2] = grid_file_version;
  words[3] = static_cast<std::uint32_t>(N);
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    words[4 + axis] = static_cast<std::uint32_t>(grid.resolution()[a]);
    words[7 + axis] = to_word(grid.low()[a]);
    words[10 + axis] = to_word(grid.high()[a]);
  }
  const auto size = static_cast<std::uint64_t>(grid.size());
  words[13] = static_cast<std::uint32_t>(size);
  words[14] = static_cast<std::uint32_t>(size >> 32);
  return words;
}

// An open grid file whose header has been read and holds together with the file's size.
class GridFileReader {
 public:
  explicit GridFileReader(const std::filesystem::path& path) : path_(path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) fail(error ? error.message() : "is not a file");
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    file_.open(path, std::ios::binary);
    if (error || !file_) fail("cannot be read");
    if (size < grid_file_header_size + grid_file_checksum_size) fail("is no grid: too short");

    GridFileHeaderWords words;
    read(words.data(), words.size());
    std::array<unsigned char, 8> mark;
    GridFileWords().encode(words.data(), 2, mark.data());
    if (std::memcmp(mark.data(), grid_file_mark, sizeof grid_file_mark) != 0) fail("is no grid");
    if (words[2] != grid_file_version) {
      fail("has version " + std::to_string(words[2]) + " of the format; this reads " +
           std::to_string(grid_file_version));
    }
    // No product below can overflow: 12 * 1024^2 * 2^31, then counted down.
    if (words[3] < 1 || words[3] > 1024) fail("is damaged: it says it has " + std::to_string(words[3]) + " bands");
    std::uint64_t floats = std::uint64_t{12} * words[3] * words[3];
    for (std::size_t a = 0; a < 3; ++a) {
      const std::uint32_t count = words[4 + a];
      if (count < 2 || count > 0x7FFFFFFF || floats > (size / 4 + 1) / count) {
        fail("is damaged: its resolution does not go with its size");
      }
      floats *= count;
    }
    const std::uint64_t stated = words[13] | static_cast<std::uint64_t>(words[14]) << 32;
    if (stated != floats || size != grid_file_header_size + 4 * floats + grid_file_checksum_size) {
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

  void read_floats(float* floats, std::size_t count) {
    std::array<std::uint32_t, GridFileWords::block> words;
    for (std::size_t done = 0; done < count; done += words.size()) {
      const std::size_t now = std::min(words.size(), count - done);
      read(words.data(), now);
      for (std::size_t i = 0; i < now; ++i) floats[done + i] = from_word(words[i]);
    }
  }
  void check_the_end() {
    const std::uint64_t expected = words_.checksum();
    std::uint32_t words[2];
    read(words, 2);
    if (expected != (words[0] | static_cast<std::uint64_t>(words[1]) << 32)) fail("is damaged: wrong checksum");
  }

  [[noreturn]] void fail(const std::string& what) const { throw GridFileError(path_, what); }

 private:
  void read(std::uint32_t* words, std::size_t count) {
    std::array<unsigned char, 4 * GridFileWords::block> bytes;
    file_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(4 * count));
    if (!file_) fail("cannot be read to its end");
    words_.decode(bytes.data(), count, words);
  }

  std::filesystem::path path_;
  std::ifstream file_;
  GridFileWords words_;
  GridFileHeader header_{};
};

// A file that stands in its place whole, or not at all.
class GridFileWriter {
 public:
  explicit GridFileWriter(const std::filesystem::path& path) : path_(path) {
    std::error_code error;
    const std::filesystem::path real = std::filesystem::canonical(path, error);  // a link stays a link
    if (!error) path_ = real;
    if (std::filesystem::exists(path_, error) && !std::filesystem::is_regular_file(path_, error)) {
      throw GridFileError(path, "is not a file");
    }
    beside_ = path_;
    beside_ += ".tmp" + std::to_string(std::random_device{}());
    file_.open(beside_, std::ios::binary);
    if (!file_) throw GridFileError(path, "cannot be written");
  }
  ~GridFileWriter() {
    std::error_code ignored;
    if (!beside_.empty()) std::filesystem::remove(beside_, ignored);
  }
  GridFileWriter(const GridFileWriter&) = delete;
  GridFileWriter& operator=(const GridFileWriter&) = delete;

  void write(const std::uint32_t* words, std::size_t count) {
    std::array<unsigned char, 4 * GridFileWords::block> bytes;
    words_.encode(words, count, bytes.data());
    file_.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(4 * count));
  }
  void write_floats(const float* floats, std::size_t count) {
    std::array<std::uint32_t, GridFileWords::block> words;
    for (std::size_t done = 0; done < count; done += words.size()) {
      const std::size_t now = std::min(words.size(), count - done);
      for (std::size_t i = 0; i < now; ++i) words[i] = to_word(floats[done + i]);
      write(words.data(), now);
    }
  }
  // The checksum, and the move.
  void finish() {
    const std::uint64_t checksum = words_.checksum();
    const std::uint32_t words[2] = {static_cast<std::uint32_t>(checksum), static_cast<std::uint32_t>(checksum >> 32)};
    write(words, 2);
    file_.close();
    std::error_code error;
    if (file_) std::filesystem::rename(beside_, path_, error);
    if (!file_ || error) throw GridFileError(path_, "cannot be written whole");
    beside_.clear();
  }

 private:
  std::filesystem::path path_, beside_;
  std::ofstream file_;
  GridFileWords words_;
};

}  // namespace detail

/// Writes the grid. Throws GridFileError where it cannot; the file is then what it was, or still not there.
template <int N>
void save_grid(const std::filesystem::path& path, const CoefficientGrid<N>& grid) {
  detail::GridFileWriter writer(path);
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

}  // namespace zonal
