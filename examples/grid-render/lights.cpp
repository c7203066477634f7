#include "lights.hpp"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "shared/image_file.hpp"
#include "shared/input_error.hpp"

namespace example::grid_render {
namespace {

/// u and v from 0 to 1; v runs down a picture.
glm::vec3 panel_point(const LightPanel& panel, float u, float v) {
  return panel.centre + (2.0f * u - 1.0f) * panel.half_u + (1.0f - 2.0f * v) * panel.half_v;
}

/// Fully lit, half saturated.
glm::vec3 hue_colour(float hue) {
  const glm::vec3 phases = glm::two_pi<float>() * (hue + glm::vec3(0.0f, -1.0f / 3.0f, 1.0f / 3.0f));
  return 0.55f + 0.45f * glm::cos(phases);
}

/// Lights of whatever brightness, to where the sum of radius^2 radiance is what the distance asks for.
void set_brightness(SphereLights& lights, float distance) {
  double sum = 0.0;
  for (const auto& [light, colour] : lights) {
    const glm::dvec3 rgb(colour);
    sum += static_cast<double>(light.radius * light.radius) * (rgb.r + rgb.g + rgb.b) / 3.0;
  }
  if (!(sum >= 1e-25)) throw InputError("the lights are too dark");
  const auto factor = static_cast<float>(static_cast<double>(distance * distance) / sum);
  for (auto& light : lights) light.colour *= factor;
}

/// The texels first.x to last.x - 1, first.y to last.y - 1.
struct Block {
  glm::ivec2 first, last;

  glm::ivec2 size() const { return last - first; }
};

/// Splits a picture into blocks of nearly one colour, and makes each a light.
class Quadtree {
 public:
  Quadtree(const LightPanel& panel, const Image& texels, float bound, SphereLights& lights)
      : panel_(panel), texels_(texels), bound_(bound), lights_(lights) {}

  void add(const Block& block) {
    const glm::vec3 mean = mean_of(block);
    const bool single = block.size() == glm::ivec2(1);
    if (single || deviation(block, mean) <= bound_) {
      add_light(block, mean);
      return;
    }
    const glm::ivec2 middle = block.first + block.size() / 2;
    const glm::ivec2 x[] = {{block.first.x, middle.x}, {middle.x, block.last.x}};
    const glm::ivec2 y[] = {{block.first.y, middle.y}, {middle.y, block.last.y}};
    for (const glm::ivec2& rows : y) {
      for (const glm::ivec2& columns : x) {
        if (columns[0] < columns[1] && rows[0] < rows[1]) add({{columns[0], rows[0]}, {columns[1], rows[1]}});
      }
    }
  }

  glm::vec3 mean_of(const Block& block) const {
    glm::dvec3 sum(0.0);
    for_each(block, [&](const glm::vec3& texel) { sum += texel; });
    return sum / static_cast<double>(block.size().x * block.size().y);
  }

 private:
  template <class Body>
  void for_each(const Block& block, const Body& body) const {
    for (int y = block.first.y; y < block.last.y; ++y) {
      for (int x = block.first.x; x < block.last.x; ++x) body(texels_.at(x, y));
    }
  }

  float deviation(const Block& block, const glm::vec3& mean) const {
    float greatest = 0.0f;
    for_each(block, [&](const glm::vec3& texel) {
      const glm::vec3 difference = glm::abs(texel - mean);
      greatest = std::max({greatest, difference.r, difference.g, difference.b});
    });
    return greatest;
  }

  void add_light(const Block& block, const glm::vec3& radiance) {
    if (radiance == glm::vec3(0.0f)) return;
    const glm::vec2 size(texels_.width, texels_.height);
    const glm::vec2 centre = 0.5f * glm::vec2(block.first + block.last) / size;
    const glm::vec2 extent = glm::vec2(block.size()) / size;
    const float area = panel_.area() * extent.x * extent.y;
    lights_.push_back({{panel_point(panel_, centre.x, centre.y), std::sqrt(area / glm::pi<float>())}, radiance});
  }

