#pragma once

#include <memory>

#include "lighting.hpp"

namespace example::grid_render {

/// Sphere lights without coefficients of their own frame: light and lobe are both zonal, and the cosine is that at the
/// light's centre (Mezieres et al., Harmonics Virtual Lights, CGF 41(6), 2022; the gradient paper's "ZH approx.").
///
/// A light is A_l Y_l^m(w), w the direction to its centre; a lobe about the axis a is the BRDF alone, with the zonal
/// coefficients k_l. Their product's integral is the sum over l of A_l k_l Y_l^0(w . a), and the cosine a factor:
///
///   max(0, w . a) sum_l A_l k_l Y_l^0(w . a)
///
/// The axis is the normal for the diffuse lobe, whose k has one band, and the mirrored view direction for a glossy one,
/// which stands for the normal there as it does in the kernel that includes the cosine (GlossyLobe). Against that the
/// only difference is where the cosine is taken.
std::unique_ptr<LightField> make_zonal_field(const SphereLights& lights, int bands);

}  // namespace example::grid_render
