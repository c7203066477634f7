// zonal.hpp, nothing of it
#include <zonal/zonal.hpp>
