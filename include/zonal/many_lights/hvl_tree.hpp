// Harmonics virtual lights in a tree, and the few that a cut draws of them as a cache for `gather`.
#pragma once

#include <cstdint>
#include <vector>

#include "../gather/hvl.hpp"
#include "../transform/rotate.hpp"
#include "drawn_lights.hpp"
#include "light_cut.hpp"

namespace zonal {
inline namespace ZONAL_TARGET {

/// What a light sends, as the tree keeps it.
template <int NE, class Emission>
TreeLight<NE> tree_light(const HvlRecord<NE, float, Emission>& record) {
  const auto vector = [](const float(&v)[3]) { return glm::vec3(v[0], v[1], v[2]); };
  TreeLight<NE> light;
  light.position = vector(record.position);
  light.normal = vector(record.normal);
  light.radius = record.radius;
  for (int l = 0; l < NE; ++l) {
    for (int m = has_order(Emission::symmetry, -1) ? -l : l % 2; m <= l; m += 2) {
      const int i = Emission::index(l, m);
      light.emission(l, m) = glm::vec3(record.emission[0][i], record.emission[1][i], record.emission[2][i]) *
                             (record.radius * record.radius);
    }
  }
  if constexpr (NE > 1) {
    const glm::vec3 tangent = vector(record.tangent);
    light.emission = rotate(light.emission,
                            Rotation<NE, float>::from_axes(tangent, glm::cross(light.normal, tangent), light.normal));
  }
  return light;
}

/// The lights of a cache.
template <int NE>
class HvlTree {
 public:
  using Record = HvlRecord<NE, float>;
  using AnisotropicRecord = HvlRecord<NE, float, AnyEmission>;

  HvlTree() = default;
  template <class ForEach = SerialForEach>
  explicit HvlTree(const HvlCache<NE>& lights, const ForEach& for_each = {}) {
    tree_ = LightTree<NE>(
        lights.size(), [&](int i) { return of_cache(lights, i); }, for_each);
    // In the tree's order, for what is drawn together lies near together.
    const bool mixed = lights.anisotropic().size() > 0;
    if (mixed) ranks_.resize(std::size_t(size()));
    const int isotropic = lights.isotropic().size();
    for (int place = 0; place < size(); ++place) {
      const int light = tree_.light_at(place);
      if (light < isotropic) {
        if (mixed) ranks_[std::size_t(place)] = int(isotropic_.size());
        isotropic_.push_back(lights.isotropic().record(light));
      } else {
        ranks_[std::size_t(place)] = ~int(anisotropic_.size());
        anisotropic_.push_back(lights.anisotropic().record(light - isotropic));
      }
    }
  }

  /// The cache has other lights at these numbers now (HvlCache::replace): LightTree::update.
  void update(const HvlCache<NE>& lights, const std::vector<int>& changed) {
    tree_.update(changed, [&](int i) { return of_cache(lights, i); });
    for (const int light : changed) {
      const int r = rank(tree_.place_of(light));
      if (r >= 0) {
        isotropic_[std::size_t(r)] = lights.isotropic().record(light);
      } else {
        anisotropic_[std::size_t(~r)] = lights.anisotropic().record(light - lights.isotropic().size());
      }
    }
  }

  int size() const { return tree_.size(); }
  const LightTree<NE>& tree() const { return tree_; }
  /// Memory, without what a vector holds in reserve.
  std::size_t bytes() const {
    return tree_.bytes() + ranks_.size() * sizeof(int) + isotropic_.size() * sizeof(Record) +
           anisotropic_.size() * sizeof(AnisotropicRecord);
  }

  /// Lights in place of all, as many draws of a cut of this tree as `draws` has: see LightCut::draw; for receivers
  /// within the box.
  template <int N, Horizon method>
  void draw(const LightCut<N, NE, method>& cut, const ReceiverBox& receivers, std::uint64_t seed,
            std::vector<DrawnLights<NE>>& draws) const {
    // The records lie anywhere: each is fetched while others are put in their place.
    struct Drawn {
      int draw, place;
      float factor;
    };
    constexpr int ahead = 32;
    Drawn waiting[ahead];
    int count = 0;
    const auto put = [&](const Drawn& drawn) {
      const auto append = [&](const auto& record) {
        draws[std::size_t(drawn.draw)].append(scaled(record, drawn.factor), receivers, method != Horizon::none);
      };
      const int r = rank(drawn.place);
      if (r >= 0) {
        append(isotropic_[std::size_t(r)]);
      } else {
        append(anisotropic_[std::size_t(~r)]);
      }
    };
    for (DrawnLights<NE>& lights : draws) lights.reset();
    cut.draw(int(draws.size()), seed, [&](int draw, int place, float factor) {
      Drawn& next = waiting[count % ahead];
      if (count >= ahead) put(next);
      next = {draw, place, factor};
      prefetch(place);
      ++count;
    });
    for (int i = (std::max)(count - ahead, 0); i < count; ++i) put(waiting[i % ahead]);
  }

 private:
  static TreeLight<NE> of_cache(const HvlCache<NE>& lights, int i) {
    const int isotropic = lights.isotropic().size();
    return i < isotropic ? tree_light(lights.isotropic().record(i))
                         : tree_light(lights.anisotropic().record(i - isotropic));
  }

  int rank(int place) const { return ranks_.empty() ? place : ranks_[std::size_t(place)]; }

  void prefetch(int place) const {
    const int r = rank(place);
    if (r < 0) return;
    const auto* bytes = reinterpret_cast<const char*>(&isotropic_[std::size_t(r)]);
    for (std::size_t i = 0; i < sizeof(Record); i += 64) detail::prefetch(bytes + i);
    detail::prefetch(bytes + sizeof(Record) - 1);
  }

  LightTree<NE> tree_;
  std::vector<int> ranks_;  // of the light at a place: in one list, or ~ in the other; none where all are isotropic
  std::vector<Record> isotropic_;
  std::vector<AnisotropicRecord> anisotropic_;
};

}  // namespace ZONAL_TARGET
}  // namespace zonal
