// Filling a grid from polygon lights, exactly: edge by edge (light/polygon.hpp).
//
// Where two polygons share an edge, what each has from it differs in sign and colour only. So an edge is integrated
// once, and counts with the difference of the radiances on its two sides; where there is none, in the midst of a
// uniform light, not at all. Besides the work it saves, in float it is what keeps a light of many small polygons exact:
// their own edges would cancel (light/polygon.hpp), shared ones have done so already.
#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

#include "../light/polygon.hpp"
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

inline bool is_zero_everywhere(const VertexLanes (&rgb)[3]) {
  float lanes[kNativeLanes];
  for (const VertexLanes& channel : rgb) {
    channel.store(lanes);
    if (std::any_of(lanes, lanes + kNativeLanes, [](float x) { return x != 0; })) return false;
  }
  return true;
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

  void add_solid_angle(const VertexLanes& solid_angle, const glm::vec3& colour) {
    for (int c = 0; c < 3; ++c) add_product(sums_[c].solid_angle, solid_angle, VertexLanes(colour[c]));
  }

  // `jump` is the radiance to the left of each edge less that to the right, RGB.
  void add(const LightEdge* const (&edges)[edges_at_once], const Edges (&jump)[3], const EdgeRules& rules,
           const Edges (&receiver)[3]) {
    Edges p[3], q[3], edge[3];
    for (int i = 0; i < 3; ++i) {
      const float from[edges_at_once] = {edges[0]->from[i], edges[1]->from[i]};
      const float to[edges_at_once] = {edges[0]->to[i], edges[1]->to[i]};
      const float along[edges_at_once] = {to[0] - from[0], to[1] - from[1]};
      p[i] = Edges::template blocks<edges_at_once>(from) - receiver[i];
      q[i] = Edges::template blocks<edges_at_once>(to) - receiver[i];
      edge[i] = Edges::template blocks<edges_at_once>(along);
    }
    float cosines[edges_at_once * kNativeLanes];
    arc_cosine(p, q).store(cosines);
    const float arc = acos(*std::min_element(cosines, cosines + edges_at_once * kNativeLanes));

    EdgeIntegrals<N, Edges> integrals;
    integrate_edge<N>(p, edge, q, rules.for_arc(static_cast<double>(arc)), integrals);
    for (int c = 0; c < 3; ++c) {
      add_edge<N>(integrals, jump[c], sums_[c]);
    }
  }

  /// The results: sink(l, m, colour, value, d/dx, d/dy, d/dz), colour 0 to 2.
  template <class Sink>
  void finish(Sink&& sink) const {
    for (int c = 0; c < 3; ++c) {
      zonal::finish<N>(sums_[c], [&](auto l, auto m, const VertexLanes& value, const VertexLanes& x,
                                     const VertexLanes& y, const VertexLanes& z) { sink(l, m, c, value, x, y, z); });
    }
  }

 private:
  PolygonSums<N, VertexLanes> sums_[3];
};

}  // namespace detail

/// Adds polygon lights of RGB radiance to the grid: value and gradient at every vertex, each edge within `tolerance` of
/// its polygon's largest coefficient (edge_nodes). for_each as in add_lights.hpp.
template <int N, int V, class ForEach>
void add_lights(CoefficientGrid<N>& grid, const std::vector<ColouredLight<PolygonLight<V, float>>>& lights,
                double tolerance, ForEach&& for_each) {
  using detail::VertexLanes;
  using Sums = detail::PolygonLightSums<N>;
  using Edges = typename Sums::Edges;
  const EdgeRules rules(N, tolerance);
  const detail::LightEdges light_edges = detail::edges_of(lights);
  for_each(detail::vertex_packet_count(grid), [&](int packet) {
    const detail::VertexPacket<N> vertices(grid, static_cast<std::size_t>(packet));
    Sums sums;

    std::vector<VertexLanes> side(lights.size());
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const auto view = detail::view(detail::SeenPolygon<V, VertexLanes>(lights[i].light, vertices.position));
      side[i] = view.side;
      sums.add_solid_angle(view.solid_angle, lights[i].colour);
    }

    Edges receiver[3];
    for (int i = 0; i < 3; ++i) receiver[i] = vertices.position[i].template repeated<Sums::edges_at_once>();
    const detail::LightEdge* pending[Sums::edges_at_once];
    VertexLanes jumps[3][Sums::edges_at_once];
    int count = 0;
    const auto add_pending = [&] {
      const Edges jump[3] = {Edges::template side_by_side<Sums::edges_at_once>(jumps[0]),
                             Edges::template side_by_side<Sums::edges_at_once>(jumps[1]),
                             Edges::template side_by_side<Sums::edges_at_once>(jumps[2])};
      sums.add(pending, jump, rules, receiver);
      count = 0;
    };
    for (const detail::LightEdge& edge : light_edges.edges) {
      VertexLanes jump[3] = {VertexLanes(0), VertexLanes(0), VertexLanes(0)};
      for (std::size_t u = edge.first; u < edge.last; ++u) {
        const detail::EdgeUse& use = light_edges.uses[u];
        const glm::vec3 colour = use.direction * lights[use.polygon].colour;
        for (int c = 0; c < 3; ++c) add_product(jump[c], side[use.polygon], VertexLanes(colour[c]));
      }
      if (detail::is_zero_everywhere(jump)) continue;
      pending[count] = &edge;
      for (int c = 0; c < 3; ++c) jumps[c][count] = jump[c];
      if (++count == Sums::edges_at_once) add_pending();
    }
    if (count > 0) {  // the last one alone, beside itself without light
      pending[1] = pending[0];
      for (auto& channel : jumps) channel[1] = VertexLanes(0);
      add_pending();
    }
    sums.finish([&](auto l, auto m, int c, const VertexLanes& value, const VertexLanes& x, const VertexLanes& y,
                    const VertexLanes& z) { vertices.add(grid, 3 * sh_index(l, m) + c, value, x, y, z); });
  });
}

}  // namespace ZONAL_TARGET
}  // namespace zonal
