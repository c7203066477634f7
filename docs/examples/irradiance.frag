#version 300 es
// A surface under distant light in 3 bands: nine coefficients per colour channel, for every normal.
precision highp float;

#include "zonal_irradiance.glsl"

uniform float radiance_r[9], radiance_g[9], radiance_b[9];
uniform vec3 albedo;
in vec3 normal;
out vec4 colour;

void main() {
  vec3 n = normalize(normal);
  vec3 reflected = vec3(zonal_reconstruct_lambert_3(radiance_r, n), zonal_reconstruct_lambert_3(radiance_g, n),
                        zonal_reconstruct_lambert_3(radiance_b, n));
  colour = vec4(albedo * max(reflected, vec3(0.0)), 1.0);
}
