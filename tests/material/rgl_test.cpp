// RGL files: of known BRDFs, isotropic and not, and of anything else.
#include <zonal/material/even_part.hpp>
#include <zonal/material/material_table.hpp>
#include <zonal/material/rgl.hpp>

#include <cstdlib>
#include <limits>

#include "../catch.hpp"
#include "tensor_writer.hpp"

using namespace material_test;
using namespace file_test;
namespace fs = std::filesystem;

namespace {

zonal::RglBrdf read_back(const Microfacets& f, const RglGrid& grid) {
  const Folder folder;
  write(folder.path / "a.bsdf", tensor_file(rgl_tensors(f, grid)));
  return zonal::load_rgl(folder.path / "a.bsdf");
}

std::string error_of(const fs::path& path) {
  try {
    zonal::load_rgl(path);
  } catch (const zonal::FileError& error) {
    return error.what();
  }
  return {};
}

/// The greatest error over random directions within `degrees` of the normal, relative to the greatest value. Half of
/// them are near the mirror direction.
double interpolation_error(const zonal::RglBrdf& brdf, const Microfacets& f, double degrees, std::uint32_t seed) {
  Random random(seed);
  double worst = 0.0, peak = 0.0;
  const double lowest = std::cos(degrees * pi / 180.0);
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 wo = glm::normalize(glm::dvec3(random.direction())), other(random.direction());
    const glm::dvec3 wi = glm::normalize(i % 2 == 0 ? other : glm::dvec3(-wo.x, -wo.y, wo.z) + 0.2 * other);
    if (wi.z < lowest || wo.z < lowest) continue;
    worst = std::fmax(worst, largest(brdf(wi, wo) - f(wi, wo)));
    peak = std::fmax(peak, largest(f(wi, wo)));
  }
  return worst / peak;
}

}  // namespace

TEST_CASE("rgl: an isotropic file's material is the BRDF it was written from, within the interpolation error") {
  for (const double alpha : {0.2, 0.5}) {
    const Microfacets f{alpha, alpha};
    for (const bool jacobian : {true, false}) {
      for (const int phi_nodes : {1, 2}) {
        RglGrid grid;
        grid.jacobian = jacobian;
        grid.phi_nodes = phi_nodes;
        const zonal::RglBrdf brdf = read_back(f, grid);
        CHECK(brdf.isotropic());
        CHECK(brdf.description() == "microfacets");
        const double error = interpolation_error(brdf, f, 60.0, 31);
        CAPTURE(alpha, jacobian, phi_nodes, error);
        CHECK(error <= (alpha == 0.2 ? 1e-2 : 2e-2));
      }
    }
  }
}

TEST_CASE("rgl: at an outgoing direction of the file, the error falls with the square of the grid's spacing") {
  const Microfacets f{0.3, 0.3};
  double errors[2];
  for (int level = 0; level < 2; ++level) {
    RglGrid grid;
    grid.square = level == 0 ? 33 : 65;
    grid.rgb = level == 0 ? 25 : 49;
    grid.theta_nodes = 6;
    const zonal::RglBrdf brdf = read_back(f, grid);
    Random random(32);
    double worst = 0.0;
    for (int i = 0; i < 4000; ++i) {
      const glm::dvec3 wo = direction(double(float(pi / 6.0)), 2.0 * pi * double(random())), wi(random.direction());
      if (wi.z < 0.5) continue;
      worst = std::fmax(worst, largest(brdf(wi, wo) - f(wi, wo)));
    }
    errors[level] = worst / largest(f(direction(pi / 6.0, pi), direction(pi / 6.0, 0.0)));
  }
  CAPTURE(errors[0], errors[1]);
  CHECK(errors[1] < 1e-3);
  CHECK(errors[1] < 0.35 * errors[0]);
}

