#include "preview.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <stb_easy_font.h>
#include <glm/gtc/type_ptr.hpp>
#include <zonal/environment/reconstruct_picture.hpp>
#include <zonal/scalar/luminance.hpp>
#include <zonal/transform/reconstruct_batch.hpp>

#include "shared/text_table.hpp"

namespace zonal_probe {
namespace {

using example::Image;

using Floats = zonal::Sh<max_bands, zonal::Rgb<float>>;

constexpr int gap = 16, text_scale = 2, line_height = 24, ball_samples = 4;
constexpr glm::vec3 background(0.11f), ink(0.92f), faint_ink(0.62f), mark(1.0f, 0.0f, 0.85f);

Floats as_floats(const Coefficients& sh) {
  Floats floats{};
  for (int i = 0; i < sh.size(); ++i) floats[i] = zonal::Rgb<float>(sh[i]);
  return floats;
}

void fill(Image& canvas, int left, int top, int width, int height, const glm::vec3& colour) {
  for (int y = std::max(0, top); y < std::min(canvas.height, top + height); ++y) {
    for (int x = std::max(0, left); x < std::min(canvas.width, left + width); ++x) canvas.at(x, y) = colour;
  }
}

std::string printable(std::string text) {
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return text;
}

/// One line, cut off at a width.
void write(Image& canvas, int left, int top, int width, std::string text, const glm::vec3& colour) {
  text = printable(text);
  while (!text.empty() && text_scale * stb_easy_font_width(text.data()) > width) text.pop_back();
  struct Corner {
    float x, y, z;
    unsigned char colour[4];
  };
  std::vector<Corner> corners(100 * (text.size() + 1));
  const int quads = stb_easy_font_print(0, 0, text.data(), nullptr, corners.data(),
                                        static_cast<int>(corners.size() * sizeof(Corner)));
  for (int i = 0; i < quads; ++i) {
    const Corner &first = corners[4 * static_cast<std::size_t>(i)],
                 &last = corners[4 * static_cast<std::size_t>(i) + 2];
    const auto scaled = [](float coordinate) { return text_scale * static_cast<int>(std::lround(coordinate)); };
    fill(canvas, left + scaled(first.x), top + scaled(first.y), scaled(last.x - first.x), scaled(last.y - first.y),
         colour);
  }
}

bool is_negative(const glm::vec3& radiance, float least) {
  return radiance.r < least || radiance.g < least || radiance.b < least;
}

/// Display values, hatched where a channel is below 0.
glm::vec3 shown(const glm::vec3& radiance, float least, int x, int y, const example::Display& display) {
  const bool is_line = (x + y) % 6 < 2;
  return is_line && is_negative(radiance, least) ? mark : example::encode(radiance, display);
}

Image reconstructed(const Coefficients& radiance, Workers& workers) {
  Image image(panel_width, panel_height);
  zonal::reconstruct(radiance, zonal::Mapping::equirectangular,
                     zonal::Picture<float>(&image.pixels.front().x, panel_width, panel_height),
                     workers.loop("preview", 0.1));
  return image;
}

/// E / pi at what faces a viewer who looks ahead, orthographic; and how much of each pixel is ball.
struct Ball {
  Image light;
  std::vector<float> cover;
};

Ball lit_ball(const Coefficients& over_pi, int size, Workers& workers) {
  Ball ball{Image(size, size), {}};
  ball.cover.resize(ball.light.pixels.size());
  const Floats sh = as_floats(over_pi);
  workers.loop("preview", 0.1)(size, [&](int row) {
    std::vector<float> normals;
    for (int column = 0; column < size; ++column) {
      normals.clear();
      for (int k = 0; k < ball_samples * ball_samples; ++k) {
        const float left = 1 - 2 * (float(column) + (float(k % ball_samples) + 0.5f) / ball_samples) / float(size);
        const float up = 1 - 2 * (float(row) + (float(k / ball_samples) + 0.5f) / ball_samples) / float(size);
        const float towards = 1 - left * left - up * up;
        if (towards > 0) normals.insert(normals.end(), {-std::sqrt(towards), left, up});
      }
      const std::size_t count = normals.size() / 3, pixel = ball.light.index(column, row);
      ball.cover[pixel] = float(count) / (ball_samples * ball_samples);
      if (count == 0) continue;
      std::vector<zonal::Rgb<float>> values(count);
      zonal::reconstruct(sh, zonal::DirectionSpan<float>::triples(normals.data(), count), values.data());
      for (const zonal::Rgb<float>& value : values) {
        ball.light.pixels[pixel] += glm::vec3(value.r, value.g, value.b) / float(count);
      }
    }
  });
  return ball;
}

const glm::dvec3 luminance_weights = glm::make_vec3(zonal::kLuminanceWeights);

/// Display luma at which a difference is fully red or blue.
constexpr float full_difference = 0.6f;

glm::vec3 signed_difference(const glm::vec3& rebuilt, const glm::vec3& truth, const example::Display& display) {
  const glm::vec3 luma(luminance_weights), zero(0.97f), brighter(0.78f, 0.07f, 0.10f), darker(0.09f, 0.24f, 0.70f);
  const float difference = glm::dot(luma, example::encode(rebuilt, display) - example::encode(truth, display));
  return glm::mix(zero, difference > 0 ? brighter : darker, std::min(1.0f, std::abs(difference) / full_difference));
}

/// Panels side by side, each under its title and over two lines.
class Sheet {
 public:
  explicit Sheet(int width) : canvas_(width, 2 * gap + panel_height + 3 * line_height) {
    std::fill(canvas_.pixels.begin(), canvas_.pixels.end(), background);
  }

