// W lanes at once: SIMD over directions, lights, grid points or pixels. Needs Eigen.
//
// A thin eager type over Eigen's registers: every operation gives a Packet, never an expression.
#pragma once

#include <Eigen/Core>

#include "lanes.hpp"
#include "scalar.hpp"
#include "unroll.hpp"

// GCC 12 takes the undefined register inside its own AVX-512 intrinsics for a mistake (GCC bug 105593).
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {
// W values as Eigen's widest registers that divide W: registers, not Eigen's arrays and expressions, which GCC copies
// by halves and stops inlining in a large kernel (20 times slower).
template <class T, int W>
struct Registers {
  using Register = typename Eigen::internal::find_best_packet<T, W>::type;
  static constexpr int step = Eigen::internal::unpacket_traits<Register>::size;
  static_assert(W % step == 0, "the width of a packet fills whole registers: 4, 8, 16, ... floats");

  Register values[static_cast<std::size_t>(W / step)];

  // f of each register, or of each pair or triple of them.
  template <class F, class... Operands>
  ZONAL_INLINE static Registers map(F f, const Operands&... operands) {
    Registers result;
    for (int i = 0; i < W / step; ++i) result.values[i] = f(operands.values[i]...);
    return result;
  }
};
}  // namespace detail

/// What comparing two packets gives: in each lane all bits set, or none.
template <class T, int W>
struct PacketMask {
  detail::Registers<T, W> bits;
};

/// W values of a built-in T, which fill whole registers: 4, 8, 16 ... floats.
template <class T, int W>
struct Packet {
  static_assert(is_builtin_scalar_v<T> && W >= 1, "a packet holds W >= 1 built-in scalars");
  using Registers = detail::Registers<T, W>;
  using Mask = PacketMask<T, W>;
  static constexpr int width = W;

  Registers lanes;

  Packet() = default;
  template <class C, class = std::enable_if_t<std::is_arithmetic_v<C>>>
  ZONAL_INLINE explicit Packet(C constant)
      : lanes(Registers::map(
            [constant] { return Eigen::internal::pset1<typename Registers::Register>(static_cast<T>(constant)); })) {}
  ZONAL_INLINE explicit Packet(const Registers& registers) : lanes(registers) {}

  /// W consecutive values; `values` may have any alignment.
  ZONAL_INLINE static Packet load(const T* values) {
    Packet r;
    for (int i = 0; i < W / Registers::step; ++i) {
      r.lanes.values[i] = Eigen::internal::ploadu<typename Registers::Register>(values + i * Registers::step);
    }
    return r;
  }
  /// K values, each in W / K consecutive lanes.
  template <int K>
  ZONAL_INLINE static Packet blocks(const T (&values)[std::size_t{K}]) {
    static_assert(W % (K * Registers::step) == 0, "each block fills whole registers");
    Packet r;
    for (int i = 0; i < W / Registers::step; ++i) {
      r.lanes.values[i] = Eigen::internal::pset1<typename Registers::Register>(values[i * Registers::step * K / W]);
    }
    return r;
  }
  /// The same lanes K times over.
  template <int K>
  ZONAL_INLINE Packet<T, W * K> repeated() const {
    Packet<T, W * K> r;
    for (int i = 0; i < K * W / Registers::step; ++i) r.lanes.values[i] = lanes.values[i % (W / Registers::step)];
    return r;
  }
  /// K packets side by side.
  template <int K>
  ZONAL_INLINE static Packet side_by_side(const Packet<T, W / K> (&parts)[std::size_t{K}]) {
    Packet r;
    constexpr int count = W / K / Registers::step;
    for (int i = 0; i < W / Registers::step; ++i) r.lanes.values[i] = parts[i / count].lanes.values[i % count];
    return r;
  }
  ZONAL_INLINE void store(T* values) const {
    for (int i = 0; i < W / Registers::step; ++i) {
      Eigen::internal::pstoreu(values + i * Registers::step, lanes.values[i]);
    }
  }

  /// One lane, for set-up and tests: not for kernels.
  T operator[](int lane) const {
    T values[static_cast<std::size_t>(W)];
    store(values);
    return values[lane];
  }
  void set(int lane, T value) {
    T values[static_cast<std::size_t>(W)];
    store(values);
    values[lane] = value;
    *this = load(values);
  }
  /// The sum of the lanes, in a fixed order.
  T sum() const {
    T values[static_cast<std::size_t>(W)];
    store(values);
    T total = values[0];
    for (int i = 1; i < W; ++i) total += values[i];
    return total;
  }

