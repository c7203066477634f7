// Files read with care, and the shape of zonal's own formats.
//
// zonal's own formats are little-endian words of 32 bits: a mark of 8 bytes, the version of the format, the rest of a
// header, data, and a checksum of 8 bytes, FNV-1a of everything before, taken four bytes at a time. Data that is not
// read from beginning to end is in parts, each with a checksum of its own after it.
//
// A reader knows the size of its file, to check a header against it before any memory is asked for. Files are written
// whole or not at all (output_file.hpp).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "output_file.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

// An open file of known size. All failures are FileError.
class InputFile {
 public:
  explicit InputFile(const std::filesystem::path& path) : path_(path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) fail(error ? error.message() : "is not a file");
    size_ = std::filesystem::file_size(path, error);
    file_.open(path, std::ios::binary);
    if (error || !file_) fail("cannot be read");
  }

  std::uint64_t size() const { return size_; }

  void read(unsigned char* bytes, std::size_t count) {
    file_.read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(count));
    if (!file_) fail("cannot be read to its end");
  }
  void seek(std::uint64_t offset) {
    if (offset > size_ || !file_.seekg(static_cast<std::streamoff>(offset))) fail("cannot be read to its end");
  }

  [[noreturn]] void fail(const std::string& what) const { throw FileError(path_, what); }

 private:
  std::filesystem::path path_;
  std::uint64_t size_ = 0;
  std::ifstream file_;
};

/// The unsigned integer of the first sizeof(T) bytes, little-endian.
template <class T>
T from_little_endian(const unsigned char* bytes) {
  std::uint64_t value = 0;
  for (std::size_t b = 0; b < sizeof(T); ++b) value |= static_cast<std::uint64_t>(bytes[b]) << (8 * b);
  return static_cast<T>(value);
}

// The same bits as another type.
template <class To, class From>
To same_bits(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}

inline std::uint32_t to_word(float x) { return same_bits<std::uint32_t>(x); }
inline float from_word(std::uint32_t word) { return same_bits<float>(word); }

inline std::uint64_t from_words(const std::uint32_t* low_high) {
  return low_high[0] | static_cast<std::uint64_t>(low_high[1]) << 32;
}
inline void to_words(std::uint64_t x, std::uint32_t* low_high) {
  low_high[0] = static_cast<std::uint32_t>(x);
  low_high[1] = static_cast<std::uint32_t>(x >> 32);
}

// 32-bit words on their way to or from a file, and their checksum.
class FileWords {
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
      words[i] = from_little_endian<std::uint32_t>(bytes + 4 * i);
      add(words[i]);
    }
  }

 private:
  void add(std::uint32_t word) { checksum_ = (checksum_ ^ word) * 1099511628211U; }

  std::uint64_t checksum_ = 14695981039346656037U;
};

/// What tells a format of zonal's from others. noun: what such a file is called in errors, "grid" say.
struct FileFormat {
  char mark[9];
  std::uint32_t version;
  std::size_t header_size;  // bytes, with mark and version
  const char* noun;

  static constexpr std::size_t checksum_size = 8;

  void begin(std::uint32_t* header) const {
    FileWords().decode(reinterpret_cast<const unsigned char*>(mark), 2, header);
    header[2] = version;
  }
};

// An open file of a format: read_header first, then as many words as its size says, then check_the_end, of the file or
// of a part.
class WordReader {
 public:
  WordReader(const std::filesystem::path& path, const FileFormat& format) : file_(path), format_(format) {}

  std::uint64_t size() const { return file_.size(); }
  [[noreturn]] void fail(const std::string& what) const { file_.fail(what); }

  /// All words of the header. Mark and version are checked.
  void read_header(std::uint32_t* words) {
    const std::string no_such = std::string("is no ") + format_.noun;
    if (size() < format_.header_size + FileFormat::checksum_size) fail(no_such + ": too short");
    read(words, format_.header_size / 4);
    std::uint32_t expected[3];
    format_.begin(expected);
    if (!std::equal(expected, expected + 2, words)) fail(no_such);
    if (words[2] != format_.version) {
      fail("has version " + std::to_string(words[2]) + " of the format; this reads " + std::to_string(format_.version));
    }
  }
  /// To where a part begins.
  void seek(std::uint64_t offset) {
    file_.seek(offset);
    words_ = {};
  }
  /// At most FileWords::block.
  void read_words(std::uint32_t* words, std::size_t count) { read(words, count); }
  void read_floats(float* floats, std::size_t count) {
    std::array<std::uint32_t, FileWords::block> words;
    for (std::size_t done = 0; done < count; done += words.size()) {
      const std::size_t now = (std::min)(words.size(), count - done);
      read(words.data(), now);
      for (std::size_t i = 0; i < now; ++i) floats[done + i] = from_word(words[i]);
    }
  }
  void check_the_end() {
    const std::uint64_t expected = words_.checksum();
    std::uint32_t words[2];
    read(words, 2);
    if (expected != from_words(words)) fail("is damaged: wrong checksum");
    words_ = {};
  }

 private:
  void read(std::uint32_t* words, std::size_t count) {
    std::array<unsigned char, 4 * FileWords::block> bytes;
    file_.read(bytes.data(), 4 * count);
    words_.decode(bytes.data(), count, words);
  }

  InputFile file_;
  FileFormat format_;
  FileWords words_;
};

/// Does the file begin as one of the format does? Its version, and whether it is whole, are not looked at.
inline bool has_mark(const std::filesystem::path& path, const FileFormat& format) {
  InputFile file(path);
  unsigned char mark[8];
  if (file.size() < sizeof mark) return false;
  file.read(mark, sizeof mark);
  return std::memcmp(mark, format.mark, sizeof mark) == 0;
}

// A file of a format, whole or not there.
class WordWriter {
 public:
  explicit WordWriter(const std::filesystem::path& path) : file_(path) {}

  void write(const std::uint32_t* words, std::size_t count) {
    std::array<unsigned char, 4 * FileWords::block> bytes;
    words_.encode(words, count, bytes.data());
    file_.write(bytes.data(), 4 * count);
  }
  void write_floats(const float* floats, std::size_t count) {
    std::array<std::uint32_t, FileWords::block> words;
    for (std::size_t done = 0; done < count; done += words.size()) {
      const std::size_t now = (std::min)(words.size(), count - done);
      for (std::size_t i = 0; i < now; ++i) words[i] = to_word(floats[done + i]);
      write(words.data(), now);
    }
  }
  /// The checksum of what was written since the last.
  void end_part() {
    std::uint32_t words[2];
    to_words(words_.checksum(), words);
    write(words, 2);
    words_ = {};
  }
  // The checksum, and the move.
  void finish() {
    end_part();
    move_into_place();
  }
  void move_into_place() { file_.move_into_place(); }

 private:
  OutputFile file_;
  FileWords words_;
};

}  // namespace detail
}  // namespace ZONAL_TARGET
}  // namespace zonal
