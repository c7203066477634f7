// Inputs of the registry's kernels, drawn by what their parameters are.
#pragma once

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "../scalar/constexpr_math.hpp"
#include "kernel_io.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

/// Which inputs: such as a renderer has, away from poles of functions, for times; the same, but half of the directions
/// at 1e-1 to 1e-7 from an end of the z axis and half of the angles 1e-1 to 1e-4, for errors; or of every size and at
/// the ends of their domains, where nothing but the same operations give the same numbers.
enum class Draw { ordinary, hard, extreme };

/// Random inputs of a kernel of so many bands, in double; the same for the same seed.
class InputSampler {
 public:
  InputSampler(unsigned seed, int bands, Draw draw) : random_(seed), bands_(bands), draw_(draw) {}

  /// One value for every number of the inputs.
  std::vector<double> draw(const std::vector<Parameter>& parameters) {
    std::vector<double> numbers;
    for (const Parameter& p : parameters) {
      if (p.direction == Direction::out) continue;
      for (int i = 0; i < p.elements(); ++i) append(p.domain, p.components, numbers);
    }
    return numbers;
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double sign() { return uniform(0, 1) < 0.5 ? -1 : 1; }
  bool is_extreme() const { return draw_ == Draw::extreme; }
  /// Every second time, of hard inputs.
  bool is_hard() { return draw_ == Draw::hard && uniform(0, 1) < 0.5; }
  bool sometimes() { return is_extreme() && uniform(0, 1) < 0.1; }
  /// Ten to the power of -exponent to exponent.
  double any_size(double exponent) { return std::pow(10, uniform(-exponent, exponent)); }

  void append(Domain domain, int components, std::vector<double>& numbers) {
    switch (domain) {
      case Domain::unit_vector:
        for (const double x : direction()) numbers.push_back(x);
        return;
      case Domain::position:
      case Domain::light_position: {
        const double scale = is_extreme() ? any_size(2) : 1;
        for (int i = 0; i < components; ++i) numbers.push_back(scale * uniform(-1, 1));
        if (domain == Domain::light_position && !is_extreme()) numbers.back() += 3.5;
        return;
      }
      case Domain::angle:
      case Domain::half_angle: {
        const double angle = any_angle(domain == Domain::angle ? double(kPi) : double(kPi) / 2);
        numbers.push_back(std::cos(angle));
        numbers.push_back(std::sin(angle));
        return;
      }
      default: break;
    }
    for (int i = 0; i < components; ++i) numbers.push_back(number(domain));
  }

  double any_angle(double greatest) {
    if (is_hard()) return std::pow(10, uniform(-4, -1));
    if (!is_extreme()) return uniform(1e-3, 0.98 * greatest);
    double angle = sometimes() ? any_size(7) * 1e-7 : uniform(0, greatest);
    if (sometimes()) angle = greatest - std::fmin(angle, greatest);
    return std::fmin(angle, greatest);
  }

  double number(Domain domain) {
    switch (domain) {
      case Domain::length: return is_extreme() ? any_size(6) : uniform(1.5, 20);
      case Domain::radius: return is_extreme() ? any_size(6) : uniform(0.01, 1.4);
      case Domain::cosine: return sometimes() ? sign() : uniform(-1, 1);
      case Domain::exponent: return sometimes() ? 0 : is_extreme() ? any_size(4) : std::exp(uniform(-3, 7));
      case Domain::window_width: return bands_ * any_size(0.5);
      case Domain::cell_coordinate: return sometimes() ? (sign() < 0 ? 0 : 1) : uniform(0, 1);
      case Domain::vertex_count: return std::floor(uniform(2, 65));
      case Domain::row_count: return sometimes() ? 1 : std::floor(uniform(2, 91));
      case Domain::identity: return uniform(0, 1) < 0.1 ? -1 : std::floor(uniform(is_extreme() ? 0 : 1, 3));
      default: return uniform(-1, 1);
    }
  }

  /// A unit vector: anywhere, near a pole, or an axis.
  std::array<double, 3> direction() {
    std::array<double, 3> v{0, 0, 0};
    if (sometimes()) {
      v[static_cast<std::size_t>(uniform(0, 3))] = sign();
      return v;
    }
    if (is_hard()) {
      const double angle = std::pow(10, uniform(-7, -1)), phi = uniform(0, 2 * double(kPi));
      return {std::sin(angle) * std::cos(phi), std::sin(angle) * std::sin(phi), sign() * std::cos(angle)};
    }
    std::normal_distribution<double> normal;
    const double width = is_extreme() && uniform(0, 1) < 0.25 ? any_size(4) * 1e-4 : 1;
    v = {width * normal(random_), width * normal(random_), normal(random_)};
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return {v[0] / length, v[1] / length, v[2] / length};
  }

  std::mt19937 random_;
  int bands_;
  Draw draw_;
};

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