  /// pixel(x, y): a display value.
  template <class Pixel>
  void add(int width, const std::string& title, const std::string& first, const std::string& second,
           const Pixel& pixel) {
    const int top = gap + line_height, below = top + panel_height + 8;
    write(canvas_, left_, gap, width, title, ink);
    for (int y = 0; y < panel_height; ++y) {
      for (int x = 0; x < width; ++x) canvas_.at(left_ + x, top + y) = pixel(x, y);
    }
    write(canvas_, left_, below, width, first, faint_ink);
    write(canvas_, left_, below + line_height, width, second, faint_ink);
    left_ += width + gap;
  }

  Image canvas_;

 private:
  int left_ = gap;
};

/// How much of the sphere an equirectangular picture is below 0, and where it is least.
struct Negative {
  double share = 0, least = 0;
};
Negative negative_of(const Image& image, float least) {
  Negative negative;
  double all = 0;
  for (int y = 0; y < image.height; ++y) {
    const double weight = std::sin(pi * (y + 0.5) / image.height);
    for (int x = 0; x < image.width; ++x) {
      const glm::vec3& c = image.at(x, y);
      all += weight;
      if (is_negative(c, least)) negative.share += weight;
      negative.least = std::min({negative.least, double(c.r), double(c.g), double(c.b)});
    }
  }
  negative.share /= all;
  return negative;
}

}  // namespace

Image make_preview(const Light& light, const std::optional<Image>& sky, const PreviewTexts& texts, Workers& workers) {
  const Coefficients radiance = of_quantity(light, zonal::Quantity::radiance).sh;
  const Coefficients over_pi = of_quantity(light, zonal::Quantity::irradiance_over_pi).sh;
  const Image rebuilt = reconstructed(radiance, workers);
  const Ball ball = lit_ball(over_pi, panel_height, workers);

  // The mean shows as a middle grey, and what is below 0 by more than rounding is hatched.
  const glm::dvec3 mean_colour = glm::dvec3(radiance[0].r, radiance[0].g, radiance[0].b) * std::sqrt(0.25 / pi);
  const double mean = glm::dot(mean_colour, luminance_weights);
  const float least = static_cast<float>(-1e-5 * std::max(mean, 0.0));
  example::Display display;
  if (mean > 1e-30) display.exposure_stops = static_cast<float>(std::clamp(std::log2(0.25 / mean), -100.0, 100.0));

  const std::string exposure = example::format("all at %+.1f stops", static_cast<double>(display.exposure_stops));
  const int pictures = sky ? 3 : 1;
  Sheet sheet(pictures * (panel_width + gap) + panel_height + 2 * gap);
  if (sky) {
    sheet.add(panel_width, "picture", texts.picture, exposure,
              [&](int x, int y) { return example::encode(sky->at(x, y), display); });
  }
  const Negative negative = negative_of(rebuilt, least);
  const bool is_any_negative = negative.share > 0;
  const std::string share = is_any_negative
                                ? example::format("hatched: below 0, %.2g %% of directions", 100 * negative.share)
                                : std::string("nowhere below 0");
  const std::string lowest =
      is_any_negative ? example::format("least: %.2g of the mean", negative.least / std::max(mean, 1e-30)) : "";
  sheet.add(panel_width, example::format(light.bands == 1 ? "%d band" : "%d bands", light.bands) + texts.window, share,
            lowest, [&](int x, int y) { return shown(rebuilt.at(x, y), least, x, y, display); });
  if (sky) {
    sheet.add(panel_width, "difference", "red: bands too bright, blue: too dark",
              example::format("full colour: %.0f %% of the screen's white", 100 * double{full_difference}),
              [&](int x, int y) { return signed_difference(rebuilt.at(x, y), sky->at(x, y), display); });
  }
  sheet.add(panel_height, "white ball", "E / pi, seen", "looking ahead", [&](int x, int y) {
    const std::size_t pixel = ball.light.index(x, y);
    return glm::mix(background, shown(ball.light.pixels[pixel], least, x, y, display), ball.cover[pixel]);
  });
  return sheet.canvas_;
}

}  // namespace zonal_probe
