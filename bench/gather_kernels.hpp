// The gathers that are measured: what one light adds to each is an entry of the registry.
#pragma once

#include <zonal/kernels/gather_kernels.hpp>

#include "kernels.hpp"

namespace zonal_bench {

template <class Visit>
void for_gather_kernels(Visit&& visit) {
  using kernels::HvlRadiance;
  using zonal::Horizon;
  // The bands of HVL Table 1.
  using GatherBands = Built<Bands<3, 5, 7, 9>, Bands<5>>;
  at<HvlRadiance<3>>(GatherBands{}, visit);
  at<HvlRadiance<1>>(GatherBands{}, visit);
  at<HvlRadiance<3, Horizon::none>>(Bands<5>{}, visit);
  at<HvlRadiance<3, Horizon::exact>>(Bands<5>{}, visit);
}

}  // namespace zonal_bench
