#include "picture.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

#include <zonal/convention/named.hpp>
#include <zonal/environment/guess.hpp>
#include <zonal/environment/project.hpp>

#include "mapping_words.hpp"
#include "shared/image_file.hpp"
#include "shared/input_error.hpp"

namespace zonal_probe {
namespace {

using example::InputError;

zonal::Mapping mapping_of(const zonal::Picture<const float>& picture, const std::string& path,
                          const std::string& word) {
  for (int i = 0; i < zonal::kMappingCount; ++i) {
    const auto mapping = static_cast<zonal::Mapping>(i);
    if (mapping_word(mapping) != word) continue;
    const std::string wrong = zonal::Environment<float>::what_is_wrong(picture, mapping);
    if (!wrong.empty()) throw InputError(path + ": " + wrong);
    return mapping;
  }
  zonal::Mapping guess{};
  if (zonal::guess_mapping(picture, guess)) return guess;
  throw InputError(path + ": a picture of " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                   ": no mapping has this shape as a rule; name one by --mapping");
}

}  // namespace

zonal::Frame frame_of(zonal::Mapping mapping) {
  const bool is_of_interface = mapping == zonal::Mapping::vertical_faces || mapping == zonal::Mapping::horizontal_faces;
  return is_of_interface ? zonal::frames::unity : zonal::frames::zonal_picture;
}

SkyPicture read_sky(const std::string& path, const std::string& mapping) {
  SkyPicture sky;
  sky.image = example::read_picture(path);
  sky.is_decoded = example::is_encoded_for_display(path);
  sky.mapping = mapping_of(sky.view(), path, mapping);
  return sky;
}

Light project_sky(const SkyPicture& sky, int bands, Workers& workers, zonal::PictureFaults& faults) {
  Light light;
  const zonal::Environment<float> environment(sky.view(), sky.mapping);
  // Of all bands, whatever is asked for: one function for the compiler, and little more time.
  light.sh = zonal::project<max_bands, Colour>(environment, workers.loop("project", 1), &faults);
  keep_bands(light, bands);
  return light;
}

example::Image resample_sky(const SkyPicture& sky, const double (&axes)[3][3], int width, int height,
                            Workers& workers) {
  const zonal::Environment<float> environment(sky.view(), sky.mapping);
  example::Image result(width, height);
  // Enough samples that none of a picture's texels is left out, up to a limit: it is there to be looked at.
  const int across = std::clamp(sky.image.width / width, 2, 8), down = std::clamp(sky.image.height / height, 2, 8);
  const zonal::Equirectangular target(width, height);
  environment.visit([&](const auto& mapping) {
    workers.loop("preview", 0.3)(height, [&](int row) {
      for (int column = 0; column < width; ++column) {
        zonal::PictureFaults ignored;
        glm::dvec3 sum(0.0);
        for (int k = 0; k < across * down; ++k) {
          const auto d = target.direction(column + (k % across + 0.5) / across, row + (k / across + 0.5) / down);
          std::array<double, 3> to{};
          for (std::size_t i = 0; i < 3; ++i) to[i] = d[0] * axes[0][i] + d[1] * axes[1][i] + d[2] * axes[2][i];
          const auto at = mapping.texel(to);
          const int i = std::clamp(static_cast<int>(at[0]), 0, sky.image.width - 1);
          const int j = std::clamp(static_cast<int>(at[1]), 0, sky.image.height - 1);
          const auto c = environment.radiance(i, j, ignored);
          sum += glm::dvec3(c.r, c.g, c.b);
        }
        result.at(column, row) = glm::vec3(sum / double(across * down));
      }
    });
  });
  return result;
}

}  // namespace zonal_probe
