// resample
#include <zonal/field/resample.hpp>

void resample(zonal::CoefficientGrid<BANDS>& grid, const zonal::DirectionBuckets& buckets,
              const std::vector<zonal::RadianceSample>& samples, const std::vector<zonal::ProbePlace>& probes) {
  zonal::resample(grid, buckets, samples, probes, 0.1F);
}
