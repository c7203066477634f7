// What a scene's materials do not need, by one tolerance: which coefficients, and what leaving them out costs. Needs
// GLM and Eigen:
//
//   g++ -std=c++17 -O2 -march=native -Iinclude -I/usr/include/eigen3 examples/pages/plan.cpp -o plan
#include <zonal/gather/hvl.hpp>
#include <zonal/material/material_table.hpp>
#include <zonal/material/named.hpp>
#include <zonal/plan/material_plan.hpp>

#include <cstdio>

int main() {
  const zonal::MaterialTable clay = zonal::project_material(zonal::matte({0.8F, 0.4F, 0.2F}), 5);
  const zonal::MaterialTable varnish = zonal::project_material(zonal::plastic({0.1F, 0.4F, 0.7F}, 0.4F), 5, 1e-3);
  const char* const symmetries[] = {"zonal", "mirror", "none"};
  struct {
    const char* name;
    const zonal::MaterialTable& table;
  } const materials[] = {{"clay", clay}, {"varnish", varnish}};

  // Of 5 bands at a receiver and 3 of what lights send: all told 15 and 4 coefficients.
  for (const auto& [name, table] : materials) {
    for (const double tolerance : {0.2, 0.1, 0.01}) {  // relative, root mean square over directions
      const zonal::CoefficientPlan plan = zonal::plan_receiver(table, {5, tolerance});
      const zonal::CoefficientPlan sent = zonal::plan_emission(table, {3, tolerance});
      std::printf("%-8s %4.2f  %-6s %d bands, %2d coefficients: %.4f, at worst %.3f; sends %d bands: %.4f\n", name,
                  tolerance, symmetries[int(plan.symmetry)], plan.bands, plan.kept_count(), plan.error.mean,
                  plan.error.worst, sent.bands, sent.error.mean);
    }
  }

  // The plan of clay within 10 %, carried out: three numbers a channel.
  zonal::VirtualLight light;
  light.position = {0.5F, 0, 2};
  light.normal = light.to_primary = {0, 0, -1};
  light.flux = glm::vec3(10);
  light.radius = 0.5F;
  light.material = &clay;
  const zonal::HvlCache<1> cache({light});
  const zonal::Receiver point{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
  const auto all = clay.with_cosine<5>(1);
  const auto few = zonal::with_bands<3>(zonal::about_axis(all));
  std::printf("gathered: %.4f, by all coefficients %.4f\n", double(zonal::gather<3, 1>(cache, point, few).r),
              double(zonal::gather<5, 1>(cache, point, all).r));
}

// It prints:
//   clay     0.20  zonal  3 bands,  3 coefficients: 0.0766, at worst 0.230; sends 1 bands: 0.0000
//   clay     0.10  zonal  3 bands,  3 coefficients: 0.0766, at worst 0.230; sends 1 bands: 0.0000
//   clay     0.01  zonal  5 bands,  4 coefficients: 0.0000, at worst 0.000; sends 1 bands: 0.0000
//   varnish  0.20  mirror 5 bands, 15 coefficients: 0.0000, at worst 0.000; sends 3 bands: 0.0000
//   varnish  0.10  mirror 5 bands, 15 coefficients: 0.0000, at worst 0.000; sends 3 bands: 0.0000
//   varnish  0.01  mirror 5 bands, 15 coefficients: 0.0000, at worst 0.000; sends 3 bands: 0.0000
//   gathered: 0.1503, by all coefficients 0.1416
