// The container of the RGL material database [1]: named arrays in one file.
//
// All little-endian: "tensor_file" and a zero byte, version 1.0 as two bytes, the number of fields in 32 bits; then for
// each field the length of its name in 16 bits, the name, the number of dimensions in 16 bits, the type in 8 bits, the
// offset of its data from the beginning of the file in 64 bits, and its shape, 64 bits each, the last index fastest.
// Types: 1 to 8 are uint8, int8, uint16, ..., int64; 9 to 11 float16, float32, float64.
//
// [1] J. Dupuy, W. Jakob, "An Adaptive Parameterization for Efficient Material Acquisition and Rendering", ACM TOG
//     37(6), 2018; https://rgl.epfl.ch/materials.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "../file/checked_file.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What a tensor file says of a field. offset: bytes from the beginning of the file; elements: product of the shape.
struct TensorField {
  enum class Type : unsigned char { u8 = 1, i8, u16, i16, u32, i32, u64, i64, f16, f32, f64 };

  Type type;
  std::uint64_t offset, elements;
  std::vector<std::uint64_t> shape;
};

/// An open tensor file whose list of fields has been read and holds together with the file's size: no field, read or
/// not, reaches beyond the file's end. Throws FileError for anything else.
class TensorFile {
 public:
  explicit TensorFile(const std::filesystem::path& path) : file_(path) {
    constexpr std::array<unsigned char, 12> mark{'t', 'e', 'n', 's', 'o', 'r', '_', 'f', 'i', 'l', 'e', '\0'};
    std::array<unsigned char, 12> start{};
    if (file_.size() < mark.size() + 6) fail("is no tensor file: too short");
    file_.read(start.data(), start.size());
    if (start != mark) fail("is no tensor file");
    const auto major = read<std::uint8_t>(), minor = read<std::uint8_t>();
    if (major != 1 || minor != 0) {
      fail("has version " + std::to_string(major) + "." + std::to_string(minor) + " of the format; this reads 1.0");
    }
    position_ = mark.size() + 2;
    for (auto count = next<std::uint32_t>(); count > 0; --count) read_field();
  }

  const std::map<std::string, TensorField>& fields() const { return fields_; }
  bool has(const std::string& name) const { return fields_.count(name) != 0; }

  /// The field of that name, which must have that type and that many dimensions.
  const TensorField& field(const std::string& name, TensorField::Type type, std::size_t dimensions) const {
    const auto found = fields_.find(name);
    if (found == fields_.end()) fail("has no field " + name);
    if (found->second.type != type) fail("is damaged: the type of its field " + name);
    if (found->second.shape.size() != dimensions) fail("is damaged: the dimensions of its field " + name);
    return found->second;
  }

  std::vector<unsigned char> read_bytes(const TensorField& field) {
    std::vector<unsigned char> bytes(static_cast<std::size_t>(field.elements));
    file_.seek(field.offset);
    file_.read(bytes.data(), bytes.size());
    return bytes;
  }

  /// All elements of the field, which is of type f32. Numbers that are not finite are an error.
  std::vector<float> read_floats(const std::string& name, const TensorField& field) {
    constexpr std::size_t block = 4096;
    std::array<unsigned char, 4 * block> bytes;
    std::vector<float> floats(static_cast<std::size_t>(field.elements));
    file_.seek(field.offset);
    for (std::size_t done = 0; done < floats.size(); done += block) {
      const std::size_t now = (std::min)(block, floats.size() - done);
      file_.read(bytes.data(), 4 * now);
      for (std::size_t i = 0; i < now; ++i) {
        const float x = detail::from_word(detail::from_little_endian<std::uint32_t>(&bytes[4 * i]));
        if (!std::isfinite(x))
          fail("is damaged: element " + std::to_string(done + i) + " of " + name + " is no number");
        floats[done + i] = x;
      }
    }
    return floats;
  }

  [[noreturn]] void fail(const std::string& what) const { file_.fail(what); }

 private:
  static std::uint64_t bytes_per_element(TensorField::Type type) {
    constexpr std::uint64_t size[] = {1, 1, 2, 2, 4, 4, 8, 8, 2, 4, 8};
    return size[static_cast<std::size_t>(type) - 1];
  }

  template <class T>
  T read() {
    std::array<unsigned char, sizeof(T)> bytes;
    file_.read(bytes.data(), bytes.size());
    return detail::from_little_endian<T>(bytes.data());
  }
  /// The same within the list of fields, whose lengths are the file's own word.
  template <class T>
  T next() {
    take(sizeof(T));
    return read<T>();
  }
  void take(std::uint64_t bytes) {
    if (bytes > file_.size() - position_) fail("is damaged: its list of fields goes beyond its end");
    position_ += bytes;
  }

  void read_field() {
    const auto length = next<std::uint16_t>();
    take(length);
    std::vector<unsigned char> letters(length);
    file_.read(letters.data(), letters.size());
    const std::string name(letters.begin(), letters.end());

    TensorField field{};
    const auto dimensions = next<std::uint16_t>();
    const auto type = next<std::uint8_t>();
    if (type < 1 || type > 11) fail("is damaged: a field of type " + std::to_string(type));
    field.type = static_cast<TensorField::Type>(type);
    field.offset = next<std::uint64_t>();
    if (field.offset > file_.size()) fail("is damaged: a field begins beyond its end");
    const std::uint64_t room = (file_.size() - field.offset) / bytes_per_element(field.type);
    field.elements = 1;
    for (unsigned d = 0; d < dimensions; ++d) {
      const auto extent = next<std::uint64_t>();
      if (extent != 0 && field.elements > room / extent) fail("is damaged: a field's shape does not go with its size");
      field.elements *= extent;
      field.shape.push_back(extent);
    }
    if (field.elements > room) fail("is damaged: a field ends beyond its end");
    if (!fields_.emplace(name, std::move(field)).second) fail("is damaged: two fields of one name");
  }

  detail::InputFile file_;
  std::uint64_t position_ = 0;  // in the list of fields
  std::map<std::string, TensorField> fields_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
