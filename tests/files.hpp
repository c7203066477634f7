// Files of tests: a folder that goes away, bytes in and out.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

namespace file_test {

/// A folder that goes away with the test.
struct Folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / ("zonal_test." + std::to_string(getpid()));
  Folder() {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::size_t files() const {
    using Iterator = std::filesystem::directory_iterator;
    return static_cast<std::size_t>(std::distance(Iterator(path), Iterator()));
  }
};

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
inline void write(const std::filesystem::path& path, const std::string& bytes) {
  std::filesystem::remove(path);  // some file systems wait for the disk where a file is truncated
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}
inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Overwrites bytes of a file, which stays otherwise as it is.
inline void patch(const std::filesystem::path& path, std::size_t offset, const std::string& bytes) {
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(static_cast<std::streamoff>(offset));
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

/// The bytes of a value, as they lie in memory.
template <class T>
std::string raw(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// check(damaged bytes, place) for one wrong bit in each byte of the head, and in every stride-th byte after it.
template <class Check>
void for_each_wrong_bit(const std::string& good, std::size_t head, std::size_t stride, const Check& check) {
  std::mt19937 random(82);
  for (std::size_t i = 0; i < good.size(); i += i < head ? 1 : stride) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ (1 << random() % 8));
    check(bad, i);
  }
}

/// check(bytes, length) for lengths that are not the file's: none, within the head and just after it, half, and one
/// byte more or less than the whole.
template <class Check>
void for_each_wrong_length(const std::string& good, std::size_t head, const Check& check) {
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{7}, head - 1, head + 7, good.size() / 2, good.size() - 1, good.size() + 1}) {
    std::string bad = good;
    bad.resize(length);
    check(bad, length);
  }
}

}  // namespace file_test
