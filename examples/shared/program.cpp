#include "program.hpp"

#include <algorithm>

#include <tbb/info.h>

namespace example {

void print_warnings(const char* program, const Scene& scene) {
  for (const std::string& warning : scene.warnings) warn(program, warning);
}

std::size_t repair(const char* program, const std::vector<Image*>& pictures) {
  std::size_t count = 0;
  for (Image* picture : pictures) count += blacken_non_finite(*picture);
  if (count > 0) warn(program, std::to_string(count) + " pixels are not finite; they are written black");
  return count;
}

bool warn_if_black(const char* program, const Image& picture, std::size_t primary_hits) {
  const bool black = std::all_of(picture.pixels.begin(), picture.pixels.end(),
                                 [](const glm::vec3& pixel) { return pixel == glm::vec3(0.0f); });
  if (black) {
    warn(program, primary_hits == 0 ? "nothing is in view, and the picture black"
                                    : "nothing in view is lit, and the picture black");
  }
  return black;
}

ThreadLimit::ThreadLimit(int threads)
    : machine_{tbb::info::default_concurrency(), threads > 0 ? threads : tbb::info::default_concurrency()},
      control_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(machine_.threads)) {}

}  // namespace example
