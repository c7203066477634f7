// MERL files: of known BRDFs, in the format's own order and scales, and of anything else.
#include <zonal/material/even_part.hpp>
#include <zonal/material/material_table.hpp>
#include <zonal/material/merl.hpp>

#include <cstdlib>
#include <limits>

#include "../catch.hpp"
#include "../files.hpp"
#include "merl_writer.hpp"
#include "support.hpp"

using namespace material_test;
using namespace file_test;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t bins = merl_bins, header_size = 12, file_size = header_size + 24 * bins;

std::string error_of(const fs::path& path) {
  try {
    zonal::load_merl(path);
  } catch (const zonal::FileError& error) {
    return error.what();
  }
  return {};
}

const std::vector<Named>& measured_materials() {
  static const std::vector<Named> list{{"Lambert", {{zonal::LambertBrdf{{0.7F, 0.5F, 0.2F}}}}},
                                       {"gold 0.1", ggx(0.1F, gold())},
                                       {"gold 0.3", ggx(0.3F, gold())},
                                       {"gold 1", ggx(1.0F, gold())}};
  return list;
}

/// All materials, read back from their files.
const std::vector<zonal::MerlBrdf>& read_back() {
  static const std::vector<zonal::MerlBrdf> list = [] {
    const Folder folder;
    const fs::path path = folder.path / "a.binary";
    std::vector<zonal::MerlBrdf> result;
    for (const auto& named : measured_materials()) {
      write(path, merl_bytes(named.brdf));
      result.push_back(zonal::load_merl(path));
    }
    return result;
  }();
  return list;
}

}  // namespace

TEST_CASE("merl: half and difference angles are those of the rotations that define them, turned about z too") {
  Random random(11);
  for (int i = 0; i < 2000; ++i) {
    const double half = double(random()) * 0.5 * pi, theta = double(random()) * 0.5 * pi;
    const double phi = (2.0 * double(random()) - 1.0) * pi, turn = 2.0 * pi * double(random());
    Pair pair = directions(half, theta, phi);
    for (glm::dvec3* v : {&pair.wi, &pair.wo}) {
      *v = {std::cos(turn) * v->x - std::sin(turn) * v->y, std::sin(turn) * v->x + std::cos(turn) * v->y, v->z};
    }
    if (half < 1e-3 || theta < 1e-3) continue;  // phi is ill-conditioned there
    const auto angles = zonal::half_difference_angles(pair.wi, pair.wo);
    CAPTURE(half, theta, phi, turn);
    CHECK(std::abs(angles.theta_half - half) < 2e-15 / std::cos(theta));
    CHECK(std::abs(angles.theta_difference - theta) < 2e-15);
    CHECK(std::abs(std::remainder(angles.phi_difference - phi, 2.0 * pi)) < 1e-11);
  }
  const auto normal = zonal::half_difference_angles(glm::dvec3(0, 0, 1), glm::dvec3(0, 0, 1));
  CHECK(normal.theta_half == 0.0);
  CHECK(normal.theta_difference == 0.0);
}

TEST_CASE("merl: at the middle of a bin, a file's material is the BRDF it was written from") {
  Random random(12);
  for (std::size_t k = 0; k < measured_materials().size(); ++k) {
    for (int i = 0; i < 3000; ++i) {
      const int half = int(random() * 90), theta = int(random() * 90), phi = int(random() * 180);
      const Pair pair = middle(half, theta, phi);
      if (pair.wi.z <= 1e-9 || pair.wo.z <= 1e-9) continue;
      const glm::dvec3 exact = evaluate(measured_materials()[k].brdf, pair.wi, pair.wo);
      const glm::dvec3 read = read_back()[k](pair.wi, pair.wo);
      CAPTURE(measured_materials()[k].name, half, theta, phi);
      for (int c = 0; c < 3; ++c) CHECK(std::abs(read[c] - exact[c]) <= 1e-6 * exact[c]);
    }
  }
}

TEST_CASE("merl: between the middles it is within the stated interpolation error") {
  Random random(13);
  for (std::size_t k = 0; k < measured_materials().size(); ++k) {
    double worst = 0.0, peak = 0.0;
    for (int i = 0; i < 40000; ++i) {
      const glm::dvec3 wo(random.direction());
      const double spread = std::pow(10.0, -3.0 * double(random()));
      const glm::dvec3 wi = glm::normalize(glm::dvec3(-wo.x, -wo.y, wo.z) + spread * glm::dvec3(random.direction()));
      if (wi.z < std::cos(80.0 * pi / 180.0) || wo.z < std::cos(80.0 * pi / 180.0)) continue;
      const glm::dvec3 exact = evaluate(measured_materials()[k].brdf, wi, wo);
      worst = std::fmax(worst, largest(read_back()[k](wi, wo) - exact));
      peak = std::fmax(peak, largest(exact));
    }
    CAPTURE(measured_materials()[k].name, worst, peak);
    CHECK(worst <= (k == 1 ? 6e-3 : 3.5e-3) * peak);
  }
}

