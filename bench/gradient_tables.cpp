// The gradient paper's Tables 1 and 2 and Fig. 15, in its layout, what it prints in the left columns.
#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <string>

#include <zonal/grid/light_sums.hpp>

#include "square_light.hpp"
#include "tables.hpp"

namespace zonal_bench {
namespace {

constexpr std::array table_1_bands{3, 4, 5, 6, 8, 10};
using Row = std::array<double, table_1_bands.size()>;

// ns of a kernel, or of one less another; negative where it was not measured.
Row measured(const Results& results, const char* kernel, const char* less, const char* scalar) {
  Row row;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const auto ns = [&](const char* name) {
      const Result* r = find(results, kernel_name(name, table_1_bands[i]) + "/" + scalar);
      return r ? r->median_ns() : -1e9;
    };
    row[i] = ns(kernel) - (less ? ns(less) : 0);
  }
  return row;
}

void print_row(std::ostream& out, const char* title, const Row& paper, const Row& here) {
  out << format("%-42s", title);
  for (const double ns : paper) out << (ns > 0 ? format("%7.1f", ns) : format("%7s", "-"));
  out << " |";
  for (const double ns : here) out << (ns > -1e8 ? format("%7.1f", ns) : format("%7s", "-"));
  out << "\n";
}

void print_ratio(std::ostream& out, const char* title, const Row& slow, const Row& fast) {
  out << format("%-42s%42s |", title, "");
  for (std::size_t i = 0; i < slow.size(); ++i) out << format("%7.2f", slow[i] / fast[i]);
  out << "\n";
}

void print_table_1(std::ostream& out, const Results& results, const char* scalar) {
  const auto here = [&](const char* kernel, const char* less = nullptr) {
    return measured(results, kernel, less, scalar);
  };
  out << format("%-42s%42s |%42s\n", "", "the paper, Xeon 2.1 GHz", scalar) << format("%-42s", "bands");
  for (int column = 0; column < 2; ++column) {
    for (const int bands : table_1_bands) out << format("%7d", bands);
    out << (column == 0 ? " |" : "\n");
  }
  print_row(out, "polynomial: evaluation", {27.82, 32.22, 40.57, 54.63, 84.51, 144.01}, here("polynomial"));
  print_row(out, "polynomial: gradient xyz", {56.91, 83.34, 122.28, 190.25, 386.91, 720.26},
            here("polynomial_gradient", "polynomial"));
  print_row(out, "polynomial: sum", {84.74, 115.56, 162.85, 244.87, 471.42, 864.27}, here("polynomial_gradient"));
  print_row(out, "Sloan's like: value, gradient theta phi", {25.86, 33.77, 44.51, 59.95, 106.35, 169.82},
            here("sloan_like_angular"));
  print_row(out, "Direct: value, gradient theta phi", {42.28, 60.66, 81.15, 112.32, 196.33, 296.94},
            here("direct_angular"));
  print_row(out, "Cartesian conversion", {41.63, 43.67, 48.97, 53.82, 66.19, 84.41},
            here("sloan_like", "sloan_like_angular"));
  print_row(out, "Sloan's like: value, gradient xyz", {67.50, 77.43, 93.48, 113.78, 172.55, 254.23},
            here("sloan_like"));
  print_row(out, "Direct: value, gradient xyz", {83.92, 104.32, 130.13, 166.14, 262.52, 381.35}, here("direct"));
  print_row(out, "here: value, gradient xyz, by the ladder", {}, here("evaluate_with_gradient"));
}

constexpr std::array table_2_bands{5, 6, 7, 8, 9};

}  // namespace

void print_gradient_table_1(std::ostream& out, const Results& results) {
  out << "Gradient paper, Table 1: ns per direction, one thread; rows of differences: \"gradient xyz\" and "
         "\"conversion\"\n\n";
  print_table_1(out, results, "float");
  out << "\n";
  print_table_1(out, results, "packet");
  const auto row = [&](const char* kernel, const char* scalar) { return measured(results, kernel, nullptr, scalar); };
  out << "\nTimes faster, with the Cartesian gradient:\n";
  const Row one = row("evaluate_with_gradient", "float"), packet = row("evaluate_with_gradient", "packet");
  print_ratio(out, "one direction, than Sloan's like", row("sloan_like", "float"), one);
  print_ratio(out, "one direction, than polynomials", row("polynomial_gradient", "float"), one);
  print_ratio(out, "packet, than Sloan's like in packets", row("sloan_like", "packet"), packet);
  print_ratio(out, "packet, than polynomials in packets", row("polynomial_gradient", "packet"), packet);
  print_ratio(out, "packet, than Sloan's like, one by one", row("sloan_like", "float"), packet);
  print_ratio(out, "packet, than polynomials, one by one", row("polynomial_gradient", "float"), packet);
}

