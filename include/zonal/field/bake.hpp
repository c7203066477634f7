// A field from a sequence larger than memory: in two steps, each of which may be stopped at any moment and goes on from
// there.
//
// The first reads pictures, as many at a time as memory is given for, and writes their samples, sorted, to a file in a
// folder of the bake's own. The second reads them back block by block, and keeps what it has added up in a file there,
// written whole or not at all. A file that is there, and is of the same sequence and the same options, is not made
// again: nothing is lost but what was not yet written, nothing is counted twice, and the result has the same bits.
//
// Blocks may be shared out: `share` says which this process takes, and sums of all shares add up to the field.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include "../file/checked_file.hpp"
#include "resample.hpp"
#include "sample_file.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

// What results depend on, as one number: FNV-1a of words.
class Fingerprint {
 public:
  template <class Number>
  Fingerprint& add(Number number) {
    static_assert(std::is_arithmetic_v<Number> && sizeof(Number) <= 8);
    std::uint32_t words[2] = {};
    std::memcpy(words, &number, sizeof number);
    unsigned char bytes[8];
    words_.encode(words, 2, bytes);
    return *this;
  }
  Fingerprint& add(const std::string& text) {
    for (const char c : text) add(static_cast<int>(c));
    return add(text.size());
  }
  Fingerprint& add(const char* text) { return add(std::string(text)); }
  Fingerprint& add(const glm::vec3& v) { return add(v.x).add(v.y).add(v.z); }
  Fingerprint& add(const glm::quat& q) { return add(q.w).add(q.x).add(q.y).add(q.z); }
  std::uint64_t value() const { return words_.checksum(); }

 private:
  FileWords words_;
};

inline constexpr FileFormat sums_file_format{"ZONALSUM", 1, 36, "file of sums"};

}  // namespace detail

/// What the samples of a sequence depend on, as one number: positions, and which file each picture is, how large and of
/// when. Throws FileError where one is not there.
inline std::uint64_t fingerprint(const ProbeSequence& sequence, const DirectionBuckets& buckets) {
  std::error_code error;
  detail::Fingerprint print;
  print.add(sequence.sphere_radius).add(sequence.dead_angle).add(int(sequence.dead_angle_is));
  print.add(int(buckets.mapping())).add(buckets.width()).add(buckets.height()).add(buckets.orientation());
  for (const SequenceProbe& probe : sequence.probes) {
    const auto size = std::filesystem::file_size(probe.picture, error);
    const auto time =
        error ? std::filesystem::file_time_type{} : std::filesystem::last_write_time(probe.picture, error);
    if (error) throw FileError(probe.picture, "cannot be read (" + error.message() + ")");
    print.add(probe.picture.string()).add(size).add(static_cast<std::int64_t>(time.time_since_epoch().count()));
    print.add(probe.position).add(sequence.orientation_of(probe));
  }
  return print.value();
}

