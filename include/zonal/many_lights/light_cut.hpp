// A cut of a light tree for some receivers: clusters that together hold every light, of each of which one is drawn.
//
// It is refined where the bound on the deviation is greatest, until the root mean square over the receivers is within
// the tolerance; a cluster of one light deviates by nothing. Refining takes two evaluations of the bound per cluster,
// so that receivers share a cut: those of a block of pixels on one surface, by some of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../scalar/packet.hpp"
#include "cluster_bound.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// Receivers that a cut is made for: a packet of them. The bound is the mean over these: let each stand for as many of
/// all that use the cut, or be `weighted`.
inline constexpr int cut_receivers = 8;

template <int N>
using CutReceivers = BoundedReceiver<N, Packet<float, cut_receivers>>;

template <int N>
CutReceivers<N> as_packet(const BoundedReceiver<N, float> (&receivers)[std::size_t{cut_receivers}]) {
  CutReceivers<N> packet;
  float lanes[field_count<BoundedReceiver<N, float>>][cut_receivers];
  for (int lane = 0; lane < cut_receivers; ++lane) {
    auto receiver = receivers[lane];
    int field = 0;
    for_each_field(receiver, [&](float value) { lanes[field++][lane] = value; });
  }
  int field = 0;
  for_each_field(packet, [&](auto& lane) { lane = Packet<float, cut_receivers>::load(lanes[field++]); });
  packet.is_zonal = std::all_of(receivers, receivers + cut_receivers, [](const auto& r) { return r.is_zonal; });
  return packet;
}

namespace detail {

/// A number of [0, 1) for each pair of integers.
inline double scatter(std::uint64_t a, std::uint64_t b) {
  std::uint64_t x = a * 0x9e3779b97f4a7c15U ^ (b + 1) * 0xd1b54a32d192ed03U;  // splitmix64's finaliser
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return double((x ^ (x >> 31)) >> 11) * 0x1p-53;
}

}  // namespace detail

/// How far the radiance that receivers are given may be off.
struct CutTolerance {
  /// The root mean square error of all receivers, of the root mean square of their radiance: 0.01 is 1 %.
  float relative = 0.01F;
  /// If not 0, in place of that: the greatest mean square deviation, RGB added up, that the light drawn of any one
  /// cluster may have. Where many cuts share a tolerance, the same number for all costs least.
  float of_one_light = 0;
  /// Are lights hidden from receivers, which nothing is known of beforehand? Then a cluster may send anything between
  /// nothing and all, and the bound holds with visibility too.
  bool with_visibility = false;
};

/// May be used again, for other receivers, which keeps its memory.
template <int N, int NE, Horizon method = Horizon::smoothstep>
class LightCut {
 public:
  explicit LightCut(const LightTree<NE>& tree) : tree_(&tree) {}

  /// The coarsest cut that refining finds. The same for the same tree and receivers.
  void find(const CutReceivers<N>& receivers, const CutTolerance& tolerance) {
    heap_.clear(), clusters_.clear(), whole_.clear();
    for (auto& sum : radiance_sum_) sum = Lanes(0);
    variance_ = 0, size_of_whole_ = unknown_ = 0;
    if (tree_->size() == 0) return;
    add(receivers, tolerance, 0, 0);
    while (!heap_.empty() && !is_fine(tolerance)) refine(receivers, tolerance);
  }

  /// Lights that are drawn at a time; up to the tree's size.
  int size() const { return size_of_whole_ + int(heap_.size()); }
  /// The mean over the receivers of the square of the deviation, at most, and of the radiance, about; RGB added up.
  double variance() const { return (std::max)(variance_, 0.0) / cut_receivers; }
  double power() const {
    Lanes power(0);
    for (const Lanes& sum : radiance_sum_) power = power + sum * sum;
    return double(power.sum()) / cut_receivers;
  }

  /// What the cluster that deviates most adds to the variance.
  double greatest_variance() const { return heap_.empty() ? 0 : double(heap_.front().variance) / cut_receivers; }

