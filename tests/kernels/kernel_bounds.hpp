// The greatest errors of the registry's kernels at four bands, in any scalar, for ordinary inputs: of each kernel one.
// The definitions are another matter: the rooms' tests, and ../accuracy_table.hpp.
#pragma once

/// An error is measured in ulps of the largest number that the kernel gives: for the same inputs, or, where a sum may
/// cancel, for any of the test's inputs.
enum class Unit { largest_of_run, largest_of_all };

struct KernelBound {
  const char* kernel;
  double ulps;
  Unit unit;
};

inline constexpr KernelBound kernel_bounds[] = {
    {"evaluate", 5, Unit::largest_of_run},
    {"evaluate_even", 6, Unit::largest_of_run},
    {"evaluate_zonal", 4, Unit::largest_of_run},
    {"evaluate_with_gradient", 8, Unit::largest_of_run},
    {"cap", 4, Unit::largest_of_run},
    {"cap_up_to_hemisphere", 4, Unit::largest_of_run},
    {"sphere_cap", 6, Unit::largest_of_run},
    {"cap_derivative", 6, Unit::largest_of_run},
    {"lambert", 1, Unit::largest_of_run},
    {"phong", 4, Unit::largest_of_run},
    {"spherical_gaussian", 5, Unit::largest_of_run},
    {"orient", 5, Unit::largest_of_run},
    {"reconstruct", 3, Unit::largest_of_all},
    {"reconstruct_even", 3, Unit::largest_of_all},
    {"reconstruct_zonal", 3, Unit::largest_of_all},
    {"reconstruct_lambert", 3, Unit::largest_of_all},
    {"reconstruct_convolved", 3, Unit::largest_of_all},
    {"convolve", 3, Unit::largest_of_run},
    {"convolve_zonal", 3, Unit::largest_of_run},
    {"dot", 2, Unit::largest_of_all},
    {"dot_even", 2, Unit::largest_of_all},
    {"dot_zonal", 2, Unit::largest_of_all},
    {"hann_window", 3, Unit::largest_of_run},
    {"sinc_window", 3, Unit::largest_of_run},
    {"apply_hann_window", 8, Unit::largest_of_run},
    {"apply_sinc_window", 8, Unit::largest_of_run},
    {"project_sphere", 25, Unit::largest_of_run},
    {"project_sphere_with_gradient", 25, Unit::largest_of_run},
    {"cell_position", 4, Unit::largest_of_run},
    {"trilinear_weights", 4, Unit::largest_of_run},
    {"hermite_weights", 5, Unit::largest_of_run},
    {"clear_sums", 0, Unit::largest_of_run},
    {"add_sphere", 8, Unit::largest_of_run},
    {"finish_sums", 3, Unit::largest_of_run},
    {"horizon_smoothstep", 3, Unit::largest_of_all},
    {"horizon_exact", 3, Unit::largest_of_all},
    {"hvl_radiance_diffuse", 15, Unit::largest_of_all},
    {"hvl_radiance", 8, Unit::largest_of_all},
    {"arcs", 4, Unit::largest_of_run},
    {"project_spot_with_gradient", 40, Unit::largest_of_run},
    {"project_triangle_sphere_with_gradient", 35, Unit::largest_of_run},
    {"project_polygon_with_gradient", 40, Unit::largest_of_run},
    {"hvl_radiance_exact", 8, Unit::largest_of_all},
};
