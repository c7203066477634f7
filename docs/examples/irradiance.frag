#version 300 es
// A surface under distant light in 3 bands, nine colours, for every normal: a whole fragment shader of WebGL 2.
precision highp float;

// zonal 0.2.0, GLSL ES 3.00. --bands 3 --functions reconstruct_lambert_colour
// 1 function, 73 operations. Written by zonal-glsl: do not edit.

#ifndef ZONAL_RECONSTRUCT_LAMBERT_COLOUR_3
#define ZONAL_RECONSTRUCT_LAMBERT_COLOUR_3
// Radiance convolved with the clamped cosine: irradiance over pi at a normal. For colours.
// 73 operations: 27 additions, 46 multiplications, 0 divisions, 0 square roots, 0 comparisons and choices.
highp vec3 zonal_reconstruct_lambert_colour_3(in highp vec3 radiance[9], highp vec3 normal) {
  highp float t0 = 0.48860252f * normal.z;
  highp float t1 = -0.48860252f * normal.y;
  highp float t2 = -0.48860252f * normal.x;
  highp float t3 = (radiance[2].x * t0 + radiance[1].x * t1 + radiance[3].x * t2) * 0.6666667f;
  highp float t4 = 0.9461747f * (normal.z * normal.z) + -0.31539157f;
  highp float t5 = -1.0925485f * normal.z;
  highp float t6 = t5 * normal.y;
  highp float t7 = t5 * normal.x;
  highp float t8 = normal.y * normal.x;
  highp float t9 = 0.54627424f * (t8 + t8);
  highp float t10 = radiance[6].x * t4 + radiance[5].x * t6 + radiance[7].x * t7 + radiance[4].x * t9;
  highp float t11 = 0.54627424f * (normal.x * normal.x - normal.y * normal.y);
  highp float t12 = (radiance[2].y * t0 + radiance[1].y * t1 + radiance[3].y * t2) * 0.6666667f;
  highp float t13 = radiance[6].y * t4 + radiance[5].y * t6 + radiance[7].y * t7 + radiance[4].y * t9;
  highp float t14 = (radiance[2].z * t0 + radiance[1].z * t1 + radiance[3].z * t2) * 0.6666667f;
  highp float t15 = radiance[6].z * t4 + radiance[5].z * t6 + radiance[7].z * t7 + radiance[4].z * t9;
  highp vec3 value = vec3(radiance[0].x * 0.2820948f + t3 + (t10 + radiance[8].x * t11) * 0.25f,
      radiance[0].y * 0.2820948f + t12 + (t13 + radiance[8].y * t11) * 0.25f,
      radiance[0].z * 0.2820948f + t14 + (t15 + radiance[8].z * t11) * 0.25f);
  return value;
}
#endif

uniform vec3 radiance[9];  // as SH coefficients; see zonal/zonal.hpp for their order and signs
uniform vec3 albedo;
in vec3 normal;
out vec4 colour;

void main() {
  vec3 reflected = zonal_reconstruct_lambert_colour_3(radiance, normalize(normal));
  colour = vec4(albedo * max(reflected, vec3(0.0)), 1.0);
}
