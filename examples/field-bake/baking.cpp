#include "baking.hpp"

#include <utility>

#include <tbb/parallel_for.h>
#include <zonal/field/resample_reference.hpp>
#include <zonal/grid/grid_file.hpp>

namespace example::field_bake {
namespace {

const auto for_each = [](int count, const auto& body) { tbb::parallel_for(0, count, body); };

template <class Sums>
class BakingOf final : public Baking {
 public:
  using Grid = typename Sums::Grid;

  BakingOf(const Options& options, const Bounds& box, const zonal::BakeFolder& folder,
           const zonal::ProbeSequence& sequence, const zonal::DirectionBuckets& buckets, const Ranks& ranks)
      : grid_(box.lower, box.upper, options.resolution),
        bake_(folder, sequence, buckets, grid_, options.resampling, {ranks.index(), ranks.count()}) {}

  std::size_t count() const override { return bake_.count(); }
  std::size_t done() const override { return bake_.done(); }
  void step() override { bake_.step(for_each); }
  void save() override { bake_.save(); }
  bool finish(const Ranks& ranks, const Options& options) override {
    bake_.sums().visit_state([&](auto* numbers, std::size_t count) { ranks.add_up(numbers, count); });
    if (!ranks.is_first()) return true;
    if (!bake_.sums().finish(grid_, for_each)) return false;
    zonal::save_grid(options.out, grid_, options.half ? zonal::GridNumbers::halves : zonal::GridNumbers::floats);
    return true;
  }
  void forget() override { bake_.forget(); }
  std::size_t grid_bytes() const override { return grid_.size() * sizeof(float); }

 private:
  Grid grid_;
  zonal::FieldBake<Sums> bake_;
};

template <int N, class... Arguments>
std::unique_ptr<Baking> make_of_bands(const Options& options, Arguments&&... arguments) {
  if (options.path == Path::space) {
    return std::make_unique<BakingOf<zonal::ReferenceFieldSums<N>>>(options, arguments...);
  }
  if (options.gradients) {
    return std::make_unique<BakingOf<zonal::FieldSums<N, zonal::GridContent::values_and_gradients>>>(options,
                                                                                                     arguments...);
  }
  return std::make_unique<BakingOf<zonal::FieldSums<N>>>(options, arguments...);
}

}  // namespace

std::unique_ptr<Baking> make_baking(const Options& options, const Bounds& box, const zonal::BakeFolder& folder,
                                    const zonal::ProbeSequence& sequence, const zonal::DirectionBuckets& buckets,
                                    const Ranks& ranks) {
  const auto make = [&](auto bands) { return make_of_bands<bands>(options, box, folder, sequence, buckets, ranks); };
  switch (options.bands) {
    case 2: return make(zonal::Index<2>{});
    case 3: return make(zonal::Index<3>{});
    case 4: return make(zonal::Index<4>{});
    case 6: return make(zonal::Index<6>{});
    default: return make(zonal::Index<5>{});
  }
}

}  // namespace example::field_bake
