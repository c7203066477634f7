#pragma once

#include <string>
#include <vector>

#include <zonal/convention/axes.hpp>
#include <zonal/environment/mapping.hpp>
#include <zonal/environment/picture.hpp>

#include "light.hpp"
#include "shared/image.hpp"
#include "workers.hpp"

namespace zonal_probe {

/// A picture of all directions.
struct SkyPicture {
  example::Image image;
  zonal::Mapping mapping{};
  bool is_decoded = false;  // from 8 bits of sRGB; else it was linear

  zonal::Picture<const float> view() const { return {&image.pixels.front().x, image.width, image.height}; }
};

/// `mapping`: one of mapping_words(). Throws InputError.
SkyPicture read_sky(const std::string& path, const std::string& mapping);

/// Which way a mapping's x, y and z go: the library's frame of pictures, but Direct3D's for faces of cubes in a row.
zonal::Frame frame_of(zonal::Mapping mapping);

/// Radiance; directions are the mapping's own, as frame_of says.
Light project_sky(const SkyPicture& sky, int bands, Workers& workers, zonal::PictureFaults& faults);

/// The picture as an equirectangular one, row 0 up and its middle ahead. axes: where the viewer's ahead, left and up
/// are in the mapping's directions.
example::Image resample_sky(const SkyPicture& sky, const double (&axes)[3][3], int width, int height, Workers& workers);

}  // namespace zonal_probe
