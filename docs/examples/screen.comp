// Light of interleaved sets, averaged over each surface and shaded, one pixel per invocation, in two passes: PASS 1 along
// rows; PASS 2 along columns, and then what the surface makes of it. OpenGL 4.5 and Vulkan; the functions
// come from: zonal-glsl --bands 3 --functions filter_across,filter_down,reconstruct_lambert_colour,phong,reconstruct_convolved_colour -o zonal_screen.glsl
#version 450
#extension GL_GOOGLE_include_directive : enable
layout(local_size_x = 64) in;

#ifndef PASS
#define PASS 2
#endif
// The number of bands, and functions of as many.
#ifndef BANDS
#define BANDS 3
#define FILTER_ACROSS zonal_filter_across_3
#define FILTER_DOWN zonal_filter_down_3
#define LAMBERT zonal_reconstruct_lambert_colour_3
#define PHONG zonal_phong_3
#define CONVOLVED zonal_reconstruct_convolved_colour_3
#endif

// As zonal::shader_buffer gives them (zonal/shader/buffers.hpp): SurfacePicture, RadiancePicture<BANDS>. Of PASS 2 the
// second is what PASS 1 wrote.
layout(std430, binding = 0) readonly buffer Surfaces { float surfaces[]; };
layout(std430, binding = 1) readonly buffer Pixels { float pixels[]; };
// Thirteen floats each: shading normal, direction to the eye, albedo and gloss, RGB, and Phong's exponent.
layout(std430, binding = 2) readonly buffer Shading { float shading[]; };
layout(std430, binding = 3) writeonly buffer Image { float image[]; };
layout(std140, binding = 4) uniform Sizes {
  uint width;
  uint height;
  uint pitch;
  uint columns;
  uint rows;
  float cos_normal;
  float plane_distance;
};

#define ZONAL_SURFACE(i) surfaces[i]
#define ZONAL_PIXEL(i) pixels[i]
#include "zonal_screen.glsl"

vec3 shading_vector(uint at) { return vec3(shading[at], shading[at + 1u], shading[at + 2u]); }

void main() {
  uint i = gl_GlobalInvocationID.x, x = i % width, y = i / width;
  if (i >= width * height) return;
  vec3 radiance[BANDS * BANDS];
#if PASS == 1
  FILTER_ACROSS(x, y, width, height, pitch, columns, cos_normal, plane_distance, radiance);
  uint first = y * uint(3 * BANDS * BANDS) * pitch + x;
  for (uint k = 0u; k < uint(BANDS * BANDS); ++k) {
    uint at = first + 3u * k * pitch;
    image[at] = radiance[k].r;
    image[at + pitch] = radiance[k].g;
    image[at + 2u * pitch] = radiance[k].b;
  }
#else
  FILTER_DOWN(x, y, width, height, pitch, rows, cos_normal, plane_distance, radiance);
  vec3 normal = shading_vector(13u * i), outgoing = shading_vector(13u * i + 3u);
  float lobe[BANDS];
  PHONG(shading[13u * i + 12u], lobe);
  // dot() in the order of C++, so that the tests can compare to the bit.
  precise float cos_outgoing = normal.x * outgoing.x + normal.y * outgoing.y + normal.z * outgoing.z;
  precise vec3 mirror = 2.0 * cos_outgoing * normal - outgoing;
  precise vec3 reflected = shading_vector(13u * i + 6u) * max(LAMBERT(radiance, normal), vec3(0.0)) +
                           shading_vector(13u * i + 9u) * max(CONVOLVED(radiance, lobe, mirror), vec3(0.0));
  image[3u * i] = reflected.r;
  image[3u * i + 1u] = reflected.g;
  image[3u * i + 2u] = reflected.b;
#endif
}