TEST_CASE("rgl: anisotropic files of the whole turn, its half and its quarter") {
  const Microfacets f{0.25, 0.5};
  for (const int symmetry : {1, 2, 4}) {
    RglGrid grid;
    grid.phi_nodes = 32 / symmetry + 1;
    grid.square = 48;
    grid.rgb = 32;
    grid.symmetry = symmetry;
    const zonal::RglBrdf brdf = read_back(f, grid);
    CHECK_FALSE(brdf.isotropic());
    CHECK(brdf.symmetry() == symmetry);
    const double error = interpolation_error(brdf, f, 60.0, 33);
    CAPTURE(symmetry, error);
    CHECK(error <= 2e-2);
  }
}

TEST_CASE("rgl: the warp is the cumulative distribution of the blended densities, rows first") {
  constexpr std::size_t rows = 4, columns = 7, slices = 6;
  Random random(36);
  std::vector<float> density(slices * rows * columns);
  for (float& x : density) x = random() < 0.3F ? 0.0F : random();
  const zonal::detail::SquareWarp warp({rows, columns}, density);

  // each slice as a function, and its integral, by midpoints of a grid that the samples are part of
  constexpr int fine = 120;
  std::vector<std::vector<double>> cells(slices, std::vector<double>(fine * fine));
  for (std::size_t slice = 0; slice < slices; ++slice) {
    const auto first = density.begin() + std::ptrdiff_t(slice * rows * columns);
    const zonal::detail::SquareFunction f{{rows, columns}, {first, first + std::ptrdiff_t(rows * columns)}};
    double total = 0.0;
    for (int i = 0; i < fine * fine; ++i) {
      total += cells[slice][std::size_t(i)] = f({(i % fine + 0.5) / fine, (i / fine + 0.5) / fine});
    }
    for (double& cell : cells[slice]) cell /= total;
  }
  for (int trial = 0; trial < 200; ++trial) {
    const zonal::detail::NodePair phi{0, 1, double(random())}, theta{1, 2, double(random())};
    const zonal::detail::SliceBlend blend = zonal::detail::slice_blend(phi, theta, 3);
    const int column = 1 + int(random() * (fine - 1)), row = 1 + int(random() * (fine - 1));
    double below = 0.0, left = 0.0, whole_row = 0.0;
    for (int y = 0; y <= row; ++y) {
      for (int x = 0; x < fine; ++x) {
        double cell = 0.0;
        for (std::size_t k = 0; k < 4; ++k) cell += blend.weight[k] * cells[blend.slice[k]][std::size_t(y * fine + x)];
        if (y < row) below += cell;
        // along the row at the edge between two rows of cells: their mean
        if (y + 1 >= row) whole_row += 0.5 * cell;
        if (y + 1 >= row && x < column) left += 0.5 * cell;
      }
    }
    const glm::dvec2 place = warp({column / double(fine), row / double(fine)}, blend);
    CAPTURE(trial, column, row);
    CHECK(std::abs(place.y - below) < 1e-5);
    // at a row of samples the density has a kink, which the mean of two rows rounds off
    CHECK(std::abs(place.x - left / whole_row) < (row % (fine / (int(rows) - 1)) == 0 ? 2e-2 : 1e-5));
  }
  CHECK_THROWS_AS(zonal::detail::SquareWarp({2, 2}, std::vector<float>{0, -1, 0, 0}), std::invalid_argument);
}

TEST_CASE("rgl: zero at and below the horizon, finite above it") {
  const zonal::RglBrdf brdf = read_back({0.3, 0.3}, {});
  Random random(34);
  for (int i = 0; i < 5000; ++i) {
    glm::dvec3 wi(random.direction()), wo(random.direction());
    if (i % 2 == 0) wi.z *= 1e-6;
    if (i % 3 == 0) wo.z *= 1e-12;
    wi = glm::normalize(wi), wo = glm::normalize(wo);
    const glm::dvec3 f = brdf(wi, wo);
    CAPTURE(wi.x, wi.y, wi.z, wo.x, wo.y, wo.z);
    for (int c = 0; c < 3; ++c) CHECK((std::isfinite(f[c]) && f[c] >= 0.0));
    CHECK(brdf({wi.x, wi.y, -wi.z}, wo) == glm::dvec3(0.0));
    CHECK(brdf(wi, {wo.x, wo.y, 0.0}) == glm::dvec3(0.0));
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {nan, 1e300, -1e300}) {
    brdf({bad, 0.0, 1.0}, {0.0, bad, 1.0});  // nothing to expect but to come back
    brdf({0.0, bad, 1e300}, {bad, bad, 1.0});
  }
}

