// Projected materials as files: what is written comes back, nothing else is taken for a table, and a cache builds once.
#include <zonal/material/material_file.hpp>

#include <cstring>
#include <limits>

#include "../catch.hpp"
#include "../files.hpp"
#include "support.hpp"

using namespace material_test;
using namespace file_test;
namespace fs = std::filesystem;

namespace {

zonal::MaterialTable random_table(int bands, int angles, std::uint32_t seed = 21) {
  Random random(seed);
  std::vector<glm::vec3> rows[2];
  for (auto& table : rows) {
    for (int i = 0; i < angles * bands * (bands + 1) / 2; ++i) table.emplace_back(random(), -random(), random());
  }
  rows[0][0] = {std::numeric_limits<float>::denorm_min(), -0.0F, std::numeric_limits<float>::max()};
  return {bands, angles, 1.25e-5, rows[0], zonal::MirroredRows(rows[1])};
}

bool same_bits(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}
bool same(const zonal::MaterialTable& a, const zonal::MaterialTable& b) {
  return a.bands() == b.bands() && a.angles() == b.angles() && a.achieved_error() == b.achieved_error() &&
         same_bits(a.with_cosine_rows(), b.with_cosine_rows()) &&
         same_bits(a.without_cosine_rows(), b.without_cosine_rows());
}

std::string error_of(const fs::path& path) {
  try {
    zonal::load_material_table(path);
  } catch (const zonal::FileError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("material file: what is saved comes back to the bit, over an older file too") {
  const Folder folder;
  const fs::path path = folder.path / "a.material";
  write(path, "something else");
  for (const int bands : {1, 7, 21}) {
    for (const int angles : {1, 90}) {
      CAPTURE(bands, angles);
      const zonal::MaterialTable table = random_table(bands, angles);
      zonal::save_material_table(path, table, 0x123456789ABCDEF0U);
      CHECK(folder.files() == 1);
      CHECK(fs::file_size(path) == std::size_t(36 + 12 * angles * bands * (bands + 1) + 8));
      CHECK(same(zonal::load_material_table(path), table));
      const zonal::MaterialFileHeader header = zonal::read_material_header(path);
      CHECK(header.bands == bands);
      CHECK(header.angles == angles);
      CHECK(header.fingerprint == 0x123456789ABCDEF0U);
      CHECK(header.achieved_error == 1.25e-5);
    }
  }
}

TEST_CASE("material file: its bytes are little-endian, as stated") {
  const Folder folder;
  const fs::path path = folder.path / "a.material";
  zonal::save_material_table(path,
                             {1, 1, 0.5, {{1.5F, 0.0F, -2.0F}}, zonal::MirroredRows(std::vector{glm::vec3(0, 0, 1)})},
                             0x0102030405060708U);
  const std::string expected(
      "ZONALMAT\1\0\0\0\1\0\0\0\1\0\0\0\x8\7\6\5\4\3\2\1\0\0\0\0\0\0\xe0\x3f"
      "\0\0\xc0\x3f\0\0\0\0\0\0\0\xc0\0\0\0\0\0\0\0\0\0\0\x80\x3f",
      60);
  CHECK(bytes_of(path).substr(0, 60) == expected);
}

TEST_CASE("material file: every damaged byte, and every wrong length, is an error") {
  const Folder folder;
  const fs::path path = folder.path / "a.material";
  zonal::save_material_table(path, random_table(3, 90));
  const std::string good = bytes_of(path);
  REQUIRE(error_of(path).empty());

  for_each_wrong_bit(good, 60, 7, [&](const std::string& bad, std::size_t place) {
    write(path, bad);
    CAPTURE(place);
    REQUIRE(contains(error_of(path), path.string() + ": "));
  });
  for_each_wrong_length(good, 36, [&](const std::string& bad, std::size_t length) {
    write(path, bad);
    CAPTURE(length);
    REQUIRE(contains(error_of(path), "is "));
  });
  const auto patched = [&](std::size_t offset, std::uint32_t value) {
    write(path, good);
    patch(path, offset, raw(value));
    return error_of(path);
  };
  CHECK(contains(patched(0, 0), "is no table of a material"));
  CHECK(contains(patched(8, 2), "has version 2 of the format; this reads 1"));
  CHECK(contains(patched(12, 22), "it says it has 22 bands"));
  CHECK(contains(patched(12, 0xFFFFFFFF), "it says it has 4294967295 bands"));
  CHECK(contains(patched(16, 2), "it says it has 2 angles"));
  CHECK(contains(patched(12, 4), "its size is not what its header says"));
  CHECK(contains(patched(40, 0), "wrong checksum"));
}

TEST_CASE("material file: thousands of mutated files are errors") {
  const Folder folder;
  const fs::path path = folder.path / "a.material";
  zonal::save_material_table(path, random_table(2, 1));
  const std::string good = bytes_of(path);
  std::mt19937 random(23);
  for (int i = 0; i < 5000; ++i) {
    std::string bad = good;
    for (int changes = 1 + int(random() % 4); changes > 0; --changes) bad[random() % bad.size()] = char(random());
    if (i % 3 == 0) bad.resize(random() % (2 * good.size()));
    if (bad == good) continue;
    write(path, bad);
    CAPTURE(i);
    REQUIRE(contains(error_of(path), "a.material: "));
  }
}

TEST_CASE("material file: a cache is built once for each fingerprint, and again when it is damaged") {
  const Folder folder;
  const fs::path path = folder.path / "a.material";
  int built = 0;
  const zonal::MaterialTable table = random_table(4, 90);
  const auto build = [&] { return ++built, table; };
  const auto get = [&](std::uint64_t fingerprint) {
    return same(zonal::cached_material_table(path, fingerprint, build), table);
  };
  CHECK((get(1) && built == 1));
  CHECK((get(1) && built == 1));
  CHECK((get(2) && built == 2));
  CHECK((get(2) && built == 2));
  for (const std::size_t offset : {8U, 13U, 100U, 4000U}) {
    CAPTURE(offset);
    patch(path, offset, "\x55");
    const int before = built;
    CHECK((get(2) && built == before + 1));
    CHECK((get(2) && built == before + 1));
  }
  CHECK(folder.files() == 1);
}

TEST_CASE("material file: a cache overwrites nothing else, and fails before it builds") {
  const Folder folder;
  const auto build = []() -> zonal::MaterialTable { throw std::logic_error("built"); };
  const fs::path other = folder.path / "photograph";
  for (const std::string& content : {std::string("precious"), std::string()}) {
    write(other, content);
    CHECK_THROWS_AS(zonal::cached_material_table(other, 1, build), zonal::FileError);
    CHECK(bytes_of(other) == content);
  }
  CHECK_THROWS_AS(zonal::cached_material_table(folder.path, 1, build), zonal::FileError);
  CHECK_THROWS_AS(zonal::cached_material_table(folder.path / "nowhere" / "a", 1, build), zonal::FileError);
  CHECK_THROWS_AS(zonal::cached_material_table(folder.path / "a", 1, build), std::logic_error);
  CHECK(folder.files() == 1);  // nothing is left of what was not built
}

TEST_CASE("material file: a fingerprint tells sources, bands, tolerances and versions of the projection apart") {
  const Folder folder;
  const fs::path path = folder.path / "source";
  std::vector<std::uint64_t> all;
  std::string bytes(40000, 'x');
  for (const std::size_t size : {0U, 1U, 3U, 4U, 5U, 16384U, 16385U, 40000U}) {
    write(path, bytes.substr(0, size));
    all.push_back(zonal::material_fingerprint(path, 5, 1e-4));
    CHECK(all.back() == zonal::material_fingerprint(path, 5, 1e-4));
  }
  write(path, std::string(5, '\0'));
  all.push_back(zonal::material_fingerprint(path, 5, 1e-4));
  write(path, std::string(6, '\0'));
  for (const int bands : {5, 6}) {
    for (const double tolerance : {1e-4, 1e-3}) all.push_back(zonal::material_fingerprint(path, bands, tolerance));
  }
  for (const std::uint32_t version : {1U, 3U}) all.push_back(zonal::material_fingerprint(path, 5, 1e-4, version));
  std::sort(all.begin(), all.end());
  CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
  CHECK_THROWS_AS(zonal::material_fingerprint(folder.path / "nowhere", 5, 1e-4), zonal::FileError);
}
