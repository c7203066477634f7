#include "split_material.hpp"

#include <tbb/parallel_for.h>

#include "input_error.hpp"

namespace example {
namespace {

constexpr double table_tolerance = 1e-4;

zonal::MaterialTable table_of(const zonal::Brdf& part) {
  const auto for_each = [](int count, const auto& body) { tbb::parallel_for(0, count, body); };
  return zonal::project_material(part, zonal::MaterialTable::max_bands, table_tolerance, for_each);
}

}  // namespace

SplitMaterial::SplitMaterial(const Material& material)
    : BodyAndRest(body_and_rest(material.brdf)), body_table(table_of(body)), rest_table(table_of(rest)) {
  if (!is_isotropic(material.brdf)) throw InputError(material.name + ": is anisotropic, which is not taken here");
}

}  // namespace example
