// Operation counts of the kernels, from the recorder.
#pragma once

#include <zonal/scalar/recorder.hpp>

namespace zonal_bench {

/// The operations of the kernel of this name and bands per item: per direction, cap or light.
zonal::OperationCount operation_count(const char* name, int bands);

}  // namespace zonal_bench
