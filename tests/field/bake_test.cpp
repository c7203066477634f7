// Bakes through files: the same bits, however often they are stopped; damage is found.
#include <zonal/field/bake.hpp>
#include <zonal/field/resample_reference.hpp>

#include <cstring>
#include <random>

#include "../catch.hpp"
#include "../files.hpp"
#include "fields.hpp"

namespace {

using namespace field_test;
using file_test::Folder;
using Grid = zonal::CoefficientGrid<3>;
using Sums = zonal::FieldSums<3, zonal::GridContent::values_and_gradients>;
using Bake = zonal::FieldBake<Sums>;

const glm::quat no_turn(1, 0, 0, 0);
constexpr int picture_size = 20;

/// Seventeen probes of a mirror sphere, and a loader of their pictures.
struct Capture {
  Folder folder;
  DirectionBuckets buckets{zonal::Mapping::mirror_sphere, picture_size, picture_size, no_turn};
  zonal::ProbeSequence sequence;
  std::vector<ProbePlace> places = random_probes(17, glm::vec3(0), glm::vec3(1), 1);
  std::vector<RadianceSample> samples = take_samples(buckets, places, 0.05F, Glow{{0.5F, 0.5F, 3}, false});
  Grid grid{glm::vec3(0), glm::vec3(1), glm::ivec3(5, 4, 3)};
  mutable int loaded = 0;