/// The folder of a bake, and which of the sequence's samples stand in which file.
class BakeFolder {
 public:
  /// Makes the folder where it is not there. `memory`, in bytes, is for the samples of one file. Throws FileError; also
  /// where a picture is not there.
  BakeFolder(const std::filesystem::path& folder, const ProbeSequence& sequence, const DirectionBuckets& buckets,
             std::size_t memory)
      : folder_(folder),
        probes_(sequence.probes.size()),
        buckets_(buckets.size()),
        fingerprint_(zonal::fingerprint(sequence, buckets)) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw FileError(folder, "cannot be made (" + error.message() + ")");
    per_file_ = (std::max)(memory / (buckets_ * sizeof(RadianceSample)), std::size_t{1});
  }

  /// Removes what processes that were killed left half written. No other may be writing to the folder.
  void clean() const {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
      const std::string name = entry.path().filename().string();
      if (name.rfind(".zonal-", 0) == 0 && entry.path().extension() == ".tmp")
        std::filesystem::remove(entry.path(), error);
    }
  }

  /// Removes the samples, and the folder if nothing else is in it.
  void remove() const {
    std::error_code error;
    for (std::size_t n = 0; n < file_count(); ++n) std::filesystem::remove(file(n), error);
    std::filesystem::remove(folder_, error);
  }

  std::uint64_t fingerprint() const { return fingerprint_; }
  std::size_t bucket_count() const { return buckets_; }

  std::size_t file_count() const { return (probes_ + per_file_ - 1) / per_file_; }
  std::filesystem::path file(std::size_t n) const { return folder_ / ("samples-" + std::to_string(n) + ".zonal"); }
  SampleFileHeader header(std::size_t n) const {
    const std::size_t first = n * per_file_;
    return {first, (std::min)(per_file_, probes_ - first), buckets_, fingerprint_};
  }
  /// Is file n there, whole, and of these samples?
  bool has(std::size_t n) const {
    std::error_code error;
    if (!std::filesystem::exists(file(n), error)) return false;
    try {
      return SampleFile(file(n)).header() == header(n);
    } catch (const FileError&) {
      return false;  // it is made again
    }
  }
  std::filesystem::path sums_file(const std::string& share) const { return folder_ / ("sums" + share + ".zonal"); }

  /// All samples of a block, probe by probe within a bucket. Throws FileError where one is missing or damaged.
  void read_block(std::size_t block, std::vector<RadianceSample>& samples) const {
    samples.resize(buckets_of_block(block, buckets_) * probes_);
    for (std::size_t n = 0; n < file_count(); ++n) {
      SampleFile samples_file(file(n));
      if (!(samples_file.header() == header(n))) throw FileError(file(n), "is of other samples");
      samples_file.read_block(block, samples.data() + samples_file.header().first_probe, probes_);
    }
  }

 private:
  std::filesystem::path folder_;
  std::size_t probes_, buckets_, per_file_ = 1;
  std::uint64_t fingerprint_ = 0;
};

/// Writes file n of the samples. load(probe, use) calls use(environment) with a probe's picture, or throws. Gives back
/// what no picture should hold.
template <class Load, class ForEach = SerialForEach>
PictureFaults sort_samples(const BakeFolder& folder, std::size_t n, const ProbeSequence& sequence,
                           const DirectionBuckets& buckets, const Load& load, ForEach&& for_each = {}) {
  const SampleFileHeader header = folder.header(n);
  std::vector<RadianceSample> samples(header.buckets * header.probes);
  std::vector<PictureFaults> faults(header.probes);
  for_each(static_cast<int>(header.probes), [&](int i) {
    const auto p = static_cast<std::size_t>(i);
    const SequenceProbe& probe = sequence.probes[header.first_probe + p];
    load(probe, [&](const auto& environment) {
      buckets.sort(environment, sequence.orientation_of(probe), sequence.dead_angle_is, samples.data() + p,
                   header.probes, faults[p]);
    });
  });
  write_samples(folder.file(n), header, samples.data());
  for (std::size_t p = 1; p < faults.size(); ++p) faults[0] += faults[p];
  return faults[0];
}

/// Of `count` processes, number `index`.
struct BakeShare {
  std::size_t index = 0, count = 1;
};

/// The second step: sums of the blocks index, index + count, ... of all. Sums is FieldSums, or ReferenceFieldSums.
template <class Sums>
class FieldBake {
 public:
  using Grid = typename Sums::Grid;

  /// Goes on with what the folder holds of the same bake. Throws FileError. All must outlive this.
  FieldBake(const BakeFolder& folder, const ProbeSequence& sequence, const DirectionBuckets& buckets, const Grid& grid,
            const Resampling& resampling, const BakeShare& share = {})
      : folder_(folder),
        buckets_(buckets),
        sphere_radius_(sequence.sphere_radius),
        resampling_(resampling),
        share_(share),
        sums_(grid) {
    for (const SequenceProbe& probe : sequence.probes) places_.push_back(place_of(sequence, probe));
    detail::Fingerprint print;
    print.add(folder.fingerprint())
        .add(Sums::name)
        .add(Grid::bands)
        .add(int(Grid::content))
        .add(grid.low())
        .add(grid.high());
    print.add(grid.resolution().x).add(grid.resolution().y).add(grid.resolution().z);
    print.add(resampling.slope_damping).add(int(resampling.repair)).add(share.index).add(share.count);
    fingerprint_ = print.value();
    load();
  }

