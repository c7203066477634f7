// The measured isotropic materials of the MERL database.
//
// A file, all little-endian: three 32-bit counts, 90, 90 and 180, then three planes of doubles, red, green and blue.
// Each plane has a sample per bin of the half and difference angles [2], the last fastest:
//
//   theta_half        90 bins in [0, pi/2], equal in sqrt(theta_half)
//   theta_difference  90 bins in [0, pi/2]
//   phi_difference    180 bins in [0, pi); f(phi + pi) = f(phi), by reciprocity
//
// A plane's samples times 1/1500, 1.15/1500 and 1.66/1500 are the BRDF in 1/sr.
//
// Here a sample is the BRDF at the middle of its bin, in between it is trilinear in the bins' coordinates, and beyond
// the outermost middles constant. Negative samples are those that could not be measured, channel by channel: they
// are left out, the weights of the others being divided by their sum, and where nothing is left f is zero.
//
// project_material(even_part(merl), bands, tolerance) makes its table: 1 s at a tolerance of 1e-3, 8 s at 1e-4, for the
// kinks between bins. material_file.hpp keeps it.
//
// [1] W. Matusik, H. Pfister, M. Brand, L. McMillan, "A Data-Driven Reflectance Model", SIGGRAPH 2003.
// [2] S. Rusinkiewicz, "A New Change of Variables for Efficient BRDF Representation", EGWR 1998.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "../file/checked_file.hpp"
#include "../scalar/constexpr_math.hpp"
#include "../scalar/index.hpp"
#include "brdf.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// The half vector's angle to the normal, and the direction of wi as seen from the half vector [2]. Radians:
/// theta_half and theta_difference in [0, pi/2], phi_difference in [-pi, pi].
struct HalfDifferenceAngles {
  double theta_half, theta_difference, phi_difference;
};

/// Of two unit vectors with z > 0. Where the half vector is the normal, its azimuth is taken to be 0.
/// Greatest error: 1e-15.
inline HalfDifferenceAngles half_difference_angles(const glm::dvec3& wi, const glm::dvec3& wo) {
  const glm::dvec3 sum = wi + wo, difference = wi - wo;
  const double rho = std::hypot(sum.x, sum.y), length = std::hypot(rho, sum.z);
  const double cos_phi = rho > 0.0 ? sum.x / rho : 1.0, sin_phi = rho > 0.0 ? sum.y / rho : 0.0;
  // wi - wo is normal to the half vector: its azimuth around it is that of wi
  const double along = cos_phi * difference.x + sin_phi * difference.y;
  const double x = (sum.z * along - rho * difference.z) / length, y = cos_phi * difference.y - sin_phi * difference.x;
  return {std::atan2(rho, sum.z), std::atan2(std::hypot(x, y), length), std::atan2(y, x)};
}

/// A material of the MERL database: see above for what it is between samples, and where none was measured.
class MerlBrdf {
 public:
  static constexpr int theta_half_bins = 90, theta_difference_bins = 90, phi_difference_bins = 180;
  static constexpr std::size_t bins = std::size_t{theta_half_bins} * theta_difference_bins * phi_difference_bins;

  /// One sample per bin, RGB in 1/sr, phi_difference fastest, then theta_difference; negative, or missing: not
  /// measured.
  explicit MerlBrdf(std::vector<glm::vec3> samples) : samples_(std::move(samples)) {
    assert(samples_.size() == bins);
    samples_.resize(bins, glm::vec3(-1.0F));
  }

  const std::vector<glm::vec3>& samples() const { return samples_; }

  /// The BRDF, RGB in 1/sr, for unit vectors in the local frame; zero when either has z <= 0. Reciprocal up to
  /// rounding. Greatest error against the function sampled, relative to its largest value, both directions within 80
  /// degrees of the normal: GGX of roughness 0.1 6e-3, 0.3 to 1 3.5e-3; of 7 bands of their projection 2e-3.
  glm::dvec3 operator()(const glm::dvec3& wi, const glm::dvec3& wo) const {
    if (!detail::above_horizon(wi, wo)) return glm::dvec3(0.0);
    const HalfDifferenceAngles angles = half_difference_angles(wi, wo);
    const double half_turn = double(kPi), right_angle = 0.5 * half_turn;
    const Place half = place(std::sqrt(angles.theta_half / right_angle), theta_half_bins);
    const Place theta = place(angles.theta_difference / right_angle, theta_difference_bins);
    const Place phi = periodic_place(angles.phi_difference / half_turn, phi_difference_bins);

    glm::dvec3 sum(0.0), weights(0.0);
    for (int corner = 0; corner < 8; ++corner) {
      const bool h = (corner & 4) != 0, t = (corner & 2) != 0, p = (corner & 1) != 0;
      const double weight = half.weight(h) * theta.weight(t) * phi.weight(p);
      const glm::vec3& sample = samples_[index(half.bin(h), theta.bin(t), phi.bin(p))];
      for (int c = 0; c < 3; ++c) {
        if (sample[c] < 0.0F) continue;
        sum[c] += weight * double(sample[c]);
        weights[c] += weight;
      }
    }
    for (int c = 0; c < 3; ++c) sum[c] = weights[c] > 0.0 ? sum[c] / weights[c] : 0.0;
    return sum;
  }

