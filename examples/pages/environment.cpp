// The light of a picture of all directions in nine numbers a channel: reads a PFM file (portable float map), or, where
// none is named, makes a sky. Standard library alone:
//
//   g++ -std=c++17 -O2 -Iinclude examples/pages/environment.cpp -o environment && ./environment [picture.pfm [mapping]]
#include <zonal/environment/guess.hpp>
#include <zonal/environment/irradiance.hpp>
#include <zonal/environment/project.hpp>
#include <zonal/environment/reconstruct_picture.hpp>
#include <zonal/zonal.hpp>

#include <array>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

using Rgb = zonal::Rgb<float>;  // or glm::vec3, Eigen::Vector3f, a struct of three floats
using Vec3 = std::array<float, 3>;

struct Texels {
  std::vector<float> numbers;
  int width, height;
};

// "PF", width, height, -1 and the numbers, little-endian, the lowest row first.
Texels read(const char* path) {
  std::ifstream file(path, std::ios::binary);
  std::string mark;
  float order = 0;
  Texels t{{}, 0, 0};
  file >> mark >> t.width >> t.height >> order;
  file.get();
  if (!file || mark != "PF" || !(order < 0)) throw std::runtime_error("no little-endian colour PFM file");
  if (t.width < 1 || t.height < 1 || t.width > 32768 || t.height > 32768)
    throw std::runtime_error("a size beyond 32768");
  t.numbers.resize(3 * std::size_t(t.width) * std::size_t(t.height));
  const auto bytes = std::streamsize(t.numbers.size() * sizeof(float));
  if (!file.read(reinterpret_cast<char*>(t.numbers.data()), bytes)) throw std::runtime_error("the file is cut off");
  return t;
}

// A blue sky over brown ground, and a sun ahead to the left.
Texels sky() {
  Texels t{std::vector<float>(3 * 256 * 128), 256, 128};
  const zonal::Equirectangular mapping(256, 128);
  for (int row = 0; row < 128; ++row) {
    for (int column = 0; column < 256; ++column) {
      const auto d = mapping.direction(column + 0.5, row + 0.5);  // x forward, y left, z up
      const Rgb colour = 0.48 * d[0] + 0.64 * d[1] + 0.6 * d[2] > 0.99 ? Rgb{60, 55, 40}
                         : d[2] > 0                                    ? Rgb{0.4F, 0.6F, 1}
                                                                       : Rgb{0.2F, 0.15F, 0.1F};
      for (int c = 0; c < 3; ++c) t.numbers[std::size_t(3 * (256 * row + column) + c)] = colour[c];
    }
  }
  return t;
}

int run(int argc, char** argv) {
  const Texels texels = argc > 1 ? read(argv[1]) : sky();
  auto picture = zonal::Picture<const float>::of(texels.numbers, texels.width, texels.height);
  if (argc > 1) {  // the lowest row comes first in the file: a view that goes upwards
    picture.data = picture.at(0, texels.height - 1);
    picture.row_stride = -picture.row_stride;
  }
  zonal::Mapping mapping{};
  const bool is_known = argc > 2 ? zonal::find_mapping(argv[2], mapping) : zonal::guess_mapping(picture, mapping);
  if (!is_known) throw std::runtime_error("which mapping is it?");

  zonal::PictureFaults faults;
  const zonal::Environment environment(picture, mapping);
  const zonal::Sh<3, Rgb> radiance = zonal::project<3>(environment, zonal::SerialForEach{}, &faults);
  const zonal::Sh<3, Rgb> over_pi = zonal::irradiance_over_pi(radiance);
  std::printf("%d x %d, %s, %zu numbers that are no radiance\n", texels.width, texels.height,
              zonal::mapping_name(mapping), faults.total());
  std::printf(" l  m  radiance                    E / pi\n");
  for (int l = 0; l < 3; ++l) {
    for (int m = -l; m <= l; ++m) {
      const Rgb a = radiance(l, m), b = over_pi(l, m);
      std::printf("%2d %2d %8.4f %8.4f %8.4f  %8.4f %8.4f %8.4f\n", l, m, double(a.r), double(a.g), double(a.b),
                  double(b.r), double(b.g), double(b.b));
    }
  }
  const Rgb floor = zonal::reconstruct(over_pi, Vec3{0, 0, 1}), wall = zonal::reconstruct(over_pi, Vec3{0, 1, 0});
  std::printf("white floor %.3f %.3f %.3f, wall that looks left %.3f %.3f %.3f\n", double(floor.r), double(floor.g),
              double(floor.b), double(wall.r), double(wall.g), double(wall.b));

  std::vector<float> map(3 * 16 * 16);  // E / pi by the normal, as a texture
  zonal::reconstruct(over_pi, zonal::Mapping::octahedral, zonal::Picture<float>(map.data(), 16, 16));
  return 0;
}

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "environment: %s\n", error.what());
    return 1;
  }
}

// It prints:
//   256 x 128, equirectangular, 0 numbers that are no radiance
//    l  m  radiance                    E / pi
//    0  0   2.1205   2.2942   2.6414    2.1205   2.2942   2.6414
//    1 -1  -1.1695  -1.0675  -0.7653   -0.7797  -0.7117  -0.5102
//    1  0   1.4001   1.6885   2.0969    0.9334   1.1257   1.3979
//    1  1  -0.8695  -0.7936  -0.5690   -0.5797  -0.5291  -0.3793
//    2 -2   1.2360   1.1281   0.8088    0.3090   0.2820   0.2022
//    2 -1  -1.5535  -1.4180  -1.0166   -0.3884  -0.3545  -0.2541
//    2  0   0.0934   0.0853   0.0611    0.0234   0.0213   0.0153
//    2  1  -1.1547  -1.0539  -0.7556   -0.2887  -0.2635  -0.1889
//    2  2  -0.3716  -0.3391  -0.2431   -0.0929  -0.0848  -0.0608
//   white floor 1.069 1.211 1.438, wall that looks left 1.023 1.034 1.023

