// Files in the format of the MERL database, of models: for a scene of measured materials where none are at hand.
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

#include <zonal/file/checked_file.hpp>
#include <zonal/material/merl.hpp>

#include "materials.hpp"
#include "report.hpp"

namespace zonal_report {
namespace {

using zonal::MerlBrdf;

glm::dvec3 turned_about_y(const glm::dvec3& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

// The BRDF in the middle of a bin; black where a direction is below the horizon.
glm::dvec3 sample(const zonal::Brdf& brdf, int half, int theta, int phi) {
  const double right_angle = 0.5 * double(zonal::kPi), root = (half + 0.5) / MerlBrdf::theta_half_bins;
  const double theta_half = root * root * right_angle;
  const double theta_difference = (theta + 0.5) / MerlBrdf::theta_difference_bins * right_angle;
  const double phi_difference = (phi + 0.5) / MerlBrdf::phi_difference_bins * double(zonal::kPi);
  const double across = std::sin(theta_difference);
  const glm::dvec3 d(across * std::cos(phi_difference), across * std::sin(phi_difference), std::cos(theta_difference));
  return zonal::evaluate(brdf, turned_about_y(d, theta_half), turned_about_y({-d.x, -d.y, d.z}, theta_half));
}

void write(const std::filesystem::path& path, const zonal::Brdf& brdf) {
  constexpr double scales[] = {1.0 / 1500, 1.15 / 1500, 1.66 / 1500};
  std::vector<double> planes(3 * MerlBrdf::bins);
  std::size_t bin = 0;
  for (int half = 0; half < MerlBrdf::theta_half_bins; ++half) {
    for (int theta = 0; theta < MerlBrdf::theta_difference_bins; ++theta) {
      for (int phi = 0; phi < MerlBrdf::phi_difference_bins; ++phi, ++bin) {
        const glm::dvec3 f = sample(brdf, half, theta, phi);
        for (int c = 0; c < 3; ++c) planes[bin + MerlBrdf::bins * std::size_t(c)] = f[c] / scales[c];
      }
    }
  }
  std::ofstream file(path, std::ios::binary);
  const std::int32_t header[] = {MerlBrdf::theta_half_bins, MerlBrdf::theta_difference_bins,
                                 MerlBrdf::phi_difference_bins};
  file.write(reinterpret_cast<const char*>(header), sizeof header);
  file.write(reinterpret_cast<const char*>(planes.data()), std::streamsize(sizeof(double) * planes.size()));
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace

void write_merl_files(const char* folder) {
  write(std::filesystem::path(folder) / "gold.binary", gold(0.2F));
  write(std::filesystem::path(folder) / "lacquer.binary", plastic({0.5F, 0.08F, 0.05F}, 0.15F));
  write(std::filesystem::path(folder) / "stone.binary", plastic({0.55F, 0.5F, 0.45F}, 0.4F));
}

}  // namespace zonal_report
