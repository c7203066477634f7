#!/usr/bin/env bash
# Writes shaders/, for those who build no C++, when a kernel changes: scripts/write_shaders.sh <zonal-glsl> [<folder>]
set -eu
program="$(realpath "$1")"
folder="${2:-$(dirname "$0")/../shaders}"
mkdir -p "$folder"

functions=""
for name in evaluate evaluate_with_gradient reconstruct reconstruct_colour reconstruct_lambert \
  reconstruct_lambert_colour orient orient_colour dot dot_colour dot_colours convolve convolve_colour lambert \
  cap cap_up_to_hemisphere sphere_cap phong spherical_gaussian project_sphere; do
  for bands in 2 3 4 5; do functions="$functions,$name@$bands"; done
done
for name in reconstruct_with_adjoint splat_colour splat_with_adjoint; do
  for bands in 3 4; do functions="$functions,$name@$bands"; done
done
for name in rotate_about_z prepare_rotation rotate rotate_colour product product_colour triple_product; do  # they grow fast
  for bands in 2 3; do functions="$functions,$name@$bands"; done
done

functions="$functions,reconstruct_seven_vectors,reconstruct_nine_polynomials_colour,reconstruct_polynomials_colour"
functions="$functions,linear_axis,hallucinate_zh3,hallucinate_zh3_colour,irradiance_zh3,irradiance_zh3_colour"
functions="$functions,irradiance_nonlinear,irradiance_nonlinear_colour,irradiance_six_floats"
functions="$functions,irradiance_six_floats_nonlinear,irradiance_bytes@2,irradiance_bytes@3"

write() { "$program" --functions "${functions#,}" --dialect "$1" -o "$folder/$2"; }
write glsl450 zonal.glsl
write glsles300 zonal_es.glsl
write hlsl zonal.hlsl
write wgsl zonal.wgsl
write cpp zonal_functions.hpp
