// docs/pictures/orientation.svg: where each mapping of an environment has its axes, painted by the mappings themselves.
//
//   g++ -std=c++17 -O2 -Iinclude scripts/orientation_picture.cpp -o orientation && ./orientation >
//   docs/pictures/orientation.svg
#include <zonal/environment/mapping.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

namespace {

using Direction = std::array<double, 3>;

struct Axis {
  const char *label, *colour;
  Direction direction;
};
const Axis axes[] = {{"+x", "#d98880", {1, 0, 0}},  {"-x", "#f2d7d5", {-1, 0, 0}}, {"+y", "#7dcea0", {0, 1, 0}},
                     {"-y", "#d4efdf", {0, -1, 0}}, {"+z", "#85c1e9", {0, 0, 1}},  {"-z", "#d6eaf8", {0, 0, -1}}};

double cosine(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// That of the nearest axis; empty where there is no direction.
std::string colour(const Direction& d) {
  if (cosine(d, d) < 0.5) return "";
  const Axis* nearest = axes;
  for (const Axis& axis : axes) {
    if (cosine(d, axis.direction) > cosine(d, nearest->direction)) nearest = &axis;
  }
  return nearest->colour;
}

// A panel whose upper left corner is at (left, top), `unit` a texel.
template <class M>
void draw(double left, double top, int width, int height, double unit) {
  const M mapping(width, height);
  std::printf("<text x='%.1f' y='%.1f' font-weight='bold'>%s</text>\n", left, top - 6, mapping.name);
  for (int row = 0; row < height; ++row) {
    int begin = 0;
    std::string run;
    for (int column = 0; column <= width; ++column) {
      const bool is_texel = column < width && mapping.has_direction(column, row);
      const std::string next = is_texel ? colour(mapping.direction(column + 0.5, row + 0.5)) : "";
      if (column > 0 && next == run && column < width) continue;
      if (!run.empty()) {
        std::printf("<path fill='%s' d='M%.1f %.1fh%.1fv%.2fh-%.1f'/>\n", run.c_str(), left + begin * unit,
                    top + row * unit, (column - begin) * unit, unit * 1.1, (column - begin) * unit);
      }
      begin = column;
      run = next;
    }
  }
  for (const Axis& axis : axes) {
    auto at = mapping.texel(axis.direction);
    at[0] = std::fmin(std::fmax(at[0] * unit, 9), width * unit - 9);
    at[1] = std::fmin(std::fmax(at[1] * unit, 9), height * unit - 9);
    std::printf("<text x='%.1f' y='%.1f' text-anchor='middle'>%s</text>\n", left + at[0], top + at[1] + 4, axis.label);
  }
}

}  // namespace

int main() {
  std::printf(
      "<svg xmlns='http://www.w3.org/2000/svg' width='900' height='470' font-family='sans-serif' "
      "font-size='12'>\n<rect width='900' height='470' fill='white'/>\n");
  draw<zonal::Equirectangular>(20, 30, 128, 64, 2);
  draw<zonal::VerticalCross>(20, 190, 96, 128, 2);
  draw<zonal::HorizontalCross>(310, 30, 128, 96, 2);
  draw<zonal::VerticalFaces>(230, 190, 22, 132, 2);
  draw<zonal::HorizontalFaces>(600, 30, 132, 22, 2);
  draw<zonal::MirrorSphere>(600, 110, 64, 64, 2.4);
  draw<zonal::AngularMap>(764, 110, 64, 64, 2);
  draw<zonal::Octahedral>(310, 270, 64, 64, 2);
  std::printf(
      "<text x='460' y='300'>+x forward, +y left, +z up;</text>\n"
      "<text x='460' y='318'>in faces of cubes as graphics interfaces have them +y is up.</text>\n"
      "<text x='460' y='336'>The colour is that of the nearest axis.</text>\n</svg>\n");
}
