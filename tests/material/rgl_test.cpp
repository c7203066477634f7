// RGL files: of known BRDFs, isotropic and not, and of anything else.
#include <zonal/material/even_part.hpp>
#include <zonal/material/material_table.hpp>
#include <zonal/material/rgl.hpp>

#include <cstdlib>
#include <limits>
#include <optional>

#include "../catch.hpp"
#include "../csv.hpp"
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

namespace {

/// The material's coefficients from its values alone, by the midpoint rule over half vectors whose angle to the normal
/// goes from 0 to the horizon's, `count` squared, crowded at either end: at the normal for the lobe, at the horizon
/// because f grows there as the cosine's inverse.
template <int N>
struct SlowProjection {
  zonal::Sh<N, glm::dvec3> with_cosine{}, without_cosine{};

  SlowProjection(const zonal::RglBrdf& f, const glm::dvec3& wo, int count) {
    const double sin_o = std::hypot(wo.x, wo.y), phi_o = std::atan2(wo.y, wo.x);
    for (int j = 0; j < count; ++j) {
      const double phi = 2.0 * pi * (j + 0.5) / count, horizon = 0.5 * std::atan2(wo.z, -sin_o * std::cos(phi - phi_o));
      for (int i = 0; i < count; ++i) {
        const double u = (i + 0.5) / count, a = u * u, b = std::pow(1.0 - u, 4);
        const double slope = (2.0 * u * b + 4.0 * a * b / (1.0 - u)) / ((a + b) * (a + b));  // of a / (a + b)
        const double theta = horizon * a / (a + b);
        const glm::dvec3 h = direction(theta, phi), wi = 2.0 * glm::dot(h, wo) * h - wo;
        if (wi.z <= 0.0) continue;
        const double d_theta = horizon * slope / count, d_phi = 2.0 * pi / count;
        add(wi, f(wi, wo) * (4.0 * glm::dot(h, wo) * std::sin(theta) * d_theta * d_phi));
      }
    }
  }

 private:
  void add(const glm::dvec3& wi, const glm::dvec3& weighted) {
    zonal::evaluate<N>(wi.x, wi.y, wi.z, [&](auto l, auto m, double y) {
      with_cosine(l, m) += weighted * (wi.z * y);
      if (zonal::is_even_in_z(l, m)) without_cosine(l, m) += 2.0 * weighted * y;
    });
  }
};

/// The greatest error of a projection's coefficients of m >= 0, relative to the largest.
template <int N>
double error_of_projection(const zonal::BrdfProjection<21>& got, const SlowProjection<N>& expected) {
  double with_cosine = 0.0, without_cosine = 0.0;
  for (int l = 0; l < N; ++l) {
    for (int m = 0; m <= l; ++m) {
      with_cosine = std::fmax(with_cosine, largest(got.with_cosine(l, m) - expected.with_cosine(l, m)));
      without_cosine = std::fmax(without_cosine, largest(got.without_cosine(l, m) - expected.without_cosine(l, m)));
    }
  }
  return std::fmax(with_cosine / largest_coefficient(expected.with_cosine),
                   without_cosine / largest_coefficient(expected.without_cosine));
}

zonal::BrdfProjection<21> project(const zonal::RglBrdf& brdf, const glm::dvec3& wo, double tolerance) {
  const zonal::BrdfNodes nodes = [&brdf](const glm::dvec3& from, int level, const auto& visit) {
    brdf.for_each_node(from, level, visit);
  };
  return zonal::detail::project_nodes<21>(nodes, wo.z, tolerance);
}

}  // namespace

