// SPDX-License-Identifier: Apache-2.0
// What the writers and readers of the picture formats share; of no use outside this folder.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "output/image.h"
#include "output/indices.h"

namespace sundog::output {

static_assert(std::endian::native == std::endian::little, "Rgba8's bytes are R, G, B, A in memory");

using Bytes = std::span<const unsigned char>;

/// Why a file is no picture; read_image() and read_rgba8() add the file's name.
class DecodeError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A decoded picture; one of the three vectors holds the pixels.
struct Decoded {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint32_t> rgba8;   ///< As stored, 0xAABBGGRR.
    std::vector<std::uint16_t> rgba16;  ///< As stored, four numbers a pixel.
    std::vector<Vec3> linear;           ///< Linear RGB.
};

/// Throws DecodeError unless a picture of this size has pixels, at most a gigapixel of them, and fits 4 GiB at
/// `bytes_per_pixel`.
void check_size(std::uint64_t width, std::uint64_t height, std::size_t bytes_per_pixel);

/// Throws DecodeError if a file of `file_size` bytes can't hold so large a picture.
void check_plausible(std::uint64_t width, std::uint64_t height, std::size_t file_size,
                     std::uint64_t most_pixels_per_byte);

/// Makes `values` longer. Memory follows what has been decoded, in doublings up to `total`, so that a file that lies
/// about its size costs no more than its own bytes can fill.
template <typename T>
void grow(std::vector<T>& values, std::size_t size, std::size_t total) {
    if (values.capacity() < size) values.reserve(std::min(total, std::max(size, 2 * values.capacity())));
    values.resize(size);
}

/// Decodes a file of any format, told by its content. `bytes_per_pixel` is what the caller's own copy takes, for
/// check_size(). Errors: DecodeError, std::bad_alloc.
Decoded decode(Bytes bytes, std::size_t bytes_per_pixel);

// Each format's pair. Encoders get a picture that has pixels, and throw OutputError; decoders throw DecodeError.
std::string encode_png(const Image& image, const Encoding& encoding);
Decoded decode_png(Bytes bytes, std::size_t bytes_per_pixel);
/// The palette's numbers; nothing if there is no palette.
std::optional<IndexedImage> decode_png_indices(Bytes bytes);
IndexedImage decode_gif_indices(Bytes bytes);
bool png_tells_encoding(Bytes bytes);
std::string encode_jpeg(const Image& image, const Encoding& encoding);
Decoded decode_jpeg(Bytes bytes, std::size_t bytes_per_pixel);
std::string encode_exr(const Image& image, const std::vector<Layer>& layers);
Decoded decode_exr(Bytes bytes, std::size_t bytes_per_pixel);
std::string encode_radiance(const Image& image);
Decoded decode_radiance(Bytes bytes, std::size_t bytes_per_pixel);
std::string encode_ppm(const Image& image, const Encoding& encoding);
Decoded decode_pnm(Bytes bytes, std::size_t bytes_per_pixel);
std::string encode_tga(const Image& image, const Encoding& encoding);
std::string encode_bmp(const Image& image, const Encoding& encoding);
/// BMP, GIF and TGA.
Decoded decode_small_format(Bytes bytes, std::size_t bytes_per_pixel, std::uint64_t most_pixels_per_byte);
/// TGA has no magic number; true if the header makes sense.
bool looks_like_tga(Bytes bytes);

}  // namespace sundog::output