  const LightPanel& panel_;
  const Image& texels_;
  float bound_;
  SphereLights& lights_;
};

/// A picture may hold anything.
Image without_nonsense(Image picture) {
  blacken_non_finite(picture);
  for (glm::vec3& pixel : picture.pixels) pixel = glm::max(pixel, 0.0f);
  return picture;
}

}  // namespace

SphereLights make_lanterns(const LightPanel& panel, int count) {
  constexpr int hooks = 5;          // spans of a string
  constexpr float sag = 0.06f;      // of the string's length
  constexpr float fullness = 0.3f;  // a lantern's radius, of the distance to the next
  const float width = glm::length(panel.half_u), length = 2.0f * glm::length(panel.half_v);
  const float radius = fullness * std::sqrt(panel.area() / static_cast<float>(count));
  const int strings =
      std::clamp(static_cast<int>(std::lround(std::sqrt(static_cast<float>(count) * 2.0f * width / length))), 1, count);
  SphereLights lights;
  for (int string = 0; string < strings; ++string) {
    const int on_string = count / strings + (string < count % strings ? 1 : 0);
    const float u = (static_cast<float>(string) + 0.5f) / static_cast<float>(strings);
    for (int i = 0; i < on_string; ++i) {
      const float v = (static_cast<float>(i) + 0.5f) / static_cast<float>(on_string);
      const float in_span = v * hooks - std::floor(v * hooks);
      const glm::vec3 below(0.0f, -4.0f * sag * length * in_span * (1.0f - in_span), 0.0f);
      lights.push_back({{panel_point(panel, u, v) + below, radius}, hue_colour(v + 0.25f * u)});
    }
  }
  return lights;
}

Image texels_of(const Image& picture, const LightPanel& panel, int longest) {
  const glm::vec2 sides(glm::length(panel.half_u), glm::length(panel.half_v));
  const glm::vec2 texels = glm::max(glm::round(static_cast<float>(longest) * sides / std::max(sides.x, sides.y)), 1.0f);
  return resample(without_nonsense(picture), static_cast<int>(texels.x), static_cast<int>(texels.y));
}

SphereLights make_texture_lights(const LightPanel& panel, const Image& texels, std::optional<float> quadtree_error) {
  SphereLights lights;
  const Block all{{0, 0}, {texels.width, texels.height}};
  const glm::vec3 mean = Quadtree(panel, texels, 0.0f, lights).mean_of(all);
  const float never = -1.0f;
  const float bound = quadtree_error ? *quadtree_error * (mean.r + mean.g + mean.b) / 3.0f : never;
  Quadtree(panel, texels, bound, lights).add(all);
  return lights;
}

TriangleLights triangles_of(const SphereLights& lights, const LightPanel& panel) {
  const glm::vec3 u = glm::normalize(panel.half_u), v = glm::normalize(panel.half_v);
  TriangleLights triangles;
  for (const auto& [light, colour] : lights) {
    const float half = 0.5f * glm::root_pi<float>() * light.radius;
    const auto corner = [&, &sphere = light](float x, float y) { return sphere.center + half * (x * u + y * v); };
    const glm::vec3 corners[] = {corner(-1.0f, -1.0f), corner(1.0f, -1.0f), corner(1.0f, 1.0f), corner(-1.0f, 1.0f)};
    triangles.push_back({{{corners[0], corners[1], corners[2]}}, colour});
    triangles.push_back({{{corners[0], corners[2], corners[3]}}, colour});
  }
  return triangles;
}

TriangleSphereLights triangle_spheres_of(const TriangleLights& triangles) {
  TriangleSphereLights lights;
  for (const auto& [triangle, colour] : triangles) {
    lights.push_back({zonal::TriangleSphereLight<float>::approximate(triangle), colour});
  }
  return lights;
}

SphereLights make_lights(const Scene& scene, const Options& options) {
  SphereLights lights;
  if (options.texture.empty()) {
    lights = make_lanterns(scene.panel, options.lights);
  } else {
    const Image texels = texels_of(read_picture(options.texture), scene.panel, options.texture_size);
    lights = make_texture_lights(scene.panel, texels, options.quadtree_error);
    if (lights.empty()) throw InputError(options.texture + ": is black, and lights nothing");
  }
  set_brightness(lights, scene.panel.distance);
  return lights;
}

}  // namespace example::grid_render
