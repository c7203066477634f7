// W lanes at once: SIMD over directions, lights, grid points or pixels.
//
// As many registers as the lanes fill (lanes.hpp), with all that a scalar can do.
#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>

#include "lanes.hpp"
#include "scalar.hpp"

#if defined(ZONAL_COMPILER_VECTORS) && defined(__AVX__)
#include <immintrin.h>
#elif defined(ZONAL_COMPILER_VECTORS) && defined(__SSE2__)
#include <emmintrin.h>
#endif

// GCC 12 takes the undefined register inside its own AVX-512 intrinsics for a mistake (GCC bug 105593).
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wignored-attributes"
#endif

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

// What compilers have no operator for, of a register: here number by number, below by the targets' own instructions.
// The minimum of a and b is b < a ? b : a, also of what is no number.
template <class T, std::size_t bytes>
struct RegisterMath {
  static constexpr int count = static_cast<int>(bytes / sizeof(T));
  using R = typename Lanes<T, count>::Vector;

  template <class F>
  ZONAL_INLINE static R each(F f) {
    R r;
    for (int i = 0; i < count; ++i) r[i] = f(i);
    return r;
  }
  ZONAL_INLINE static R root(const R& a) {
    return each([&](int i) ZONAL_INLINE { return std::sqrt(a[i]); });
  }
  ZONAL_INLINE static R least(const R& a, const R& b) {
    return each([&](int i) ZONAL_INLINE { return minimum(T(a[i]), T(b[i])); });
  }
  ZONAL_INLINE static R greatest(const R& a, const R& b) {
    return each([&](int i) ZONAL_INLINE { return maximum(T(a[i]), T(b[i])); });
  }
};

#if defined(ZONAL_COMPILER_VECTORS) && defined(__SSE2__)
template <>
struct RegisterMath<float, 16> {
  using R = __m128;
  ZONAL_INLINE static R root(R a) { return _mm_sqrt_ps(a); }
  ZONAL_INLINE static R least(R a, R b) { return _mm_min_ps(b, a); }
  ZONAL_INLINE static R greatest(R a, R b) { return _mm_max_ps(b, a); }
};
template <>
struct RegisterMath<double, 16> {
  using R = __m128d;
  ZONAL_INLINE static R root(R a) { return _mm_sqrt_pd(a); }
  ZONAL_INLINE static R least(R a, R b) { return _mm_min_pd(b, a); }
  ZONAL_INLINE static R greatest(R a, R b) { return _mm_max_pd(b, a); }
};
#endif
#if defined(ZONAL_COMPILER_VECTORS) && defined(__AVX__)
template <>
struct RegisterMath<float, 32> {
  using R = __m256;
  ZONAL_INLINE static R root(R a) { return _mm256_sqrt_ps(a); }
  ZONAL_INLINE static R least(R a, R b) { return _mm256_min_ps(b, a); }
  ZONAL_INLINE static R greatest(R a, R b) { return _mm256_max_ps(b, a); }
};
template <>
struct RegisterMath<double, 32> {
  using R = __m256d;
  ZONAL_INLINE static R root(R a) { return _mm256_sqrt_pd(a); }
  ZONAL_INLINE static R least(R a, R b) { return _mm256_min_pd(b, a); }
  ZONAL_INLINE static R greatest(R a, R b) { return _mm256_max_pd(b, a); }
};
#endif
#if defined(ZONAL_COMPILER_VECTORS) && defined(__AVX512F__)
template <>
struct RegisterMath<float, 64> {
  using R = __m512;
  ZONAL_INLINE static R root(R a) { return _mm512_sqrt_ps(a); }
  ZONAL_INLINE static R least(R a, R b) { return _mm512_min_ps(b, a); }
  ZONAL_INLINE static R greatest(R a, R b) { return _mm512_max_ps(b, a); }
};
template <>
struct RegisterMath<double, 64> {
  using R = __m512d;
  ZONAL_INLINE static R root(R a) { return _mm512_sqrt_pd(a); }
  ZONAL_INLINE static R least(R a, R b) { return _mm512_min_pd(b, a); }
  ZONAL_INLINE static R greatest(R a, R b) { return _mm512_max_pd(b, a); }
};
#endif

// The widest registers that divide W lanes.
template <class T>
constexpr int register_lanes(int W) {
  int lanes = native_lanes_v<T>;
  while (W % lanes != 0) lanes /= 2;
  return lanes;
}

// W values in registers, and not in one array of them, which GCC copies by halves and stops inlining in a large kernel
// (20 times slower).
template <class T, int W>
struct Registers {
  static constexpr int step = register_lanes<T>(W);
  using Register = Lanes<T, step>;
  using Math = RegisterMath<T, sizeof(Register)>;
  static_assert(W % step == 0 && sizeof(Register) >= 16, "a packet fills whole registers: 4, 8, 16, ... floats");

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
  using Registers = detail::Registers<T, W>;
  typename Registers::Register::Mask values[static_cast<std::size_t>(W / Registers::step)];
};

/// W values of a built-in T, which fill whole registers: 4, 8, 16 ... floats.
template <class T, int W>
struct Packet {
  static_assert(is_builtin_scalar_v<T> && W >= 1, "a packet holds W >= 1 built-in scalars");
  using Registers = detail::Registers<T, W>;
  using Register = typename Registers::Register;
  using Math = typename Registers::Math;
  using Mask = PacketMask<T, W>;
  static constexpr int width = W;

