// A tree of virtual lights: what each cluster of them sends, and how far its lights differ.
//
// One light of a cluster can be drawn to stand for all of it (light_cut.hpp). That is right in the mean, and strays by
// the spread of what the lights contribute. cluster_bound.hpp bounds that spread by what a node knows: the means over
// its lights of position, normal and emission, weighted by what they send at most, and how far the lights lie from
// these. Emission is kept as a function of the direction in world space, so that lights of any frame and material have
// a mean.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "../scalar/for_each.hpp"
#include "../scalar/prefetch.hpp"
#include "degree_norms.hpp"
#include "sort_key.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// A light as the tree sees it: a sphere at a point of a surface; or of no surface, with a normal of 0, which sends as
/// much to every side. `emission` is the intensity by direction in world space, RGB, without the cosine at the light:
/// in any unit that is the same for all.
template <int NE>
struct TreeLight {
  glm::vec3 position{0}, normal{0};
  float radius = 0;
  Sh<NE, glm::vec3> emission{};
};

/// A cluster: the lights [first, last) of the tree's order. Lengths are the caller's; the mean of unit normals is
/// shorter than 1; emission is per unit of weight.
template <int NE>
struct LightNode {
  glm::vec3 position{0}, normal{0};  // means, as that of the emission
  float weight = 0;                  // sum; of a light what it sends at most, of any channel, in any direction
  glm::vec3 reach{0};                // greatest distance from the mean position, along each axis
  float covariance[6] = {};          // of positions: xx, xy, xz, yy, yz, zz
  float normal_reach = 0;            // greatest distance from the mean normal, and root mean square
  float normal_spread = 0;
  float least_radius = 0, greatest_radius = 0;
  Sh<NE, glm::vec3> emission{};
  glm::vec3 emission_spread{0};  // root mean square of the lights' greatest differences from the mean, RGB
  float emission_reach = 0;      // the greatest of these differences, of any channel
  glm::vec3 emission_slope{0};   // greatest derivative of the mean, per radian
  std::int32_t first = 0, last = 0;
  std::int32_t children = 0;  // two, side by side; 0: a leaf

  int size() const { return last - first; }
};

/// Nodes stand level by level, the root first. 132 bytes a node with one band of emission, 228 with three; half as many
/// nodes as lights, or twice as many where lights are few.
template <int NE>
class LightTree {
 public:
  LightTree() = default;

  /// light(i) -> TreeLight<NE>, for 0 <= i < count; called once for each. The tree does not depend on how for_each
  /// spreads the work.
  template <class Light, class ForEach = SerialForEach>
  explicit LightTree(int count, const Light& light, const ForEach& for_each = {}) {
    if (count <= 0) return;
    std::vector<TreeLight<NE>> lights(static_cast<std::size_t>(count));
    std::vector<Place> places(lights.size());
    for_each(count, [&](int i) {
      TreeLight<NE>& l = lights[std::size_t(i)];
      l = light(i);
      places[std::size_t(i)] = {l.position, l.normal, i};
    });
    const std::vector<int> levels = split_all(places, count <= few_lights ? 1 : leaf_lights, for_each);
    order_.reserve(places.size());
    for (const Place& place : places) order_.push_back(place.light);
    const auto of_index = [&](int i) -> const TreeLight<NE>& { return lights[std::size_t(i)]; };
    for (std::size_t level = levels.size() - 1; level-- > 0;) {
      for_each(levels[level + 1] - levels[level],
               [&](int i) { summarise(nodes_[std::size_t(levels[level] + i)], of_index); });
    }
    places_.resize(places.size());
    for (int place = 0; place < size(); ++place) places_[std::size_t(light_at(place))] = place;
    add_up(of_index);
  }

  int size() const { return int(order_.size()); }
  std::size_t bytes() const {
    return nodes_.size() * sizeof(LightNode<NE>) + order_.size() * (2 * sizeof(int) + sizeof(double));
  }
  const std::vector<LightNode<NE>>& nodes() const { return nodes_; }
  const LightNode<NE>& node(int index) const { return nodes_[std::size_t(index)]; }
  /// The caller's number of the light that stands at `place` of the tree's order.
  int light_at(int place) const { return order_[std::size_t(place)]; }
  int place_of(int light) const { return places_[std::size_t(light)]; }
  /// The weights of all lights before a place, 0 to size().
  double weight_before(int place) const { return sums_[std::size_t(place)]; }

  /// Fetches what place_at will read of a node's lights from `part` on, `count` times, evenly spread.
  void prefetch_weights(const LightNode<NE>& node, double part, int count) const {
    detail::prefetch(&sums_[std::size_t(node.first)]);
    detail::prefetch(&sums_[std::size_t(node.last)]);
    for (int i = 0; i < count; ++i) {
      const double place = part + double(i) / count;
      detail::prefetch(&sums_[std::size_t(node.first + int((place < 1 ? place : place - 1) * node.size()))]);
    }
  }

