#pragma once

#include <filesystem>
#include <string>

#include "image.hpp"

namespace hvl_render {

/// The bytes of a file: 8 bits per channel of display values.
std::string png_bytes(const Image& encoded);

/// The bytes of a file: linear radiance, 32-bit float, ZIP-compressed.
std::string exr_bytes(const Image& radiance);

/// Throws InputError unless an RGB image can be read.
Image read_exr(const std::filesystem::path& path);

}  // namespace hvl_render
