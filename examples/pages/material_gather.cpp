// Indirect light on gold: a material projected to a table, virtual lights gathered by it, and what an integral over the
// surface gives. Needs GLM:
//
//   g++ -std=c++17 -O2 -march=native -Iinclude examples/pages/material_gather.cpp -o gather
#include <zonal/gather/hvl.hpp>
#include <zonal/gather/radius.hpp>
#include <zonal/material/material_table.hpp>
#include <zonal/material/named.hpp>

#include <cmath>
#include <cstdio>
#include <vector>

int main() {
  // The materials, and their coefficients by outgoing angle: 9 bands of gold, of which GGX's roughness is 0.25, and the
  // one band that clay has. A table takes a fraction of a second, and can be saved (material/material_file.hpp).
  const zonal::Brdf clay = zonal::matte({0.8F, 0.4F, 0.2F}), gold = zonal::metal(*zonal::find_metal("gold"), 0.25F);
  const zonal::MaterialTable clay_table = zonal::project_material(clay, 1);
  const zonal::MaterialTable gold_table = zonal::project_material(gold, 9, 1e-3);

  // A ceiling of clay, 2 x 2 m and 0.6 m above the floor, on which 10 W/m^2 arrive, as 8 x 8 virtual lights: in a
  // renderer the texels of a reflective shadow map. Each is a sphere about as large as the piece that it stands for.
  const int side = 8;
  const float step = 2.0F / side;
  std::vector<zonal::VirtualLight> lights(side * side);
  for (int i = 0; i < side * side; ++i) {
    lights[i].position = {step * (float(i % side) + 0.5F) - 1.0F, step * (float(i / side) + 0.5F) - 1.0F, 0.6F};
    lights[i].normal = lights[i].to_primary = {0, 0, -1};
    lights[i].flux = glm::vec3(10.0F * step * step);
    lights[i].material = &clay_table;
  }
  zonal::set_neighbour_radii(lights.data(), side, side, 0.5F);
  const zonal::HvlCache<1> cache(lights);  // one band of emission

  for (const float x : {-0.25F, -0.75F, -1.25F}) {  // a floor of gold, seen from 45 degrees
    const zonal::Receiver point{{x, 0, 0}, {0, 0, 1}, glm::normalize(glm::vec3(-1, 0, 1))};
    const glm::vec3 gathered = zonal::gather<9, 1>(cache, point, gold_table);

    // The same by definition: radiance of clay, E albedo / pi, times f cos at the floor, over the ceiling's area.
    glm::dvec3 exact(0);
    const int fine = 300;
    for (int i = 0; i < fine * fine; ++i) {
      const glm::dvec3 to_light((i % fine + 0.5) * 2 / fine - 1 - x, (i / fine + 0.5) * 2 / fine - 1, 0.6);
      const double d2 = glm::dot(to_light, to_light), cosine = to_light.z / std::sqrt(d2);
      // In the material's frame, where x is towards the eye: here it is -x, and y is -y.
      const glm::dvec3 wi = glm::dvec3(-to_light.x, -to_light.y, to_light.z) / std::sqrt(d2);
      const glm::dvec3 f = evaluate(gold, wi, glm::normalize(glm::dvec3(1, 0, 1)));
      exact += f * glm::dvec3(0.8, 0.4, 0.2) * (10 / 3.14159265358979 * cosine * cosine / d2 * 4 / (fine * fine));
    }
    std::printf("x = %5.2f: %.2f %.2f %.2f, exactly %.2f %.2f %.2f\n", double(x), double(gathered.r),
                double(gathered.g), double(gathered.b), exact.r, exact.g, exact.b);
  }
}

// It prints:
//   x = -0.25: 1.86 0.77 0.16, exactly 1.86 0.77 0.16
//   x = -0.75: 1.92 0.80 0.17, exactly 1.91 0.79 0.17
//   x = -1.25: 1.51 0.63 0.13, exactly 1.53 0.64 0.13