  /// The place where `part`, in [0, 1), of a node's weight is reached: draws a light in proportion to the weights.
  int place_at(const LightNode<NE>& node, double part) const {
    const double* sums = sums_.data();
    const double target = sums[node.first] + part * (sums[node.last] - sums[node.first]);
    // Weights are often much alike: the search begins where it would end if they were, and opens from there.
    int low = (std::min)(node.first + int(part * node.size()), node.last - 1), high = low + 1;
    for (int step = 1; low > node.first && sums[low] > target; step *= 2) {
      high = low;
      low = (std::max)(low - step, node.first);
    }
    for (int step = 1; high < node.last && !(sums[high] > target); step *= 2) {
      low = high;
      high = (std::min)(high + step, node.last);
    }
    while (high - low > 1) {
      const int middle = low + (high - low) / 2;
      (sums[middle] > target ? high : low) = middle;
    }
    return low;
  }

  /// These lights, by the caller's numbers, are others now: light(i) -> TreeLight<NE> as for the whole tree, asked for
  /// all of their leaves. Their clusters are bounded anew, less tightly than by a new tree. What it costs grows with
  /// the number of clusters above them and, where a weight changes, by one addition for each light behind it in the
  /// tree's order.
  template <class Light>
  void update(const std::vector<int>& changed, const Light& light) {
    std::vector<int> clusters, places;
    for (const int i : changed) {
      const int place = place_of(i);
      places.push_back(place);
      for (int n = 0;;) {
        clusters.push_back(n);
        if (node(n).children == 0) break;
        const int second = node(n).children + 1;
        n = node(second).first <= place ? second : node(n).children;
      }
    }
    // Children have higher numbers than their parents.
    std::sort(clusters.begin(), clusters.end(), std::greater<int>());
    clusters.erase(std::unique(clusters.begin(), clusters.end()), clusters.end());
    for (const int n : clusters) {
      LightNode<NE>& cluster = nodes_[std::size_t(n)];
      if (cluster.children == 0) {
        summarise(cluster, light);
      } else {
        join_children(cluster);
      }
    }
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    add_changes(places, light);
  }

  static float weight_of(const TreeLight<NE>& light) {
    return detail::greatest_component(greatest_value(light.emission));
  }

 private:
  static constexpr int few_lights = 1 << 16, leaf_lights = 4;

  struct Place {
    glm::vec3 position, normal;
    int light;
  };

  /// Halves clusters until they have no more than `leaf` lights; returns where each level begins, and the end.
  template <class ForEach>
  std::vector<int> split_all(std::vector<Place>& places, int leaf, const ForEach& for_each) {
    std::vector<int> levels{0};
    nodes_.emplace_back().last = int(places.size());
    while (levels.back() < int(nodes_.size())) {
      const int first = levels.back(), last = int(nodes_.size());
      int next = last;
      for (int n = first; n < last; ++n) {
        if (node(n).size() > leaf) nodes_[std::size_t(n)].children = next, next += 2;
      }
      nodes_.resize(std::size_t(next));
      for_each(last - first, [&](int i) {
        const LightNode<NE>& whole = node(first + i);
        if (whole.children == 0) return;
        LightNode<NE>* child = &nodes_[std::size_t(whole.children)];
        child[0].first = whole.first;
        child[0].last = child[1].first = halve(places.data() + whole.first, whole.size()) + whole.first;
        child[1].last = whole.last;
      });
      levels.push_back(last);
    }
    return levels;
  }

  /// Moves one half in front of the other, along the axis on which positions, or normals, lie widest apart.
  static int halve(Place* places, int count) {
    glm::vec3 low(places->position), high(low), normal_low(places->normal), normal_high(normal_low);
    for (const Place* p = places; p < places + count; ++p) {
      low = (glm::min)(low, p->position), high = (glm::max)(high, p->position);
      normal_low = (glm::min)(normal_low, p->normal), normal_high = (glm::max)(normal_high, p->normal);
    }
    // A cluster is used from several of its sizes away: there a turn counts as much as that part of the size.
    constexpr float turn_against_size = 0.25F;
    const glm::vec3 size = high - low, turn = turn_against_size * glm::length(size) * (normal_high - normal_low);
    int axis = 0;
    for (int i = 1; i < 6; ++i) {
      const auto width = [&](int k) { return k < 3 ? size[k] : turn[k - 3]; };
      if (width(axis) < width(i)) axis = i;
    }
    const auto key = [axis](const Place& p) {
      return detail::sort_key(axis < 3 ? p.position[axis] : p.normal[axis - 3]);
    };
    std::nth_element(places, places + count / 2, places + count, [&](const Place& a, const Place& b) {
      return key(a) < key(b) || (!(key(b) < key(a)) && a.light < b.light);
    });
    return count / 2;
  }

