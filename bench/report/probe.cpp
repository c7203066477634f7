// Irradiance by what engines keep of a probe, against the sum over all texels: environments that are made here, and
// those that lie in $ZONAL_DATA (EXR and HDR, 2:1 or vertical crosses) where pictures can be read.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <zonal/environment/guess.hpp>
#include <zonal/probe/dering.hpp>
#include <zonal/probe/nonlinear_l1.hpp>
#include <zonal/probe/six_floats.hpp>
#include <zonal/probe/storage.hpp>
#include <zonal/probe/zh3.hpp>

#ifdef ZONAL_REPORT_PICTURES
#include "shared/image_file.hpp"
#endif

#include "report.hpp"

namespace zonal_report {
namespace {

using Rgb = zonal::Rgb<float>;
using Vec3 = std::array<float, 3>;

struct Environment {
  std::string name, source;  // made, or file
  std::vector<float> texels;
  int width, height;
};

float dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3 unit(float x, float y, float z) {
  const float length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

template <class Radiance>
Environment made(const char* name, const Radiance& radiance) {
  Environment e{name, "made", std::vector<float>(3 * 128 * 64), 128, 64};
  const zonal::Equirectangular mapping(128, 64);
  for (int row = 0; row < 64; ++row) {
    for (int column = 0; column < 128; ++column) {
      const auto d = mapping.direction(column + 0.5, row + 0.5);
      const Rgb c = radiance(Vec3{float(d[0]), float(d[1]), float(d[2])});
      for (int i = 0; i < 3; ++i) e.texels[std::size_t(3 * (128 * row + column) + i)] = c[i];
    }
  }
  return e;
}

std::vector<Environment> all_environments() {
  const Vec3 sun = unit(0.48F, 0.64F, 0.6F), window = unit(1, 0.2F, 0.1F);
  const Vec3 lamps[3] = {unit(1, 0, 1), unit(-1, 1, 0.5F), unit(0, -1, 0.2F)};
  const Rgb colours[3] = {{30, 4, 2}, {3, 25, 4}, {3, 5, 40}};
  const auto sky = [](const Vec3& d) {
    return d[2] > 0 ? Rgb{0.3F, 0.5F, 0.9F} * (1.2F - d[2]) : Rgb{0.2F, 0.15F, 0.1F};
  };
  std::vector<Environment> all;
  all.push_back(made("overcast", [](const Vec3& d) { return Rgb{1, 1, 1.1F} * (1 + 2 * std::max(d[2], -0.4F)); }));
  all.push_back(made("sky", sky));
  all.push_back(made("sunny sky", [&](const Vec3& d) { return dot(d, sun) > 0.995F ? Rgb{90, 80, 60} : sky(d); }));
  all.push_back(made("window", [&](const Vec3& d) {
    return std::abs(d[2] - window[2]) < 0.35F && dot(d, window) > 0.8F ? Rgb{6, 7, 8} : Rgb{0.25F, 0.2F, 0.15F};
  }));
  all.push_back(made("three lamps", [&](const Vec3& d) {
    Rgb c{0.05F, 0.05F, 0.05F};
    for (int i = 0; i < 3; ++i) c += dot(d, lamps[i]) > 0.98F ? colours[i] : Rgb{0, 0, 0};
    return c;
  }));
  all.push_back(made("one lamp", [&](const Vec3& d) { return dot(d, sun) > 0.98F ? Rgb{50, 40, 30} : Rgb{0, 0, 0}; }));
#ifdef ZONAL_REPORT_PICTURES
  if (const char* data = std::getenv("ZONAL_DATA")) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(data)) {
      if (entry.path().extension() == ".exr" || entry.path().extension() == ".hdr") paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    for (const auto& path : paths) {
      const example::Image image = example::read_picture(path);
      Environment e{path.stem().string(), "file", {}, image.width, image.height};
      for (const auto& pixel : image.pixels) e.texels.insert(e.texels.end(), {pixel.r, pixel.g, pixel.b});
      all.push_back(std::move(e));
    }
  }
#endif
  return all;
}

// Three bands of radiance, and E / pi at each normal, both texel by texel.
struct Truth {
  zonal::Sh<3, Rgb> probe;
  std::vector<Rgb> irradiance;
};
Truth sum_texels(const zonal::Environment<float>& environment, const std::vector<Vec3>& normals) {
  Truth truth{{}, std::vector<Rgb>(normals.size(), Rgb{0, 0, 0})};
  std::vector<Vec3> directions;
  std::vector<Rgb> light;  // radiance times solid angle
  const auto add_row = [&] {
    zonal::Sh<3, Rgb> of_row{};
    for (std::size_t k = 0; k < light.size(); ++k) of_row += zonal::evaluate<3>(directions[k]) * light[k];
    truth.probe += of_row;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      Rgb sum{0, 0, 0};
      for (std::size_t k = 0; k < light.size(); ++k) sum += light[k] * std::max(dot(normals[i], directions[k]), 0.0F);
      truth.irradiance[i] += sum * (1 / 3.14159265F);
    }
    directions.clear(), light.clear();
  };
  environment.visit([&](const auto& mapping) {
    for (int row = 0; row < environment.height(); ++row) {
      for (int column = 0; column < environment.width(); ++column) {
        if (!mapping.has_direction(column, row)) continue;
        const auto d = mapping.direction(column + 0.5, row + 0.5);
        directions.push_back({float(d[0]), float(d[1]), float(d[2])});
        light.push_back(environment.picture().rgb(column, row) * float(mapping.solid_angle(column, row)));
      }
      add_row();
    }
  });
  return truth;
}

class Forms {
 public:
  Forms(const Environment& e, const std::vector<Vec3>& normals)
      : name_(e.name),
        source_(e.source),
        normals_(normals),
        truth_(sum_texels(zonal::guess_environment(zonal::Picture<const float>(e.texels.data(), e.width, e.height)),
                          normals)) {}

