#include "lighting_bands.hpp"

namespace example::grid_render {

extern template class LightingOf<3>;
extern template class LightingOf<5>;
extern template class LightingOf<7>;
extern template class LightingOf<9>;

namespace {

using Make = std::unique_ptr<Lighting> (*)(const SphereLights&);
template <int N>
std::unique_ptr<Lighting> make(const SphereLights& lights) {
  return std::make_unique<LightingOf<N>>(lights);
}
constexpr std::array<std::pair<int, Make>, 4> makers{{{3, make<3>}, {5, make<5>}, {7, make<7>}, {9, make<9>}}};

}  // namespace

std::unique_ptr<Lighting> make_lighting(const SphereLights& lights, int bands) {
  const auto found =
      std::find_if(makers.begin(), makers.end(), [&](const auto& entry) { return entry.first == bands; });
  return found->second(lights);
}

std::vector<int> lighting_bands() {
  std::vector<int> bands;
  for (const auto& [number, make] : makers) bands.push_back(number);
  return bands;
}

std::size_t grid_bytes(int bands, const glm::ivec3& resolution, GridContent content) {
  const int blocks = content == GridContent::values ? 1 : 4;
  return sizeof(float) * static_cast<std::size_t>(blocks * 3 * bands * bands) *
         static_cast<std::size_t>(resolution.x * resolution.y * resolution.z);
}

}  // namespace example::grid_render
