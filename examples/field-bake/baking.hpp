#pragma once

#include <cstddef>
#include <memory>

#include <zonal/field/bake.hpp>

#include "options.hpp"
#include "ranks.hpp"

namespace example::field_bake {

/// A field on its way, of any number of bands.
class Baking {
 public:
  virtual ~Baking() = default;

  /// Blocks of buckets that are this process's, and how many are done.
  virtual std::size_t count() const = 0;
  virtual std::size_t done() const = 0;
  virtual void step() = 0;
  /// Keeps what is done in the work folder. Throws zonal::FileError.
  virtual void save() = 0;
  /// Adds the ranks' sums up and, in the first, writes the grid. False where no sample met the box. Throws
  /// zonal::FileError.
  virtual bool finish(const Ranks& ranks, const Options& options) = 0;
  /// Removes what was kept.
  virtual void forget() = 0;
  /// Bytes of the grid.
  virtual std::size_t grid_bytes() const = 0;
};

/// What --bands, --gradients and --path name. All must outlive it.
std::unique_ptr<Baking> make_baking(const Options& options, const Bounds& box, const zonal::BakeFolder& folder,
                                    const zonal::ProbeSequence& sequence, const zonal::DirectionBuckets& buckets,
                                    const Ranks& ranks);

}  // namespace example::field_bake
