// hvl_radiance, recorded for a shader
#include <zonal/kernels/gather_kernels.hpp>
#include <zonal/shader/recorded_function.hpp>

zonal::shader::RecordedFunction recorded() {
  return zonal::shader::record<zonal::kernels::HvlRadiance<3, zonal::Horizon::smoothstep>, BANDS>();
}