  Registers lanes;

  Packet() = default;
  template <class C, class = std::enable_if_t<std::is_arithmetic_v<C>>>
  ZONAL_INLINE explicit Packet(C constant)
      : lanes(Registers::map([constant]() ZONAL_INLINE { return Register(static_cast<T>(constant)); })) {}
  ZONAL_INLINE explicit Packet(const Registers& registers) : lanes(registers) {}

  /// W consecutive values; `values` may have any alignment.
  ZONAL_INLINE static Packet load(const T* values) {
    Packet r;
    for (int i = 0; i < W / Registers::step; ++i) {
      r.lanes.values[i] = Register::load(values + i * Registers::step);
    }
    return r;
  }
  /// K values, each in W / K consecutive lanes.
  template <int K>
  ZONAL_INLINE static Packet blocks(const T (&values)[std::size_t{K}]) {
    static_assert(W % (K * Registers::step) == 0, "each block fills whole registers");
    Packet r;
    for (int i = 0; i < W / Registers::step; ++i) {
      r.lanes.values[i] = Register(values[i * Registers::step * K / W]);
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
      lanes.values[i].store(values + i * Registers::step);
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
    return Packet(Registers::map([](const auto& x) ZONAL_INLINE { return -x; }, a.lanes));
  }
  ZONAL_INLINE friend Packet operator+(const Packet& a, const Packet& b) {
    return Packet(Registers::map([](const auto& x, const auto& y) ZONAL_INLINE { return x + y; }, a.lanes, b.lanes));
  }
  ZONAL_INLINE friend Packet operator-(const Packet& a, const Packet& b) {
    return Packet(Registers::map([](const auto& x, const auto& y) ZONAL_INLINE { return x - y; }, a.lanes, b.lanes));
  }
  ZONAL_INLINE friend Packet operator*(const Packet& a, const Packet& b) {
    return Packet(Registers::map([](const auto& x, const auto& y) ZONAL_INLINE { return x * y; }, a.lanes, b.lanes));
  }
  ZONAL_INLINE friend Packet operator/(const Packet& a, const Packet& b) {
    return Packet(Registers::map([](const auto& x, const auto& y) ZONAL_INLINE { return x / y; }, a.lanes, b.lanes));
  }
  ZONAL_INLINE friend Packet minimum(const Packet& a, const Packet& b) {
    return Packet(Registers::map([](const auto& x, const auto& y)
                                     ZONAL_INLINE { return Register(Math::least(x.vector(), y.vector())); },
                                 a.lanes, b.lanes));
  }
  ZONAL_INLINE friend Packet maximum(const Packet& a, const Packet& b) {
    return Packet(Registers::map([](const auto& x, const auto& y)
                                     ZONAL_INLINE { return Register(Math::greatest(x.vector(), y.vector())); },
                                 a.lanes, b.lanes));
  }
  ZONAL_INLINE friend Packet abs(const Packet& a) {
    return Packet(Registers::map([](const auto& x) ZONAL_INLINE { return abs(x); }, a.lanes));
  }
  ZONAL_INLINE friend Packet sqrt(const Packet& a) {
    return Packet(Registers::map([](const auto& x) ZONAL_INLINE { return Register(Math::root(x.vector())); }, a.lanes));
  }

  ZONAL_INLINE friend Mask operator<(const Packet& a, const Packet& b) {
    Mask mask;
    for (int i = 0; i < W / Registers::step; ++i) mask.values[i] = a.lanes.values[i] < b.lanes.values[i];
    return mask;
  }
  ZONAL_INLINE friend Mask operator<=(const Packet& a, const Packet& b) {
    Mask mask;
    for (int i = 0; i < W / Registers::step; ++i) mask.values[i] = a.lanes.values[i] <= b.lanes.values[i];
    return mask;
  }
  ZONAL_INLINE friend Mask operator>(const Packet& a, const Packet& b) { return b < a; }
  ZONAL_INLINE friend Mask operator>=(const Packet& a, const Packet& b) { return b <= a; }

  ZONAL_INLINE friend Packet select(const Mask& mask, const Packet& a, const Packet& b) {
    return Packet(Registers::map([](const auto& m, const auto& x, const auto& y)
                                     ZONAL_INLINE { return Register::select(m, x, y); },
                                 mask, a.lanes, b.lanes));
  }
};

/// sum += a * b, where a and b may have several times the lanes: all of them are added up.
template <class T, int W, int V>
ZONAL_INLINE inline void add_product(Packet<T, W>& sum, const Packet<T, V>& a, const Packet<T, V>& b) {
  constexpr int step = Packet<T, W>::Registers::step;
  static_assert(V % W == 0 && Packet<T, V>::Registers::step == step, "whole multiples, in registers of one size");
  for (int i = 0; i < V / step; ++i) {
    sum.lanes.values[i % (W / step)].add_product(a.lanes.values[i], b.lanes.values[i]);
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

template <class T, int W>
struct AnyLane<Packet<T, W>> {
  ZONAL_INLINE static bool of(const mask_t<Packet<T, W>>& mask) {
    return select(mask, Packet<T, W>(1), Packet<T, W>(0)).sum() > 0;
  }
};

}  // namespace ZONAL_TARGET
}  // namespace zonal

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