  ZONAL_INLINE friend Packet operator-(const Packet& a) {
    return Packet(Registers::map([](const auto& x) ZONAL_INLINE { return Eigen::internal::pnegate(x); }, a.lanes));
  }
  ZONAL_INLINE friend Packet operator+(const Packet& a, const Packet& b) {
    return Packet(Registers::map([](const auto& x, const auto& y) ZONAL_INLINE { return Eigen::internal::padd(x, y); },
                                 a.lanes, b.lanes));
  }
  ZONAL_INLINE friend Packet operator-(const Packet& a, const Packet& b) {
    return Packet(Registers::map([](const auto& x, const auto& y) ZONAL_INLINE { return Eigen::internal::psub(x, y); },
                                 a.lanes, b.lanes));
  }
  ZONAL_INLINE friend Packet operator*(const Packet& a, const Packet& b) {
    return Packet(Registers::map([](const auto& x, const auto& y) ZONAL_INLINE { return Eigen::internal::pmul(x, y); },
                                 a.lanes, b.lanes));
  }
  ZONAL_INLINE friend Packet operator/(const Packet& a, const Packet& b) {
    return Packet(Registers::map([](const auto& x, const auto& y) ZONAL_INLINE { return Eigen::internal::pdiv(x, y); },
                                 a.lanes, b.lanes));
  }
  ZONAL_INLINE friend Packet minimum(const Packet& a, const Packet& b) {
    return Packet(Registers::map([](const auto& x, const auto& y) ZONAL_INLINE { return Eigen::internal::pmin(x, y); },
                                 a.lanes, b.lanes));
  }
  ZONAL_INLINE friend Packet maximum(const Packet& a, const Packet& b) {
    return Packet(Registers::map([](const auto& x, const auto& y) ZONAL_INLINE { return Eigen::internal::pmax(x, y); },
                                 a.lanes, b.lanes));
  }
  ZONAL_INLINE friend Packet abs(const Packet& a) {
    return Packet(Registers::map([](const auto& x) ZONAL_INLINE { return Eigen::internal::pabs(x); }, a.lanes));
  }
  ZONAL_INLINE friend Packet sqrt(const Packet& a) {
    return Packet(Registers::map([](const auto& x) ZONAL_INLINE { return Eigen::internal::psqrt(x); }, a.lanes));
  }

  ZONAL_INLINE friend Mask operator<(const Packet& a, const Packet& b) {
    return {Registers::map([](const auto& x, const auto& y) ZONAL_INLINE { return Eigen::internal::pcmp_lt(x, y); },
                           a.lanes, b.lanes)};
  }
  ZONAL_INLINE friend Mask operator<=(const Packet& a, const Packet& b) {
    return {Registers::map([](const auto& x, const auto& y) ZONAL_INLINE { return Eigen::internal::pcmp_le(x, y); },
                           a.lanes, b.lanes)};
  }
  ZONAL_INLINE friend Mask operator>(const Packet& a, const Packet& b) { return b < a; }
  ZONAL_INLINE friend Mask operator>=(const Packet& a, const Packet& b) { return b <= a; }

  ZONAL_INLINE friend Packet select(const Mask& mask, const Packet& a, const Packet& b) {
    return Packet(Registers::map([](const auto& m, const auto& x, const auto& y)
                                     ZONAL_INLINE { return Eigen::internal::pselect(m, x, y); },
                                 mask.bits, a.lanes, b.lanes));
  }
};

/// sum += a * b, where a and b may have several times the lanes: all of them are added up.
template <class T, int W, int V>
ZONAL_INLINE inline void add_product(Packet<T, W>& sum, const Packet<T, V>& a, const Packet<T, V>& b) {
  constexpr int step = Packet<T, W>::Registers::step;
  static_assert(V % W == 0 && Packet<T, V>::Registers::step == step, "whole multiples, in registers of one size");
  for (int i = 0; i < V / step; ++i) {
    auto& target = sum.lanes.values[i % (W / step)];
    target = Eigen::internal::pmadd(a.lanes.values[i], b.lanes.values[i], target);
  }
}
template <class T, int W>  // for the compiler, which has no preference between the above and the one of any scalar
ZONAL_INLINE inline void add_product(Packet<T, W>& sum, const Packet<T, W>& a, const Packet<T, W>& b) {
  add_product<T, W, W>(sum, a, b);
}
template <class T, int W>
ZONAL_INLINE inline void subtract_product(Packet<T, W>& sum, const Packet<T, W>& a, const Packet<T, W>& b) {
  add_product<T, W, W>(sum, -a, b);
}

template <class T, int W>
struct ScalarTraits<Packet<T, W>> {
  using Lane = T;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
