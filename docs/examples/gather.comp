// The gather of virtual lights, one receiver per invocation: the indirect light of Harmonics Virtual Lights. OpenGL 4.5
// and Vulkan; the functions: zonal-glsl --functions gather@5,material_with_cosine@5,tangent_towards -o zonal_gather.glsl
#version 450
#extension GL_GOOGLE_include_directive : enable
layout(local_size_x = 64) in;

// Which loop, its number of bands, and the material of as many.
#ifndef GATHER
#define GATHER zonal_gather_5
#define MATERIAL zonal_material_with_cosine_5
#define BANDS 5
#endif

// The first two as zonal::shader_buffer gives them (zonal/shader/buffers.hpp), several materials one after the other.
layout(std430, binding = 0) readonly buffer Lights { float lights[]; };
layout(std430, binding = 1) readonly buffer Materials { float materials[]; };
// Ten floats each: position, normal, direction to the eye, and where in `materials` its material begins.
layout(std430, binding = 2) readonly buffer Receivers { float receivers[]; };
layout(std430, binding = 3) writeonly buffer Image { float radiance[]; };
layout(std140, binding = 4) uniform Sizes {
  uint light_count;
  uint receiver_count;
};

#define ZONAL_LIGHT(i) lights[i]
#define ZONAL_MATERIAL(i) materials[i]
#include "zonal_gather.glsl"

vec3 receiver_vector(uint at) { return vec3(receivers[at], receivers[at + 1u], receivers[at + 2u]); }

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= receiver_count) return;
  vec3 normal = receiver_vector(10u * i + 3u), outgoing = receiver_vector(10u * i + 6u);
  // dot() in the order of C++, so that the tests can compare to the bit.
  precise float cos_outgoing = normal.x * outgoing.x + normal.y * outgoing.y + normal.z * outgoing.z;
  vec3 f[BANDS * (BANDS + 1) / 2];
  MATERIAL(uint(receivers[10u * i + 9u]), cos_outgoing, f);
  vec3 sum = GATHER(light_count, receiver_vector(10u * i), normal, zonal_tangent_towards(normal, outgoing), f);
  radiance[3u * i] = sum.r;
  radiance[3u * i + 1u] = sum.g;
  radiance[3u * i + 2u] = sum.b;
}
