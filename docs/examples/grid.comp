// Fills a grid of coefficients and gradients from sphere lights, one vertex and colour channel per invocation. OpenGL 4.5
// and Vulkan; the functions: zonal-glsl --functions sum_lights@5 -o zonal_grid.glsl
#version 450
#extension GL_GOOGLE_include_directive : enable
layout(local_size_x = 16, local_size_y = 3) in;

// Which loop, and its number of bands.
#ifndef SUM_LIGHTS
#define SUM_LIGHTS zonal_sum_lights_5
#define BANDS 5
#endif

layout(std430, binding = 0) readonly buffer Lights { float lights[]; };  // center, radius, colour
layout(std430, binding = 1) writeonly buffer Grid { float grid[]; };    // as CoefficientGrid::data()
layout(std140, binding = 2) uniform Sizes {
  uvec3 vertices;
  uint light_count;
  vec3 low;
  vec3 spacing;
};

#define ZONAL_LIGHT(i) lights[i]
#include "zonal_grid.glsl"

void main() {
  uint vertex = gl_GlobalInvocationID.x, channel = gl_GlobalInvocationID.y;
  if (vertex >= vertices.x * vertices.y * vertices.z) return;
  uvec3 place = uvec3(vertex % vertices.x, vertex / vertices.x % vertices.y, vertex / (vertices.x * vertices.y));
  precise vec3 position = low + vec3(place) * spacing;

  float value[BANDS * BANDS];
  vec3 gradient[BANDS * BANDS];
  float cell = max(spacing.x, max(spacing.y, spacing.z));
  SUM_LIGHTS(light_count, channel, position, cell, value, gradient);

  // Four blocks per vertex, value and the derivatives by x, y and z; coefficient by coefficient, RGB innermost.
  uint block = uint(3 * BANDS * BANDS), first = vertex * 4u * block + channel;
  for (uint i = 0u; i < uint(BANDS * BANDS); ++i) {
    uint at = first + 3u * i;
    grid[at] = value[i];
    grid[at + block] = gradient[i].x;
    grid[at + 2u * block] = gradient[i].y;
    grid[at + 3u * block] = gradient[i].z;
  }
}