TEST_CASE("merl: reciprocal, isotropic, zero at and below the horizon, finite everywhere") {
  Random random(14);
  const zonal::MerlBrdf& brdf = read_back()[1];
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 wi = glm::normalize(glm::dvec3(random.direction()));
    const glm::dvec3 wo = glm::normalize(glm::dvec3(random.direction()));
    const glm::dvec3 f = brdf(wi, wo);
    CAPTURE(wi.x, wi.y, wi.z, wo.x, wo.y, wo.z);
    CHECK(largest(f - brdf(wo, wi)) <= 1e-9 * (1.0 + largest(f)));
    CHECK(largest(f - brdf({-wi.y, wi.x, wi.z}, {-wo.y, wo.x, wo.z})) <= 1e-9 * (1.0 + largest(f)));
    CHECK(brdf({wi.x, wi.y, -wi.z}, wo) == glm::dvec3(0.0));
    CHECK(brdf(wi, {wo.x, wo.y, 0.0}) == glm::dvec3(0.0));
  }
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity, 1e300}) {
    brdf({bad, 0.0, 1.0}, {0.0, bad, 1.0});  // nothing to expect but to come back
    brdf({0.0, bad, bad}, {0.0, 0.0, 1.0});
  }
  for (const double z : {1e-12, 1e-300}) {
    const glm::dvec3 f = brdf({1.0, 0.0, z}, {-1.0, 0.0, z});
    CHECK((std::isfinite(f.x) && f.x >= 0.0));
  }
}

TEST_CASE("merl: samples not measured are left out, channel by channel") {
  std::vector<glm::vec3> samples(bins, glm::vec3(2.0F, 3.0F, 4.0F));
  const auto index = [](int half, int theta, int phi) { return std::size_t(phi + 180 * (theta + 90 * half)); };
  samples[index(40, 20, 100)] = {-1.0F, 7.0F, 4.0F};
  for (int half = 60; half < 62; ++half) {
    for (int theta = 30; theta < 32; ++theta) {
      for (int phi = 90; phi < 92; ++phi) samples[index(half, theta, phi)] = glm::vec3(-0.5F);
    }
  }
  const zonal::MerlBrdf brdf(samples);
  const auto at = [&](double half, double theta, double phi) {
    const double root = (half + 0.5) / 90.0;
    const Pair pair = directions(root * root * 0.5 * pi, (theta + 0.5) / 90.0 * 0.5 * pi, (phi + 0.5) / 180.0 * pi);
    return brdf(pair.wi, pair.wo);
  };
  CHECK(largest(at(40.25, 20.0, 100.0) - glm::dvec3(2.0, 6.0, 4.0)) < 1e-9);
  CHECK(largest(at(60.5, 30.5, 90.5)) == 0.0);
  CHECK(largest(at(59.5, 30.5, 90.5) - glm::dvec3(2.0, 3.0, 4.0)) < 1e-9);
}

TEST_CASE("merl: phi_difference is periodic: the last bin meets the first") {
  std::vector<glm::vec3> samples(bins, glm::vec3(0.0F));
  for (std::size_t i = 0; i < bins; i += 180) samples[i] = glm::vec3(8.0F);
  const zonal::MerlBrdf brdf(samples);
  for (const double step : {0.0, 0.25, 0.75, 1.0}) {
    const Pair pair = directions(0.5, 0.4, (0.5 - step) / 180.0 * pi);
    CAPTURE(step);
    CHECK(brdf(pair.wi, pair.wo).x == Approx(8.0 * (1.0 - step)).margin(1e-9));
    CHECK(brdf(pair.wo, pair.wi).x == Approx(8.0 * (1.0 - step)).margin(1e-9));
  }
}

TEST_CASE("merl: its projection is that of the BRDF it was written from") {
  for (std::size_t k = 0; k < measured_materials().size(); ++k) {
    const auto exact_function = [&](const glm::dvec3& wi, const glm::dvec3& wo) {
      return evaluate(measured_materials()[k].brdf, wi, wo);
    };
    for (const double degrees : {0.0, 30.0, 60.0}) {
      const double cosine = std::cos(degrees * pi / 180.0);
      const auto exact = zonal::project_brdf<7>(exact_function, cosine, 1e-5);
      const auto read = zonal::project_brdf<7>(zonal::even_part(read_back()[k]), cosine, 1e-3);
      const double error =
          largest_difference(read.with_cosine, exact.with_cosine) / largest_coefficient(exact.with_cosine);
      CAPTURE(measured_materials()[k].name, degrees, read.theta_nodes, read.error);
      CHECK(error <= 2e-3);
    }
  }
}