TEST_CASE("rgl: its projection is that of the BRDF it was written from") {
  const Microfacets f{0.3, 0.3};
  RglGrid grid;
  grid.theta_nodes = 30;
  const zonal::RglBrdf brdf = read_back(f, grid);
  for (const double degrees : {0.0, 31.0, 50.0}) {
    const double cosine = std::cos(degrees * pi / 180.0);
    const auto exact = zonal::project_brdf<7>(f, cosine, 1e-5);
    const auto read = zonal::project_brdf<7>(zonal::even_part(brdf), cosine, 1e-3);
    const double error =
        largest_difference(read.with_cosine, exact.with_cosine) / largest_coefficient(exact.with_cosine);
    CAPTURE(degrees, read.theta_nodes, read.error, error);
    CHECK(error <= 2e-3);
  }
}

TEST_CASE("rgl: each thing wrong with a file is its own error") {
  const Folder folder;
  const fs::path path = folder.path / "a.bsdf";
  RglGrid grid;
  grid.theta_nodes = 2;
  grid.square = 4;
  grid.rgb = 3;
  const std::vector<Tensor> good = rgl_tensors({0.5, 0.5}, grid);
  const auto error_with = [&](const auto& change) {
    std::vector<Tensor> tensors = good;
    change(tensors);
    write(path, tensor_file(tensors));
    return error_of(path);
  };
  REQUIRE(error_with([](auto&) {}).empty());
  const auto named = [](std::vector<Tensor>& tensors, const std::string& name) -> Tensor& {
    return *std::find_if(tensors.begin(), tensors.end(), [&](const Tensor& t) { return t.name == name; });
  };
  for (std::size_t i = 0; i < good.size(); ++i) {
    CAPTURE(good[i].name);
    CHECK(
        contains(error_with([&](auto& t) { t.erase(t.begin() + std::ptrdiff_t(i)); }), "has no field " + good[i].name));
    CHECK(contains(error_with([&](auto& t) { t[i].type = 2 + 7 * (i % 2 == 0 ? 0 : 1); }), "a.bsdf: is damaged: "));
    CHECK(
        contains(error_with([&](auto& t) { t[i].shape.push_back(1); }), "the dimensions of its field " + good[i].name));
    CHECK(contains(error_with([&](auto& t) { t.push_back(t[i]); }), "two fields of one name"));
    CHECK(contains(error_with([&](auto& t) { t[i].shape[0] = std::uint64_t{1} << 60; }), "is damaged: "));
    CHECK(contains(error_with([&](auto& t) { t[i].shape = {0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF}; }), "is damaged: "));
    if (good[i].name != "description") {
      CHECK(contains(error_with([&](auto& t) { t[i].shape[0] = 0; }), "do not go together"));
    }
    if (good[i].type != 10 || good[i].name == "luminance") continue;
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
      const std::string last = std::to_string(good[i].data.size() / 4 - 1);
      const auto change = [&](auto& t) { t[i].data.replace(t[i].data.size() - 4, 4, raw(bad)); };
      CHECK(contains(error_with(change), "element " + last + " of " + good[i].name + " is no number"));
    }
  }
  const auto replaced = [&](const std::string& name, float value) {
    return error_with([&](auto& t) {
      std::string& data = named(t, name).data;
      for (std::size_t k = 0; k < data.size(); k += 4) data.replace(k, 4, raw(value));
    });
  };
  CHECK(contains(replaced("vndf", 0.0F), "a density of vndf is zero everywhere"));
  CHECK(contains(replaced("vndf", -1.0F), "a density of vndf is zero everywhere"));
  CHECK(contains(replaced("theta_i", 1.0F), "element 1 of theta_i"));
  CHECK(contains(replaced("theta_i", 1e30F), "element 0 of theta_i"));
  CHECK(contains(error_with([&](auto& t) { t.push_back(float_tensor("spectra", {1}, {1.0F})); }), "spectral"));
  CHECK(contains(error_with([&](auto& t) { named(t, "ndf").shape = {16, 1}; }), "do not go together: ndf"));

  write(path, tensor_file(good));
  patch(path, 12, "\2");
  CHECK(contains(error_of(path), "has version 2.0 of the format; this reads 1.0"));
  write(path, "tensor_fill" + tensor_file(good).substr(11));
  CHECK(contains(error_of(path), "is no tensor file"));
  CHECK(contains(error_of(folder.path), "is not a file"));
  CHECK(contains(error_of(folder.path / "nowhere"), "nowhere: "));
}

