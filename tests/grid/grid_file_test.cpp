// Grids as files: what is written comes back, and nothing else is taken for a grid.
#include <zonal/grid/grid_file.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "../catch.hpp"
#include "../files.hpp"

namespace fs = std::filesystem;
using namespace file_test;

namespace {

constexpr int N = 3;

zonal::CoefficientGrid<N> random_grid() {
  zonal::CoefficientGrid<N> grid({-1, 0.1F, 2}, {1, 3.3F, 1e6F}, {3, 2, 4});
  std::mt19937 random(81);
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::generate_n(grid.data(), grid.size(), [&] { return uniform(random); });
  grid.data()[0] = std::numeric_limits<float>::denorm_min();
  grid.data()[1] = -0.0F;
  grid.data()[2] = std::numeric_limits<float>::infinity();
  grid.data()[3] = std::numeric_limits<float>::quiet_NaN();
  return grid;
}

std::string error_of(const fs::path& path) {
  try {
    zonal::load_grid<N>(path);
  } catch (const zonal::GridFileError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("grid file: what is saved comes back to the bit, over an older file too") {
  const Folder folder;
  const fs::path path = folder.path / "a.grid";
  write(path, "something else");
  const auto grid = random_grid();
  zonal::save_grid(path, grid);
  CHECK(folder.files() == 1);
  CHECK(fs::file_size(path) == 60 + 4 * grid.size() + 8);

  const auto header = zonal::read_grid_header(path);
  CHECK(header.bands == N);
  CHECK(header.resolution == grid.resolution());
  const auto loaded = zonal::load_grid<N>(path);
  CHECK(loaded.low() == grid.low());
  CHECK(loaded.high() == grid.high());
  CHECK(loaded.resolution() == grid.resolution());
  REQUIRE(loaded.size() == grid.size());
  CHECK(std::memcmp(loaded.data(), grid.data(), 4 * grid.size()) == 0);
}

TEST_CASE("grid file: its bytes are little-endian, as stated") {
  const Folder folder;
  const fs::path path = folder.path / "a.grid";
  zonal::CoefficientGrid<1> grid({0, 0, 0}, {1, 2, 4}, {2, 2, 3});
  grid.data()[0] = 1.5F;  // 0x3FC00000
  zonal::save_grid(path, grid);
  const std::string expected(
      "ZONALGRD\1\0\0\0\1\0\0\0\2\0\0\0\2\0\0\0\3\0\0\0"
      "\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\x40\0\0\x80\x40"
      "\x90\0\0\0\0\0\0\0\0\0\xc0\x3f",
      64);
  CHECK(bytes_of(path).substr(0, 64) == expected);
}

TEST_CASE("grid file: in 16 bits what is saved comes back as half floats, in half the space") {
  const Folder folder;
  const fs::path path = folder.path / "a.grid";
  const auto grid = random_grid();  // with a denormal, -0, infinity and NaN
  zonal::save_grid(path, grid, zonal::GridNumbers::halves);
  CHECK(fs::file_size(path) == 60 + 2 * grid.size() + 8);
  CHECK(zonal::read_grid_header(path).numbers == zonal::GridNumbers::halves);
  const auto loaded = zonal::load_grid<N>(path);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const float expected = zonal::to_float(zonal::to_half(grid.data()[i]));
    INFO(i);
    CHECK(std::memcmp(&expected, &loaded.data()[i], 4) == 0);
  }

  const std::string good = bytes_of(path);
  for_each_wrong_bit(good, 64, 301, [&](const std::string& bad, std::size_t) {
    write(path, bad);
    CHECK(!error_of(path).empty());
  });
  write(path, good.substr(0, good.size() - 2));
  CHECK(!error_of(path).empty());

  // An odd number of numbers: the last word holds one, and 0.
  zonal::CoefficientGrid<1, zonal::GridContent::values> odd({0, 0, 0}, {1, 1, 1}, {3, 3, 3});
  for (std::size_t i = 0; i < odd.size(); ++i) odd.data()[i] = float(i);
  zonal::save_grid(path, odd, zonal::GridNumbers::halves);
  CHECK(fs::file_size(path) == 60 + 4 * 41 + 8);
  const auto back = zonal::load_grid<1, zonal::GridContent::values>(path);
  CHECK(std::equal(odd.data(), odd.data() + odd.size(), back.data()));

  odd.data()[5] = 65519;
  zonal::save_grid(path, odd, zonal::GridNumbers::halves);
  odd.data()[5] = -65520;
  const std::string before = bytes_of(path);
  CHECK_THROWS_WITH(zonal::save_grid(path, odd, zonal::GridNumbers::halves),
                    Catch::Matchers::EndsWith("cannot be written in 16 bits, which hold numbers up to 65504 alone"));
  CHECK(bytes_of(path) == before);
}

TEST_CASE("grid file: a link to a file stays a link") {
  const Folder folder;
  const fs::path path = folder.path / "a.grid", link = folder.path / "link.grid";
  write(path, "old");
  fs::create_symlink(path, link);
  zonal::save_grid(link, random_grid());
  CHECK(fs::is_symlink(link));
  CHECK(zonal::read_grid_header(path).bands == N);
}

TEST_CASE("grid file: any one bit that is wrong, and any other length, is an error") {
  const Folder folder;
  const fs::path path = folder.path / "a.grid";
  zonal::save_grid(path, random_grid());
  const std::string good = bytes_of(path);
  REQUIRE(error_of(path).empty());

  for_each_wrong_bit(good, 80, 37, [&](const std::string& bad, std::size_t place) {
    write(path, bad);
    CAPTURE(place);
    REQUIRE(contains(error_of(path), path.string() + ": "));
  });
  for_each_wrong_length(good, 60, [&](const std::string& bad, std::size_t length) {
    write(path, bad);
    CAPTURE(length);
    REQUIRE(contains(error_of(path), "is "));
  });
  std::string huge = good;
  std::fill(huge.begin() + 16, huge.begin() + 28, '\x7F');  // 2139062143 vertices on each axis
  write(path, huge);
  CHECK(contains(error_of(path), "its resolution does not go with its size"));
  std::string newer = good;
  newer[8] = 2;
  write(path, newer);
  CHECK(contains(error_of(path), "has version 2 of the format; this reads 1"));
}

TEST_CASE("grid file: errors name the file and leave nothing behind") {
  const Folder folder;
  CHECK(contains(error_of(folder.path / "nowhere"), "nowhere: "));
  CHECK(contains(error_of(folder.path), "is not a file"));
  zonal::save_grid(folder.path / "two.grid", zonal::CoefficientGrid<2>({0, 0, 0}, {1, 1, 1}, {2, 2, 2}));
  CHECK(contains(error_of(folder.path / "two.grid"), "has 2 bands, not 3"));

  CHECK_THROWS_AS(zonal::save_grid(folder.path / "nowhere" / "a.grid", random_grid()), zonal::GridFileError);
  CHECK_THROWS_AS(zonal::save_grid(folder.path, random_grid()), zonal::GridFileError);
  CHECK(folder.files() == 1);
}
