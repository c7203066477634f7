#include "hit_groups.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace example::hvl_render {

Tiles::Tiles(int image_width, const PrimaryHits& hits, int lights) : width_(image_width), height_(hits.slice().rows) {
  const bool has_few_lights = lights < 2000;
  least_group_ = has_few_lights ? 256 : 64;
  const int side = std::clamp(image_width / 80 * (has_few_lights ? 6 : 4), 8, 96);
  // About as many hits, whatever is seen of a pixel; and a whole number of the dither's patterns.
  side_ = std::max(4, static_cast<int>(side / std::sqrt(static_cast<double>(hits.per_pixel()))) / 4 * 4);
  across_ = (width_ + side_ - 1) / side_;
  down_ = (height_ + side_ - 1) / side_;
}

Tile Tiles::operator[](int number) const {
  const int left = number % across_ * side_, top = number / across_ * side_;
  return {left, top, std::min(side_, width_ - left), std::min(side_, height_ - top)};
}

void HitGroups::for_each(const Tile& tile, int least_group, const PrimaryHits& hits, float turn_length,
                         zonal::FunctionRef<void(const HitGroup&)> visit) {
  collect(tile, hits);
  few_.clear();
  HitGroup few{nullptr, {}};
  const auto visit_parted = [&](HitGroup& group) {
    group.parts.halve_all(group.receivers, turn_length);
    visit(group);
  };
  const auto visit_few = [&] {
    few.receivers = few_.data();
    visit_parted(few);
    few.parts = {};
    few_.clear();
  };
  for_each_surface([&](zonal::GroupedReceiver* receivers, int count) {
    if (count >= least_group) {
      HitGroup group{receivers, {}};
      group.parts.add(count);
      return visit_parted(group);
    }
    few_.insert(few_.end(), receivers, receivers + count);
    few.parts.add(count);
    if (few.parts.parts == zonal::cut_receivers || few.count() >= least_group) visit_few();
  });
  if (few.count() > 0) visit_few();
}

void HitGroups::collect(const Tile& tile, const PrimaryHits& hits) {
  // What stands near together, in rows and columns too, is spread over the draws.
  constexpr std::uint32_t ordered[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
  places_.clear();
  receivers_.clear();
  const auto per_pixel = static_cast<std::uint32_t>(hits.per_pixel());
  for (int y = tile.top; y < tile.top + tile.height; ++y) {
    for (int x = tile.left; x < tile.left + tile.width; ++x) {
      const std::size_t in_slice = hits.index(x, y), pixel = hits.index(x, y + hits.slice().first_row);
      for (std::uint32_t sample = 0; sample < per_pixel; ++sample) {
        const std::optional<Hit>& hit = hits.of_pixel(in_slice)[sample];
        if (!hit) continue;
        receivers_.push_back({hit->position, hit->normal, static_cast<int>(places_.size())});
        places_.push_back({&*hit, pixel, pixel * per_pixel + sample, (ordered[y % 4][x % 4] + 7 * sample) % 16});
      }
    }
  }
}

void HitGroups::for_each_surface(zonal::FunctionRef<void(zonal::GroupedReceiver*, int)> visit) {
  const auto material = [&](const zonal::GroupedReceiver& receiver) {
    return places_[static_cast<std::size_t>(receiver.index)].hit->material;
  };
  std::stable_sort(receivers_.begin(), receivers_.end(),
                   [&](const auto& a, const auto& b) { return material(a) < material(b); });
  for (auto first = receivers_.begin(), last = first; first != receivers_.end(); first = last) {
    last = std::find_if(first, receivers_.end(),
                        [&](const auto& receiver) { return material(receiver) != material(*first); });
    zonal::for_each_receiver_group(&*first, static_cast<int>(last - first), visit);
  }
}

}  // namespace example::hvl_render