TEST_CASE("rgl: its projection is that of the BRDF it was written from") {
  const Microfacets f{0.3, 0.3};
  RglGrid grid;
  grid.theta_nodes = 30;
  const zonal::RglBrdf brdf = read_back(f, grid);
  for (const double degrees : {0.0, 31.0, 50.0}) {
    const auto exact = zonal::project_brdf<7>(f, outgoing(degrees).z, 1e-5);
    const auto read = project(brdf, outgoing(degrees), 1e-3);
    double error = 0.0;
    for (int i = 0; i < exact.with_cosine.size(); ++i) {
      error = std::fmax(error, largest(read.with_cosine[i] - exact.with_cosine[i]));
    }
    error /= largest_coefficient(exact.with_cosine);
    CAPTURE(degrees, read.theta_nodes, read.error, error);
    CHECK(error <= 2e-3);
  }
}

TEST_CASE("rgl: the projection by the tables' pieces is the integral of the values, coarse tables and sharp ones") {
  const auto check = [](const zonal::RglBrdf& brdf, const char* what) {
    for (const double degrees : {0.0, 37.0, 85.0}) {
      const auto read = project(brdf, outgoing(degrees), 3e-3);
      const double error = error_of_projection(read, SlowProjection<7>(brdf, outgoing(degrees), 400));
      CAPTURE(what, degrees, read.error, read.theta_nodes, error);
      CHECK(read.error <= 3e-3);
      CHECK(error <= 2e-3);
    }
  };
  RglGrid coarse;  // kinks that are seen; three grids that have nothing in common
  coarse.theta_nodes = 5;
  coarse.square = 10;
  coarse.rgb = 7;
  check(read_back({0.3, 0.3}, coarse), "coarse");
  coarse.jacobian = false;
  check(read_back({0.6, 0.6}, coarse), "without jacobian");
  RglGrid sharp;
  sharp.theta_nodes = 8;
  sharp.rgb = 24;
  check(read_back({0.02, 0.02}, sharp), "sharp");
}

TEST_CASE("rgl: tables that are not mirror images of themselves, and empty rows") {
  Random random(37);
  RglGrid grid;
  grid.theta_nodes = 3;
  grid.square = grid.rgb = 6;
  std::vector<Tensor> tensors = rgl_tensors({0.6, 0.6}, grid);
  for (Tensor& tensor : tensors) {
    if (tensor.name != "vndf" && tensor.name != "rgb") continue;
    for (std::size_t k = 0; k < tensor.data.size(); k += 4) {
      const bool zero = tensor.name == "vndf" && k / 4 % 36 >= 12 && k / 4 % 36 < 24;  // two rows of each slice
      tensor.data.replace(k, 4, raw(zero ? 0.0F : random() - (tensor.name == "rgb" ? 0.2F : 0.0F)));
    }
  }
  const Folder folder;
  write(folder.path / "a.bsdf", tensor_file(tensors));
  const zonal::RglBrdf brdf = zonal::load_rgl(folder.path / "a.bsdf");
  for (const double degrees : {20.0, 70.0}) {
    const auto read = project(brdf, outgoing(degrees), 1e-3);
    const double error = error_of_projection(read, SlowProjection<7>(brdf, outgoing(degrees), 800));
    CAPTURE(degrees, read.error, error);
    CHECK(error <= 3e-3);
  }
}

TEST_CASE("rgl: the nodes of anisotropic files are a quadrature too, in whatever part of the turn wo is") {
  for (const int symmetry : {1, 2, 4}) {
    RglGrid grid;
    grid.phi_nodes = 8 / symmetry + 1;
    grid.theta_nodes = 4;
    grid.square = 12;
    grid.rgb = 8;
    grid.symmetry = symmetry;
    const zonal::RglBrdf brdf = read_back({0.3, 0.6}, grid);
    for (const double phi : {0.0, 0.4, 2.0, pi, -2.3, -0.5}) {
      const glm::dvec3 wo = direction(0.8, phi);
      zonal::Sh<4, glm::dvec3> sum{};
      brdf.for_each_node(wo, 2, [&](const glm::dvec3& wi, const glm::dvec3& weighted) {
        const auto y = zonal::evaluate<4>(wi);
        for (int i = 0; i < 16; ++i) sum[i] += weighted * (wi.z * y[i]);
      });
      const SlowProjection<4> expected(brdf, wo, 300);
      CAPTURE(symmetry, phi);
      CHECK(largest_difference(sum, expected.with_cosine) <= 1e-3 * largest_coefficient(expected.with_cosine));
    }
  }
}