  /// Blocks of this share, and how many of them are done.
  std::size_t count() const {
    const std::size_t blocks = block_count(folder_.bucket_count());
    return (blocks + share_.count - 1 - share_.index) / share_.count;
  }
  std::size_t done() const { return done_; }

  /// Adds the next block.
  template <class ForEach = SerialForEach>
  void step(ForEach&& for_each = {}) {
    const std::size_t block = share_.index + done_ * share_.count;
    folder_.read_block(block, samples_);
    sums_.add(buckets_, {block * SampleBlock::most_buckets, buckets_of_block(block, buckets_.size()), samples_.data()},
              places_, sphere_radius_, resampling_, for_each);
    ++done_;
  }

  /// Keeps what is done. Throws FileError; what was kept before is then still there.
  void save() {
    detail::WordWriter writer(path());
    const HeaderWords header = header_words();
    writer.write(header.data(), header.size());
    sums_.visit_state([&](auto* numbers, std::size_t count) { write_numbers(writer, numbers, count); });
    writer.finish();
  }
  /// Removes what was kept.
  void forget() const {
    std::error_code error;
    std::filesystem::remove(path(), error);
  }

  Sums& sums() { return sums_; }

 private:
  using HeaderWords = std::array<std::uint32_t, detail::sums_file_format.header_size / 4>;

  std::filesystem::path path() const {
    const bool is_all = share_.count == 1;
    return folder_.sums_file(is_all ? "" : "-" + std::to_string(share_.index) + "-of-" + std::to_string(share_.count));
  }
  HeaderWords header_words() {
    HeaderWords words{};
    detail::sums_file_format.begin(words.data());
    detail::to_words(fingerprint_, &words[3]);
    detail::to_words(done_, &words[5]);
    std::uint64_t size = 0;
    sums_.visit_state([&](auto* numbers, std::size_t count) { size += count * sizeof *numbers / 4; });
    detail::to_words(size, &words[7]);
    return words;
  }
  // Sums of another bake are none of ours: they are written over.
  void load() {
    std::error_code error;
    if (!std::filesystem::exists(path(), error)) return;
    detail::WordReader reader(path(), detail::sums_file_format);
    HeaderWords words;
    reader.read_header(words.data());
    const HeaderWords expected = header_words();
    if (detail::from_words(&words[3]) != fingerprint_) return;
    const std::uint64_t size = detail::from_words(&words[7]), done = detail::from_words(&words[5]);
    if (size != detail::from_words(&expected[7]) || done > count() ||
        reader.size() != detail::sums_file_format.header_size + 4 * size + detail::FileFormat::checksum_size) {
      reader.fail("is damaged: its size is not what its header says");
    }
    sums_.visit_state([&](auto* numbers, std::size_t count) { read_numbers(reader, numbers, count); });
    reader.check_the_end();
    done_ = static_cast<std::size_t>(done);
  }

  static void write_numbers(detail::WordWriter& writer, const float* numbers, std::size_t count) {
    writer.write_floats(numbers, count);
  }
  static void write_numbers(detail::WordWriter& writer, const double* numbers, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) {
      std::uint32_t words[2];
      detail::to_words(detail::same_bits<std::uint64_t>(numbers[n]), words);
      writer.write(words, 2);
    }
  }
  static void read_numbers(detail::WordReader& reader, float* numbers, std::size_t count) {
    reader.read_floats(numbers, count);
  }
  static void read_numbers(detail::WordReader& reader, double* numbers, std::size_t count) {
    for (std::size_t n = 0; n < count; ++n) {
      std::uint32_t words[2];
      reader.read_words(words, 2);
      numbers[n] = detail::same_bits<double>(detail::from_words(words));
    }
  }

  const BakeFolder& folder_;
  const DirectionBuckets& buckets_;
  float sphere_radius_;
  Resampling resampling_;
  BakeShare share_;
  Sums sums_;
  std::vector<ProbePlace> places_;
  std::vector<RadianceSample> samples_;
  std::uint64_t fingerprint_ = 0;
  std::size_t done_ = 0;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
