// Records of a virtual light's fields as a structure of arrays, in packets.
#pragma once

#include <cstddef>
#include <vector>

#include "../scalar/packet.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Packet after packet, each field by field: one gather step reads one run of memory. Record<T> has field(i), i <
/// field_count; the last packet is padded with zeros in all fields.
template <template <class> class Record>
class PacketArray {
 public:
  using Lanes = Packet<float, kNativeLanes>;
  static constexpr int field_count = Record<float>::field_count;

  /// Records, and the packets that hold them.
  int size() const { return size_; }
  int packet_count() const { return (size_ + Lanes::width - 1) / Lanes::width; }

  void append(Record<float> record) {
    const int lane = size_ % Lanes::width;
    if (lane == 0) fields_.resize(fields_.size() + packet_size, 0.0F);
    float* target = fields_.data() + fields_.size() - packet_size + lane;
    for (int i = 0; i < field_count; ++i) target[i * Lanes::width] = record.field(i);
    ++size_;
  }

  ZONAL_INLINE Record<Lanes> packet(int index) const {
    Record<Lanes> record;
    const float* source = fields_.data() + std::size_t(index) * packet_size;
    unroll<0, field_count>([&](auto i) ZONAL_INLINE { record.field(i) = Lanes::load(source + i * Lanes::width); });
    return record;
  }

 private:
  static constexpr std::size_t packet_size = std::size_t(Lanes::width * field_count);

  std::vector<float> fields_;
  int size_ = 0;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
