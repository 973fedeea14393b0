// SPDX-License-Identifier: Apache-2.0
// Pictures in memory and on disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec.h"

namespace sundog::output {

/// Linear RGB floats, row 0 at the top.
struct Image {
    int width = 0, height = 0;
    std::vector<Vec3> pixels;
    Image() = default;
    Image(int width_, int height_)
        : width(width_), height(height_),
          pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}
    [[nodiscard]] Vec3& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)]; }
    [[nodiscard]] const Vec3& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)]; }
};

/// A further plane of an EXR file: channels "name.R" and so on, or "name" for a single one.
struct Layer {
    std::string name;                    ///< "depth", "normal", "albedo", "object", "samples", "cost"
    std::vector<std::string> channels;   ///< {"Z"}, {"X","Y","Z"}, {"R","G","B"}, {"id"}
    std::vector<float> values;           ///< Interleaved, width*height*channels.size().
};

enum class Format { png, jpg, exr, hdr, ppm };

/// By the file's ending (any case). Errors: OutputError naming the endings there are.
Format format_of(const std::filesystem::path& file);

/// 8-bit sRGB of linear RGB (IEC 61966-2-1), clamped, rounded, 3 bytes a pixel; NaN becomes black.
std::vector<std::uint8_t> to_srgb8(const Image& image);

/// The file's bytes. Layers are only kept by EXR.
std::string encode(const Image& image, Format format, const std::vector<Layer>& layers = {});

/// Writes a picture beside its place and renames it, so that the file is whole or untouched; "-" is standard output
/// (PNG unless format says otherwise). Errors: OutputError.
void write_image(const std::filesystem::path& file, const Image& image, const std::vector<Layer>& layers = {});

/// Reads .png .jpg .exr .hdr .ppm into linear RGB (8-bit formats are decoded as sRGB). Errors: InputError.
Image read_image(const std::filesystem::path& file);

/// 8-bit RGBA of a texture file of any format we read, as stored (not linearised): 0xAABBGGRR. Errors: InputError.
struct Rgba8 {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint32_t> pixels;
};
Rgba8 read_rgba8(const std::filesystem::path& file);

/// Writes `bytes` to a new file beside `file`, then renames it over `file`. Errors: OutputError; `file` stays as it was.
void write_file_atomically(const std::filesystem::path& file, std::string_view bytes);

}  // namespace sundog::output
