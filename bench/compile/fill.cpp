// add_lights, of sphere lights
#include <zonal/grid/add_lights.hpp>
#include <zonal/light/sphere.hpp>
#include <zonal/scalar/for_each.hpp>

void fill(zonal::CoefficientGrid<BANDS>& grid,
          const std::vector<zonal::ColouredLight<zonal::SphereLight<float>>>& lights) {
  zonal::add_lights(grid, lights, zonal::SerialForEach{});
}
