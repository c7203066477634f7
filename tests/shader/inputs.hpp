// Inputs of a shader function: random, and the ends of their domains.
#pragma once

#include <zonal/kernels/kernel_io.hpp>

#include <array>
#include <cmath>
#include <random>
#include <vector>

class InputSampler {
 public:
  InputSampler(unsigned seed, int bands) : random_(seed), bands_(bands) {}

  /// One value for every number of the function's inputs.
  std::vector<float> draw(const std::vector<zonal::kernels::Parameter>& parameters) {
    std::vector<float> numbers;
    for (const auto& p : parameters) {
      if (p.direction == zonal::kernels::Direction::out) continue;
      for (int i = 0; i < p.elements(); ++i) append(p.domain, p.components, numbers);
    }
    return numbers;
  }

 private:
  using Domain = zonal::kernels::Domain;

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool sometimes() { return uniform(0, 1) < 0.1; }
  /// Ten to the power of -exponent to exponent.
  double any_size(double exponent) { return std::pow(10, uniform(-exponent, exponent)); }

  void append(Domain domain, int components, std::vector<float>& numbers) {
    const auto put = [&](double value) { numbers.push_back(static_cast<float>(value)); };
    const double quarter = std::acos(-1.0) / 2;
    switch (domain) {
      case Domain::unit_vector:
        for (const double x : direction()) put(x);
        return;
      case Domain::position: {
        const double scale = any_size(2);
        for (int i = 0; i < components; ++i) put(scale * uniform(-1, 1));
        return;
      }
      case Domain::angle:
      case Domain::half_angle: {
        const double greatest = domain == Domain::angle ? 2 * quarter : quarter;
        double angle = sometimes() ? any_size(7) * 1e-7 : uniform(0, greatest);
        if (sometimes()) angle = greatest - std::fmin(angle, greatest);
        put(std::cos(std::fmin(angle, greatest)));
        put(std::sin(std::fmin(angle, greatest)));
        return;
      }
      default: break;
    }
    for (int i = 0; i < components; ++i) put(number(domain));
  }

  double number(Domain domain) {
    switch (domain) {
      case Domain::length: return any_size(6);
      case Domain::cosine: return sometimes() ? (uniform(0, 1) < 0.5 ? -1 : 1) : uniform(-1, 1);
      case Domain::exponent: return sometimes() ? 0 : any_size(4);
      case Domain::window_width: return bands_ * any_size(0.5);
      case Domain::cell_coordinate: return sometimes() ? (uniform(0, 1) < 0.5 ? 0 : 1) : uniform(0, 1);
      case Domain::vertex_count: return std::floor(uniform(2, 65));
      default: return uniform(-1, 1);
    }
  }

  /// A unit vector: anywhere, near a pole, or an axis.
  std::array<double, 3> direction() {
    std::array<double, 3> v{0, 0, 0};
    if (sometimes()) {
      v[static_cast<std::size_t>(uniform(0, 3))] = uniform(0, 1) < 0.5 ? -1 : 1;
      return v;
    }
    std::normal_distribution<double> normal;
    const double width = uniform(0, 1) < 0.25 ? any_size(4) * 1e-4 : 1;
    v = {width * normal(random_), width * normal(random_), normal(random_)};
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return {v[0] / length, v[1] / length, v[2] / length};
  }

  std::mt19937 random_;
  int bands_;
};
