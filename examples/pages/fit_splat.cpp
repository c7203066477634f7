// A splat's colour and place, found by gradient descent from how it looks to many cameras. Needs GLM:
//
//   g++ -std=c++17 -O2 -Iinclude examples/pages/fit_splat.cpp -o fit_splat
#include <zonal/transform/reconstruct_adjoint.hpp>

#include <glm/glm.hpp>

#include <cmath>
#include <cstdio>

using Colours = zonal::Sh<3, glm::vec3>;
constexpr auto splat =
    zonal::ColourRule::splat;  // of the sum half more, and at least 0, as 3D Gaussian splatting has it

// Cameras all around, at a distance of 2.
constexpr int cameras = 256;
glm::vec3 camera(int i) {
  const float z = 1 - (2 * float(i) + 1) / cameras, phi = 2.3999632F * float(i), r = std::sqrt(1 - z * z);
  return 2.0F * glm::vec3(r * std::cos(phi), r * std::sin(phi), z);
}

int main() {
  Colours truth{};
  truth(0, 0) = {1.0F, 0.4F, 0.2F};
  truth(1, 0) = {0.3F, 0.1F, -0.2F};
  truth(1, 1) = {-0.2F, 0.4F, 0.1F};
  truth(2, -1) = {0.1F, 0.3F, 0.5F};
  const glm::vec3 place(0.3F, -0.2F, 0.1F);

  Colours sh{};
  glm::vec3 position(0);
  for (int step = 0; step <= 400; ++step) {
    float loss = 0;  // half the mean square of the errors
    Colours by_sh{};
    glm::vec3 by_position(0);
    for (int i = 0; i < cameras; ++i) {
      const glm::vec3 seen = zonal::reconstruct_along<splat>(truth, place - camera(i));
      const glm::vec3 error = zonal::reconstruct_along<splat>(sh, position - camera(i)) - seen;
      const auto adjoint = zonal::reconstruct_with_adjoint<splat>(sh, position - camera(i), error / float(cameras));
      loss += glm::dot(error, error) / (2 * cameras);
      by_sh += adjoint.by_sh;
      for (int k = 0; k < 3; ++k) by_position[k] += adjoint.by_direction[k];
    }
    if (step % 100 == 0) {
      std::printf("step %3d: loss %.6f, red %.3f %.3f, at %.3f %.3f %.3f\n", step, double(loss), double(sh(0, 0).r),
                  double(sh(1, 0).r), double(position.x), double(position.y), double(position.z));
    }
    sh -= by_sh * 4.0F;
    position -= by_position * 4.0F;
  }
}

// It prints:
//   step   0: loss 0.077048, red 0.000 0.000, at 0.000 0.000 0.000
//   step 100: loss 0.000012, red 1.010 0.302, at 0.229 -0.175 0.095
//   step 200: loss 0.000001, red 1.002 0.300, at 0.284 -0.197 0.099
//   step 300: loss 0.000000, red 1.001 0.300, at 0.296 -0.200 0.100
//   step 400: loss 0.000000, red 1.000 0.300, at 0.299 -0.200 0.100
