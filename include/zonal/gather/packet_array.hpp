// Records of a virtual light's fields as a structure of arrays, in packets.
#pragma once

#include <cstddef>
#include <vector>

#include "../scalar/fields.hpp"
#include "../scalar/packet.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Block after block of 16 records, each field by field, of which a packet is as many lanes as the target has: what is
/// kept in memory is the same for every target, so that a unit compiled by other flags may read it. Record<T> has
/// members(visit), fields.hpp; the last block is padded with zeros in all fields.
template <template <class> class Record>
class PacketArray {
 public:
  using Lanes = Packet<float, kNativeLanes>;
  static constexpr int field_count = zonal::field_count<Record<float>>;
  static_assert(sizeof(Record<float>) == std::size_t{field_count} * sizeof(float), "members() names every member");

  /// Records, and the packets that hold them.
  int size() const { return size_; }
  int packet_count() const { return (size_ + Lanes::width - 1) / Lanes::width; }

  /// Keeps its memory.
  void clear() {
    fields_.clear();
    size_ = 0;
  }

  void append(const Record<float>& record) {
    if (size_ % block_lanes == 0) fields_.resize(fields_.size() + block_size, 0.0F);
    replace(size_++, record);
  }

  void replace(int index, Record<float> record) {
    float* target = fields_.data() + first_field(index);
    for_each_field(record, [&](float field) {
      *target = field;
      target += block_lanes;
    });
  }

  /// One record, for set-up.
  Record<float> record(int index) const {
    Record<float> record;
    const float* source = fields_.data() + first_field(index);
    for_each_field(record, [&](float& field) {
      field = *source;
      source += block_lanes;
    });
    return record;
  }

  ZONAL_INLINE Record<Lanes> packet(int index) const {
    Record<Lanes> record;
    const unsigned first = unsigned(index) * unsigned(Lanes::width);
    const float* source = fields_.data() + std::size_t(first / block_lanes) * block_size + first % block_lanes;
    for_each_field(record, [&](Lanes& field) ZONAL_INLINE {
      field = Lanes::load(source);
      source += block_lanes;
    });
    return record;
  }

  /// Record after record, field after field: size() * field_count floats, without padding.
  std::vector<float> by_record() const {
    std::vector<float> floats;
    floats.reserve(std::size_t(size_) * field_count);
    for (int i = 0; i < size_; ++i) {
      const float* field = fields_.data() + first_field(i);
      for (int k = 0; k < field_count; ++k) floats.push_back(field[k * block_lanes]);
    }
    return floats;
  }

 private:
  static constexpr int block_lanes = 16;
  static constexpr std::size_t block_size = std::size_t(block_lanes * field_count);
  static_assert(block_lanes % Lanes::width == 0, "a block is whole packets");

  static std::size_t first_field(int index) {
    return std::size_t(index / block_lanes) * block_size + std::size_t(index % block_lanes);
  }

  std::vector<float> fields_;
  int size_ = 0;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
