// Filling a grid from polygon lights, exactly: edge by edge (light/polygon.hpp).
//
// Where two polygons share an edge, what each has from it differs in sign and colour only. So an edge is integrated
// once, and counts with the difference of the radiances on its two sides; where there is none, in the midst of a
// uniform light, not at all. Besides the work it saves, in float it is what keeps a light of many small polygons exact:
// their own edges would cancel (light/polygon.hpp), shared ones have done so already.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

#include "../light/polygon.hpp"
#include "../scalar/long_sum.hpp"
#include "light_sums.hpp"
#include "vertex_packet.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

namespace detail {

// What a polygon is to an edge: 1 if it runs along it from `from` to `to`, -1 if the other way.
struct EdgeUse {
  std::size_t polygon;
  float direction;
};
// An edge of a light: from one vertex to another, and its polygons, at uses[first] to uses[last - 1].
struct LightEdge {
  glm::vec3 from, to;
  std::size_t first, last;
};
struct LightEdges {
  std::vector<LightEdge> edges;
  std::vector<EdgeUse> uses;
};

// Edges are one where their ends are, to the bit.
template <int V>
LightEdges edges_of(const std::vector<ColouredLight<PolygonLight<V, float>>>& lights) {
  const auto key = [](const glm::vec3& v) { return std::make_tuple(v.x, v.y, v.z); };
  struct Side {
    glm::vec3 from, to;
    EdgeUse use;
  };
  std::vector<Side> sides;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    for (int v = 0; v < V; ++v) {
      const glm::vec3 &p = lights[i].light.vertices[v], &q = lights[i].light.vertices[(v + 1) % V];
      if (key(p) < key(q)) sides.push_back({p, q, {i, 1.0F}});
      if (key(q) < key(p)) sides.push_back({q, p, {i, -1.0F}});
    }
  }
  std::stable_sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) {
    return std::make_pair(key(a.from), key(a.to)) < std::make_pair(key(b.from), key(b.to));
  });
  LightEdges result;
  for (const Side& side : sides) {
    if (result.edges.empty() || result.edges.back().from != side.from || result.edges.back().to != side.to) {
      result.edges.push_back({side.from, side.to, result.uses.size(), 0});
    }
    result.uses.push_back(side.use);
    result.edges.back().last = result.uses.size();
  }
  return result;
}

inline float least_of(const VertexLanes& x) {
  float lanes[kNativeLanes];
  x.store(lanes);
  return *std::min_element(lanes, lanes + kNativeLanes);
}

inline bool is_zero_everywhere(const VertexLanes& x) {
  float lanes[kNativeLanes];
  x.store(lanes);
  return std::all_of(lanes, lanes + kNativeLanes, [](float lane) { return is_equal(lane, 0.0F); });
}

// The sums over all edges for a packet of vertices, RGB. Two edges are integrated at once, which halves the traffic to
// sums that do not fit into the first-level cache.
template <int N>
class PolygonLightSums {
 public:
  static constexpr int edges_at_once = 2;
  using Edges = Packet<float, edges_at_once * kNativeLanes>;

  PolygonLightSums() {
    for (auto& sums : sums_) sums = PolygonSums<N, VertexLanes>::zero();
  }

  void add_solid_angle(const VertexLanes& solid_angle, const VertexLanes& outline_length, const glm::vec3& colour) {
    for (int c = 0; c < 3; ++c) {
      add_product(sums_[c].solid_angle, solid_angle, VertexLanes(colour[c]));
      add_product(outline_lengths_[c], outline_length, VertexLanes(std::abs(colour[c])));
    }
  }

  // Once all polygons' solid angles are known: the error that each radian of an edge may have at any of the vertices.
  float allowance(double tolerance) const {
    float least = (std::numeric_limits<float>::max)();
    for (int c = 0; c < 3; ++c) {
      if (is_zero_everywhere(outline_lengths_[c])) continue;
      least = (std::min)(least, least_of(edge_allowance(sums_[c].solid_angle, outline_lengths_[c], tolerance)));
    }
    return least;
  }

  // `jump` is the radiance to the left of each edge less that to the right, RGB.
  void add(const LightEdge* const (&edges)[edges_at_once], const Edges (&jump)[3], float allowance,
           const Edges (&receiver)[3], float most_inverse_distance) {
    Edges p[3], q[3], edge[3];
    for (int i = 0; i < 3; ++i) {
      const float start[edges_at_once] = {edges[0]->from[i], edges[1]->from[i]};
      const float end[edges_at_once] = {edges[0]->to[i], edges[1]->to[i]};
      const float along[edges_at_once] = {end[0] - start[0], end[1] - start[1]};
      p[i] = Edges::template blocks<edges_at_once>(start) - receiver[i];
      q[i] = Edges::template blocks<edges_at_once>(end) - receiver[i];
      edge[i] = Edges::template blocks<edges_at_once>(along);
    }
    const auto from = SeenPoint<Edges>::at(p), to = SeenPoint<Edges>::at(q);
    float reaches[edges_at_once * kNativeLanes];
    edge_reach<N>(from, to, arc_bound(from, to)).store(reaches);
    const float reach = *std::max_element(reaches, reaches + edges_at_once * kNativeLanes);
    const int nodes = edge_nodes(N, static_cast<double>(reach), static_cast<double>(allowance));

    EdgeIntegrals<N, Edges> integrals;
    integrate_edge<N>(from, edge, to, edge_rule(nodes), Edges(most_inverse_distance), integrals);
    for (int c = 0; c < 3; ++c) {
      add_edge<N>(integrals, jump[c], sums_[c]);
    }
  }

