// The parameters of a kernel, and the objects through which it takes and gives them in any scalar.
//
// An entry of the table (kernel_list.hpp) names its inputs and outputs as it uses them:
//
//   const auto direction = io.vector("direction", Domain::unit_vector);
//   auto y = io.output("y", N * N);
//   evaluate<N>(direction[0], direction[1], direction[2], [&](auto l, auto m, const T& value) { y(l, m) = value; });
//
// There are two: DescribingIo, which keeps the parameters too, for whoever records a kernel or must know its inputs;
// and PlainIo (plain_io.hpp), for whoever runs it. With a Recorder the first writes the shader function down.
//
// An entry for colours (OfColours in kernel_list.hpp) runs the same kernel three times, a channel at a time: its
// coefficients are then triples, and what does not depend on them is shared, for a record holds no operation twice.
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

#include "../basis/sh.hpp"
#include "../lobe/cap.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

/// What the numbers of an input are: for documentation, and to draw them from (sampler.hpp).
enum class Domain {
  coefficient,      // any number of moderate size
  unit_vector,      //
  position,         // any point
  light_position,   // any point; ordinary ones are clear of the positions
  length,           // > 0
  radius,           // > 0; ordinary ones are shorter than lengths
  angle,            // its cosine and sine, 0 to pi
  half_angle,       // its cosine and sine, 0 to pi/2
  cosine,           // -1 to 1
  exponent,         // >= 0
  window_width,     // > 0
  cell_coordinate,  // 0 to 1
  vertex_count,     // a whole number, >= 2
  row_count,        // a whole number, >= 1
  identity,         // a whole number; below 0 there is nothing
};

enum class Direction { in, out, inout };

/// `count` numbers, pairs or triples, by `components`; count 0 is a single one that is no array.
struct Parameter {
  const char* name;
  Direction direction;
  Domain domain;
  int components;
  int count;
  bool has_orders = false;   // whether (l, m) stands at l (l + 1) + m
  bool is_gradient = false;  // triples that the kernel leaves as planes

  bool is_array() const { return count > 0; }
  int elements() const { return is_array() ? count : 1; }
  int size() const { return elements() * components; }
};

/// The order of what a kernel gives: output after output, inouts too, in the order in which it names them, each as the
/// array that a shader function has; but gradients are planes, d/dx of all coefficients, then d/dy, then d/dz, as the
/// library has them and computes them fastest. This brings them into the order of the shader function.
template <class T>
std::vector<T> with_triples(const std::vector<Parameter>& parameters, const std::vector<T>& given) {
  std::vector<T> result;
  std::size_t first = 0;
  for (const Parameter& p : parameters) {
    if (p.direction == Direction::in) continue;
    for (int i = 0; i < p.size(); ++i) {
      const int place = p.is_gradient ? i % 3 * p.count + i / 3 : i;
      result.push_back(given[first + static_cast<std::size_t>(place)]);
    }
    first += static_cast<std::size_t>(p.size());
  }
  return result;
}

/// Numbers, or triples of them, that a kernel writes; an inout also reads them.
template <class T>
struct Numbers {
  T* values;
  int stride;  // 3 where they are one channel of colours
  ZONAL_INLINE T& operator[](int i) const { return values[stride * i]; }
};
template <class T>
struct Triples {
  T* values;
  T* operator[](int i) const { return values + 3 * i; }
  void set(int i, const T& x, const T& y, const T& z) const {
    values[3 * i] = x, values[3 * i + 1] = y, values[3 * i + 2] = z;
  }
};

/// A gradient by x, y and z: `size` numbers of each.
template <class T>
struct Planes {
  T* values;
  int size;
  T* operator[](int axis) const { return values + axis * size; }
  void set(int i, const T& x, const T& y, const T& z) const {
    values[i] = x, values[size + i] = y, values[2 * size + i] = z;
  }
};

/// Where a kernel that gives (l, m, value), or (l, m, value, d/dx, d/dy, d/dz), is to leave them.
template <class T>
struct ShOutput {
  Numbers<T> values;
  template <int l, int m>
  ZONAL_INLINE void operator()(Index<l>, Index<m>, const T& value) const {
    values[sh_index(l, m)] = value;
  }
};
template <class T>
struct GradientOutput {
  Numbers<T> values;
  Planes<T> gradient;
  template <int l, int m>
  ZONAL_INLINE void operator()(Index<l>, Index<m>, const T& value, const T& x, const T& y, const T& z) const {
    values[sh_index(l, m)] = value;
    gradient.set(sh_index(l, m), x, y, z);
  }
};
/// The same of a zonal function, (l, value).
template <class T>
struct ZonalOutput {
  Numbers<T> values;
  template <int l>
  ZONAL_INLINE void operator()(Index<l>, const T& value) const {
    values[l] = value;
  }
};

inline constexpr int all_orders = -1;

/// Which coefficients are colours: none; those of the first operand; those of all.
enum class Colours { none, first, all };

/// Hands a kernel its inputs, collects its outputs, and keeps what it calls them.
template <class T>
class DescribingIo {
 public:
  using Scalar = T;
  /// The next number of an input.
  using Source = std::function<T(const Parameter& parameter)>;

  explicit DescribingIo(Source source, int order = all_orders) : source_(std::move(source)), order_(order) {}

  /// The kernel is about to run for a channel, 0, 1 and 2 in turn. Results are colours then.
  void start_channel(Colours colours, int channel) {
    colours_ = colours;
    channel_ = channel;
    next_input_ = next_output_ = 0;
  }

