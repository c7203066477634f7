// project_material
#include <zonal/material/material_table.hpp>

zonal::MaterialTable table(const zonal::Brdf& brdf) { return zonal::project_material(brdf, BANDS); }
