#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

namespace example {

/// What the samples of a picture mean: bytes of colours are sRGB; those of heights and normals are shares of 255.
enum class TextureUse { colour, values };

/// A picture to lay on surfaces, rows from the top, of one channel or three. Its memory: a byte per sample of 8 bits,
/// and a float per sample of any other.
class Texture {
 public:
  Texture(int width, int height, int channels, std::vector<std::uint8_t> bytes, TextureUse use);
  Texture(int width, int height, int channels, std::vector<float> linear);

  /// Linear values, interpolated bilinearly between the texels' centres. (0, 0) is the lower left corner of the picture
  /// and (1, 1) the upper right; beyond, the picture repeats, or its edge goes on.
  glm::vec3 at(const glm::vec2& place, bool clamped) const;

  /// How the first channel grows with each coordinate: its mean over one texel, which is continuous.
  glm::vec2 gradient(const glm::vec2& place, bool clamped) const;

  glm::vec3 mean() const { return mean_; }
  glm::ivec2 size() const { return {width_, height_}; }
  std::size_t bytes() const { return bytes_.size() + linear_.size() * sizeof(float); }

 private:
  glm::vec3 texel(int x, int y) const;
  glm::vec3 mean_of_texels() const;

  int width_, height_, channels_;
  std::vector<std::uint8_t> bytes_;  // one of the two is empty
  std::vector<float> linear_;
  const float* decoded_ = nullptr;  // of the bytes
  glm::vec3 mean_;
};

/// Where a texture lies on a surface.
struct TextureMap {
  std::shared_ptr<const Texture> texture;  // null: none
  glm::vec2 scale{1.0f}, offset{0.0f};     // its place is scale * texture coordinates + offset
  bool clamped = false;                    // beyond its edges; else it repeats

  explicit operator bool() const { return texture != nullptr; }
  glm::vec3 at(const glm::vec2& coordinates) const { return texture->at(scale * coordinates + offset, clamped); }
  /// By the texture coordinates.
  glm::vec2 gradient(const glm::vec2& coordinates) const {
    return scale * texture->gradient(scale * coordinates + offset, clamped);
  }
};

/// What bends a surface's normals.
struct Relief {
  enum class Kind { normals, heights };

  TextureMap map;
  Kind kind = Kind::heights;
  float strength = 1.0f;  // metres that a height of 1 stands out; of normals, a factor of their slope

  explicit operator bool() const { return static_cast<bool>(map); }
};

}  // namespace example