TEST_CASE("merl: a file's header, size and samples are checked, each with its error") {
  const Folder folder;
  const fs::path path = folder.path / "a.binary";
  write(path, merl_bytes([](const glm::dvec3&, const glm::dvec3&) { return glm::dvec3(0.3); }));
  REQUIRE(fs::file_size(path) == file_size);
  REQUIRE(error_of(path).empty());

  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, -nan, infinity, -infinity, 1e300, -1e40}) {
    for (const std::size_t sample : {std::size_t{0}, bins + 4711, 3 * bins - 1}) {
      const std::size_t offset = header_size + 8 * sample;
      std::string before(8, '\0');
      std::ifstream(path, std::ios::binary).seekg(std::streamoff(offset)).read(before.data(), 8);
      patch(path, offset, raw(bad));
      CAPTURE(bad, sample);
      CHECK(contains(error_of(path), "a.binary: is damaged: sample " + std::to_string(sample % bins) + " of channel " +
                                         std::to_string(sample / bins)));
      patch(path, offset, before);
    }
  }
  REQUIRE(error_of(path).empty());

  for (const std::size_t size : {file_size - 1, file_size + 1, file_size / 2, 2 * file_size}) {
    fs::resize_file(path, size);
    CAPTURE(size);
    CHECK(contains(error_of(path), "has " + std::to_string(size) + " bytes, not the 34992012 of a MERL file"));
  }
  fs::resize_file(path, file_size);
  for (std::size_t count = 0; count < 3; ++count) {
    for (const std::int32_t value : {0, 91, -90, 360, 0x7FFFFFFF}) {
      patch(path, 4 * count, raw(value));
      CAPTURE(count, value);
      CHECK(contains(error_of(path), "is no MERL file: its count " + std::to_string(count) + " is "));
    }
    patch(path, 4 * count, raw(std::int32_t{count == 2 ? 180 : 90}));
  }

  write(path, merl_bytes([](const glm::dvec3&, const glm::dvec3&) { return glm::dvec3(-1.0); }));
  CHECK(contains(error_of(path), "no sample was measured"));
  CHECK(contains(error_of(folder.path), "is not a file"));
  CHECK(contains(error_of(folder.path / "nowhere"), "nowhere: "));
}

TEST_CASE("merl: thousands of files that are none are errors") {
  const Folder folder;
  const fs::path path = folder.path / "a.binary";
  std::mt19937 random(15);
  const std::string header = raw(std::int32_t{90}) + raw(std::int32_t{90}) + raw(std::int32_t{180});
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = i % 2 == 0 ? header : std::string();
    bytes.resize(i < 40 ? std::size_t(i) : random() % 200);
    for (std::size_t b = i % 2 == 0 ? header.size() : 0; b < bytes.size(); ++b) bytes[b] = char(random());
    if (i % 4 == 0 && !bytes.empty()) bytes[random() % bytes.size()] = char(random());
    write(path, bytes);
    CAPTURE(i, bytes.size());
    REQUIRE(contains(error_of(path), "a.binary: "));
  }
}

TEST_CASE("merl: a whole file with random bytes in it is an error, or a material that can be asked for its values") {
  const Folder folder;
  const fs::path path = folder.path / "a.binary";
  write(path, merl_bytes([](const glm::dvec3&, const glm::dvec3&) { return glm::dvec3(0.3); }));
  std::mt19937 random(16);
  int errors = 0;
  for (int i = 0; i < 24; ++i) {
    std::string noise(8 + random() % 2000, '\0');
    for (char& byte : noise) byte = char(random());
    patch(path, header_size + 8 * (random() % (3 * bins - 300)), noise.substr(0, i % 2 == 0 ? 3 : noise.size()));
    CAPTURE(i);
    try {
      const zonal::MerlBrdf brdf = zonal::load_merl(path);
      Random directions_of(17);
      for (int k = 0; k < 2000; ++k) {
        const glm::dvec3 f = brdf(glm::dvec3(directions_of.direction()), glm::dvec3(directions_of.direction()));
        for (int c = 0; c < 3; ++c) REQUIRE((std::isfinite(f[c]) && f[c] >= 0.0));
      }
    } catch (const zonal::FileError& error) {
      ++errors;
      REQUIRE(contains(error.what(), "is damaged: sample "));
      write(path, merl_bytes([](const glm::dvec3&, const glm::dvec3&) { return glm::dvec3(0.3); }));
    }
  }
  CHECK((errors > 0 && errors < 24));
}

TEST_CASE("merl: real files, of the folder ZONAL_DATA/merl where there is one") {
  const char* data = std::getenv("ZONAL_DATA");
  const fs::path folder = fs::path(data == nullptr ? "" : data) / "merl";
  if (data == nullptr || !fs::is_directory(folder)) {
    WARN("skipped: ZONAL_DATA names no folder with real files in merl/");
    return;
  }
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".binary") continue;
    const zonal::MerlBrdf brdf = zonal::load_merl(entry.path());
    CAPTURE(entry.path());
    // reflects some of the light, and no more than all of it
    for (const double degrees : {0.0, 30.0, 60.0}) {
      glm::dvec3 albedo(0.0);
      midpoint_hemisphere(200, 400, [&](const glm::dvec3& wi, double solid_angle) {
        albedo += brdf(wi, outgoing(degrees)) * (wi.z * solid_angle);
      });
      CAPTURE(degrees, albedo.x, albedo.y, albedo.z);
      for (int c = 0; c < 3; ++c) CHECK((albedo[c] > 1e-3 && albedo[c] < 1.05));
    }
  }
}
