// The plain way to run an entry of the registry (kernel_list.hpp): numbers in, numbers out, in any scalar.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "../lobe/cap.hpp"
#include "kernel_io.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {
namespace kernels {

/// Hands a kernel its inputs off one array and lays its outputs into another, each in the order in which the kernel
/// names them, gradients as planes (with_triples, kernel_io.hpp); an inout stands in both. Nothing is described,
/// checked or allocated: it can be timed. Entries for colours need `with_colours`; the others are slower with it, for
/// the compiler no longer knows their outputs' stride.
template <class T, bool with_colours = false>
class PlainIo {
 public:
  using Scalar = T;

  PlainIo(const T* inputs, T* outputs, int order = all_orders)
      : inputs_(inputs), outputs_(outputs), first_input_(inputs), first_output_(outputs), order_(order) {}

  void start_channel(Colours colours, int channel) {
    static_assert(with_colours, "a kernel of colours: PlainIo<T, true>");
    colours_ = colours;
    channel_ = channel;
    inputs_ = first_input_;
    outputs_ = first_output_;
  }

  T number(const char*, Domain) { return *inputs_++; }
  std::array<T, 3> vector(const char*, Domain) { return take<3>(); }
  SphericalCap<T> cap(const char*, Domain) {
    const auto values = take<2>();
    return {values[0], values[1]};
  }
  template <int Count>
  std::array<T, std::size_t{Count}> numbers(const char*, Domain) {
    return take<std::size_t{Count}>();
  }
  template <int Count>
  std::array<T, std::size_t{3 * Count}> triples(const char*, Domain) {
    return take<std::size_t{3 * Count}>();
  }
  template <int Count>
  std::array<T, std::size_t{Count}> coefficients(const char*, bool is_first = true) {
    const bool is_coloured = with_colours && (colours_ == Colours::all || (colours_ == Colours::first && is_first));
    return is_coloured ? take<std::size_t{Count}, 3>(channel_) : take<std::size_t{Count}>();
  }

  T coefficient(const char* name) { return coefficients<1>(name)[0]; }

  Numbers<T> output(const char*, int count) {
    if constexpr (!with_colours) {
      return {put(elements(count)), 1};
    } else {
      const int stride = colours_ == Colours::none ? 1 : 3;
      return {put(stride * elements(count)) + channel_, stride};
    }
  }
  Triples<T> output_triples(const char*, int count) { return {put(3 * elements(count))}; }
  template <int N>
  Numbers<T> output_sh(const char* name) {
    return output(name, N * N);
  }
  template <int N>
  Planes<T> output_gradient(const char*) {
    return {put(3 * N * N), N * N};
  }
  Numbers<T> sums(const char*, int count) {
    T* const values = put(elements(count));
    for (int i = 0; i < elements(count); ++i) values[i] = *inputs_++;
    return {values, 1};
  }

  bool keeps(int m) const { return order_ == all_orders || order_ == (m < 0 ? -m : m); }

 private:
  static int elements(int count) { return count > 0 ? count : 1; }

  template <std::size_t Size, std::size_t Stride = 1>
  std::array<T, Size> take(int from = 0) {
    const T* const first = inputs_ + from;
    inputs_ += Stride * Size;
    return take<Stride>(first, std::make_index_sequence<Size>{});
  }
  // Not by a loop: GCC then copies packets by halves, and waits when it reads the whole.
  template <std::size_t Stride, std::size_t... I>
  static std::array<T, sizeof...(I)> take(const T* first, std::index_sequence<I...>) {
    return {first[Stride * I]...};
  }
  T* put(int size) {
    T* const values = outputs_;
    outputs_ += size;
    return values;
  }

  const T* inputs_;
  T* outputs_;
  const T* first_input_;
  T* first_output_;
  int order_;
  Colours colours_ = Colours::none;
  int channel_ = 0;
};

/// Runs an entry with N bands: its inputs from one array, its outputs into another.
template <class Entry, int N, class T>
void run_plainly(const T* inputs, T* outputs) {
  PlainIo<T, Entry::is_coloured> io(inputs, outputs);
  Entry::template run<N>(io);
}

}  // namespace kernels
}  // namespace ZONAL_TARGET
}  // namespace zonal
