#pragma once

#include <filesystem>

#include "image.hpp"

namespace hvl_render {

/// 8 bits per channel of display values.
void write_png(const std::filesystem::path& path, const Image& encoded);

/// Linear radiance, 32-bit float, ZIP-compressed.
void write_exr(const std::filesystem::path& path, const Image& radiance);

/// Throws InputError when there is no readable RGB image of that size.
Image read_exr(const std::filesystem::path& path);

}  // namespace hvl_render
