#include "search.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "replay.hpp"

namespace zonal_prove {

namespace {

using zonal::kernels::Domain;
using zonal::kernels::Parameter;

template <class T>
class Climber {
 public:
  Climber(const Subject& subject, double greatest, unsigned seed)
      : subject_(subject), replay_(subject), greatest_(greatest), random_(seed) {
    for (const Parameter& p : subject.parameters) {
      if (p.direction != zonal::kernels::Direction::out) parameters_.push_back(p);
    }
  }

  WorstInput run(int climbs, int steps) {
    for (int climb = 0; climb < climbs; ++climb) {
      std::vector<T> best = fresh();
      double error = error_at(best);
      for (int i = 0; i < 64; ++i) {
        std::vector<T> other = fresh();
        if (const double e = error_at(other); e > error) error = e, best = other;
      }
      for (int since = 0; since < steps; ++since) {
        std::vector<T> other = neighbour(best);
        if (other.empty()) continue;
        const double e = error_at(other);
        if (e > error) since = 0;
        if (e >= error) error = e, best = other;
      }
      if (error > worst_.error) worst_.error = error, worst_.inputs.assign(best.begin(), best.end());
    }
    return worst_;
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool one_in(int n) { return std::uniform_int_distribution<int>(1, n)(random_) == 1; }

  double error_at(const std::vector<T>& inputs) {
    ++worst_.tried;
    replay_.run(inputs);
    const double error = replay_.error();
    if (!std::isfinite(error)) ++worst_.not_numbers;
    return std::isfinite(error) ? error : 0;
  }

  std::vector<T> fresh() {
    std::vector<T> inputs;
    const auto add = [&](double x) { inputs.push_back(static_cast<T>(x)); };
    constexpr double pi = 3.14159265358979323846;
    for (const Parameter& p : parameters_) {
      switch (p.domain) {
        case Domain::unit_vector: {
          const double z = one_in(2) ? uniform(-1, 1) : std::cos(std::pow(10, uniform(-7, 0))) * (one_in(2) ? 1 : -1);
          const double phi = uniform(0, 2 * pi), s = std::sqrt((1 - z) * (1 + z));
          add(s * std::cos(phi)), add(s * std::sin(phi)), add(z);
          break;
        }
        case Domain::cosine: add(one_in(2) ? uniform(-1, 1) : std::cos(std::pow(10, uniform(-4, 0)))); break;
        case Domain::angle:
        case Domain::half_angle: {
          const double a = one_in(2) ? uniform(0, pi / 2) : std::pow(10, uniform(-12, 0));
          add((p.domain == Domain::angle && one_in(2) ? -1 : 1) * std::cos(a)), add(std::sin(a));
          break;
        }
        case Domain::exponent: add(one_in(2) ? uniform(0, greatest_) : greatest_ * std::pow(10, uniform(-9, 0))); break;
        default:
          for (int i = 0; i < p.size(); ++i) add(uniform(-1, 1));
      }
    }
    return inputs;
  }

  T moved(T x) {
    const int ulps = std::uniform_int_distribution<int>(1, one_in(2) ? 2 : 64)(random_);
    const T towards = (one_in(2) ? 1 : -1) * std::numeric_limits<T>::infinity();
    for (int i = 0; i < ulps; ++i) x = std::nextafter(x, towards);
    return x;
  }

  /// Empty where it would leave the domain.
  std::vector<T> neighbour(std::vector<T> inputs) {
    std::size_t first = 0;
    const auto which = std::uniform_int_distribution<std::size_t>(0, inputs.size() - 1)(random_);
    for (const Parameter& p : parameters_) {
      const auto size = static_cast<std::size_t>(p.size());
      const bool is_here = which >= first && which < first + size;
      T* const at = &inputs[first];
      first += size;
      if (!is_here) continue;
      const bool is_vector = p.domain == Domain::unit_vector;
      const bool is_angle = p.domain == Domain::angle || p.domain == Domain::half_angle;
      if ((is_vector || is_angle) && one_in(2)) {  // a turn
        const double size_of_turn = std::pow(10, uniform(-7, -1));
        double squares = 0, v[3] = {};
        for (std::size_t i = 0; i < size; ++i) {
          v[i] = static_cast<double>(at[i]) + size_of_turn * uniform(-1, 1) * (is_angle ? double(at[1]) : 1);
          squares += v[i] * v[i];
        }
        for (std::size_t i = 0; i < size; ++i) at[i] = static_cast<T>(v[i] / std::sqrt(squares));
      } else {
        T& x = at[which - (first - size)];
        x = moved(x);
        if (!is_vector && !is_angle && one_in(4))
          x *= static_cast<T>(1 + uniform(-1, 1) * std::pow(10, uniform(-6, -1)));
      }
      if (!is_inside(p, at)) return {};
    }
    return inputs;
  }

  /// Rounded unit vectors, cosines and sines may be off by half an ulp of 1 each.
  bool is_inside(const Parameter& p, const T* at) const {
    const double slack = 1.5 * static_cast<double>(std::numeric_limits<T>::epsilon());
    long double squares = 0;
    for (int i = 0; i < p.size(); ++i) squares += static_cast<long double>(at[i]) * static_cast<long double>(at[i]);
    const bool is_unit = std::abs(static_cast<double>(squares - 1)) <= slack;
    switch (p.domain) {
      case Domain::unit_vector: return is_unit;
      case Domain::angle: return is_unit && at[1] > T(1e-12);
      case Domain::half_angle: return is_unit && at[0] >= T(0) && at[1] > T(1e-12);
      case Domain::cosine: return std::abs(at[0]) <= T(1);
      case Domain::exponent: return at[0] >= T(0) && at[0] <= static_cast<T>(greatest_);
      default: return std::abs(at[0]) <= T(1);
    }
  }

  const Subject& subject_;
  Replay<T, long double> replay_;
  double greatest_;
  std::mt19937 random_;
  std::vector<Parameter> parameters_;
  WorstInput worst_;
};

}  // namespace

WorstInput search(const Subject& subject, double greatest, unsigned seed, int climbs, int steps) {
  if (subject.trace.digits == std::numeric_limits<float>::digits) {
    return Climber<float>(subject, greatest, seed).run(climbs, steps);
  }
  return Climber<double>(subject, greatest, seed).run(climbs, steps);
}

}  // namespace zonal_prove