  void print_all() const {
    const zonal::LambertLobe lambert;
    const zonal::Sh<3, Rgb>& probe = truth_.probe;
    const auto linear = zonal::with_bands<2>(probe);
    print("3 bands, floats", 108, [&](const Vec3& n) { return zonal::reconstruct_convolved(probe, lambert, n); });
    print_stored("3 bands, halves", 54, probe, [](const auto& sh) { return zonal::to_halves(sh); });
    print_stored("3 bands, bytes by band", 45, probe,
                 [](const auto& sh) { return zonal::to_bytes<zonal::ByteScale::band>(sh); });
    print_stored("3 bands, bytes", 33, probe, [](const auto& sh) { return zonal::to_bytes(sh); });
    const auto print_zh3 = [&](const char* form, int bytes, const zonal::Zh3<Rgb>& zh3, zonal::Zh3Axis axis) {
      print(form, bytes, [&](const Vec3& n) { return zonal::irradiance_over_pi(zh3, n, axis); });
    };
    using zonal::Zh3Axis;
    print_zh3("ZH3, solved", 60, zonal::solve_zh3(probe), Zh3Axis::luminance);
    print_zh3("ZH3, projected", 60, zonal::project_zh3(probe), Zh3Axis::luminance);
    print_zh3("ZH3, solved by channel", 60, zonal::solve_zh3(probe, Zh3Axis::channel), Zh3Axis::channel);
    print_zh3("ZH3, hallucinated", 48, zonal::hallucinate_zh3(linear), Zh3Axis::luminance);
    print("2 bands", 48, [&](const Vec3& n) { return zonal::reconstruct_convolved(linear, lambert, n); });
    print("2 bands, non-linear", 48, [&](const Vec3& n) { return zonal::nonlinear_irradiance_over_pi(linear, n); });
    const auto six = zonal::to_six_floats(linear);
    print("six floats", 24, [&](const Vec3& n) { return zonal::irradiance_over_pi<Rgb>(six, n); });
    print("six floats, non-linear", 24,
          [&](const Vec3& n) { return zonal::irradiance_over_pi<Rgb, zonal::SixFloatsShape::nonlinear>(six, n); });
    for (const bool of_radiance : {true, false}) {
      const auto of = of_radiance ? zonal::DeringOf::radiance : zonal::DeringOf::irradiance;
      const auto dered = zonal::dering(probe, {zonal::DeringWindow::laplacian, of}).sh;
      print(of_radiance ? "3 bands, radiance dered" : "3 bands, irradiance dered", 108,
            [&](const Vec3& n) { return zonal::reconstruct_convolved(dered, lambert, n); });
    }
  }

 private:
  // Root mean square and greatest error over the root mean square of E / pi, and the least value over it.
  void print(const char* form, int bytes, const std::function<Rgb(const Vec3&)>& value) const {
    double squares = 0, errors = 0, greatest = 0, least = 1e30;
    for (std::size_t i = 0; i < normals_.size(); ++i) {
      const Rgb found = value(normals_[i]);
      for (int c = 0; c < 3; ++c) {
        const double exact = double(truth_.irradiance[i][c]), error = std::abs(double(found[c]) - exact);
        squares += exact * exact, errors += error * error;
        greatest = std::max(greatest, error), least = std::min(least, double(found[c]));
      }
    }
    const double count = 3.0 * double(normals_.size()), size = std::sqrt(squares / count);
    std::string text = form;
    std::replace(text.begin(), text.end(), ',', ';');  // a field of CSV
    print_row(name_, source_, text, bytes, std::sqrt(errors / count) / size, greatest / size, least / size);
  }
  template <class Store>
  void print_stored(const char* form, int bytes, const zonal::Sh<3, Rgb>& probe, const Store& store) const {
    const auto channel = [&](int c) {
      zonal::Sh<3, float> sh{};
      for (int i = 0; i < 9; ++i) sh[i] = probe[i][c];
      return store(sh);
    };
    const auto r = channel(0), g = channel(1), b = channel(2);
    print(form, bytes, [&](const Vec3& n) {
      return Rgb{zonal::irradiance_over_pi(r, n), zonal::irradiance_over_pi(g, n), zonal::irradiance_over_pi(b, n)};
    });
  }

  std::string name_, source_;
  const std::vector<Vec3>& normals_;
  Truth truth_;
};

}  // namespace

void print_probe(Effort effort) {
  print_row("environment", "source", "form", "bytes", "rmse", "greatest", "least");
  const int count = choose(effort, 100, 600, 2000);
  std::vector<Vec3> normals;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, s = std::sqrt(1 - z * z), phi = 2.399963229728653 * i;
    normals.push_back({float(s * std::cos(phi)), float(s * std::sin(phi)), float(z)});
  }
  for (const Environment& environment : all_environments()) Forms(environment, normals).print_all();
}

}  // namespace zonal_report
