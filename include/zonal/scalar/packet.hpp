// W lanes at once: SIMD over directions, lights, grid points or pixels. Needs Eigen.
//
// A thin eager type over Eigen's fixed-size arrays: every operation gives a Packet, never an expression.
#pragma once

#include <Eigen/Core>

#include "scalar.hpp"

// GCC 12 takes the undefined register inside its own AVX-512 intrinsics for a mistake (GCC bug 105593).
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

namespace zonal {

namespace detail {
// Eigen's widest register type that divides W values, and a loop over the registers of its arrays. Comparing and
// selecting go through these because Eigen's own arrays of bool are not vectorised.
template <class T, int W>
using Register = typename Eigen::internal::find_best_packet<T, W>::type;

template <class T, int W, class F, class... Arrays>
Eigen::Array<T, W, 1> map_registers(F f, const Arrays&... arrays) {
  constexpr int step = Eigen::internal::unpacket_traits<Register<T, W>>::size;
  static_assert(W % step == 0, "the width of a packet fills whole registers: 4, 8, 16, ... floats");
  Eigen::Array<T, W, 1> result;
  for (int i = 0; i < W; i += step) {
    Eigen::internal::pstoreu(result.data() + i,
                             f(Eigen::internal::ploadu<Register<T, W>>(arrays.data() + i)...));
  }
  return result;
}
}  // namespace detail

/// What comparing two packets gives: in each lane all bits set, or none.
template <class T, int W>
struct PacketMask {
  Eigen::Array<T, W, 1> bits;
};

/// W values of a built-in T. For speed W * sizeof(T) is 16, 32 or 64 bytes; see kNativeLanes.
template <class T, int W>
struct Packet {
  static_assert(is_builtin_scalar_v<T> && W >= 1, "a packet holds W >= 1 built-in scalars");
  using Array = Eigen::Array<T, W, 1>;
  static constexpr int width = W;

  Array lanes;

  Packet() = default;
  template <class C, class = std::enable_if_t<std::is_arithmetic_v<C>>>
  explicit Packet(C constant) : lanes(Array::Constant(static_cast<T>(constant))) {}
  explicit Packet(const Array& values) : lanes(values) {}

  /// W consecutive values; `values` may have any alignment.
  static Packet load(const T* values) { return Packet(Array(Eigen::Map<const Array>(values))); }
  void store(T* values) const { Eigen::Map<Array>{values} = lanes; }

  T operator[](int lane) const { return lanes[lane]; }
  T& operator[](int lane) { return lanes[lane]; }
  T sum() const { return lanes.sum(); }

  Packet operator-() const { return Packet(Array(-lanes)); }
  friend Packet operator+(const Packet& a, const Packet& b) { return Packet(Array(a.lanes + b.lanes)); }
  friend Packet operator-(const Packet& a, const Packet& b) { return Packet(Array(a.lanes - b.lanes)); }
  friend Packet operator*(const Packet& a, const Packet& b) { return Packet(Array(a.lanes * b.lanes)); }
  friend Packet operator/(const Packet& a, const Packet& b) { return Packet(Array(a.lanes / b.lanes)); }

  friend Packet min(const Packet& a, const Packet& b) { return Packet(Array(a.lanes.min(b.lanes))); }
  friend Packet max(const Packet& a, const Packet& b) { return Packet(Array(a.lanes.max(b.lanes))); }
  friend Packet abs(const Packet& a) { return Packet(Array(a.lanes.abs())); }
  friend Packet sqrt(const Packet& a) { return Packet(Array(a.lanes.sqrt())); }
  friend Packet exp(const Packet& a) { return Packet(Array(a.lanes.exp())); }

  friend PacketMask<T, W> operator<(const Packet& a, const Packet& b) {
    return {detail::map_registers<T, W>(
        [](const auto& x, const auto& y) { return Eigen::internal::pcmp_lt(x, y); }, a.lanes, b.lanes)};
  }
  friend PacketMask<T, W> operator<=(const Packet& a, const Packet& b) {
    return {detail::map_registers<T, W>(
        [](const auto& x, const auto& y) { return Eigen::internal::pcmp_le(x, y); }, a.lanes, b.lanes)};
  }
  friend PacketMask<T, W> operator>(const Packet& a, const Packet& b) { return b < a; }
  friend PacketMask<T, W> operator>=(const Packet& a, const Packet& b) { return b <= a; }

  friend Packet select(const PacketMask<T, W>& mask, const Packet& a, const Packet& b) {
    return Packet(detail::map_registers<T, W>(
        [](const auto& m, const auto& x, const auto& y) { return Eigen::internal::pselect(m, x, y); }, mask.bits,
        a.lanes, b.lanes));
  }
};

template <class T, int W>
struct ScalarTraits<Packet<T, W>> {
  using Lane = T;
};

/// Floats in one register of the target this file is compiled for: 16 with AVX-512, 8 with AVX, else 4.
#if defined(__AVX512F__)
inline constexpr int kNativeLanes = 16;
#elif defined(__AVX__)
inline constexpr int kNativeLanes = 8;
#else
inline constexpr int kNativeLanes = 4;
#endif

}  // namespace zonal

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
