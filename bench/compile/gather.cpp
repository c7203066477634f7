// gather, of HVLs that send three bands
#include <zonal/gather/hvl.hpp>

glm::vec3 gathered(const zonal::HvlCache<3>& lights, const zonal::Receiver& receiver,
                   const zonal::MaterialTable& table) {
  return zonal::gather<BANDS, 3>(lights, receiver, table);
}
