// Projected materials as files: a table takes seconds to build and milliseconds to read.
//
// All little-endian: a header of 36 bytes, then the rows of MaterialTable, then a checksum.
//
//   bytes   what
//   0-7     "ZONALMAT"
//   8-11    version of the format, 1
//   12-15   bands, 1 to 21
//   16-19   angles: 1 or 90
//   20-27   fingerprint of what was projected, and how
//   28-35   achieved error, a double
//   36-     floats: the rows of F, then those of F', angles * bands (bands + 1) / 2 coefficients each, RGB
//   last 8  FNV-1a of everything before, 64 bits, taken four bytes at a time
//
// A file is written beside its place and moved there when it is whole. Loading checks all of the above, and the size of
// the file before any memory is asked for.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "../file/checked_file.hpp"
#include "material_table.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What a table's file says of it before the data.
struct MaterialFileHeader {
  int bands, angles;
  std::uint64_t fingerprint;
  double achieved_error;
};

namespace detail {

inline constexpr FileFormat material_file_format{"ZONALMAT", 1, 36, "table of a material"};

using MaterialFileHeaderWords = std::array<std::uint32_t, material_file_format.header_size / 4>;

inline MaterialFileHeaderWords header_words(const MaterialTable& table, std::uint64_t fingerprint) {
  MaterialFileHeaderWords words{};
  material_file_format.begin(words.data());
  words[3] = static_cast<std::uint32_t>(table.bands());
  words[4] = static_cast<std::uint32_t>(table.angles());
  to_words(fingerprint, &words[5]);
  to_words(same_bits<std::uint64_t>(table.achieved_error()), &words[7]);
  return words;
}

// An open file whose header has been read and holds together with the file's size.
class MaterialFileReader : public WordReader {
 public:
  explicit MaterialFileReader(const std::filesystem::path& path) : WordReader(path, material_file_format) {
    MaterialFileHeaderWords words;
    read_header(words.data());
    if (words[3] < 1 || words[3] > MaterialTable::max_bands) {
      fail("is damaged: it says it has " + std::to_string(words[3]) + " bands");
    }
    if (words[4] != 1 && words[4] != MaterialTable::max_angles) {
      fail("is damaged: it says it has " + std::to_string(words[4]) + " angles");
    }
    header_ = {static_cast<int>(words[3]), static_cast<int>(words[4]), from_words(&words[5]),
               same_bits<double>(from_words(&words[7]))};
    if (size() != material_file_format.header_size + 2 * 12 * row_coefficients() + FileFormat::checksum_size) {
      fail("is damaged: its size is not what its header says");
    }
  }

  const MaterialFileHeader& header() const { return header_; }

  std::vector<glm::vec3> read_rows() {
    std::vector<glm::vec3> rows(row_coefficients());
    for (glm::vec3& coefficient : rows) {
      float rgb[3];
      read_floats(rgb, 3);
      coefficient = {rgb[0], rgb[1], rgb[2]};
    }
    return rows;
  }

 private:
  std::size_t row_coefficients() const {
    return static_cast<std::size_t>(header_.angles * even_index(header_.bands, 0));
  }

  MaterialFileHeader header_{};
};

inline void write_rows(WordWriter& writer, const std::vector<glm::vec3>& rows) {
  for (const glm::vec3& coefficient : rows) {
    const float rgb[3] = {coefficient.x, coefficient.y, coefficient.z};
    writer.write_floats(rgb, 3);
  }
}

inline void write_table(WordWriter& writer, const MaterialTable& table, std::uint64_t fingerprint) {
  const MaterialFileHeaderWords header = header_words(table, fingerprint);
  writer.write(header.data(), header.size());
  write_rows(writer, table.with_cosine_rows());
  write_rows(writer, table.without_cosine_rows());
  writer.finish();
}

}  // namespace detail

/// Writes the table. Throws FileError where it cannot; the file is then what it was, or still not there.
inline void save_material_table(const std::filesystem::path& path, const MaterialTable& table,
                                std::uint64_t fingerprint = 0) {
  detail::WordWriter writer(path);
  detail::write_table(writer, table, fingerprint);
}

/// What stands in the file, without its data. Throws FileError.
inline MaterialFileHeader read_material_header(const std::filesystem::path& path) {
  return detail::MaterialFileReader(path).header();
}

/// Reads a table. Throws FileError unless it is one, whole and undamaged.
inline MaterialTable load_material_table(const std::filesystem::path& path) {
  detail::MaterialFileReader reader(path);
  std::vector<glm::vec3> with_cosine = reader.read_rows(), without_cosine = reader.read_rows();
  reader.check_the_end();
  const MaterialFileHeader& header = reader.header();
  return MaterialTable(header.bands, header.angles, header.achieved_error, std::move(with_cosine),
                       MirroredRows(std::move(without_cosine)));
}

/// To be raised with every change of how a file is read or projected that changes its table: 2 since RGL materials are
/// integrated by the pieces of their own tables. Tables of another version are built anew.
inline constexpr std::uint32_t material_projection_version = 2;

/// A fingerprint of a measured material's file, all its bytes, projected to `bands` bands within `tolerance` by that
/// version of the projection: 64 bits, against mistakes and not against malice. Throws FileError where the file cannot
/// be read.
inline std::uint64_t material_fingerprint(const std::filesystem::path& source, int bands, double tolerance,
                                          std::uint32_t version = material_projection_version) {
  detail::InputFile file(source);
  detail::FileWords words;
  std::array<unsigned char, 4 * detail::FileWords::block> bytes;
  std::array<std::uint32_t, detail::FileWords::block> decoded;
  for (std::uint64_t left = file.size(); left > 0;) {
    const auto now = static_cast<std::size_t>((std::min<std::uint64_t>)(left, bytes.size()));
    std::fill(bytes.begin(), bytes.end(), static_cast<unsigned char>(0));
    file.read(bytes.data(), now);
    words.decode(bytes.data(), (now + 3) / 4, decoded.data());
    left -= now;
  }
  std::uint32_t rest[6] = {static_cast<std::uint32_t>(bands)};
  detail::to_words(file.size(), &rest[1]);
  detail::to_words(detail::same_bits<std::uint64_t>(tolerance), &rest[3]);
  rest[5] = version;
  words.encode(rest, 6, bytes.data());
  return words.checksum();
}

/// The table of that fingerprint in the file at `path`; where there is none, or a damaged one, or another material's,
/// build(), a callable () -> MaterialTable, which is then written there. Throws FileError, before anything is built,
/// where the file cannot be written or is something else than a table: it is never overwritten then.
template <class Build>
MaterialTable cached_material_table(const std::filesystem::path& path, std::uint64_t fingerprint, const Build& build) {
  if (std::filesystem::exists(path)) {
    if (!detail::has_mark(path, detail::material_file_format)) {
      throw FileError(path, "is no table of a material, and is not overwritten");
    }
    try {
      if (read_material_header(path).fingerprint == fingerprint) return load_material_table(path);
    } catch (const FileError&) {
      // damaged, or of another version: built anew
    }
  }
  detail::WordWriter writer(path);
  MaterialTable table = build();
  detail::write_table(writer, table, fingerprint);
  return table;
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
