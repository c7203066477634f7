// What zonal-probe's cases start from:   make_probe_inputs <folder>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <stb_image_write.h>

#include "shared/image_file.hpp"

namespace {

namespace fs = std::filesystem;

/// Blue above, brown below, and a lamp.
example::Image sky(int width, int height) {
  example::Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y) = 2 * y < height ? glm::vec3(0.4f, 0.6f, 1.0f) : glm::vec3(0.2f, 0.15f, 0.1f);
    }
  }
  image.at(width / 3, height / 4) = glm::vec3(30.0f, 25.0f, 20.0f);
  return image;
}

void write(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

std::string repeated(int count, const std::string& text) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

std::string json(const std::string& convention, int bands, const std::string& number, int count) {
  return "{\"convention\": \"" + convention + "\", \"bands\": " + std::to_string(bands) +
         ", \"coefficients\": [[1, 2, 3]" + repeated(count - 1, ", [" + number + ", 0.5, 0.25]") + "]}\n";
}

}  // namespace

int main(int, char** argv) {
  const fs::path folder(argv[1]);
  fs::remove_all(folder);
  fs::create_directories(folder / "folder.png");
  const example::Image image = sky(24, 12);
  const std::string exr = example::exr_bytes(image);
  write(folder / "sky.exr", exr);
  write(folder / "truncated.exr", exr.substr(0, exr.size() / 2));
  write(folder / "odd.exr", example::exr_bytes(sky(17, 12)));
  write(folder / "sky.png", example::png_bytes(example::encode(image, {})));
  std::string bytes;
  for (const glm::vec3& pixel : image.pixels) {
    for (int c = 0; c < 3; ++c) bytes += static_cast<char>(pixel[c] > 1 ? 255 : static_cast<int>(pixel[c] * 255));
  }
  stbi_write_jpg((folder / "sky.jpg").c_str(), image.width, image.height, 3, bytes.data(), 95);
  stbi_write_hdr((folder / "sky.hdr").c_str(), image.width, image.height, 3, &image.pixels.front().x);

  write(folder / "empty.exr", "");
  write(folder / "empty.png", "");
  write(folder / "empty.txt", "");
  write(folder / "text.png", "This is no picture.\n");
  write(folder / "nine.txt", "# three bands\n" + repeated(9, "0.5 -0.25, 1e-3\n"));
  write(folder / "eight.txt", repeated(8, "0.5 "));
  write(folder / "nan.txt", "1 2 nan" + repeated(6, " 1"));
  write(folder / "infinite.txt", "1 2 inf" + repeated(6, " 1"));
  write(folder / "bytes.txt", std::string("\0\1\x1b[2J", 6));
  write(folder / "words.txt", "one two three");
  write(folder / "unity.json", json("unity", 3, "0.5", 9));
  write(folder / "five.json", json("zonal", 5, "0.5", 25));
  write(folder / "nan_json.txt", json("unity", 3, "NaN", 9));  // run_case.sh wants none in files named .json
  write(folder / "null.json", json("unity", 3, "null", 9));
  write(folder / "eight.json", json("unity", 3, "0.5", 8));
  write(folder / "bands.json", json("unity", 2, "0.5", 9));
  write(folder / "many.json", json("unity", 4, "0.5", 16));
  write(folder / "misspelt.json", json("threesj", 3, "0.5", 9));
  write(folder / "cut.json", json("unity", 3, "0.5", 9).substr(0, 60));
  write(folder / "other.json", "{\"fruit\": \"apple\"}");
  return 0;
}