  Capture() {
    sequence.sphere_radius = 0.05F;
    for (std::size_t p = 0; p < places.size(); ++p) {
      zonal::SequenceProbe probe;
      probe.picture = folder.path / (std::to_string(p) + ".picture");
      probe.position = places[p].position;
      file_test::write(probe.picture, "some picture");
      sequence.probes.push_back(probe);
    }
  }
  zonal::BakeFolder bake_folder(std::size_t probes_per_file = 4) const {
    return {folder.path / "bake", sequence, buckets, probes_per_file * buckets.size() * sizeof(RadianceSample)};
  }
  auto loader() const {
    return [this](const zonal::SequenceProbe& probe, const auto& use) {
      const auto p = static_cast<std::size_t>(&probe - sequence.probes.data());
      std::vector<float> numbers(3 * picture_size * picture_size);
      for (std::size_t b = 0; b < buckets.size(); ++b) {
        for (int c = 0; c < 3; ++c) {
          numbers[std::size_t(3 * (buckets[b].row * picture_size + buckets[b].column) + c)] =
              samples[b * places.size() + p][c];
        }
      }
      ++loaded;
      use(zonal::Environment<float>({numbers.data(), picture_size, picture_size}, zonal::Mapping::mirror_sphere));
    };
  }
  void sort(const zonal::BakeFolder& bake) const {
    for (std::size_t n = 0; n < bake.file_count(); ++n) {
      if (!bake.has(n)) sort_samples(bake, n, sequence, buckets, loader());
    }
  }
  Grid in_memory() const {
    Grid result = grid;
    REQUIRE(zonal::resample<Sums>(result, buckets, samples, places, 0.05F));
    return result;
  }
};

bool is_same(const Grid& a, const Grid& b) { return std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0; }

std::string error_of(const std::function<void()>& run) {
  try {
    run();
  } catch (const zonal::FileError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("through files the field has the bits that it has in memory, however often it is stopped") {
  const Capture capture;
  const Grid expected = capture.in_memory();
  for (const int some : {1, 4, 100}) {
    const auto per_file = static_cast<std::size_t>(some);
    const auto folder = capture.bake_folder(per_file);
    std::filesystem::remove_all(capture.folder.path / "bake");
    const auto again = capture.bake_folder(per_file);  // makes the folder
    REQUIRE(again.file_count() == (17 + per_file - 1) / per_file);
    capture.loaded = 0;
    capture.sort(folder);
    capture.sort(folder);
    REQUIRE(capture.loaded == 17);  // the second time nothing is read

    std::mt19937 random(unsigned(per_file) + 1);
    Grid result = capture.grid;
    bool is_done = false;
    for (int runs = 0; !is_done; ++runs) {  // each is stopped after some steps, saved or not
      REQUIRE(runs < 200);
      Bake bake(folder, capture.sequence, capture.buckets, capture.grid, {});
      for (auto steps = random() % 3; steps > 0 && bake.done() < bake.count(); --steps) {
        bake.step(TwoThreads{});
        if (random() % 2 == 0) bake.save();
      }
      is_done = bake.done() == bake.count();
      if (is_done) REQUIRE(bake.sums().finish(result));
    }
    REQUIRE(is_same(result, expected));
  }
}

TEST_CASE("the paper's steps go on as well") {
  using SlowSums = zonal::ReferenceFieldSums<3>;
  const Capture capture;
  const SlowSums::Grid grid(glm::vec3(0), glm::vec3(1), glm::ivec3(4));
  SlowSums::Grid expected = grid, result = grid;
  REQUIRE(zonal::resample<SlowSums>(expected, capture.buckets, capture.samples, capture.places, 0.05F));
  const auto folder = capture.bake_folder();
  capture.sort(folder);
  for (bool is_done = false; !is_done;) {
    zonal::FieldBake<SlowSums> bake(folder, capture.sequence, capture.buckets, grid, {});
    bake.step();
    bake.save();
    is_done = bake.done() == bake.count();
    if (is_done) REQUIRE(bake.sums().finish(result));
  }
  REQUIRE(std::memcmp(result.data(), expected.data(), result.size() * sizeof(float)) == 0);
}

TEST_CASE("shares of a bake add up to it") {
  const Capture capture;
  const Grid expected = capture.in_memory();
  const auto folder = capture.bake_folder();
  capture.sort(folder);
  for (const int some : {2, 3, 20}) {  // 20 is more than there are blocks
    const auto shares = static_cast<std::size_t>(some);
    Bake first(folder, capture.sequence, capture.buckets, capture.grid, {}, {0, shares});
    std::size_t blocks = 0;
    for (std::size_t i = 0; i < shares; ++i) {
      Bake other(folder, capture.sequence, capture.buckets, capture.grid, {}, {i, shares});
      Bake& bake = i == 0 ? first : other;
      while (bake.done() < bake.count()) bake.step();
      blocks += bake.count();
      if (i == 0) continue;
      std::vector<double> numbers;
      bake.sums().visit_state(
          [&](const auto* source, std::size_t count) { numbers.insert(numbers.end(), source, source + count); });
      std::size_t at = 0;
      first.sums().visit_state([&](auto* target, std::size_t count) {
        using Number = std::remove_pointer_t<decltype(target)>;
        for (std::size_t n = 0; n < count; ++n)
          target[n] = static_cast<Number>(target[n] + static_cast<Number>(numbers[at++]));
      });
    }
    REQUIRE(blocks == zonal::block_count(capture.buckets.size()));
    Grid result = capture.grid;
    REQUIRE(first.sums().finish(result));
    float largest = 0;
    for (std::size_t n = 0; n < result.size(); ++n) largest = (std::max)(largest, std::abs(expected.data()[n]));
    for (std::size_t n = 0; n < result.size(); ++n) {
      REQUIRE(std::abs(result.data()[n] - expected.data()[n]) <= 2e-6F * largest);
    }
  }
}

TEST_CASE("what the folder holds of another bake is not taken") {
  Capture capture;
  capture.sort(capture.bake_folder());
  {
    const auto folder = capture.bake_folder();
    Bake bake(folder, capture.sequence, capture.buckets, capture.grid, {});
    bake.step();
    bake.save();
    REQUIRE(Bake(folder, capture.sequence, capture.buckets, capture.grid, {}).done() == 1);
    REQUIRE(Bake(folder, capture.sequence, capture.buckets, capture.grid, {0.2F, zonal::Repair::mip_maps}).done() == 0);
    REQUIRE(Bake(folder, capture.sequence, capture.buckets, capture.grid, {}, {0, 2}).done() == 0);
    const Grid other(glm::vec3(0), glm::vec3(1), glm::ivec3(5, 3, 4));
    REQUIRE(Bake(folder, capture.sequence, capture.buckets, other, {}).done() == 0);
    zonal::FieldBake<zonal::FieldSums<4>> bands(
        folder, capture.sequence, capture.buckets,
        zonal::CoefficientGrid<4, zonal::GridContent::values>(glm::vec3(0), glm::vec3(1), glm::ivec3(5, 4, 3)), {});
    REQUIRE(bands.done() == 0);
    bake.forget();
    REQUIRE(Bake(folder, capture.sequence, capture.buckets, capture.grid, {}).done() == 0);
  }
  // Another position, another picture: other samples.
  capture.sequence.probes[3].position.x += 1e-6F;
  REQUIRE(!capture.bake_folder().has(0));
  REQUIRE(!capture.bake_folder().has(1));
  capture.sequence.probes[3].position.x = capture.places[3].position.x;
  REQUIRE(capture.bake_folder().has(1));
  file_test::write(capture.sequence.probes[16].picture, "another picture");
  REQUIRE(!capture.bake_folder().has(1));
  const auto folder = capture.bake_folder();
  std::vector<RadianceSample> samples;
  REQUIRE(
      file_test::contains(error_of([&] { folder.read_block(0, samples); }), "samples-0.zonal: is of other samples"));

  std::filesystem::remove(capture.sequence.probes[5].picture);
  REQUIRE(file_test::contains(error_of([&] { capture.bake_folder(); }), "5.picture: cannot be read"));
}

TEST_CASE("what a killed process left half written goes, and nothing else") {
  const Capture capture;
  const auto folder = capture.bake_folder();
  file_test::write(capture.folder.path / "bake" / ".zonal-123.tmp", "half");
  file_test::write(capture.folder.path / "bake" / "notes.txt", "mine");
  folder.clean();
  REQUIRE(!std::filesystem::exists(capture.folder.path / "bake" / ".zonal-123.tmp"));
  REQUIRE(std::filesystem::exists(capture.folder.path / "bake" / "notes.txt"));
}

TEST_CASE("every wrong bit in a file of samples, and every cut, is found") {
  const Capture capture;
  const auto folder = capture.bake_folder(2);
  sort_samples(folder, 0, capture.sequence, capture.buckets, capture.loader());
  const std::string good = file_test::bytes_of(folder.file(0));
  const auto read_all = [&] {
    zonal::SampleFile file(folder.file(0));
    std::vector<RadianceSample> samples(zonal::SampleBlock::most_buckets * 2);
    for (std::size_t block = 0; block < zonal::block_count(capture.buckets.size()); ++block) {
      file.read_block(block, samples.data(), 2);
    }
  };
  REQUIRE(error_of(read_all) == "no error");
  REQUIRE(folder.has(0));
  file_test::for_each_wrong_bit(good, 60, 29, [&](const std::string& bad, std::size_t place) {
    INFO(place);
    file_test::write(folder.file(0), bad);
    REQUIRE(error_of(read_all) != "no error");
  });
  for (std::size_t size = 0; size < good.size(); size += size < 60 ? 1 : 97) {
    INFO(size);
    file_test::write(folder.file(0), good.substr(0, size));
    REQUIRE(error_of(read_all) != "no error");
    REQUIRE(!folder.has(0));
  }
  file_test::write(folder.file(0), good + "1234");
  REQUIRE(error_of(read_all) != "no error");
  // Two blocks that changed places.
  const std::size_t first = 40, length = 4 + 64 * 2 * 12 + 8;
  file_test::write(folder.file(0), good.substr(0, first) + good.substr(first + length, length) +
                                       good.substr(first, length) + good.substr(first + 2 * length));
  REQUIRE(file_test::contains(error_of(read_all), "a block is not in its place"));
}

TEST_CASE("every wrong bit in a file of sums is found") {
  const Capture capture;
  const auto folder = capture.bake_folder();
  capture.sort(folder);
  Bake bake(folder, capture.sequence, capture.buckets, capture.grid, {});
  bake.step();
  bake.save();
  const auto path = folder.sums_file("");
  const std::string good = file_test::bytes_of(path);
  const auto done = [&] { return Bake(folder, capture.sequence, capture.buckets, capture.grid, {}).done(); };
  REQUIRE(done() == 1);
  file_test::for_each_wrong_bit(good, 40, 97, [&](const std::string& bad, std::size_t place) {
    INFO(place);
    file_test::write(path, bad);
    const bool is_fingerprint = place >= 12 && place < 20;  // of another bake, then: begins anew
    if (is_fingerprint) {
      REQUIRE(done() == 0);
    } else {
      REQUIRE(error_of([&] { done(); }) != "no error");
    }
  });
  file_test::write(path, good.substr(0, good.size() / 2));
  REQUIRE(file_test::contains(error_of([&] { done(); }), "is damaged"));
}