 private:
  // Two neighbouring bins, and how far the place is from the middle of the first to that of the second.
  struct Place {
    int below, above;
    double t;

    int bin(bool second) const { return second ? above : below; }
    double weight(bool second) const { return second ? t : 1.0 - t; }
  };

  // position in [0, 1]; what is outside, or no number, is moved to an end.
  static Place place(double position, int count) {
    const double x = position * count - 0.5;
    const double inside = x > 0.0 ? (std::min)(x, double(count - 1)) : 0.0;
    const int below = detail::index_below(inside, count - 2);
    return {below, below + 1, inside - below};
  }
  // position of period 1.
  static Place periodic_place(double position, int count) {
    const double turn = position - std::floor(position);
    const double x = (turn > 0.0 ? turn : 0.0) * count + (count - 0.5);  // a period on, to stay positive
    const int below = detail::index_below(x, 2 * count);
    return {below % count, (below + 1) % count, x - below};
  }
  static std::size_t index(int half, int theta, int phi) {
    return std::size_t((half * theta_difference_bins + theta) * phi_difference_bins + phi);
  }

  std::vector<glm::vec3> samples_;
};

namespace detail {

inline constexpr std::size_t merl_header_size = 12;
inline constexpr std::uint64_t merl_file_size = merl_header_size + 3 * 8 * MerlBrdf::bins;
inline constexpr double merl_scale[3] = {1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};
inline constexpr double merl_largest = 1e30;  // 1/sr: what floats can hold, and sums of theirs

inline void check_merl_header(InputFile& file) {
  const std::string whole = " bytes, not the " + std::to_string(merl_file_size) + " of a MERL file";
  if (file.size() < merl_header_size) file.fail("has " + std::to_string(file.size()) + whole);
  std::array<unsigned char, merl_header_size> header;
  file.read(header.data(), header.size());
  constexpr std::uint32_t expected[3] = {MerlBrdf::theta_half_bins, MerlBrdf::theta_difference_bins,
                                         MerlBrdf::phi_difference_bins};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto count = from_little_endian<std::uint32_t>(&header[4 * i]);
    if (count != expected[i]) {
      file.fail("is no MERL file: its count " + std::to_string(i) + " is " + std::to_string(count) + ", not " +
                std::to_string(expected[i]));
    }
  }
  if (file.size() != merl_file_size) file.fail("has " + std::to_string(file.size()) + whole);
}

/// One channel of all samples. True if any is not negative.
inline bool read_merl_plane(InputFile& file, int channel, std::vector<glm::vec3>& samples) {
  constexpr std::size_t block = 4096;
  std::array<unsigned char, 8 * block> bytes;
  bool any = false;
  for (std::size_t done = 0; done < samples.size(); done += block) {
    const std::size_t now = (std::min)(block, samples.size() - done);
    file.read(bytes.data(), 8 * now);
    for (std::size_t i = 0; i < now; ++i) {
      const double stored = same_bits<double>(from_little_endian<std::uint64_t>(&bytes[8 * i]));
      const double value = stored * merl_scale[channel];
      if (!(std::abs(value) <= merl_largest)) {
        file.fail("is damaged: sample " + std::to_string(done + i) + " of channel " + std::to_string(channel) + " is " +
                  std::to_string(stored));
      }
      any = any || value >= 0.0;
      samples[done + i][channel] = float(value);
    }
  }
  return any;
}

}  // namespace detail

/// Reads a file of the MERL database, 35 MB. Throws FileError unless its counts and its size are right, and all its
/// samples are numbers, at most 1e30 / sr, and some not negative.
inline MerlBrdf load_merl(const std::filesystem::path& path) {
  detail::InputFile file(path);
  detail::check_merl_header(file);
  std::vector<glm::vec3> samples(MerlBrdf::bins);
  bool any = false;
  for (int channel = 0; channel < 3; ++channel) any = detail::read_merl_plane(file, channel, samples) || any;
  if (!any) file.fail("is damaged: no sample was measured");
  return MerlBrdf(std::move(samples));
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
