// SPDX-License-Identifier: Apache-2.0
// Pictures in memory and on disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec.h"

namespace sundog::output {

/// Linear RGB floats, row 0 at the top.
struct Image {
    int width = 0, height = 0;
    std::vector<Vec3> pixels;
    std::vector<float> alpha;  ///< Opacity of each pixel, 0 to 1, not multiplied into the colours; empty: opaque.
    Image() = default;
    Image(int width_, int height_)
        : width(width_),
          height(height_),
          pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}
    [[nodiscard]] Vec3& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    [[nodiscard]] const Vec3& at(int x, int y) const {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

/// A further plane of an EXR file, in channels "name.channel" (just "name" where the channel's name is empty).
/// Channels called "id" are written as 32-bit unsigned integers (negative and NaN become 0), others as 32-bit floats.
struct Layer {
    std::string name;                   ///< "depth", "normal", "albedo", "object", "samples", "cost"
    std::vector<std::string> channels;  ///< {"Z"}, {"X","Y","Z"}, {"R","G","B"}, {"id"}
    std::vector<float> values;          ///< Interleaved, width*height*channels.size().
};

enum class Format { png, jpg, exr, hdr, ppm, tga, bmp };

/// How a file holds colours, where its format leaves a choice.
struct Encoding {
    int bits = 8;                 ///< PNG, PPM: of each channel, 1 to 16.
    std::optional<double> gamma;  ///< Of a power law, which a PNG says in its header; nothing: sRGB. Not EXR and HDR.
    bool grayscale = false;       ///< Luminance alone; PNG, JPEG, PPM, Targa, BMP.
    bool run_length = false;      ///< Targa: compressed.
    int jpeg_quality = 95;        ///< 1 to 100
};

/// By the file's ending (any case). Errors: OutputError naming the endings there are.
Format format_of(const std::filesystem::path& file);

/// 8-bit sRGB of linear RGB (IEC 61966-2-1), clamped, rounded, 3 bytes a pixel; NaN becomes black.
std::vector<std::uint8_t> to_srgb8(const Image& image);

/// The file's bytes. PNG, JPEG (without chroma subsampling), PPM, Targa and BMP hold what `encoding` says, Radiance HDR
/// and EXR (32-bit float) linear RGB. Alpha is kept by PNG, Targa and BMP, straight, and by EXR, with the colours
/// multiplied by it; layers by EXR alone.
/// Errors: OutputError (a picture without pixels, or too large for the format, or a layer of another size).
std::string encode(const Image& image, Format format, const std::vector<Layer>& layers = {},
                   const Encoding& encoding = {});

/// Writes a picture beside its place and renames it, so that the file is whole or untouched. "-" is standard output;
/// it and special files (devices, pipes) are written to directly, as PNG where their name has no known ending.
/// Errors: OutputError naming the file and the reason.
void write_image(const std::filesystem::path& file, const Image& image, const std::vector<Layer>& layers = {});

/// Reads a PNG, JPEG, EXR, Radiance HDR, PBM-family (P2 P3 P5 P6), BMP, GIF (first frame) or TGA file into linear RGB;
/// integer formats are decoded as sRGB, alpha is dropped. The format is told by content, not by the file's ending.
/// Errors: InputError, also for files that are no regular file, damaged or cut off, have more than a gigapixel, or
/// would take over 4 GiB decoded.
Image read_image(const std::filesystem::path& file);

/// 8-bit RGBA pixels, each 0xAABBGGRR, row 0 at the top.
struct Rgba8 {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint32_t> pixels;
};
/// Reads a texture of any format that read_image reads, as stored (not linearised; EXR and HDR are encoded as sRGB).
/// Errors: as read_image.
Rgba8 read_rgba8(const std::filesystem::path& file);
/// The same of a file's bytes, which messages call `name`.
Rgba8 decode_rgba8(std::span<const unsigned char> bytes, const std::string& name);

/// Whether a PNG file says how its numbers are encoded, in a gAMA or sRGB chunk; false for other files.
/// Errors: InputError for one that can't be read or is damaged.
bool tells_encoding(const std::filesystem::path& file);

/// Writes `bytes` to a new file beside `file`, then renames it over `file` (over what it points to, if it is a symbolic
/// link). Special files are written to directly. Errors: OutputError; a regular `file` then stays as it was.
void write_file_atomically(const std::filesystem::path& file, std::string_view bytes);

}  // namespace sundog::output
