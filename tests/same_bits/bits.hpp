// What the kernels of the registry give for fixed inputs, as hashes of the bits, which must be the same whatever the
// compiler, its options, the lanes of a packet and the processor.
#pragma once

#include <zonal/kernels/kernel_io.hpp>
#include <zonal/kernels/sampler.hpp>
#include <zonal/scalar/packet.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace same_bits {

using zonal::kernels::Direction;
using zonal::kernels::Domain;
using zonal::kernels::Draw;
using zonal::kernels::InputSampler;
using zonal::kernels::Parameter;

// SplitMix64.
inline std::uint64_t scrambled(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

// The sampler asks the C library for sines, logarithms and powers, whose last bits differ from processor to processor.
// 20 bits are left of each number, and others put in place of the rest, but for whole numbers.
inline double portable(double x, std::uint64_t& state) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits = (bits + (std::uint64_t{1} << 31)) & ~((std::uint64_t{1} << 32) - 1);
  state = scrambled(state);
  double rounded;
  std::memcpy(&rounded, &bits, sizeof rounded);
  if (std::floor(rounded) < rounded) bits |= state >> 34;  // 30 bits: a float's last ones too
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

/// Inputs of many runs, one run after the other.
struct Inputs {
  std::size_t runs = 0;
  std::vector<double> numbers;

  template <class T>
  std::vector<T> run(std::size_t i) const {
    const auto size = static_cast<std::ptrdiff_t>(numbers.size() / runs), first = static_cast<std::ptrdiff_t>(i) * size;
    return {numbers.begin() + first, numbers.begin() + first + size};
  }
};

inline constexpr double kHostile[] = {
    std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity(),
    0.0,
    1e-42,
    3e38,
};

/// Ordinary, hard and extreme ones in range, and ordinary ones of which one number after the other is hostile.
inline Inputs inputs_of(const std::vector<Parameter>& parameters, int bands) {
  constexpr int draws = 128;
  constexpr std::size_t most_lanes = 16;
  std::uint64_t state = 0;
  Inputs inputs;
  const auto append = [&](const std::vector<double>& numbers) {
    inputs.numbers.insert(inputs.numbers.end(), numbers.begin(), numbers.end());
    ++inputs.runs;
  };
  const auto draw = [&](InputSampler& sampler) {
    std::vector<double> numbers = sampler.draw(parameters);
    for (double& number : numbers) number = portable(number, state);
    return numbers;
  };
  for (const Draw kind : {Draw::ordinary, Draw::hard, Draw::extreme}) {
    InputSampler sampler(21, bands, kind);
    for (int i = 0; i < draws; ++i) append(draw(sampler));
  }
  InputSampler sampler(22, bands, Draw::ordinary);
  const std::vector<double> base = draw(sampler);
  for (std::size_t k = 0; k < base.size(); ++k) {
    for (const double hostile : kHostile) {
      std::vector<double> numbers = base;
      numbers[k] = hostile;
      append(numbers);
    }
  }
  while (inputs.runs % most_lanes != 0) append(base);
  return inputs;
}

// FNV-1a; one NaN is as good as another.
template <class T>
std::uint64_t hash_of(const std::vector<T>& numbers) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const T& number : numbers) {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &number, sizeof(T));
    if (std::isnan(number)) std::memset(bytes, 0xff, sizeof(T));
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001b3U;
  }
  return hash;
}

/// A kernel: `name`, `parameters`, and run(inputs), of any scalar, which gives what it gives.
template <class T, class Kernel>
std::vector<T> results_of(const Kernel& kernel, const Inputs& inputs) {
  std::vector<T> results;
  for (std::size_t i = 0; i < inputs.runs; ++i) {
    const std::vector<T> given = kernel.run(inputs.run<T>(i));
    results.insert(results.end(), given.begin(), given.end());
  }
  return results;
}

// The same, W runs at a time.
template <class T, int W, class Kernel>
std::vector<T> results_in_packets(const Kernel& kernel, const Inputs& inputs) {
  using P = zonal::Packet<T, W>;
  std::vector<T> results;
  for (std::size_t first = 0; first < inputs.runs; first += W) {
    std::vector<P> in;
    for (int lane = 0; lane < W; ++lane) {
      const std::vector<T> run = inputs.run<T>(first + static_cast<std::size_t>(lane));
      in.resize(run.size(), P(0));
      for (std::size_t k = 0; k < run.size(); ++k) in[k].set(lane, run[k]);
    }
    const std::vector<P> given = kernel.run(in);
    for (int lane = 0; lane < W; ++lane) {
      for (const P& number : given) results.push_back(number[lane]);
    }
  }
  return results;
}

inline std::string hexadecimal(std::uint64_t number) {
  char text[24];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
  return text;
}

/// "name, hash in float, hash in double", as tests/data/same_bits.txt has it. Packets of T and W must give what their
/// scalar gives: where they do not, the line says so.
template <class Kernel>
class Line {
 public:
  Line(const Kernel& kernel, int bands)
      : kernel_(kernel),
        inputs_(inputs_of(kernel.parameters, bands)),
        in_float_(hash_of(results_of<float>(kernel, inputs_))),
        in_double_(hash_of(results_of<double>(kernel, inputs_))),
        text_(std::string(kernel.name) + " " + hexadecimal(in_float_) + " " + hexadecimal(in_double_)) {}

  template <class T, int W>
  void add_packets() {
    const std::uint64_t hash = hash_of(results_in_packets<T, W>(kernel_, inputs_));
    if (hash == (sizeof(T) == sizeof(float) ? in_float_ : in_double_)) return;
    text_ +=
        ", but in " + std::to_string(W) + (sizeof(T) == sizeof(float) ? " floats " : " doubles ") + hexadecimal(hash);
  }
  const std::string& text() const { return text_; }

 private:
  const Kernel& kernel_;
  Inputs inputs_;
  std::uint64_t in_float_, in_double_;
  std::string text_;
};

}  // namespace same_bits
