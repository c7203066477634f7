// Pictures in OpenEXR files of every kind of channels, written by OpenEXR itself.
#include "shared/image_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>

#include "catch.hpp"
#include "files.hpp"
#include "shared/input_error.hpp"

namespace {

using namespace example;

/// A picture whose first pixel is (-3, 5), with one float channel.
void write_channel(const std::filesystem::path& path, const char* name, const std::vector<float>& values, int width) {
  const int height = static_cast<int>(values.size()) / width;
  const Imath::Box2i window({-3, 5}, {width - 4, height + 4});
  Imf::Header header(window, window);
  header.channels().insert(name, Imf::Channel(Imf::FLOAT));
  Imf::OutputFile file(path.c_str(), header);
  Imf::FrameBuffer buffer;
  const auto row = sizeof(float) * static_cast<std::size_t>(width);
  char* base = reinterpret_cast<char*>(const_cast<float*>(values.data())) + 3 * sizeof(float) - 5 * row;
  buffer.insert(name, Imf::Slice(Imf::FLOAT, base, sizeof(float), row));
  file.setFrameBuffer(buffer);
  file.writePixels(height);
}

}  // namespace

TEST_CASE("a grey OpenEXR file is grey, to the bit, also beyond the range of half floats") {
  const file_test::Folder folder;
  const std::vector<float> values{0.0F, 1.0F / 3, 1e6F, 1e-9F, 0.5F, 2.0F};
  write_channel(folder.path / "y.exr", "Y", values, 3);
  const Image image = read_exr(folder.path / "y.exr");
  REQUIRE((image.width == 3 && image.height == 2));
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(image.pixels[i] == glm::vec3(values[i]));
}

TEST_CASE("a luminance-chroma OpenEXR file has its colours back") {
  const file_test::Folder folder;
  constexpr int width = 32, height = 16;
  std::vector<Imf::Rgba> pixels;  // of one hue: what lies between the chroma that are kept is then known
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float brightness = 1.0F + float(x) / width + float((x * y) % 3);
      pixels.emplace_back(brightness, 0.5F * brightness, 2.0F * brightness);
    }
  }
  const Imath::Box2i window({8, -2}, {8 + width - 1, -2 + height - 1});
  {
    Imf::RgbaOutputFile file((folder.path / "yc.exr").c_str(), window, window, Imf::WRITE_YC);
    file.setYCRounding(10, 10);
    file.setFrameBuffer(pixels.data() - 8 + 2 * width, 1, width);
    file.writePixels(height);
  }
  const Image image = read_exr(folder.path / "yc.exr");
  REQUIRE((image.width == width && image.height == height));
  float worst = 0.0F;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const float expected = c == 0 ? pixels[i].r : c == 1 ? pixels[i].g : pixels[i].b;
      worst = std::max(worst, std::abs(image.pixels[i][c] / expected - 1.0F));
    }
  }
  INFO(worst);
  CHECK(worst < 4e-3F);
}

TEST_CASE("PNM of 16 bits, of numbers that overflow or without its last pixel is refused, and of 8 bits read") {
  const file_test::Folder folder;
  file_test::write(folder.path / "grey.pgm", std::string("P5 2 2 65535\n\xff\xff\x80\x00\x40\xff\x00\x00", 21));
  CHECK_THROWS_AS(read_picture(folder.path / "grey.pgm"), InputError);
  CHECK_THROWS_AS(read_texture(folder.path / "grey.pgm", TextureUse::values), InputError);
  // stb_image's int overflows; it takes no number for 0, and remarks for blanks.
  for (const std::string head :
       {"P6 2 31444444444444444444444444444444", "P5\n# wide\n9999999999\t1 255 ", "P5 2#remark\r1#9\n4294967295 "}) {
    CAPTURE(head);
    file_test::write(folder.path / "long.ppm", head + "\n\xff\xff\xff");
    CHECK_THROWS_AS(read_picture(folder.path / "long.ppm"), InputError);
    CHECK_THROWS_AS(read_texture(folder.path / "long.ppm", TextureUse::colour), InputError);
  }
  for (const std::string head : {"P5 2 1 ", "P5 x 9999999999 1 255 ", "P5 2 1 255", "P6 2 1 255\nabcde"}) {
    CAPTURE(head);
    file_test::write(folder.path / "short.ppm", head);
    CHECK_THROWS_AS(read_picture(folder.path / "short.ppm"), InputError);
  }
  file_test::write(folder.path / "grey.pgm", std::string("P5#a remark\n2 1#9999999999\r255\n\xff\x33", 33));
  const Image image = read_picture(folder.path / "grey.pgm");
  REQUIRE((image.width == 2 && image.height == 1));
  CHECK(image.pixels[0] == glm::vec3(1));
  CHECK(image.pixels[1] == decode_srgb(glm::vec3(51.0F / 255.0F)));
}

TEST_CASE("a picture of no pixels, or of more than memory is there for, is refused before it is read") {
  const file_test::Folder folder;
  const auto error_of = [&](const std::string& name, std::int64_t most_pixels) -> std::string {
    try {
      read_picture(folder.path / name, most_pixels);
    } catch (const InputError& failure) {
      return failure.what();
    }
    return "";
  };
  file_test::write(folder.path / "flat.ppm", "P6 2 0 255\nabcdef");
  CHECK(file_test::contains(error_of("flat.ppm", 100), "flat.ppm: "));
  file_test::write(folder.path / "wide.ppm", "P6 16777000 16777000 255\nabcdef");
  CHECK(file_test::contains(error_of("wide.ppm", most_picture_pixels), "is of 16777000x16777000 pixels, more than"));
  file_test::write(folder.path / "six.ppm", "P6 2 3 255\nabcdefghijklmnopqr");
  write_channel(folder.path / "six.exr", "Y", {1, 2, 3, 4, 5, 6}, 3);
  for (const std::string name : {"six.ppm", "six.exr"}) {
    CAPTURE(name);
    CHECK(error_of(name, 6).empty());
    CHECK(file_test::contains(error_of(name, 5), " pixels, more than 5"));
  }
}

TEST_CASE("an OpenEXR file whose pixels lie far from (0, 0) is read as any") {
  const file_test::Folder folder;
  const Imath::Box2i window({-1000000000, 900000000}, {-1000000000 + 2, 900000000 + 1});
  Imf::Header header(window, window);
  header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
  const std::vector<float> values{0.0F, 1, 2, 3, 4, 5};
  {
    Imf::OutputFile file((folder.path / "far.exr").c_str(), header);
    Imf::FrameBuffer buffer;
    buffer.insert("Y", Imf::Slice::Make(Imf::FLOAT, values.data(), window));
    file.setFrameBuffer(buffer);
    file.writePixels(2);
  }
  const Image image = read_exr(folder.path / "far.exr");
  REQUIRE((image.width == 3 && image.height == 2));
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(image.pixels[i] == glm::vec3(values[i]));
}

TEST_CASE("a file without colours is refused by name of what it lacks") {
  const file_test::Folder folder;
  write_channel(folder.path / "z.exr", "Z", {1, 2, 3, 4}, 2);
  std::string error;
  try {
    read_exr(folder.path / "z.exr");
  } catch (const InputError& failure) {
    error = failure.what();
  }
  CHECK(file_test::contains(error, "z.exr: has no channels R, G and B, nor Y"));
}
