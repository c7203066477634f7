// Fills a grid of coefficients and gradients from sphere lights, one vertex and colour channel per invocation.
#version 450
layout(local_size_x = 16, local_size_y = 3) in;

layout(std430, binding = 0) readonly buffer Lights { float lights[]; };  // center, radius, colour
layout(std430, binding = 1) writeonly buffer Grid { float grid[]; };    // as CoefficientGrid::data()
uniform uint light_count;
uniform uint vertices_x, vertices_y, vertices_z;
uniform vec3 low;
uniform vec3 spacing;

#define ZONAL_LIGHT(i) lights[i]
#include "zonal_grid.glsl"

void main() {
  uint vertex = gl_GlobalInvocationID.x, channel = gl_GlobalInvocationID.y;
  if (vertex >= vertices_x * vertices_y * vertices_z) return;
  uvec3 place = uvec3(vertex % vertices_x, vertex / vertices_x % vertices_y, vertex / (vertices_x * vertices_y));
  precise vec3 position = low + vec3(place) * spacing;

  float value[BANDS * BANDS];
  vec3 gradient[BANDS * BANDS];
  SUM_LIGHTS(light_count, channel, position, value, gradient);

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
