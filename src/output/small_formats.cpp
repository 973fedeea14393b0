// SPDX-License-Identifier: Apache-2.0
// BMP, GIF (first frame) and TGA through stb_image, which believes what a file says; so its size is checked first,
// and reading past the file's end is noticed here.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_BMP
#define STBI_ONLY_GIF
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

#include <algorithm>
#include <cstring>
#include <memory>

#include "output/codec.h"

namespace sundog::output {
namespace {

/// A source for stb_image that remembers whether more was wanted than there is.
struct Source {
    Bytes left;
    bool cut_off = false;
};

// stb_image fills a buffer of this many bytes at a time; it may be filled partly at the end of a whole file.
constexpr int kBufferSize = 128;

int read_source(void* user, char* data, int size) {
    auto* source = static_cast<Source*>(user);
    const std::size_t count = std::min(static_cast<std::size_t>(std::max(size, 0)), source->left.size());
    if (count == 0 || (count < static_cast<std::size_t>(size) && size != kBufferSize)) source->cut_off = true;
    if (count > 0) std::memcpy(data, source->left.data(), count);
    source->left = source->left.subspan(count);
    return static_cast<int>(count);
}

void skip_source(void* user, int count) {
    auto* source = static_cast<Source*>(user);
    if (count <= 0) return;
    const std::size_t skipped = std::min(static_cast<std::size_t>(count), source->left.size());
    if (skipped < static_cast<std::size_t>(count)) source->cut_off = true;
    source->left = source->left.subspan(skipped);
}

int at_end(void* user) { return static_cast<Source*>(user)->left.empty() ? 1 : 0; }

constexpr stbi_io_callbacks kCallbacks{read_source, skip_source, at_end};

struct FreePixels {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

}  // namespace

bool looks_like_tga(Bytes bytes) {
    constexpr std::size_t kHeaderSize = 18;
    if (bytes.size() < kHeaderSize) return false;
    const int map = bytes[1];
    const int type = bytes[2] & ~8;  // With or without runs.
    const int depth = bytes[16];
    const bool depth_known = depth == 8 || depth == 15 || depth == 16 || depth == 24 || depth == 32;
    return map <= 1 && bytes[2] <= 11 && type >= 1 && type <= 3 && (type == 1) == (map == 1) && depth_known;
}

Decoded decode_small_format(Bytes bytes, std::size_t bytes_per_pixel, std::uint64_t most_pixels_per_byte) {
    int width = 0, height = 0, channels = 0;
    const auto fail = [] {
        const char* why = stbi_failure_reason();
        throw DecodeError(std::string("damaged or unsupported picture: ") + (why != nullptr ? why : "no reason given"));
    };
    Source header{bytes};
    if (stbi_info_from_callbacks(&kCallbacks, &header, &width, &height, &channels) == 0) fail();
    if (width < 0 || height < 0) throw DecodeError("damaged picture: its size is negative");
    // stb_image's own copies for GIF take 9 bytes a pixel.
    constexpr std::size_t kMostBytesPerPixel = 9;
    check_size(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height),
               std::max(bytes_per_pixel, kMostBytesPerPixel));
    check_plausible(static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height), bytes.size(),
                    most_pixels_per_byte);
    Source source{bytes};
    const std::unique_ptr<stbi_uc, FreePixels> pixels(
        stbi_load_from_callbacks(&kCallbacks, &source, &width, &height, &channels, STBI_rgb_alpha));
    if (!pixels) fail();
    if (source.cut_off) throw DecodeError("damaged picture: the file is cut off");
    Decoded decoded;
    decoded.width = static_cast<std::uint32_t>(width);
    decoded.height = static_cast<std::uint32_t>(height);
    decoded.rgba8.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::memcpy(decoded.rgba8.data(), pixels.get(), decoded.rgba8.size() * sizeof(std::uint32_t));
    return decoded;
}

}  // namespace sundog::output
