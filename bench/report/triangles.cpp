// A square light of radiance 1 over a plane, as in the gradient paper's Fig. 15: two triangles, exactly by so many
// nodes on each edge; and cut into many, each as a sphere.
#include <algorithm>
#include <cmath>
#include <vector>

#include <benchmark/benchmark.h>
#include <zonal/light/triangle.hpp>

#include "../built_bands.hpp"
#include "../square_light.hpp"
#include "timing.hpp"

namespace zonal_report {
namespace {

using Lanes = zonal::Packet<float, zonal::kNativeLanes>;
constexpr int side = 16;  // receivers along one side of the plane

// The plane z = 0 from -2 to 2.
glm::vec3 receiver(int index) {
  const auto at = [](int i) { return -2 + 4 * (float(i) + 0.5F) / side; };
  return {at(index % side), at(index / side), 0};
}

struct ReceiverPacket {
  Lanes x, y, z = Lanes(0);
};
std::vector<ReceiverPacket> receivers() {
  std::vector<ReceiverPacket> packets(side * side / zonal::kNativeLanes);
  for (int i = 0; i < side * side; ++i) {
    auto& packet = packets[std::size_t(i / zonal::kNativeLanes)];
    packet.x.set(i % zonal::kNativeLanes, receiver(i).x);
    packet.y.set(i % zonal::kNativeLanes, receiver(i).y);
  }
  return packets;
}

template <int N>
using Sums = zonal::ShGradient<N, Lanes>;

template <int N>
Sums<N> zero() {
  Sums<N> sums;
  for (auto* sh : {&sums.value, &sums.gradient[0], &sums.gradient[1], &sums.gradient[2]}) {
    for (Lanes& x : *sh) x = Lanes(0);
  }
  return sums;
}

// A sink that adds.
template <int N>
auto onto(Sums<N>& sums) {
  return [&sums](auto l, auto m, const Lanes& value, const Lanes& x, const Lanes& y, const Lanes& z) ZONAL_INLINE {
    constexpr int i = zonal::sh_index(l, m);
    sums.value[i] = sums.value[i] + value;
    sums.gradient[0][i] = sums.gradient[0][i] + x;
    sums.gradient[1][i] = sums.gradient[1][i] + y;
    sums.gradient[2][i] = sums.gradient[2][i] + z;
  };
}

template <int N>
Sums<N> by_quadrature(const std::vector<zonal::TriangleLight<float>>& triangles, const zonal::QuadratureRule& rule,
                      const ReceiverPacket& at) {
  Sums<N> sums = zero<N>();
  for (const auto& triangle : triangles) {
    zonal::finish<N>(zonal::polygon_sums<N>(triangle, rule, at.x, at.y, at.z), onto(sums));
  }
  return sums;
}

template <int N>
Sums<N> by_spheres(const std::vector<zonal::TriangleSphereLight<float>>& spheres, const ReceiverPacket& at) {
  Sums<N> sums = zero<N>();
  for (const auto& sphere : spheres) zonal::project_with_gradient<N>(sphere, at.x, at.y, at.z, onto(sums));
  return sums;
}

std::vector<zonal::TriangleLight<float>> triangles(int cuts) {
  std::vector<zonal::TriangleLight<float>> result;
  for (const auto& light : zonal_bench::square_of_triangles(cuts)) result.push_back(light.light);
  return result;
}

std::vector<zonal::TriangleSphereLight<float>> spheres(int cuts) {
  std::vector<zonal::TriangleSphereLight<float>> result;
  for (const auto& triangle : triangles(cuts)) {
    result.push_back(zonal::TriangleSphereLight<float>::approximate(triangle));
  }
  return result;
}

struct Errors {
  double value, gradient;
};

// The greatest difference over the greatest coefficient, over all receivers.
template <int N, class Project>
Errors errors_of(const Project& project) {
  const zonal::PolygonLight<4, double> square{{{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}};
  double value_error = 0, value_size = 0, gradient_error = 0, gradient_size = 0;
  const auto packets = receivers();
  for (int i = 0; i < side * side; ++i) {
    const Sums<N> got = project(packets[std::size_t(i / zonal::kNativeLanes)]);
    const auto exact = zonal::project_with_gradient<N>(square, glm::dvec3(receiver(i)), 1e-12);
    const auto compare = [&](const auto& a, const auto& b, double& error, double& size) {
      for (int k = 0; k < N * N; ++k) {
        error = std::max(error, std::abs(double(a[k][i % zonal::kNativeLanes]) - b[k]));
        size = std::max(size, std::abs(b[k]));
      }
    };
    compare(got.value, exact.value, value_error, value_size);
    for (int axis = 0; axis < 3; ++axis) {
      compare(got.gradient[axis], exact.gradient[axis], gradient_error, gradient_size);
    }
  }
  return {value_error / value_size, gradient_error / gradient_size};
}

struct Line {
  const char* method;
  int bands;
  std::size_t triangles;
  int nodes;  // of an edge; 0: spheres
  Errors errors;
  Body body;
};

template <int N, class Project>
Line line(const char* method, std::size_t count, int nodes, const Project& project) {
  return {method, N, count, nodes, errors_of<N>(project), [project, packets = receivers()] {
            for (const auto& packet : packets) {
              const auto sums = project(packet);
              const auto* address = &sums;
              benchmark::DoNotOptimize(address);
            }
          }};
}

template <int N>
void add_lines(Effort effort, std::vector<Line>& lines) {
  for (int nodes = 1; nodes <= choose(effort, 3, 10, 16); ++nodes) {
    lines.push_back(line<N>("quadrature", 2, nodes, [nodes, lights = triangles(1)](const ReceiverPacket& at) {
      return by_quadrature<N>(lights, zonal::edge_rule(nodes), at);
    }));
  }
  const auto cuts =
      choose<std::vector<int>>(effort, {1, 4}, {1, 2, 3, 4, 6, 9, 18}, {1, 2, 3, 4, 5, 6, 8, 9, 12, 18, 24, 36});
  for (const int cut : cuts) {
    lines.push_back(line<N>("spheres", spheres(cut).size(), 0,
                            [lights = spheres(cut)](const ReceiverPacket& at) { return by_spheres<N>(lights, at); }));
  }
}

}  // namespace

void print_triangles(Effort effort) {
  std::vector<Line> lines;
  using zonal_bench::Bands;
  zonal_bench::for_bands(zonal_bench::Built<Bands<3, 5, 9>, Bands<3>>{}, [&](auto n) { add_lines<n>(effort, lines); });
  std::vector<Body> bodies;
  for (const Line& line : lines) bodies.push_back(line.body);
  const auto seconds = median_seconds(bodies, repetitions(effort));
  print_row("method", "bands", "triangles", "nodes", "ns", "value_error", "gradient_error");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Line& line = lines[i];
    print_row(line.method, line.bands, line.triangles, line.nodes, 1e9 * seconds[i] / (side * side), line.errors.value,
              line.errors.gradient);
  }
}

}  // namespace zonal_report