  T number(const char* name, Domain domain) { return take<1>({name, Direction::in, domain, 1, 0})[0]; }
  std::array<T, 3> vector(const char* name, Domain domain) { return take<3>({name, Direction::in, domain, 3, 0}); }
  SphericalCap<T> cap(const char* name, Domain domain) {
    const auto values = take<2>({name, Direction::in, domain, 2, 0});
    return {values[0], values[1]};
  }
  template <int Count>
  std::array<T, std::size_t{Count}> numbers(const char* name, Domain domain) {
    return take<std::size_t{Count}>({name, Direction::in, domain, 1, Count});
  }
  template <int Count>
  std::array<T, std::size_t{3 * Count}> triples(const char* name, Domain domain) {
    return take<std::size_t{3 * Count}>({name, Direction::in, domain, 3, Count});
  }

  /// Coefficients of a function on the sphere, of the first operand or another: numbers or colours.
  template <int Count>
  std::array<T, std::size_t{Count}> coefficients(const char* name, bool is_first = true) {
    const bool is_coloured = colours_ == Colours::all || (colours_ == Colours::first && is_first);
    return take<std::size_t{Count}>({name, Direction::in, Domain::coefficient, is_coloured ? 3 : 1, Count},
                                    is_coloured ? 3 : 1);
  }

  /// A single one, of the first operand.
  T coefficient(const char* name) {
    const bool is_coloured = colours_ != Colours::none;
    return take<1>({name, Direction::in, Domain::coefficient, is_coloured ? 3 : 1, 0}, is_coloured ? 3 : 1)[0];
  }

  /// count 0: a single one, which the function returns if it has no other output.
  Numbers<T> output(const char* name, int count) { return result(name, count, false); }
  Triples<T> output_triples(const char* name, int count) {
    return {put({name, Direction::out, Domain::coefficient, 3, count})};
  }
  /// Coefficients, (l, m) at l (l + 1) + m, and gradients in that order.
  template <int N>
  Numbers<T> output_sh(const char* name) {
    return result(name, N * N, true);
  }
  template <int N>
  Planes<T> output_gradient(const char* name) {
    return {put({name, Direction::out, Domain::coefficient, 3, N * N, true, true}), N * N};
  }
  Numbers<T> sums(const char* name, int count) {
    return {put({name, Direction::inout, Domain::coefficient, 1, count}), 1};
  }

  /// Whether coefficients of order m and -m are asked for: all of them, or one pair in a loop over m.
  bool keeps(int m) const { return order_ == all_orders || order_ == (m < 0 ? -m : m); }

  const std::vector<Parameter>& parameters() const { return parameters_; }
  /// The numbers of all outputs and inouts, one after the other, gradients as triples.
  std::vector<T> outputs() const {
    std::vector<T> all;
    for (const auto& values : outputs_) all.insert(all.end(), values.begin(), values.end());
    return with_triples(parameters_, all);
  }

 private:
  // The parameter's numbers, or every third of them, from the channel's on. The first channel asks for them.
  template <std::size_t Size>
  std::array<T, Size> take(const Parameter& parameter, std::size_t stride = 1) {
    if (channel_ == 0) {
      std::vector<T>& all = inputs_.emplace_back();
      for (std::size_t i = 0; i < Size * stride; ++i) all.push_back(source_(parameter));
      parameters_.push_back(parameter);
    }
    const std::vector<T>& all = inputs_[next_input_++];
    std::array<T, Size> values;
    for (std::size_t i = 0; i < Size; ++i) values[i] = all[stride * i + (stride > 1 ? channel() : 0)];
    return values;
  }
  T* put(const Parameter& parameter) {
    if (channel_ == 0) {
      std::vector<T>& values = outputs_.emplace_back(static_cast<std::size_t>(parameter.size()), T(0));
      if (parameter.direction == Direction::inout) {
        for (T& value : values) value = source_(parameter);
      }
      parameters_.push_back(parameter);
    }
    return outputs_[next_output_++].data();
  }
  Numbers<T> result(const char* name, int count, bool has_orders) {
    const bool is_coloured = colours_ != Colours::none;
    T* values = put({name, Direction::out, Domain::coefficient, is_coloured ? 3 : 1, count, has_orders});
    return {values + (is_coloured ? channel() : 0), is_coloured ? 3 : 1};
  }
  std::size_t channel() const { return static_cast<std::size_t>(channel_); }

  Source source_;
  int order_;
  Colours colours_ = Colours::none;
  int channel_ = 0;
  std::size_t next_input_ = 0, next_output_ = 0;
  std::vector<Parameter> parameters_;
  std::deque<std::vector<T>> inputs_, outputs_;  // a deque: kernels hold pointers into it
};

/// What most entries share.
struct Kernel {
  static constexpr bool has_bands = true;              // whether the number of bands matters
  static constexpr int most_bands = 1000;              // as a shader function: more are too many operations
  static constexpr bool is_coloured = false;           // whether it runs a channel at a time
  static constexpr int order_count(int) { return 0; }  // the length of the loop over orders it takes part in
};

template <class... Entries>
struct KernelList {};

/// visit(Entry{}) for each entry of the list, in its order.
template <class Visit, class... Entries>
void for_each_kernel(KernelList<Entries...>, Visit&& visit) {
  (visit(Entries{}), ...);
}

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
