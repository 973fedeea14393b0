// SPDX-License-Identifier: Apache-2.0
// The palette's numbers of a GIF, by giflib. Its colours are read with the other small formats (small_formats.cpp).
#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <string>

#include "output/codec.h"

namespace sundog::output {
namespace {

/// No code of Lempel, Ziv and Welch's stands for more pixels, and each takes more than a byte once they are so long.
constexpr std::uint64_t kMostPixelsPerByte = 4096;

struct Closer {
    void operator()(GifFileType* gif) const {
        int ignored = 0;
        DGifCloseFile(gif, &ignored);
    }
};

int take_bytes(GifFileType* gif, GifByteType* to, int size) {
    auto& left = *static_cast<Bytes*>(gif->UserData);
    const std::size_t count = std::min(static_cast<std::size_t>(size), left.size());
    std::memcpy(to, left.data(), count);
    left = left.subspan(count);
    return static_cast<int>(count);
}

void require(bool done, int error) {
    if (done) return;
    const char* const text = GifErrorString(error);
    throw DecodeError(std::string("damaged GIF: ") + (text != nullptr ? text : "unknown error"));
}

void skip_extension(GifFileType* gif) {
    int code = 0;
    GifByteType* block = nullptr;
    require(DGifGetExtension(gif, &code, &block) == GIF_OK, gif->Error);
    while (block != nullptr) require(DGifGetExtensionNext(gif, &block) == GIF_OK, gif->Error);
}

/// Rows in the order of the picture, of rows in the order of an interlaced file.
std::vector<std::uint8_t> deinterlaced(const IndexedImage& image) {
    constexpr std::array<std::array<std::uint32_t, 2>, 4> kPasses{{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
    std::vector<std::uint8_t> out(image.indices.size());
    const std::uint8_t* from = image.indices.data();
    for (const auto& [first, step] : kPasses)
        for (std::uint32_t row = first; row < image.height; row += step, from += image.width)
            std::copy_n(from, image.width, out.data() + std::size_t{row} * image.width);
    return out;
}

IndexedImage read_picture(GifFileType* gif, std::size_t file_size) {
    require(DGifGetImageDesc(gif) == GIF_OK, gif->Error);
    IndexedImage image;
    image.width = static_cast<std::uint32_t>(std::max(gif->Image.Width, 0));
    image.height = static_cast<std::uint32_t>(std::max(gif->Image.Height, 0));
    check_size(image.width, image.height, 1);
    check_plausible(image.width, image.height, file_size, kMostPixelsPerByte);
    const std::size_t total = std::size_t{image.width} * image.height;
    for (std::size_t at = 0; at < total; at += image.width) {
        grow(image.indices, at + image.width, total);
        require(DGifGetLine(gif, image.indices.data() + at, gif->Image.Width) == GIF_OK, gif->Error);
    }
    if (gif->Image.Interlace) image.indices = deinterlaced(image);
    return image;
}

}  // namespace

IndexedImage decode_gif_indices(Bytes bytes) {
    Bytes left = bytes;
    int error = 0;
    const std::unique_ptr<GifFileType, Closer> gif(DGifOpen(&left, take_bytes, &error));
    require(gif != nullptr, error);
    while (true) {
        GifRecordType kind = UNDEFINED_RECORD_TYPE;
        require(DGifGetRecordType(gif.get(), &kind) == GIF_OK, gif->Error);
        if (kind == IMAGE_DESC_RECORD_TYPE) return read_picture(gif.get(), bytes.size());
        if (kind == EXTENSION_RECORD_TYPE) skip_extension(gif.get());
        if (kind == TERMINATE_RECORD_TYPE) throw DecodeError("damaged GIF: it holds no picture");
    }
}

}  // namespace sundog::output
