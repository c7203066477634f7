// Samples on disk: written picture by picture, read direction by direction.
//
// A file holds the samples of some consecutive probes of a sequence, sorted into buckets. All little-endian:
//
//   bytes   what
//   0-7     "ZONALSMP"
//   8-11    version of the format, 1
//   12-15   number of the first probe
//   16-19   probes
//   20-23   buckets
//   24-31   fingerprint of what the samples were made from
//   32-39   checksum
//   40-     blocks of 64 buckets, the last of what is left. A block: its number; for each bucket, for each probe red,
//           green and blue as floats, NaN where there is no sample; a checksum
//
// Checksums are FNV-1a of 64 bits, taken four bytes at a time. A file is written beside its place and moved there when
// it is whole. The header, and the size of the file, are checked before memory is asked for; a block when it is read.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "../file/checked_file.hpp"
#include "buckets.hpp"
#include "resample.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What a file of samples says of them before the data.
struct SampleFileHeader {
  std::size_t first_probe, probes, buckets;
  std::uint64_t fingerprint;

  friend bool operator==(const SampleFileHeader& a, const SampleFileHeader& b) {
    return a.first_probe == b.first_probe && a.probes == b.probes && a.buckets == b.buckets &&
           a.fingerprint == b.fingerprint;
  }
};

namespace detail {

inline constexpr FileFormat sample_file_format{"ZONALSMP", 1, 32, "file of samples"};

// Where a block begins, and the file's size: that of what would be one more.
inline std::uint64_t sample_block_begin(const SampleFileHeader& header, std::size_t block) {
  const std::uint64_t buckets = (std::min)(block * SampleBlock::most_buckets, header.buckets);
  return sample_file_format.header_size + FileFormat::checksum_size +
         block * (4 + std::uint64_t{FileFormat::checksum_size}) + buckets * header.probes * sizeof(RadianceSample);
}

}  // namespace detail

/// The blocks that a number of buckets makes, and the buckets of one.
inline std::size_t block_count(std::size_t buckets) {
  return (buckets + SampleBlock::most_buckets - 1) / SampleBlock::most_buckets;
}
inline std::size_t buckets_of_block(std::size_t block, std::size_t buckets) {
  return (std::min)(SampleBlock::most_buckets, buckets - block * SampleBlock::most_buckets);
}

/// Writes samples, that of bucket b and probe p at samples[b * header.probes + p]. Throws FileError; the file is then
/// what it was, or still not there.
inline void write_samples(const std::filesystem::path& path, const SampleFileHeader& header,
                          const RadianceSample* samples) {
  detail::WordWriter writer(path);
  std::array<std::uint32_t, detail::sample_file_format.header_size / 4> words{};
  detail::sample_file_format.begin(words.data());
  words[3] = static_cast<std::uint32_t>(header.first_probe);
  words[4] = static_cast<std::uint32_t>(header.probes);
  words[5] = static_cast<std::uint32_t>(header.buckets);
  detail::to_words(header.fingerprint, &words[6]);
  writer.write(words.data(), words.size());
  writer.end_part();
  for (std::size_t block = 0; block < block_count(header.buckets); ++block) {
    const auto number = static_cast<std::uint32_t>(block);
    writer.write(&number, 1);
    const std::size_t count = buckets_of_block(block, header.buckets) * header.probes;
    writer.write_floats(&samples[block * SampleBlock::most_buckets * header.probes].r, 3 * count);
    writer.end_part();
  }
  writer.move_into_place();
}

/// An open file of samples.
class SampleFile {
 public:
  /// Throws FileError unless its header is one, and its size what that says.
  explicit SampleFile(const std::filesystem::path& path) : reader_(path, detail::sample_file_format) {
    std::array<std::uint32_t, detail::sample_file_format.header_size / 4> words;
    reader_.read_header(words.data());
    reader_.check_the_end();
    header_ = {words[3], words[4], words[5], detail::from_words(&words[6])};
    const bool is_too_many =
        header_.probes > 0 && header_.buckets > reader_.size() / header_.probes;  // for the next line
    if (is_too_many || reader_.size() != detail::sample_block_begin(header_, block_count(header_.buckets))) {
      reader_.fail("is damaged: its size is not what its header says");
    }
  }
  const SampleFileHeader& header() const { return header_; }

  /// A block's samples, those of bucket b of the block from samples[b * stride] on. Throws FileError where it is
  /// damaged.
  void read_block(std::size_t block, RadianceSample* samples, std::size_t stride) {
    reader_.seek(detail::sample_block_begin(header_, block));
    std::uint32_t number = 0;
    reader_.read_words(&number, 1);
    if (number != block) reader_.fail("is damaged: a block is not in its place");
    for (std::size_t b = 0; b < buckets_of_block(block, header_.buckets); ++b) {
      if (header_.probes > 0) reader_.read_floats(&samples[b * stride].r, 3 * header_.probes);
    }
    reader_.check_the_end();
  }

 private:
  detail::WordReader reader_;
  SampleFileHeader header_{};
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
