#include "image_file.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <stb_image.h>
#include <stb_image_write.h>

#include "input_error.hpp"

namespace example {
namespace {

/// What stb_image gives is freed by it.
template <class Sample>
using StbSamples = std::unique_ptr<Sample, decltype(&stbi_image_free)>;

/// load(path, width, height) of stb_image, and what a sample stands for.
template <class Sample, class Value>
Image read_by_stb(const std::string& path, Sample* (*load)(const char*, int*, int*, int*, int), const Value& value) {
  int width = 0, height = 0, channels = 0;
  const StbSamples<Sample> samples(load(path.c_str(), &width, &height, &channels, 3), &stbi_image_free);
  if (!samples) throw InputError(path + ": cannot be read as a picture (" + one_line(stbi_failure_reason()) + ")");
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Sample* pixel = samples.get() + 3 * i;
    image.pixels[i] = value(glm::vec3(pixel[0], pixel[1], pixel[2]));
  }
  return image;
}

constexpr std::array<const char*, 3> channel_names{"R", "G", "B"};

/// The frame buffer that OpenEXR reads from and writes to, for an image whose first pixel is `origin`.
Imf::FrameBuffer frame_buffer(Image& image, int origin_x, int origin_y) {
  Imf::FrameBuffer buffer;
  const std::size_t pixel_stride = sizeof(glm::vec3);
  const std::size_t row_stride = pixel_stride * static_cast<std::size_t>(image.width);
  for (std::size_t channel = 0; channel < channel_names.size(); ++channel) {
    float* first = &image.pixels.front()[static_cast<int>(channel)];
    // OpenEXR addresses by absolute pixel coordinates.
    char* base = reinterpret_cast<char*>(first) - static_cast<std::ptrdiff_t>(pixel_stride) * origin_x -
                 static_cast<std::ptrdiff_t>(row_stride) * origin_y;
    buffer.insert(channel_names[channel], Imf::Slice(Imf::FLOAT, base, pixel_stride, row_stride));
  }
  return buffer;
}

}  // namespace

// Both go through memory, because neither library tells of every write that fails, as on a full disk.

std::string png_bytes(const Image& encoded) {
  std::vector<std::uint8_t> samples;
  samples.reserve(encoded.pixels.size() * 3);
  for (const glm::vec3& pixel : encoded.pixels) {
    for (int channel = 0; channel < 3; ++channel) {
      samples.push_back(static_cast<std::uint8_t>(std::lround(255.0f * glm::clamp(pixel[channel], 0.0f, 1.0f))));
    }
  }
  std::string bytes;
  const auto append = [](void* target, void* data, int size) {
    static_cast<std::string*>(target)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  if (stbi_write_png_to_func(append, &bytes, encoded.width, encoded.height, 3, samples.data(), encoded.width * 3) ==
      0) {
    throw std::runtime_error("cannot encode a PNG file");
  }
  return bytes;
}

std::string exr_bytes(const Image& radiance) {
  Image pixels = radiance;
  Imf::Header header(radiance.width, radiance.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const char* channel : channel_names) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  Imf::StdOSStream stream;
  {
    // Its destructor completes the file.
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frame_buffer(pixels, 0, 0));
    file.writePixels(radiance.height);
  }
  return stream.str();
}

std::string picture_bytes(const std::filesystem::path& path, const Image& radiance, const Display& display) {
  return path.extension() == ".exr" ? exr_bytes(radiance) : png_bytes(encode(radiance, display));
}

Image read_exr(const std::filesystem::path& path) {
  check_is_file(path);
  try {
    Imf::InputFile file(path.c_str());
    for (const char* channel : channel_names) {
      if (file.header().channels().findChannel(channel) == nullptr) {
        throw InputError(path.string() + ": no channel " + channel);
      }
    }
    const Imath::Box2i window = file.header().dataWindow();
    Image image(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1);
    file.setFrameBuffer(frame_buffer(image, window.min.x, window.min.y));
    file.readPixels(window.min.y, window.max.y);
    return image;
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(path.string() + ": cannot be read as OpenEXR (" + one_line(error.what()) + ")");
  }
}

Image read_picture(const std::filesystem::path& path) {
  if (path.extension() == ".exr") return read_exr(path);
  check_is_file(path);
  const std::string name = path.string();
  if (stbi_is_hdr(name.c_str()) != 0) {
    return read_by_stb<float>(name, stbi_loadf, [](const glm::vec3& radiance) { return radiance; });
  }
  return read_by_stb<stbi_uc>(name, stbi_load, [](const glm::vec3& bytes) { return decode_srgb(bytes / 255.0f); });
}

}  // namespace example
