// Packets, lane by lane against the built-in scalar, at every width.
#include <zonal/basis/evaluate.hpp>
#include <zonal/scalar/packet.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

#include "../catch.hpp"

namespace {

template <class T, int W>
struct Lanes {
  std::array<T, std::size_t{W}> a, b, c;
  zonal::Packet<T, W> pa, pb, pc;

  explicit Lanes(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-4, 4);
    for (std::size_t i = 0; i < W; ++i) {
      a[i] = static_cast<T>(uniform(random));
      b[i] = i % 3 == 0 ? a[i] : static_cast<T>(uniform(random));  // some are equal
      c[i] = static_cast<T>(uniform(random));
    }
    pa = zonal::Packet<T, W>::load(a.data());
    pb = zonal::Packet<T, W>::load(b.data());
    pc = zonal::Packet<T, W>::load(c.data());
  }
};

/// packets(a, b, c) is scalars(a, b, c) in each lane, to `ulps` ulp.
template <class T, int W, class F>
void check_lanes(const char* what, F f, int ulps = 0) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Lanes<T, W> lanes(seed);
    const zonal::Packet<T, W> result = f(lanes.pa, lanes.pb, lanes.pc);
    for (int i = 0; i < W; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const T expected = f(lanes.a[k], lanes.b[k], lanes.c[k]);
      CAPTURE(what, W, sizeof(T), i, lanes.a[k], lanes.b[k], lanes.c[k], expected);
      REQUIRE(std::abs(result[i] - expected) <=
              static_cast<T>(ulps) * std::numeric_limits<T>::epsilon() * std::abs(expected));
    }
  }
}

template <class T, int W>
void check_operations() {
  check_lanes<T, W>("-a", [](const auto& a, const auto&, const auto&) { return -a; });
  check_lanes<T, W>("a+b", [](const auto& a, const auto& b, const auto&) { return a + b; });
  check_lanes<T, W>("a-b", [](const auto& a, const auto& b, const auto&) { return a - b; });
  check_lanes<T, W>("a*b", [](const auto& a, const auto& b, const auto&) { return a * b; });
  check_lanes<T, W>("a/b", [](const auto& a, const auto& b, const auto&) { return a / b; });
  check_lanes<T, W>("min", [](const auto& a, const auto& b, const auto&) {
    using zonal::minimum;
    return minimum(a, b);
  });
  check_lanes<T, W>("max", [](const auto& a, const auto& b, const auto&) {
    using zonal::maximum;
    return maximum(a, b);
  });
  check_lanes<T, W>("abs", [](const auto& a, const auto&, const auto&) {
    using zonal::abs;
    return abs(a);
  });
  check_lanes<T, W>(
      "sqrt",
      [](const auto& a, const auto&, const auto&) {
        using zonal::abs, zonal::sqrt;
        return sqrt(abs(a));
      },
      2);
  check_lanes<T, W>("a<b", [](const auto& a, const auto& b, const auto& c) {
    using zonal::select;
    return select(a < b, b, c);
  });
  check_lanes<T, W>("a<=b", [](const auto& a, const auto& b, const auto& c) {
    using zonal::select;
    return select(a <= b, b, c);
  });
  check_lanes<T, W>("a>b", [](const auto& a, const auto& b, const auto& c) {
    using zonal::select;
    return select(a > b, c, b);
  });
  check_lanes<T, W>("a>=b", [](const auto& a, const auto& b, const auto& c) {
    using zonal::select;
    return select(a >= b, c, b);
  });

  const Lanes<T, W> lanes(99);
  T total = 0;
  for (const T value : lanes.a) total += value;
  CHECK(lanes.pa.sum() == total);
  zonal::Packet<T, W> packet(2);
  packet.set(W - 1, 5);
  CHECK(packet[0] == 2);
  CHECK(packet[W - 1] == 5);
  packet = zonal::Packet<T, W>(0.1L);
  for (int i = 0; i < W; ++i) CHECK(packet[i] == static_cast<T>(0.1L));

  // Eigen's square root may take a denormal for 0.
  for (const T x : {T(0), std::numeric_limits<T>::min(), std::numeric_limits<T>::max()}) {
    CAPTURE(x);
    CHECK(std::abs(sqrt(zonal::Packet<T, W>(x))[W - 1] - std::sqrt(x)) <=
          2 * std::numeric_limits<T>::epsilon() * std::sqrt(x));
  }
}

template <class T, int W>
void check_evaluate() {
  constexpr int N = 10;
  std::mt19937 random(8);
  std::normal_distribution<double> normal;
  std::array<std::array<T, std::size_t{W}>, 3> v;
  for (std::size_t i = 0; i < W; ++i) {
    const double x = normal(random), y = normal(random), z = normal(random), length = std::sqrt(x * x + y * y + z * z);
    v[0][i] = static_cast<T>(x / length), v[1][i] = static_cast<T>(y / length), v[2][i] = static_cast<T>(z / length);
  }
  using P = zonal::Packet<T, W>;
  const auto packets = zonal::evaluate<N>(std::array<P, 3>{P::load(&v[0][0]), P::load(&v[1][0]), P::load(&v[2][0])});
  const auto evens = zonal::evaluate_even<N>(P::load(&v[0][0]), P::load(&v[2][0]));
  for (int i = 0; i < W; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto y = zonal::evaluate<N>(std::array<T, 3>{v[0][k], v[1][k], v[2][k]});
    for (int l = 0; l < N; ++l) {
      for (int m = -l; m <= l; ++m) {
        CAPTURE(W, i, l, m, v[0][k], v[1][k], v[2][k]);
        // The compiler fuses differently, no more.
        REQUIRE(std::abs(packets(l, m)[i] - y(l, m)) <= 32 * std::numeric_limits<T>::epsilon());
        if (m >= 0) REQUIRE(std::abs(evens(l, m)[i] - y(l, m)) <= 32 * std::numeric_limits<T>::epsilon());
      }
    }
  }
}

}  // namespace

TEST_CASE("Every operation of a packet is that of its lanes") {
  check_operations<float, 4>();
  check_operations<float, 8>();
  check_operations<float, 16>();
  check_operations<double, 2>();
  check_operations<double, 4>();
  check_operations<double, 8>();
}

TEST_CASE("evaluate in packets is evaluate in each lane") {
  check_evaluate<float, 4>();
  check_evaluate<float, 8>();
  check_evaluate<float, 16>();
  check_evaluate<double, 2>();
  check_evaluate<double, 4>();
  check_evaluate<double, 8>();
}