  /// The means and spreads of a node, from those of its children or from its lights.
  template <class Light>
  void summarise(LightNode<NE>& node, const Light& light) const {
    if (node.children != 0) {
      join_children(node);
    } else {
      LightNode<NE> sum = of_light(light(light_at(node.first)));
      for (int place = node.first + 1; place < node.last; ++place) sum = joined(sum, of_light(light(light_at(place))));
      put(sum, node);
    }
    // Over the lights themselves the reach is tighter than over the children.
    glm::vec3 reach(0.0F);
    float normal_reach2 = 0;
    for (int place = node.first; place < node.last; ++place) {
      const TreeLight<NE>& one = light(light_at(place));
      const glm::vec3 turn = one.normal - node.normal;
      reach = (glm::max)(reach, glm::abs(one.position - node.position));
      normal_reach2 = (std::max)(normal_reach2, glm::dot(turn, turn));
    }
    node.reach = reach, node.normal_reach = std::sqrt(normal_reach2);
  }
  void join_children(LightNode<NE>& parent) const {
    put(joined(node(parent.children), node(parent.children + 1)), parent);
  }
  /// What was joined, with the place in the tree that the node has.
  static void put(LightNode<NE> sum, LightNode<NE>& node) {
    sum.first = node.first, sum.last = node.last, sum.children = node.children;
    sum.emission_slope = greatest_slope(sum.emission);
    node = sum;
  }

  static LightNode<NE> of_light(const TreeLight<NE>& light) {
    LightNode<NE> node;
    node.position = light.position;
    node.normal = light.normal;
    node.weight = weight_of(light);
    node.least_radius = node.greatest_radius = light.radius;
    if (node.weight > 0) node.emission = light.emission * (1.0F / node.weight);
    return node;
  }

  /// Squares of spreads about the common mean: those about the parts' own means, and that of these means.
  static LightNode<NE> joined(const LightNode<NE>& a, const LightNode<NE>& b) {
    LightNode<NE> node;
    node.weight = a.weight + b.weight;
    const float part = node.weight > 0 ? b.weight / node.weight : 0.5F, rest = 1 - part;
    const auto mean = [&](const auto& x, const auto& y) { return x * rest + y * part; };
    const auto square = [&](const auto& x, const auto& y, const auto& between) {
      return mean(x, y) + between * (part * rest);
    };
    const auto reach = [&](const auto& x, const auto& y, const auto& between) {
      return (glm::max)(x + between * part, y + between * rest);
    };
    const glm::vec3 apart = b.position - a.position, turned = b.normal - a.normal;
    node.position = mean(a.position, b.position);
    node.reach = reach(a.reach, b.reach, glm::abs(apart));
    for (int i = 0, k = 0; i < 3; ++i) {
      for (int j = i; j < 3; ++j, ++k)
        node.covariance[k] = square(a.covariance[k], b.covariance[k], apart[i] * apart[j]);
    }
    node.normal = mean(a.normal, b.normal);
    node.normal_reach = reach(a.normal_reach, b.normal_reach, glm::length(turned));
    node.normal_spread = std::sqrt(
        square(a.normal_spread * a.normal_spread, b.normal_spread * b.normal_spread, glm::dot(turned, turned)));
    node.least_radius = (std::min)(a.least_radius, b.least_radius);
    node.greatest_radius = (std::max)(a.greatest_radius, b.greatest_radius);
    node.emission = mean(a.emission, b.emission);
    const glm::vec3 changed = greatest_value(b.emission - a.emission);
    node.emission_spread = glm::sqrt(
        square(a.emission_spread * a.emission_spread, b.emission_spread * b.emission_spread, changed * changed));
    node.emission_reach = reach(a.emission_reach, b.emission_reach, detail::greatest_component(changed));
    return node;
  }

  template <class Light>
  void add_up(const Light& light) {
    sums_.resize(order_.size() + 1, 0.0);
    for (int place = 0; place < size(); ++place) {
      sums_[std::size_t(place) + 1] = sums_[std::size_t(place)] + double(weight_of(light(light_at(place))));
    }
  }
  /// Sums behind places, in order, whose lights have changed.
  template <class Light>
  void add_changes(const std::vector<int>& places, const Light& light) {
    std::vector<std::pair<int, double>> changes;  // of the weight at a place
    for (const int place : places) {
      const double before = weight_before(place + 1) - weight_before(place);
      const double change = double(weight_of(light(light_at(place)))) - before;
      if (std::abs(change) > 1e-6 * before) changes.emplace_back(place, change);
    }
    double sum = 0;
    for (std::size_t i = 0; i < changes.size(); ++i) {
      sum += changes[i].second;
      const int next = i + 1 < changes.size() ? changes[i + 1].first : size();
      for (int place = changes[i].first; place < next; ++place) sums_[std::size_t(place) + 1] += sum;
    }
  }

  std::vector<LightNode<NE>> nodes_;
  std::vector<int> order_, places_;  // the light at each place, and the place of each light
  std::vector<double> sums_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
