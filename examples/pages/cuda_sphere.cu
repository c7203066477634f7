// The headers in a CUDA kernel: each thread sums up what a sphere lamp sends to a place on the floor, and what a white
// matt surface makes of it; then the processor does the same. Standard library alone:
//
//   nvcc -std=c++17 --expt-relaxed-constexpr -Iinclude examples/pages/cuda_sphere.cu -o cuda_sphere
#include <zonal/zonal.hpp>

#include <cmath>
#include <cstdio>
#include <vector>

struct Vec3 {  // or float3: anything with .x, .y, .z, or with [0], [1], [2]
  float x, y, z;
};

// E / pi from five bands, i centimetres along the floor from below a lamp that hangs 2 m above it, of radius 0.5 m and
// radiance 1. One text for both.
__host__ __device__ float e_over_pi(int i) {
  const float x = 0.01F * float(i), distance = sqrtf(x * x + 4);
  const Vec3 to_lamp{-x / distance, 0, 2 / distance};
  const auto cap = zonal::SphericalCap<float>::from_sphere(distance, 0.5F);
  const zonal::Sh<5, float> radiance = zonal::orient(zonal::project<5>(cap), to_lamp);
  return zonal::reconstruct_convolved(radiance, zonal::LambertLobe{}, Vec3{0, 0, 1});
}

__global__ void light_floor(float* result, int count) {
  const int i = int(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < count) result[i] = e_over_pi(i);
}

int main() {
  const int count = 500;
  float* on_device = nullptr;
  if (cudaMalloc(&on_device, count * sizeof(float)) != cudaSuccess) {
    std::printf("no CUDA device\n");
    return 77;
  }
  light_floor<<<(count + 63) / 64, 64>>>(on_device, count);
  std::vector<float> found(count);
  if (cudaMemcpy(found.data(), on_device, count * sizeof(float), cudaMemcpyDeviceToHost) != cudaSuccess) return 1;

  float greatest = 0;
  for (int i = 0; i < count; ++i) greatest = std::fmax(greatest, std::fabs(found[i] - e_over_pi(i)));
  std::printf("below the lamp %.4f, 2 m beside %.4f; %d places within 1e-6 of the processor's: %s\n", double(found[0]),
              double(found[200]), count, greatest < 1e-6F ? "yes" : "no");
}

// It prints:
//   below the lamp 0.0610, 2 m beside 0.0224; 500 places within 1e-6 of the processor's: yes
