#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <zonal/many_lights/light_cut.hpp>
#include <zonal/many_lights/receiver_groups.hpp>
#include <zonal/scalar/function_ref.hpp>

#include "shared/primary_hits.hpp"

namespace example::hvl_render {

/// Pixels of a slice.
struct Tile {
  int left, top, width, height;
};

/// A slice in tiles, a twentieth of the picture across: few surfaces change much within one. Of few lights a cut costs
/// more than it saves where fewer hits share it, so that tiles and groups are larger.
class Tiles {
 public:
  Tiles(int image_width, const PrimaryHits& hits, int lights);

  int count() const { return across_ * down_; }
  Tile operator[](int number) const;
  /// A fifth of all, of all columns and rows alike.
  bool is_sample(int number) const { return (number % across_ + 2 * (number / across_)) % 5 == 0; }
  /// Hits that are worth a cut of their own.
  int least_group() const { return least_group_; }

 private:
  int width_, height_, side_, across_, down_, least_group_;
};

/// A hit of a tile: of which pixel and sample of the image.
struct Place {
  const Hit* hit;
  std::size_t pixel, sample;
  std::uint32_t pattern;  // 0 to 15: an ordered dither of pixels
};

/// Hits that share a cut, in parts of neighbours: of one surface and one material, or several such groups that are too
/// small for a cut of their own.
struct HitGroup {
  zonal::GroupedReceiver* receivers;
  zonal::ReceiverParts<zonal::cut_receivers> parts;

  int count() const { return parts.size(); }
};

/// The hits of a tile, by group; what a thread keeps from tile to tile.
class HitGroups {
 public:
  /// A receiver's turn by 1 rad matters as much as to move by `turn_length`. Places hold until the next call.
  void for_each(const Tile& tile, int least_group, const PrimaryHits& hits, float turn_length,
                zonal::FunctionRef<void(const HitGroup&)> visit);

  const Place& place(const HitGroup& group, int i) const {
    return places_[static_cast<std::size_t>(group.receivers[i].index)];
  }

 private:
  void collect(const Tile& tile, const PrimaryHits& hits);
  void for_each_surface(zonal::FunctionRef<void(zonal::GroupedReceiver*, int)> visit);

  std::vector<Place> places_;
  std::vector<zonal::GroupedReceiver> receivers_, few_;  // all, and those of small groups
};

}  // namespace example::hvl_render
