#pragma once

#include <zonal/material/named.hpp>

namespace example {

// The materials of the programs are the library's.
using zonal::find_metal;
using zonal::matte;
using zonal::metal;
using zonal::Metal;
using zonal::metals;
using zonal::plastic;

/// The material with the light that bounces between its microfacets, where it is a GGX lobe alone. Under a coat the
/// body has that light already: it reflects of all that the coat leaves.
zonal::Brdf with_multiple_scattering(const zonal::Brdf& brdf);

/// A material in two: its body, the lobes of is_diffuse, which a texture colours, and the rest.
struct BodyAndRest {
  zonal::Brdf body, rest;
};
BodyAndRest body_and_rest(const zonal::Brdf& brdf);

}  // namespace example
