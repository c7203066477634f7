#include "image.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <zonal/scalar/luminance.hpp>

namespace example {
namespace {

/// Narkowicz's fit of the ACES film curve.
glm::vec3 filmic(const glm::vec3& x) { return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f); }

float srgb(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

double luma(const glm::vec3& encoded) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) sum += zonal::kLuminanceWeights[c] * static_cast<double>(encoded[c]);
  return sum;
}

double mean_square_difference(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const glm::dvec3 difference = glm::dvec3(a.pixels[i]) - glm::dvec3(b.pixels[i]);
    sum += glm::dot(difference, difference);
  }
  return sum / (3.0 * static_cast<double>(a.pixels.size()));
}

double mean_absolute_difference(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const glm::dvec3 difference = glm::abs(glm::dvec3(a.pixels[i]) - glm::dvec3(b.pixels[i]));
    sum += difference.r + difference.g + difference.b;
  }
  return sum / (3.0 * static_cast<double>(a.pixels.size()));
}

double mean(const Image& image) {
  double sum = 0.0;
  for (const glm::vec3& pixel : image.pixels) sum += static_cast<double>(pixel.r + pixel.g + pixel.b);
  return sum / (3.0 * static_cast<double>(image.pixels.size()));
}

constexpr int window_size = 11;

std::array<double, window_size> gaussian_window() {
  std::array<double, window_size> weights{};
  double sum = 0.0;
  for (int i = 0; i < window_size; ++i) {
    const double offset = i - window_size / 2;
    sum += weights[static_cast<std::size_t>(i)] = std::exp(-offset * offset / (2.0 * 1.5 * 1.5));
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// One channel of doubles.
struct Plane {
  int width;
  int height;
  std::vector<double> values;
};

template <class Value>
Plane make_plane(int width, int height, Value&& value) {
  Plane plane{width, height, std::vector<double>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
  for (std::size_t i = 0; i < plane.values.size(); ++i) plane.values[i] = value(i);
  return plane;
}

/// The separable Gaussian wherever the whole window fits: smaller by window_size - 1 each way.
Plane blur(const Plane& plane) {
  const std::array<double, window_size> weights = gaussian_window();
  const auto width = static_cast<std::size_t>(plane.width);
  const std::size_t inner_width = width - (window_size - 1);
  const auto height = static_cast<std::size_t>(plane.height);
  std::vector<double> rows(inner_width * height);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double* first = &plane.values[i / inner_width * width + i % inner_width];
    for (std::size_t k = 0; k < window_size; ++k) rows[i] += weights[k] * first[k];
  }
  return make_plane(static_cast<int>(inner_width), plane.height - (window_size - 1), [&](std::size_t i) {
    double sum = 0.0;
    for (std::size_t k = 0; k < window_size; ++k) sum += weights[k] * rows[i + k * inner_width];
    return sum;
  });
}

Image transpose(const Image& image) {
  Image result(image.height, image.width);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) result.at(y, x) = image.at(x, y);
  }
  return result;
}

/// As many rows as asked for, each the mean of what it covers.
Image resample_rows(const Image& image, int rows) {
  Image result(image.width, rows);
  const double step = static_cast<double>(image.height) / rows;
  for (int row = 0; row < rows; ++row) {
    const double begin = row * step, end = begin + step;
    const int last = std::min(image.height, static_cast<int>(std::ceil(end)));
    for (int y = static_cast<int>(begin); y < last; ++y) {
      const double covered = std::min(end, y + 1.0) - std::max(begin, static_cast<double>(y));
      const auto weight = static_cast<float>(covered / step);
      for (int x = 0; x < image.width; ++x) result.at(x, row) += weight * image.at(x, y);
    }
  }
  return result;
}

}  // namespace

glm::vec3 encode(const glm::vec3& radiance, const Display& display) {
  const glm::vec3 exposed = glm::max(radiance, 0.0f) * std::exp2(display.exposure_stops);
  const glm::vec3 toned = display.tone_map == ToneMap::filmic ? filmic(exposed) : exposed;
  const glm::vec3 shown = glm::clamp(toned, 0.0f, 1.0f);
  return {srgb(shown.r), srgb(shown.g), srgb(shown.b)};
}

