#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

namespace example {

/// Linear radiance, W/(m^2 sr), rows from the top.
struct Image {
  Image() = default;
  Image(int image_width, int image_height)
      : width(image_width),
        height(image_height),
        pixels(static_cast<std::size_t>(image_width) * static_cast<std::size_t>(image_height)) {}

  glm::vec3& at(int x, int y) { return pixels[index(x, y)]; }
  const glm::vec3& at(int x, int y) const { return pixels[index(x, y)]; }

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }

  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;
};

enum class ToneMap { filmic, clamp };

/// How radiance becomes what a screen shows; the same for every image of a run.
struct Display {
  float exposure_stops = 0.0f;
  ToneMap tone_map = ToneMap::filmic;
};

/// sRGB-encoded values in [0, 1].
glm::vec3 encode(const glm::vec3& radiance, const Display& display);
Image encode(const Image& radiance, const Display& display);

/// Linear values of sRGB-encoded ones.
glm::vec3 decode_srgb(const glm::vec3& encoded);

/// Replaces pixels that are not finite by black and returns how many there were.
std::size_t blacken_non_finite(Image& image);

/// Errors of an image against a reference.
struct ImageErrors {
  double rmse = 0.0;         // of display values in [0, 1]
  double psnr = 0.0;         // dB, of the same; infinite for equal images
  double ssim = 0.0;         // of their luma; not a number for images smaller than the window
  double mae = 0.0;          // mean absolute error, of display values in [0, 1]
  double linear_rmse = 0.0;  // of radiance, in units of the reference's mean
  double linear_mae = 0.0;   // the same
};

ImageErrors compare(const Image& image, const Image& reference, const Display& display);

/// Structural similarity (Wang et al. 2004) of luma: Gaussian window of 11 pixels, sigma 1.5, wherever it
/// fits.
double structural_similarity(const Image& encoded, const Image& encoded_reference);

/// Display luma at which the difference map is fully red or blue: differences stand out four times amplified.
constexpr float difference_full_scale = 0.25f;

/// Signed difference of display luma as a heat map: red where `image` is brighter, blue where darker. Returns
/// display values.
Image difference_map(const Image& image, const Image& reference, const Display& display);

/// Absolute difference of display values, channel by channel, amplified. Returns display values.
Image amplified_difference(const Image& image, const Image& reference, const Display& display, float factor);

/// The mean of the picture over each cell of a grid of this size.
Image resample(const Image& picture, int width, int height);

}  // namespace example