void print_gradient_table_2(std::ostream& out, const Results& results) {
  struct PaperRow {
    double spheres, triangles_as_spheres, polygons;
  };
  constexpr std::array<PaperRow, table_2_bands.size()> paper{
      {{2.22, 2.53, 7.21}, {2.96, 3.39, 13.08}, {3.77, 4.42, 16.21}, {4.76, 5.35, 29.07}, {5.18, 5.74, 164.01}}};
  const auto ms = [&](const char* kernel, int bands, double unit) {
    const Result* r = find(results, kernel_name(kernel, bands) + "/packet");
    return r ? r->median_ns() / unit : std::nan("");
  };
  const Result* any = find(results, "grid-spheres/5/packet");
  out << "Gradient paper, Table 2: ms for value and gradient of 648 lights on an 8^3 grid\n\n"
      << format("%5s%34s |%34s\n", "", "the paper, RTX 2080, reversed loops",
                any ? format("here, %.0f threads", any->values.at("threads")).c_str() : "here")
      << format("%5s%10s%12s%13s |%10s%12s%13s%10s%14s\n", "bands", "spheres", "triangles", "polygons", "spheres",
                "triangles", "triangles", "times", "its greatest")
      << format("%5s%10s%12s%13s |%10s%12s%13s%10s%14s\n", "", "", "as spheres", "exactly", "", "as spheres", "exactly",
                "spheres", "error");
  for (std::size_t i = 0; i < table_2_bands.size(); ++i) {
    const int bands = table_2_bands[i];
    const double spheres = ms("grid-spheres", bands, 1e6), exact = ms("grid-triangles", bands, 1e6);
    const Result* r = find(results, kernel_name("grid-triangles", bands) + "/packet");
    out << format("%5d%10.2f%12.2f%13.2f |", bands, paper[i].spheres, paper[i].triangles_as_spheres, paper[i].polygons)
        << format("%10.2f%12.2f%13.2f%10.1f%14.1e\n", spheres, ms("grid-triangles-as-spheres", bands, 1e6), exact,
                  exact / spheres, r ? r->values.at("error") : std::nan(""));
  }
  out << "The tolerance asked for is 1e-4 of each triangle's largest coefficient; the error is of the grid's "
         "largest.\n";
}

void print_gradient_figure_15(std::ostream& out) {
  // The square light of Table 2 over a plane at z = 0 from -2 to 2, radiance 1.
  constexpr int N = 10, side = 33;
  auto triangles = square_of_triangles(18);
  for (auto& triangle : triangles) triangle.colour = glm::vec3(1);
  const auto spheres = as_modulated_spheres(triangles);
  std::array<double, N> with_cosine{}, without{}, size{};
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const glm::dvec3 x(-2 + 4.0 * column / (side - 1), -2 + 4.0 * row / (side - 1), 0);
      zonal::Sh<N, double> exact{}, modulated{}, plain{};
      // The outline is the light: its inner edges cancel.
      exact =
          zonal::project<N>(zonal::PolygonLight<4, double>{{{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}}, x, 1e-10);
      for (const auto& light : spheres) {
        const zonal::TriangleSphereLight<double> wide{glm::dvec3(light.light.center), glm::dvec3(light.light.normal),
                                                      static_cast<double>(light.light.radius)};
        modulated += zonal::project<N>(wide, x);
        plain += zonal::project<N>(zonal::SphereLight<double>{wide.center, wide.radius}, x);
      }
      for (int l = 0; l < N; ++l) {
        for (int m = -l; m <= l; ++m) {
          const auto degree = static_cast<std::size_t>(l);
          const double share = 1.0 / ((2 * l + 1) * side * side);
          with_cosine[degree] += share * std::abs(modulated(l, m) - exact(l, m));
          without[degree] += share * std::abs(plain(l, m) - exact(l, m));
          size[degree] += share * std::abs(exact(l, m));
        }
      }
    }
  }
  out << "Gradient paper, Fig. 15 d: mean error of the triangles as spheres, per coefficient, over a plane under the "
         "light\n\n"
      << format("%6s%16s%16s%16s\n", "degree", "with the cosine", "bare spheres", "mean |exact|");
  for (std::size_t l = 0; l < N; ++l) out << format("%6zu%16.2e%16.2e%16.2e\n", l, with_cosine[l], without[l], size[l]);
}

}  // namespace zonal_bench
