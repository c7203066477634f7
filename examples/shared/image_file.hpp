#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "image.hpp"
#include "texture.hpp"

namespace example {

/// The bytes of a file: 8 bits per channel of display values.
std::string png_bytes(const Image& encoded);

/// The bytes of a file: linear radiance, 32-bit float, ZIP-compressed.
std::string exr_bytes(const Image& radiance);

/// The one or the other, by the path's extension.
std::string picture_bytes(const std::filesystem::path& path, const Image& radiance, const Display& display);

/// The most pixels that a picture may have which is read: 16384 x 16384, 3 GB as colours. Others are refused.
inline constexpr std::int64_t most_picture_pixels = std::int64_t{1} << 28;

/// Channels R, G and B; or Y, grey; or Y with RY and BY, luminance and chroma. Throws InputError.
Image read_exr(const std::filesystem::path& path, std::int64_t most_pixels = most_picture_pixels);

/// EXR by its extension; else what stb_image reads, PNG, JPEG and HDR among it. Linear radiance. Throws InputError.
Image read_picture(const std::filesystem::path& path, std::int64_t most_pixels = most_picture_pixels);

/// Does read_picture decode it from 8 bits of sRGB? Else it is linear as it stands.
bool is_encoded_for_display(const std::filesystem::path& path);

/// The same files as a texture: 8 bits stay 8 bits, grey stays one channel, alpha is left out, and what is no number is
/// 0. Throws InputError.
Texture read_texture(const std::filesystem::path& path, TextureUse use, std::int64_t most_pixels = most_picture_pixels);

}  // namespace example
