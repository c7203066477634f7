// The gather of virtual lights, one receiver per invocation: the indirect light of Harmonics Virtual Lights. OpenGL 4.5
// and Vulkan; the functions: zonal-glsl --functions gather@5 -o zonal_gather.glsl
#version 450
#extension GL_GOOGLE_include_directive : enable
layout(local_size_x = 64) in;

// Which loop, and its number of bands.
#ifndef GATHER
#define GATHER zonal_gather_5
#define BANDS 5
#endif

layout(std430, binding = 0) readonly buffer Lights { float lights[]; };        // 22 floats each: HvlRecord<3, float>
layout(std430, binding = 1) readonly buffer Receivers { float receiver[]; };  // position, normal, tangent
layout(std430, binding = 2) readonly buffer Material { float material[]; };   // F of m >= 0, RGB, one row per receiver
layout(std430, binding = 3) writeonly buffer Image { float radiance[]; };
layout(std140, binding = 4) uniform Sizes {
  uint light_count;
  uint receiver_count;
};

#define ZONAL_LIGHT(i) lights[i]
#include "zonal_gather.glsl"

const int coefficients = BANDS * (BANDS + 1) / 2;

vec3 receiver_vector(uint at) { return vec3(receiver[at], receiver[at + 1u], receiver[at + 2u]); }

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= receiver_count) return;
  vec3 f[coefficients];
  for (int k = 0; k < coefficients; ++k) {
    uint at = 3u * (i * uint(coefficients) + uint(k));
    f[k] = vec3(material[at], material[at + 1u], material[at + 2u]);
  }
  vec3 sum = GATHER(light_count, receiver_vector(9u * i), receiver_vector(9u * i + 3u), receiver_vector(9u * i + 6u), f);
  radiance[3u * i] = sum.r;
  radiance[3u * i + 1u] = sum.g;
  radiance[3u * i + 2u] = sum.b;
}