  /// Draws one light for each cluster, `count` times: visit(draw, place, factor), where the light at that place of the
  /// tree's order counts `factor` times. Each draw alone is right in the mean over all seeds. Those of one seed are
  /// spread evenly over each cluster, so that the mean of all is far nearer the truth than that of as many alone.
  template <class Visit>
  void draw(int count, std::uint64_t seed, const Visit& visit) const {
    const auto visit_all = [&](const LightNode<NE>& node) {
      for (int place = node.first; place < node.last; ++place) {
        for (int draw = 0; draw < count; ++draw) visit(draw, place, 1.0F);
      }
    };
    for (const int node : whole_) visit_all(tree_->node(node));
    constexpr std::size_t ahead = 8;
    for (std::size_t i = 0; i < heap_.size(); ++i) {
      const Entry& entry = heap_[i];
      if (i + ahead < heap_.size()) {
        const std::int32_t next = heap_[i + ahead].node;
        tree_->prefetch_weights(tree_->node(next), detail::scatter(seed, std::uint64_t(next)), count);
      }
      const LightNode<NE>& node = tree_->node(entry.node);
      const double weight = tree_->weight_before(node.last) - tree_->weight_before(node.first);
      if (node.size() == 1) visit_all(node);
      if (node.size() == 1 || !(weight > 0)) continue;
      const double start = detail::scatter(seed, std::uint64_t(entry.node));
      for (int draw = 0; draw < count; ++draw) {
        const double part = start + double(draw) / count;
        const int place = tree_->place_at(node, part < 1 ? part : part - 1);
        const double own = tree_->weight_before(place + 1) - tree_->weight_before(place);
        if (own > 0) visit(draw, place, float(weight / own));
      }
    }
  }

 private:
  using Lanes = Packet<float, cut_receivers>;
  struct Cluster {
    Lanes radiance[3], variance;
  };
  struct Entry {
    float variance;
    std::int32_t node;
    std::size_t kept;  // where more of it is
    bool operator<(const Entry& other) const {
      return variance < other.variance || (!(other.variance < variance) && node < other.node);
    }
  };

  bool is_fine(const CutTolerance& tolerance) const {
    if (unknown_ > 0) return false;
    if (tolerance.of_one_light > 0) return greatest_variance() <= double(tolerance.of_one_light);
    return variance() <= double(tolerance.relative) * double(tolerance.relative) * power();
  }

  void refine(const CutReceivers<N>& receivers, const CutTolerance& tolerance) {
    std::pop_heap(heap_.begin(), heap_.end());
    const Entry worst = heap_.back();
    heap_.pop_back();
    count(worst, -1);
    const LightNode<NE>& node = tree_->node(worst.node);
    if (node.children == 0) {
      whole_.push_back(worst.node);
      size_of_whole_ += node.size();
      return;
    }
    for (int c = 0; c < 3; ++c) radiance_sum_[c] = radiance_sum_[c] - clusters_[worst.kept].radiance[c];
    add(receivers, tolerance, node.children, worst.kept);
    add(receivers, tolerance, node.children + 1, clusters_.size());
  }

  void add(const CutReceivers<N>& receivers, const CutTolerance& tolerance, std::int32_t index, std::size_t place) {
    const LightNode<NE>& node = tree_->node(index);
    const auto bound = bound_cluster<N, NE, method>(node, receivers, tolerance.with_visibility);
    if (place == clusters_.size()) clusters_.emplace_back();
    Lanes variance(0);
    for (int c = 0; c < 3; ++c) {
      clusters_[place].radiance[c] = bound.radiance[c];
      radiance_sum_[c] = radiance_sum_[c] + bound.radiance[c];
      variance = variance + bound.deviation[c] * bound.deviation[c];
    }
    clusters_[place].variance = node.size() == 1 ? Lanes(0) : variance;
    const Entry entry{clusters_[place].variance.sum(), index, place};
    heap_.push_back(entry);
    count(entry, 1);
    std::push_heap(heap_.begin(), heap_.end());
  }

  void count(const Entry& entry, int sign) {
    if (entry.variance < detail::unknown_deviation * detail::unknown_deviation) {
      variance_ += sign * double(entry.variance);
    } else {
      unknown_ += sign;
    }
  }

  const LightTree<NE>* tree_;
  std::vector<Entry> heap_;  // by variance, the greatest in front
  std::vector<Cluster> clusters_;
  std::vector<std::int32_t> whole_;  // leaves all of whose lights are taken
  int size_of_whole_ = 0;
  Lanes radiance_sum_[3];
  double variance_ = 0;
  int unknown_ = 0;  // clusters without a bound
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