Image encode(const Image& radiance, const Display& display) {
  Image encoded(radiance.width, radiance.height);
  for (std::size_t i = 0; i < radiance.pixels.size(); ++i) encoded.pixels[i] = encode(radiance.pixels[i], display);
  return encoded;
}

glm::vec3 decode_srgb(const glm::vec3& encoded) {
  const auto decode = [](float value) {
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
  };
  return {decode(encoded.r), decode(encoded.g), decode(encoded.b)};
}

std::size_t blacken_non_finite(Image& image) {
  std::size_t count = 0;
  for (glm::vec3& pixel : image.pixels) {
    if (std::isfinite(pixel.r) && std::isfinite(pixel.g) && std::isfinite(pixel.b)) continue;
    pixel = glm::vec3(0.0f);
    ++count;
  }
  return count;
}

double structural_similarity(const Image& encoded, const Image& encoded_reference) {
  if (encoded.width < window_size || encoded.height < window_size) return std::numeric_limits<double>::quiet_NaN();
  const int width = encoded.width;
  const int height = encoded.height;
  const auto a = [&](std::size_t i) { return luma(encoded.pixels[i]); };
  const auto b = [&](std::size_t i) { return luma(encoded_reference.pixels[i]); };
  const Plane mean_a = blur(make_plane(width, height, a));
  const Plane mean_b = blur(make_plane(width, height, b));
  const Plane square_a = blur(make_plane(width, height, [&](std::size_t i) { return a(i) * a(i); }));
  const Plane square_b = blur(make_plane(width, height, [&](std::size_t i) { return b(i) * b(i); }));
  const Plane product = blur(make_plane(width, height, [&](std::size_t i) { return a(i) * b(i); }));
  constexpr double c1 = 0.01 * 0.01;
  constexpr double c2 = 0.03 * 0.03;
  double sum = 0.0;
  for (std::size_t i = 0; i < mean_a.values.size(); ++i) {
    const double ma = mean_a.values[i];
    const double mb = mean_b.values[i];
    const double variances = square_a.values[i] - ma * ma + square_b.values[i] - mb * mb;
    const double covariance = product.values[i] - ma * mb;
    sum += (2.0 * ma * mb + c1) * (2.0 * covariance + c2) / ((ma * ma + mb * mb + c1) * (variances + c2));
  }
  return sum / static_cast<double>(mean_a.values.size());
}

ImageErrors compare(const Image& image, const Image& reference, const Display& display) {
  const Image shown = encode(image, display);
  const Image shown_reference = encode(reference, display);
  const double mean_square = mean_square_difference(shown, shown_reference);
  ImageErrors errors;
  errors.rmse = std::sqrt(mean_square);
  errors.psnr = -10.0 * std::log10(mean_square);
  errors.ssim = structural_similarity(shown, shown_reference);
  errors.mae = mean_absolute_difference(shown, shown_reference);
  const double reference_mean = mean(reference);
  errors.linear_rmse = std::sqrt(mean_square_difference(image, reference)) / reference_mean;
  errors.linear_mae = mean_absolute_difference(image, reference) / reference_mean;
  return errors;
}

Image difference_map(const Image& image, const Image& reference, const Display& display) {
  const glm::vec3 zero(0.97f);
  const glm::vec3 brighter(0.78f, 0.07f, 0.10f);
  const glm::vec3 darker(0.09f, 0.24f, 0.70f);
  Image map(image.width, image.height);
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    const double difference = luma(encode(image.pixels[i], display)) - luma(encode(reference.pixels[i], display));
    const float share = std::min(1.0f, static_cast<float>(std::abs(difference)) / difference_full_scale);
    map.pixels[i] = glm::mix(zero, difference > 0.0 ? brighter : darker, share);
  }
  return map;
}

Image amplified_difference(const Image& image, const Image& reference, const Display& display, float factor) {
  Image map(image.width, image.height);
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    map.pixels[i] = factor * glm::abs(encode(image.pixels[i], display) - encode(reference.pixels[i], display));
  }
  return map;
}

Image resample(const Image& picture, int width, int height) {
  const Image columns = resample_rows(picture, height);
  return transpose(resample_rows(transpose(columns), width));
}

}  // namespace example
