#include "image_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>
#include <ImfStdIO.h>
#include <stb_image.h>
#include <stb_image_write.h>

#include "input_error.hpp"

namespace example {
namespace {

/// A few bytes may say that they are any number of pixels, of which each takes memory.
void check_size(const std::filesystem::path& path, std::int64_t width, std::int64_t height, std::int64_t most) {
  if (width <= most && height <= most && width * height <= most) return;
  throw InputError(path.string() + ": is of " + std::to_string(width) + "x" + std::to_string(height) +
                   " pixels, more than " + std::to_string(most));
}

template <class Sample>
struct StbPicture {
  int width = 0, height = 0;
  std::vector<Sample> samples;
};

/// The digits of the next number in a PNM file's head, after blanks and remarks; none where something else stands
/// there.
std::string pnm_digits(std::istream& file) {
  const auto is_blank = [](int c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
  const auto is_in_line = [&] { return file.peek() != '\n' && file.peek() != '\r' && file.good(); };
  while (is_blank(file.peek()) || file.peek() == '#') {
    if (file.get() == '#') {
      while (is_in_line()) file.get();
    }
  }
  std::string digits;
  while (file.peek() >= '0' && file.peek() <= '9') digits += static_cast<char>(file.get());
  return digits;
}

struct PnmHead {
  std::int64_t width = 0, height = 0, samples_per_pixel = 0, start = 0;
};

/// Of a PNM file of bytes. Refuses what stb_image 2.27 does not read as it should: numbers that overflow it, and
/// samples of 16 bits, for which it reads beyond its memory, and in the wrong order.
std::optional<PnmHead> pnm_head(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  char magic[2] = {};
  file.read(magic, 2);
  if (magic[0] != 'P' || (magic[1] != '5' && magic[1] != '6')) return std::nullopt;
  const auto next = [&]() -> std::int64_t {
    const std::string digits = pnm_digits(file);
    if (digits.empty() || digits.size() > 9) throw InputError(path + ": has no head as a PNM file has");
    return std::stoi(digits);
  };
  PnmHead head;
  head.width = next();
  head.height = next();
  if (next() > 255) throw InputError(path + ": is PNM of 16 bits, which is not read; PNG is");
  head.samples_per_pixel = magic[1] == '6' ? 3 : 1;
  file.clear();
  head.start = file.tellg() + std::streamoff{1};
  return head;
}

/// stb_image does not miss pixels that are not there.
void check_is_whole(const std::string& path, const PnmHead& head) {
  const std::int64_t end = head.start + head.width * head.height * head.samples_per_pixel;
  if (end > static_cast<std::int64_t>(std::filesystem::file_size(path))) {
    throw InputError(path + ": ends before its last pixel");
  }
}

/// Before stb_image is asked for anything else of a file. How many channels it has; 3 where none can tell.
int check_for_stb(const std::string& path, std::int64_t most_pixels) {
  const std::optional<PnmHead> pnm = pnm_head(path);
  int width = 0, height = 0, channels = 3;
  if (stbi_info(path.c_str(), &width, &height, &channels) != 0) check_size(path, width, height, most_pixels);
  if (pnm) check_is_whole(path, *pnm);
  return channels;
}

/// By a function of stb_image; with 1 or 3 channels, whatever the file has.
template <class Sample>
StbPicture<Sample> read_by_stb(const std::string& path, Sample* (*load)(const char*, int*, int*, int*, int),
                               int channels) {
  int width = 0, height = 0, in_file = 0;
  const std::unique_ptr<Sample, decltype(&stbi_image_free)> read(load(path.c_str(), &width, &height, &in_file, 0),
                                                                 &stbi_image_free);
  if (!read) throw InputError(path + ": cannot be read as a picture (" + one_line(stbi_failure_reason()) + ")");
  if (width < 1 || height < 1) throw InputError(path + ": has no pixels");
  StbPicture<Sample> picture{width, height, {}};
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  picture.samples.reserve(pixels * static_cast<std::size_t>(channels));
  for (std::size_t i = 0; i < pixels; ++i) {
    const Sample* pixel = read.get() + i * static_cast<std::size_t>(in_file);
    for (int c = 0; c < channels; ++c) picture.samples.push_back(pixel[in_file < 3 ? 0 : c]);
  }
  return picture;
}

/// value: what the three samples of a pixel stand for.
template <class Sample, class Value>
Image image_of(const StbPicture<Sample>& picture, const Value& value) {
  Image image(picture.width, picture.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Sample* pixel = picture.samples.data() + 3 * i;
    image.pixels[i] = value(glm::vec3(pixel[0], pixel[1], pixel[2]));
  }
  return image;
}

template <class Sample, class Value>
std::vector<float> floats_of(const StbPicture<Sample>& picture, const Value& value) {
  std::vector<float> floats(picture.samples.size());
  std::transform(picture.samples.begin(), picture.samples.end(), floats.begin(), value);
  return floats;
}

bool is_exr(const std::filesystem::path& path) { return path.extension() == ".exr" || path.extension() == ".EXR"; }

const std::vector<const char*> colour_channels{"R", "G", "B"}, grey_channel{"Y"}, chroma_channels{"RY", "BY"};

/// The frame buffer that OpenEXR reads from and writes to, for an image whose first pixel is `origin`. names: the
/// channels in the file of red, green and blue, as far as they are there.
Imf::FrameBuffer frame_buffer(Image& image, const Imath::V2i& origin, const std::vector<const char*>& names) {
  Imf::FrameBuffer buffer;
  const std::size_t pixel_stride = sizeof(glm::vec3);
  const std::size_t row_stride = pixel_stride * static_cast<std::size_t>(image.width);
  for (std::size_t channel = 0; channel < names.size(); ++channel) {
    const float* first = &image.pixels.front()[static_cast<int>(channel)];
    buffer.insert(names[channel],
                  Imf::Slice::Make(Imf::FLOAT, first, origin, image.width, image.height, pixel_stride, row_stride));
  }
  return buffer;
}

bool has_channels(const Imf::InputFile& file, const std::vector<const char*>& names) {
  const Imf::ChannelList& channels = file.header().channels();
  return std::all_of(names.begin(), names.end(),
                     [&](const char* name) { return channels.findChannel(name) != nullptr; });
}

Image image_of(const std::filesystem::path& path, const Imath::Box2i& window, std::int64_t most_pixels) {
  const std::int64_t width = std::int64_t{1} + window.max.x - window.min.x;
  const std::int64_t height = std::int64_t{1} + window.max.y - window.min.y;
  check_size(path, width, height, most_pixels);
  return {static_cast<int>(width), static_cast<int>(height)};
}

Image read_channels(const std::filesystem::path& path, Imf::InputFile& file, const std::vector<const char*>& names,
                    std::int64_t most_pixels) {
  const Imath::Box2i window = file.header().dataWindow();
  Image image = image_of(path, window, most_pixels);
  file.setFrameBuffer(frame_buffer(image, window.min, names));
  file.readPixels(window.min.y, window.max.y);
  return image;
}

/// Chroma of a quarter of the pixels, which OpenEXR itself turns into colours, in half precision.
Image read_luminance_chroma(const std::filesystem::path& path, std::int64_t most_pixels) {
  Imf::RgbaInputFile file(path.c_str());
  const Imath::Box2i window = file.dataWindow();
  Image image = image_of(path, window, most_pixels);
  std::vector<Imf::Rgba> pixels(image.pixels.size());
  // OpenEXR addresses by absolute pixel coordinates: where pixel (0, 0) would be, which may be nowhere.
  const std::intptr_t before = window.min.x + std::intptr_t{window.min.y} * image.width;
  const auto first = reinterpret_cast<std::uintptr_t>(pixels.data());
  file.setFrameBuffer(reinterpret_cast<Imf::Rgba*>(first - static_cast<std::uintptr_t>(before) * sizeof(Imf::Rgba)), 1,
                      static_cast<std::size_t>(image.width));
  file.readPixels(window.min.y, window.max.y);
  std::transform(pixels.begin(), pixels.end(), image.pixels.begin(),
                 [](const Imf::Rgba& pixel) { return glm::vec3(pixel.r, pixel.g, pixel.b); });
  return image;
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
  for (const char* channel : colour_channels) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  Imf::StdOSStream stream;
  {
    // Its destructor completes the file.
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(frame_buffer(pixels, {0, 0}, colour_channels));
    file.writePixels(radiance.height);
  }
  return stream.str();
}

std::string picture_bytes(const std::filesystem::path& path, const Image& radiance, const Display& display) {
  return is_exr(path) ? exr_bytes(radiance) : png_bytes(encode(radiance, display));
}

Image read_exr(const std::filesystem::path& path, std::int64_t most_pixels) {
  check_is_file(path);
  try {
    Imf::InputFile file(path.c_str());
    if (has_channels(file, colour_channels)) return read_channels(path, file, colour_channels, most_pixels);
    if (!has_channels(file, grey_channel)) throw InputError(path.string() + ": has no channels R, G and B, nor Y");
    if (has_channels(file, chroma_channels)) return read_luminance_chroma(path, most_pixels);
    Image image = read_channels(path, file, grey_channel, most_pixels);
    for (glm::vec3& pixel : image.pixels) pixel = glm::vec3(pixel.x);
    return image;
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(path.string() + ": cannot be read as OpenEXR (" + one_line(error.what()) + ")");
  }
}

Image read_picture(const std::filesystem::path& path, std::int64_t most_pixels) {
  if (is_exr(path)) return read_exr(path, most_pixels);
  check_is_file(path);
  const std::string name = path.string();
  check_for_stb(name, most_pixels);
  if (stbi_is_hdr(name.c_str()) != 0) {
    return image_of(read_by_stb(name, stbi_loadf, 3), [](const glm::vec3& radiance) { return radiance; });
  }
  return image_of(read_by_stb(name, stbi_load, 3), [](const glm::vec3& bytes) { return decode_srgb(bytes / 255.0f); });
}

bool is_encoded_for_display(const std::filesystem::path& path) {
  return !is_exr(path) && stbi_is_hdr(path.string().c_str()) == 0;
}

Texture read_texture(const std::filesystem::path& path, TextureUse use, std::int64_t most_pixels) {
  if (is_exr(path)) {
    Image image = read_exr(path, most_pixels);
    blacken_non_finite(image);
    std::vector<float> linear;
    for (const glm::vec3& pixel : image.pixels) linear.insert(linear.end(), {pixel.r, pixel.g, pixel.b});
    return {image.width, image.height, 3, std::move(linear)};
  }
  check_is_file(path);
  const std::string name = path.string();
  const int channels = check_for_stb(name, most_pixels) < 3 ? 1 : 3;
  if (stbi_is_hdr(name.c_str()) != 0) {
    const auto picture = read_by_stb(name, stbi_loadf, channels);
    return {picture.width, picture.height, channels, floats_of(picture, [](float value) { return value; })};
  }
  if (stbi_is_16_bit(name.c_str()) != 0) {
    const auto picture = read_by_stb(name, stbi_load_16, channels);
    return {picture.width, picture.height, channels, floats_of(picture, [use](stbi_us sample) {
              const float share = static_cast<float>(sample) / 65535.0f;
              return use == TextureUse::colour ? decode_srgb(glm::vec3(share)).r : share;
            })};
  }
  StbPicture<std::uint8_t> picture = read_by_stb(name, stbi_load, channels);
  return {picture.width, picture.height, channels, std::move(picture.samples), use};
}

}  // namespace example
