#include "texture.hpp"

#include <array>
#include <cmath>
#include <utility>

#include "image.hpp"

namespace example {
namespace {

using Decoded = std::array<float, 256>;

template <class Value>
Decoded decode_bytes(const Value& value) {
  Decoded decoded;
  for (std::size_t byte = 0; byte < decoded.size(); ++byte) decoded[byte] = value(static_cast<float>(byte) / 255.0f);
  return decoded;
}

const float* decoded_bytes(TextureUse use) {
  static const Decoded shares = decode_bytes([](float share) { return share; });
  static const Decoded srgb = decode_bytes([](float share) { return decode_srgb(glm::vec3(share)).r; });
  return (use == TextureUse::colour ? srgb : shares).data();
}

/// The two texels about a place along one axis, and the share of the second.
struct Neighbours {
  int first, second;
  float share;
};

Neighbours neighbours(float place, int size, bool clamped) {
  float inside = clamped ? glm::clamp(place, 0.0f, 1.0f) : place - std::floor(place);
  if (!(inside >= 0.0f)) inside = 0.0f;  // of no number
  const float texels = inside * static_cast<float>(size) - 0.5f;
  const float below = std::floor(texels);
  const auto at = [&](int i) {
    if (clamped) return glm::clamp(i, 0, size - 1);
    return i < 0 ? i + size : i >= size ? i - size : i;
  };
  const int first = static_cast<int>(below);
  return {at(first), at(first + 1), texels - below};
}

}  // namespace

Texture::Texture(int width, int height, int channels, std::vector<std::uint8_t> bytes, TextureUse use)
    : width_(width),
      height_(height),
      channels_(channels),
      bytes_(std::move(bytes)),
      decoded_(decoded_bytes(use)),
      mean_(mean_of_texels()) {}

Texture::Texture(int width, int height, int channels, std::vector<float> linear)
    : width_(width), height_(height), channels_(channels), linear_(std::move(linear)), mean_(mean_of_texels()) {}

glm::vec3 Texture::texel(int x, int y) const {
  const std::size_t first =
      (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) *
      static_cast<std::size_t>(channels_);
  const auto sample = [&](std::size_t i) { return decoded_ != nullptr ? decoded_[bytes_[i]] : linear_[i]; };
  return channels_ == 1 ? glm::vec3(sample(first)) : glm::vec3(sample(first), sample(first + 1), sample(first + 2));
}

glm::vec3 Texture::mean_of_texels() const {
  glm::dvec3 sum(0.0);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) sum += glm::dvec3(texel(x, y));
  }
  return sum / (static_cast<double>(width_) * static_cast<double>(height_));
}

glm::vec3 Texture::at(const glm::vec2& place, bool clamped) const {
  const Neighbours x = neighbours(place.x, width_, clamped), y = neighbours(1.0f - place.y, height_, clamped);
  const glm::vec3 above = glm::mix(texel(x.first, y.first), texel(x.second, y.first), x.share);
  const glm::vec3 below = glm::mix(texel(x.first, y.second), texel(x.second, y.second), x.share);
  return glm::mix(above, below, y.share);
}

glm::vec2 Texture::gradient(const glm::vec2& place, bool clamped) const {
  const glm::vec2 size(width_, height_);
  const glm::vec2 right(0.5f / size.x, 0.0f), up(0.0f, 0.5f / size.y);
  return size * glm::vec2(at(place + right, clamped).r - at(place - right, clamped).r,
                          at(place + up, clamped).r - at(place - up, clamped).r);
}

}  // namespace example