TEST_CASE("rgl: every truncation is an error") {
  const Folder folder;
  const fs::path path = folder.path / "a.bsdf";
  RglGrid grid;
  grid.theta_nodes = 2;
  grid.square = 3;
  grid.rgb = 2;
  const std::string good = tensor_file(rgl_tensors({0.5, 0.5}, grid));
  for (std::size_t size = 0; size < good.size(); ++size) {
    write(path, good.substr(0, size));
    CAPTURE(size, good.size());
    REQUIRE(contains(error_of(path), "a.bsdf: "));
  }
}

TEST_CASE("rgl: thousands of mutated files are errors, or materials that can be asked for their values") {
  const Folder folder;
  const fs::path path = folder.path / "a.bsdf";
  RglGrid grid;
  grid.square = 3;
  grid.rgb = 2;
  grid.theta_nodes = 2;
  std::mt19937 random(35);
  int errors = 0, materials = 0;
  for (int i = 0; i < 6000; ++i) {
    grid.phi_nodes = 1 + i % 3;
    std::string bytes = tensor_file(rgl_tensors({0.4, 0.6}, grid));
    const std::size_t list = 340;  // the list of fields ends about there
    for (int changes = 1 + int(random() % 3); changes > 0; --changes) {
      bytes[random() % (i % 4 == 0 ? bytes.size() : list)] = char(i % 5 == 0 ? 0xFF : random());
    }
    if (i % 16 == 0) bytes.resize(random() % (bytes.size() + 100));
    write(path, bytes);
    CAPTURE(i);
    try {
      const zonal::RglBrdf brdf = zonal::load_rgl(path);
      ++materials;
      for (const double degrees : {0.0, 40.0, 89.0}) {
        for (const double phi : {-3.0, 0.0, 2.0}) {
          const glm::dvec3 f = brdf(direction(0.7, phi), outgoing(degrees));
          for (int c = 0; c < 3; ++c) REQUIRE((std::isfinite(f[c]) && f[c] >= 0.0));
        }
      }
    } catch (const zonal::FileError& error) {
      ++errors;
      REQUIRE(contains(error.what(), "a.bsdf: "));
    }
  }
  CAPTURE(errors, materials);
  CHECK(errors > 3000);
  CHECK(materials > 300);
}

TEST_CASE("rgl: real files, of the folder ZONAL_DATA/rgl where there is one") {
  const char* data = std::getenv("ZONAL_DATA");
  const fs::path folder = fs::path(data == nullptr ? "" : data) / "rgl";
  if (data == nullptr || !fs::is_directory(folder)) {
    WARN("skipped: ZONAL_DATA names no folder with real files in rgl/");
    return;
  }
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".bsdf") continue;
    const zonal::RglBrdf brdf = zonal::load_rgl(entry.path());
    CAPTURE(entry.path(), brdf.description());
    // reflects some of the light, and no more than all of it
    for (const double degrees : {5.0, 30.0, 60.0}) {
      glm::dvec3 albedo(0.0);
      midpoint_hemisphere(400, 400, [&](const glm::dvec3& wi, double solid_angle) {
        albedo += brdf(wi, outgoing(degrees)) * (wi.z * solid_angle);
      });
      CAPTURE(degrees, albedo.x, albedo.y, albedo.z);
      for (int c = 0; c < 3; ++c) CHECK((albedo[c] > 1e-4 && albedo[c] < 1.1));
    }
  }
}