TEST_CASE("rgl: of half and quarter turns, the planes of symmetry are continuous with what is beside them") {
  for (const int symmetry : {2, 4}) {
    RglGrid grid;
    grid.phi_nodes = 8 / symmetry + 1;
    grid.theta_nodes = 4;
    grid.symmetry = symmetry;
    const zonal::RglBrdf brdf = read_back({0.2, 0.6}, grid);
    for (const double x : {0.6, -0.6}) {
      for (const double zero : {0.0, -0.0}) {
        const glm::dvec3 wi(-0.3 * x, 0.2, 0.9);
        const glm::dvec3 on = brdf(glm::normalize(wi), {x, zero, 0.8}),
                         beside = brdf(glm::normalize(wi), {x, -1e-9, 0.8});
        CAPTURE(symmetry, x, zero);
        CHECK(largest(on - beside) <= 1e-6 * largest(on));
      }
    }
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

namespace {

/// ZONAL_DATA/rgl; empty where there is none, which is said.
fs::path real_files() {
  const char* data = std::getenv("ZONAL_DATA");
  const fs::path folder = fs::path(data == nullptr ? "" : data) / "rgl";
  if (data != nullptr && fs::is_directory(folder)) return folder;
  WARN("skipped: ZONAL_DATA names no folder with real files in rgl/");
  return {};
}

}  // namespace

TEST_CASE("rgl: real files, of the folder ZONAL_DATA/rgl where there is one") {
  const fs::path folder = real_files();
  if (folder.empty()) return;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".bsdf") continue;
    const zonal::RglBrdf brdf = zonal::load_rgl(entry.path());
    CAPTURE(entry.path(), brdf.description());
    // reflects some of the light, and not much more than all of it: a made one reflects 1.18
    for (const double degrees : {5.0, 62.0}) {
      const glm::dvec3 wo = outgoing(degrees);
      glm::dvec3 albedo(0.0);
      brdf.for_each_node(wo, 1, [&](const glm::dvec3& wi, const glm::dvec3& weighted) { albedo += weighted * wi.z; });
      CAPTURE(degrees, albedo.x, albedo.y, albedo.z);
      for (int c = 0; c < 3; ++c) CHECK((albedo[c] > 1e-4 && albedo[c] < 1.2));
      if (!brdf.isotropic()) continue;
      const auto read = project(brdf, wo, 3e-3);
      const double error = error_of_projection(read, SlowProjection<7>(brdf, wo, 400));
      CAPTURE(read.error, error);
      CHECK(read.error <= 3e-3);
      CHECK(error <= 2e-3);
    }
  }
}

TEST_CASE("rgl: real files have the values of the format's reference loader, ZONAL_DATA/rgl/expected.csv") {
  const fs::path folder = real_files();
  if (folder.empty()) return;
  if (!fs::exists(folder / "expected.csv")) {
    WARN("skipped: no expected.csv in " + folder.string());
    return;
  }
  std::string name;  // of the material at hand; lines: file, wi, wo, rgb
  std::optional<zonal::RglBrdf> brdf;
  int lines = 0;
  for (const std::vector<std::string>& row : read_csv_file((folder / "expected.csv").string())) {
    if (row.size() != 10 || !fs::exists(folder / row[0])) continue;
    if (row[0] != name) brdf.emplace(zonal::load_rgl(folder / (name = row[0])));
    glm::dvec3 v[3];
    for (std::size_t k = 0; k < 9; ++k) v[k / 3][int(k % 3)] = std::strtod(row[k + 1].c_str(), nullptr);
    const glm::dvec3 f = (*brdf)(v[0], v[1]);
    CAPTURE(++lines, name);
    CHECK(largest(f - v[2]) <= 1e-4 * largest(v[2]));
  }
  CHECK(lines > 0);
}