  /// visit(sum) for each number that is summed up, for LongSums.
  template <class Visit>
  void for_each_sum(const Visit& visit) {
    for (PolygonSums<N, VertexLanes>& sums : sums_) {
      visit(sums.solid_angle);
      for (auto& sh : sums.moment) std::for_each(sh.begin(), sh.end(), visit);
      for (auto& sh : sums.slope) std::for_each(sh.begin(), sh.end(), visit);
    }
  }

  /// The sums of a colour, 0 to 2.
  const PolygonSums<N, VertexLanes>& operator[](int colour) const { return sums_[colour]; }

 private:
  PolygonSums<N, VertexLanes> sums_[3];
  VertexLanes outline_lengths_[3] = {VertexLanes(0), VertexLanes(0), VertexLanes(0)};
};

}  // namespace detail

/// Adds polygon lights of RGB radiance, not negative, to the grid: value and gradient at every vertex. Greatest error,
/// next to rounding, with e = `tolerance` times the sum of all lights' coefficients of degree 0 there, in each channel:
/// of a coefficient e, of the gradient 4 e over the distance to the nearest edge. No point of an edge counts in the
/// gradient as nearer than a cell's longest side (gradient_limit.hpp says why). To a grid of values alone it is the
/// same work. for_each as in add_lights.hpp.
template <int N, GridContent content, int V, class ForEach>
void add_lights(CoefficientGrid<N, content>& grid, const std::vector<ColouredLight<PolygonLight<V, float>>>& lights,
                double tolerance, ForEach&& for_each) {
  using Grid = CoefficientGrid<N, content>;
  using detail::VertexLanes;
  using Sums = detail::PolygonLightSums<N>;
  using Edges = typename Sums::Edges;
  const detail::LightEdges light_edges = detail::edges_of(lights);
  const float cell = (std::max)({grid.spacing().x, grid.spacing().y, grid.spacing().z});
  for_each(detail::vertex_packet_count(grid), [&](int packet) {
    const detail::VertexPacket<Grid> vertices(grid, static_cast<std::size_t>(packet));
    Sums sums;
    LongSums<VertexLanes> totals;

    std::vector<VertexLanes> side(lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i) {
      if (i > 0 && i % terms_in_block == 0) totals.take(sums);
      const detail::SeenPolygon<V, VertexLanes> seen(lights[i].light, vertices.position);
      const auto view = detail::view(seen);
      side[i] = view.side;
      sums.add_solid_angle(view.solid_angle, detail::outline<N>(seen).length, lights[i].colour);
    }
    totals.finish(sums);
    const float allowance = sums.allowance(tolerance);

    Edges receiver[3];
    for (int i = 0; i < 3; ++i) receiver[i] = vertices.position[i].template repeated<Sums::edges_at_once>();
    const detail::LightEdge* pending[Sums::edges_at_once];
    VertexLanes jumps[3][Sums::edges_at_once];
    int count = 0, added = 0;
    const auto add_pending = [&] {
      if (++added % terms_in_block == 0) totals.take(sums);
      const Edges jump[3] = {Edges::template side_by_side<Sums::edges_at_once>(jumps[0]),
                             Edges::template side_by_side<Sums::edges_at_once>(jumps[1]),
                             Edges::template side_by_side<Sums::edges_at_once>(jumps[2])};
      sums.add(pending, jump, allowance, receiver, 1 / cell);
      count = 0;
    };
    for (const detail::LightEdge& edge : light_edges.edges) {
      VertexLanes jump[3] = {VertexLanes(0), VertexLanes(0), VertexLanes(0)};
      for (std::size_t u = edge.first; u < edge.last; ++u) {
        const detail::EdgeUse& use = light_edges.uses[u];
        const glm::vec3 colour = use.direction * lights[use.polygon].colour;
        for (int c = 0; c < 3; ++c) add_product(jump[c], side[use.polygon], VertexLanes(colour[c]));
      }
      if (std::all_of(jump, jump + 3, detail::is_zero_everywhere)) continue;
      pending[count] = &edge;
      for (int c = 0; c < 3; ++c) jumps[c][count] = jump[c];
      if (++count == Sums::edges_at_once) add_pending();
    }
    if (count > 0) {  // the last one alone, beside itself without light
      pending[1] = pending[0];
      for (auto& channel : jumps) channel[1] = VertexLanes(0);
      add_pending();
    }
    totals.finish(sums);
    for (int c = 0; c < 3; ++c) {
      Sh<N, VertexLanes> value;
      finish(sums[c], value);
      const auto& slope = sums[c].slope;
      for (int i = 0; i < N * N; ++i) {
        if constexpr (Grid::has_gradients) {
          vertices.add(grid, 3 * i + c, value[i], slope[0][i], slope[1][i], slope[2][i]);
        } else {
          vertices.add(grid, 3 * i + c, value[i]);
        }
      }
    }
  });
}

/// The same within the tolerance that project() of a polygon has by itself.
template <int N, GridContent content, int V, class ForEach>
void add_lights(CoefficientGrid<N, content>& grid, const std::vector<ColouredLight<PolygonLight<V, float>>>& lights,
                ForEach&& for_each) {
  add_lights(grid, lights, 1e-6, for_each);
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
