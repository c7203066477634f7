// Where the table of accuracy has each public function, or why it has not.
#pragma once

#include <string_view>

struct Covered {
  std::string_view room;
  std::string_view
      functions;          // names, blanks between them; of the namespace `reference` or its room's with that before
  std::string_view rows;  // of the table, ; between them
  std::string_view why;   // they are in no row
};

inline constexpr std::string_view kWholeNumbers = "whole numbers, names, yes or no: exact";
inline constexpr std::string_view kCopies = "copies numbers as they are";
inline constexpr std::string_view kFiles = "files: the bits that were written";
inline constexpr std::string_view kChoices = "chooses or describes";
inline constexpr std::string_view kTexts = "texts and records";
inline constexpr std::string_view kBounds = "a bound, which the tests find nothing beyond";

inline constexpr Covered kCovered[] = {
    {"basis", "evaluate", "evaluate", ""},
    {"basis", "evaluate_even", "evaluate_even", ""},
    {"basis", "evaluate_zonal", "evaluate_zonal", ""},
    {"basis", "evaluate_with_gradient", "evaluate_with_gradient", ""},
    {"basis", "evaluate_with_hessian", "evaluate_with_hessian", ""},
    {"basis", "reference::evaluate_polynomial", "evaluate_polynomial", ""},
    {"basis",
     "reference::evaluate_polynomial_with_gradient reference::across reference::to_cartesian "
     "reference::angular_gradient_sloan_like reference::angular_gradient_direct",
     "", "forms of papers, kept to be compared with"},
    {"basis", "sh_index even_index is_even_in_z has_order coefficient_count coefficient_index", "", kWholeNumbers},
    {"basis", "get with_bands about_axis direction_span dispatch_bands", "", kCopies},

    {"convention", "convert change_frame", "rotate", ""},
    {"convention", "evaluate_in to_complex from_complex seven_vectors to_unity nine_polynomials", "",
     "values times constants: one rounding more, or two"},
    {"convention", "reconstruct reconstruct_polynomials", "reconstruct", ""},
    {"convention", "diagnosis_directions diagnose describe", "", "to the tolerance that is asked for"},
    {"convention", "is_right_handed axes_between greatest_degree stored_index find_convention", "", kChoices},

    {"environment", "project", "project", ""},
    {"environment", "project_by_texel", "", "the definition in double, which project is held against"},
    {"environment", "reconstruct", "reconstruct", ""},
    {"environment", "irradiance irradiance_over_pi", "convolve", ""},
    {"environment", "guess_mapping guess_environment mapping_name find_mapping", "", kChoices},

    {"field", "resample kernel_weight place_of ray_origin", "resample;resample, gradients", ""},
    {"field", "sort_samples", "", "means of texels, in double"},
    {"field", "repair", "", "guesses what nobody measured"},
    {"field", "thin", "", kChoices},
    {"field", "fingerprint is_sample block_count buckets_of_block", "", kWholeNumbers},
    {"field", "write_samples read_sequence write_sequence", "", kFiles},

    {"file", "parse_number shortest_text", "", "the nearest number; the shortest text that is read as the same one"},
    {"file", "behind_links with_standard_output", "", kFiles},

    {"fit", "fit_samples", "fit_samples", ""},

    {"gather", "gather", "gather;gather, a million lights", ""},
    {"gather", "hvl_radiance look_at", "hvl_radiance_diffuse;hvl_radiance;hvl_radiance_zonal", ""},
    {"gather", "horizon horizon_smoothstep horizon_exact", "horizon_smoothstep;horizon_exact", ""},
    {"gather", "gather_vpl vpl_radiance", "gather_vpl", ""},
    {"gather", "gather_hvl_zonal hvl_zonal_radiance", "gather_hvl_zonal", ""},
    {"gather", "gather_vsl vsl_radiance", "", "random samples, whose mean is the integral"},
    {"gather", "gather_vsgl vsgl_radiance make_gaussian_lights", "",
     "an approximation by its method: docs/rooms/gather.md says how far off"},
    {"gather", "set_neighbour_radii set_field_of_view_radii set_fixed_radii", "", kChoices},
    {"gather", "emission_index hvl_record_size", "", kWholeNumbers},
    {"gather", "without_symmetry scaled", "", "copies numbers, times one factor"},

    {"grid", "add_lights gradient_limit see_limited project_with_limited_gradient",
     "add_lights;add_lights, polygons;add_sphere;finish_sums", ""},
    {"grid", "interpolate", "interpolate;AdaptiveGrid;visible_trilinear_weights;visible_hermite_weights", ""},
    {"grid", "interpolate_with_gradient axis_weight_derivatives", "interpolate_with_gradient", ""},
    {"grid", "axis_weights cell_weights", "trilinear_weights;hermite_weights", ""},
    {"grid", "visible_weights", "visible_trilinear_weights;visible_hermite_weights", ""},
    {"grid", "seen_share node_weights from_corner", "seen_share", ""},
    {"grid", "map_place", "visibility_place", ""},
    {"grid", "limit_gradients", "", "changes gradients on purpose; docs/rooms/grid.md proves what is left"},
    {"grid", "measure_visibility", "", "an estimate of what lies between its rays"},
    {"grid", "texture_planes", "", "copies numbers, or the nearest 16-bit floats"},
    {"grid", "values_of", "", kCopies},
    {"grid", "save_grid read_grid_header load_grid", "", kFiles},
    {"grid", "blocks_read texture_plane_count", "", kWholeNumbers},

    {"kernels", "hvl_name with_triples for_each_kernel run_plainly", "", "runs the others, by name"},

    {"light", "project project_radial see point_profile sphere_profile", "project_sphere", ""},
    {"light", "project_with_gradient project_radial_with_gradient project_seen_with_gradient",
     "project_sphere_with_gradient;project_spot_with_gradient;project_triangle_sphere_with_gradient;"
     "project_polygon_with_gradient",
     ""},
    {"light", "polygon_sums finish", "project_polygon_with_gradient", ""},
    {"light", "edge_nodes edge_allowance edge_demand edge_rule", "", "how many nodes a tolerance takes"},

    {"lobe", "project", "cap;sphere_cap;lambert;phong;spherical_gaussian", ""},
    {"lobe", "project_up_to_hemisphere", "cap_up_to_hemisphere", ""},
    {"lobe", "project_derivative", "cap_derivative", ""},
    {"lobe", "reference::project_cap_closed_form reference::project_cap_legendre", "",
     "forms of papers, kept to be compared with"},

    {"many_bands", "evaluate visit_degrees", "evaluate", ""},
    {"many_bands", "evaluate_with_gradient", "evaluate_with_gradient", ""},
    {"many_bands", "evaluate_zonal", "evaluate_zonal", ""},
    {"many_bands", "project", "cap;lambert;phong;spherical_gaussian", ""},
    {"many_bands", "project_derivative", "cap_derivative", ""},
    {"many_bands", "rotate", "rotate", ""},
    {"many_bands", "orient reconstruct add_sample convolve dot", "evaluate", ""},

    {"many_lights", "gather", "gather", ""},
    {"many_lights",
     "bound_cluster bounded_receiver spread_over weighted greatest_value greatest_slope greatest_curvature", "",
     kBounds},
    {"many_lights", "tree_light as_packet", "", kCopies},
    {"many_lights", "standing_of halve_receivers for_each_receiver_group", "", kChoices},

    {"material", "evaluate", "evaluate;evaluate_ggx;evaluate_oren_nayar", ""},
    {"material", "reflectance", "reflectance_conductor;reflectance_dielectric;reflectance_schlick", ""},
    {"material", "ggx_albedo left_at residual coated with_multiple_scattering", "ggx_albedo", ""},
    {"material", "sheen_albedo", "sheen_albedo", ""},
    {"material", "project_zonal", "project_zonal", ""},
    {"material", "project_brdf project_anisotropic_brdf project_material", "",
     "return their own error, which bounds the true one"},
    {"material", "sample sample_lobe pdf lobe_pdf", "", "random directions, and the density that they are drawn with"},
    {"material",
     "diffuse_albedo glossy_albedo approximate_albedo glossy_lobe glossy_gaussian glossy_height gaussian_reflection",
     "", "approximations by their method: docs/rooms/material.md and gather.md say how far off"},
    {"material",
     "is_diffuse is_isotropic glossy_part custom measured even_part matte plastic metals find_metal metal "
     "for_each_crowded_node for_each_ring for_each_azimuth for_each_mirror_node",
     "", kChoices},
    {"material", "half_difference_angles", "", "angles for a lookup in tables of degrees, in double"},
    {"material",
     "save_material_table read_material_header load_material_table material_fingerprint cached_material_table "
     "load_merl load_rgl",
     "", kFiles},

    {"plan", "plan_receiver plan_emission half_error", "plan_receiver", ""},

    {"probe", "dering dering_factor least_value", "", "found by a search, to the tolerance that is asked for"},
    {"probe",
     "dominant_light extract_light project nonlinear_irradiance_over_pi hallucinated_zonal hallucinate_zh3 "
     "nearest_zonal project_zh3 solve_zh3 linear_axis",
     "", "approximations by their method: docs/rooms/probe.md says how far off"},
    {"probe", "reconstruct irradiance_over_pi reconstruct_zh3 irradiance_zh3_over_pi expand reconstruct_scaled",
     "reconstruct;reconstruct_lambert", ""},
    {"probe", "to_halves to_bytes to_floats to_six_floats value_error", "",
     "the nearest numbers of 16 bits or 8, whose error value_error bounds"},

    {"scalar", "asin", "asin", ""},
    {"scalar", "acos", "acos", ""},
    {"scalar", "angle_from", "angle_from", ""},
    {"scalar", "sin_cos", "sin_cos", ""},
    {"scalar", "exp", "exp", ""},
    {"scalar", "to_float to_half rounded constexpr_sqrt", "", "exact, or the nearest number"},
    {"scalar", "add_product subtract_product minimum maximum abs sqrt select clamp", "",
     "one operation, or two: rounded as IEEE 754 has it"},
    {"scalar", "gauss_legendre", "", "in double, to 1e-14: polynomials of its degree are integrated exactly"},
    {"scalar", "complete_frame", "", "two unit vectors, to 3 ulp of 1"},
    {"scalar", "adjoints for_each_field unroll", "", kTexts},

    {"screen", "filter", "filter", ""},
    {"screen", "incident_radiance arrive for_each_arrival", "incident_radiance", ""},
    {"screen", "reflected_radiance in_shading_frame mirror_direction", "reflected_radiance", ""},
    {"screen", "is_same_surface", "is_same_surface", ""},
    {"screen", "point_sample spot_sample surface_sample directional_sample", "", kCopies},

    {"shader", "shader_buffer packed_halves", "", "copies numbers, or the nearest 16-bit floats"},
    {"shader",
     "adjoint_function find_dialect version_text upper_case guarded file_text record_bands append_functions prefixed "
     "text_name literal function_text signature_text parameter_count planned_shells keep_coefficients function_name "
     "record shell_name shell_text find_shell",
     "", kTexts},

    {"transform", "orient", "orient", ""},
    {"transform", "reconstruct", "reconstruct;reconstruct_even", ""},
    {"transform", "reconstruct_zonal", "reconstruct_zonal", ""},
    {"transform", "reconstruct_along", "reconstruct_along", ""},
    {"transform", "reconstruct_with_adjoint", "reconstruct_with_adjoint;splat_with_adjoint", ""},
    {"transform", "reconstruct_convolved", "reconstruct_convolved;reconstruct_lambert", ""},
    {"transform", "convolve", "convolve;convolve_zonal", ""},
    {"transform", "dot", "dot;dot_even;dot_zonal", ""},
    {"transform", "product", "product;product_with_zonal", ""},
    {"transform", "full_product", "full_product", ""},
    {"transform", "triple_product", "triple_product", ""},
    {"transform", "rotate", "rotate;prepare_rotation", ""},
    {"transform", "rotate_about_z", "rotate_about_z", ""},
    {"transform", "rotation_derivative", "rotation_derivative", ""},
    {"transform", "window_factor", "hann_window;sinc_window", ""},
    {"transform", "apply_window", "apply_hann_window;apply_sinc_window", ""},
};
