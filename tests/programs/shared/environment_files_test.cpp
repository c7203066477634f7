// Real environments, of the folder ZONAL_DATA where there is one: *.exr and *_cross.hdr.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <zonal/environment/guess.hpp>
#include <zonal/environment/project.hpp>
#include <zonal/environment/project_reference.hpp>

#include "catch.hpp"
#include "shared/image_file.hpp"

namespace {

namespace fs = std::filesystem;
using zonal::Rgb;
using Pixels = zonal::Picture<const float>;

/// Empty where there are none, which is said.
std::vector<fs::path> real_environments() {
  std::vector<fs::path> files;
  const char* data = std::getenv("ZONAL_DATA");
  if (data != nullptr && fs::is_directory(data)) {
    for (const auto& entry : fs::directory_iterator(data)) {
      const std::string name = entry.path().filename().string();
      if (entry.path().extension() == ".exr" || name.find("_cross.hdr") != std::string::npos)
        files.push_back(entry.path());
    }
  }
  if (files.empty()) WARN("skipped: ZONAL_DATA names no folder with environments, *.exr or *_cross.hdr");
  return files;
}

/// The greatest difference, in units of a colour's first coefficient.
template <int N, class A, class B>
double difference(const zonal::Sh<N, A>& a, const zonal::Sh<N, B>& b) {
  double worst = 0;
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < N * N; ++i) {
      const double d = std::abs(double(a[i][c]) - double(b[i][c])) / double(b[0][c]);
      worst = d <= worst ? worst : d;
    }
  }
  return worst;
}

template <int N, class Element>
void check_fast(const zonal::Environment<Element>& environment) {
  CAPTURE(N);
  for (const auto rule : {zonal::TexelRule::constant_exact, zonal::TexelRule::middles}) {
    const auto plain = zonal::project_by_texel<N>(environment, rule);
    const auto fast = zonal::project<N>(environment, zonal::SerialForEach{}, nullptr, rule);
    const double error = difference(fast, plain);
    CAPTURE(error, int(rule));
    CHECK(error < 2e-6);
    std::printf(" %d bands %.1e", N, error);
  }
}

/// The picture in another mapping: of each texel nine parts, each to the texel where it comes to lie, so that none of
/// the light is lost; where that is beside a disc, to the next that is on it.
std::vector<float> remapped(const zonal::Environment<float>& source, zonal::Mapping kind, int width, int height) {
  std::vector<double> light(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::vector<float> numbers(light.size());
  zonal::PictureFaults faults;
  const auto first = [&](int column, int row) {
    return 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column));
  };
  source.visit([&](const auto& from) {
    zonal::Environment<float>(Pixels::of(numbers, width, height), kind).visit([&](const auto& to) {
      for (int row = 0; row < source.height(); ++row) {
        for (int column = 0; column < source.width(); ++column) {
          if (!from.has_direction(column, row)) continue;
          const Rgb<double> part =
              Rgb<double>(source.radiance(column, row, faults)) * (from.solid_angle(column, row) / 9);
          for (int k = 0; k < 9; ++k) {
            auto place = to.texel(from.direction(column + (k % 3 + 0.5) / 3, row + (k / 3 + 0.5) / 3));
            while (!to.has_direction(int(place[0]), int(place[1]))) {
              for (std::size_t i = 0; i < 2; ++i) place[i] += (0.5 * width - place[i]) / width;
            }
            for (int c = 0; c < 3; ++c) light[first(int(place[0]), int(place[1])) + std::size_t(c)] += part[c];
          }
        }
      }
      for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
          const double solid_angle = to.solid_angle(column, row);
          for (std::size_t c = 0; c < 3 && solid_angle > 0; ++c) {
            numbers[first(column, row) + c] = static_cast<float>(light[first(column, row) + c] / solid_angle);
          }
        }
      }
    });
  });
  return numbers;
}

}  // namespace

TEST_CASE("environments: real ones, projected by rows and by octants, equal the plain sum") {
  for (const fs::path& file : real_environments()) {
    const example::Image image = example::read_picture(file);
    const Pixels picture(&image.pixels.data()->x, image.width, image.height);
    const auto environment = zonal::guess_environment(picture);
    CAPTURE(file.string());
    std::printf("%-16s %d x %d, %s:", file.filename().c_str(), image.width, image.height,
                zonal::mapping_name(environment.mapping()));
    check_fast<3>(environment);
    check_fast<5>(environment);
    check_fast<9>(environment);
    float brightest = 0;
    zonal::PictureFaults faults;
    zonal::project<1>(environment, zonal::SerialForEach{}, &faults);
    for (const glm::vec3& pixel : image.pixels) brightest = std::max(brightest, pixel.y);
    std::printf(", brightest green %.0f, %zu numbers no radiance\n", double(brightest), faults.total());

    // As half floats; what is beyond them is infinite, and counted.
    std::vector<zonal::Half> halves;
    for (const glm::vec3& pixel : image.pixels) {
      for (int c = 0; c < 3; ++c) halves.push_back(zonal::to_half(pixel[c]));
    }
    const zonal::Environment<zonal::Half> half(zonal::Picture<const zonal::Half>::of(halves, image.width, image.height),
                                               environment.mapping());
    CHECK(difference(zonal::project<3>(half), zonal::project_by_texel<3>(half)) < 2e-6);
  }
}

TEST_CASE("environments: real ones in every other mapping have the same coefficients") {
  for (const fs::path& file : real_environments()) {
    const example::Image image = example::read_picture(file);
    const auto source = zonal::guess_environment(Pixels(&image.pixels.data()->x, image.width, image.height));
    const auto expected = zonal::project<3, Rgb<double>>(source);
    std::printf("%-16s", file.filename().c_str());
    for (int i = 0; i < zonal::kMappingCount; ++i) {
      const auto kind = zonal::Mapping(i);
      const int size = 256;  // texels from pole to pole, or a face's
      const int shape[zonal::kMappingCount][2] = {{4, 2}, {3, 4}, {4, 3}, {1, 6}, {6, 1}, {4, 4}, {4, 4}, {4, 4}};
      const int width = shape[i][0] * size / 2, height = shape[i][1] * size / 2;
      const std::vector<float> numbers = remapped(source, kind, width, height);
      const zonal::Environment<float> other(Pixels::of(numbers, width, height), kind);
      const double error = difference(zonal::project<3, Rgb<double>>(other), expected);
      CAPTURE(file.string(), zonal::mapping_name(kind), width, height, error);
      // Texels are pi / 256 wide: a light that comes to lie a little beside its place is the worst.
      CHECK(error < 5e-4);
      std::printf(" %s %.0e", zonal::mapping_name(kind), error);
    }
    std::printf("\n");
  }
}
