// SPDX-License-Identifier: Apache-2.0
#include "output/indices.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include "output/codec.h"

namespace sundog::output {
namespace {

constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28U;

/// Reads little-endian numbers and blocks of a GIF (Graphics Interchange Format, version 89a, 1990).
class GifReader {
public:
    explicit GifReader(Bytes bytes) : bytes_(bytes) {}

    std::optional<IndexedImage> read() {
        constexpr std::size_t kHeader = 13;
        if (bytes_.size() < kHeader) return std::nullopt;
        at_ = kHeader;
        skip_palette(bytes_[10]);
        while (at_ < bytes_.size()) {
            const unsigned kind = bytes_[at_++];
            if (kind == 0x21) {  // an extension
                ++at_;
                skip_blocks();
            } else if (kind == 0x2c) {
                return read_picture();
            } else {
                break;
            }
        }
        return std::nullopt;
    }

private:
    void skip_palette(unsigned flags) {
        if ((flags & 0x80U) != 0) at_ += std::size_t{3} << ((flags & 7U) + 1);
    }
    void skip_blocks() {
        while (at_ < bytes_.size() && bytes_[at_] != 0) at_ += bytes_[at_] + std::size_t{1};
        ++at_;
    }
    [[nodiscard]] std::uint32_t number(std::size_t at) const { return bytes_[at] | bytes_[at + 1] * 256U; }

    std::optional<IndexedImage> read_picture() {
        if (at_ + 10 > bytes_.size()) return std::nullopt;
        IndexedImage image;
        image.width = number(at_ + 4), image.height = number(at_ + 6);
        const unsigned flags = bytes_[at_ + 8];
        at_ += 9;
        skip_palette(flags);
        if (at_ >= bytes_.size()) return std::nullopt;
        const unsigned code_size = bytes_[at_++];
        const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
        if (code_size < 1 || code_size > 8 || pixels == 0 || pixels > kMostPixels) return std::nullopt;
        std::vector<std::uint8_t> data;
        while (at_ < bytes_.size() && bytes_[at_] != 0) {
            const std::size_t size = std::min<std::size_t>(bytes_[at_], bytes_.size() - at_ - 1);
            data.insert(data.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(at_ + 1),
                        bytes_.begin() + static_cast<std::ptrdiff_t>(at_ + 1 + size));
            at_ += size + 1;
        }
        // No code of 12 bits stands for more than 4096 pixels.
        if (pixels > (data.size() + 1) * 4096) return std::nullopt;
        image.indices = decompressed(data, code_size, static_cast<std::size_t>(pixels));
        if ((flags & 0x40U) != 0) image.indices = deinterlaced(image);
        return image;
    }

    /// Lempel, Ziv and Welch's compression; what is missing is 0.
    static std::vector<std::uint8_t> decompressed(const std::vector<std::uint8_t>& data, unsigned code_size,
                                                  std::size_t pixels) {
        struct Entry {
            std::uint16_t before = 0;
            std::uint8_t last = 0;
        };
        constexpr unsigned kMostCodes = 4096;
        std::array<Entry, kMostCodes> table{};
        const unsigned clear = 1U << code_size;
        for (unsigned i = 0; i < clear; ++i) table[i].last = static_cast<std::uint8_t>(i);
        std::vector<std::uint8_t> out;
        out.reserve(pixels);
        std::vector<std::uint8_t> text;
        unsigned bits = code_size + 1;
        unsigned next = clear + 2;
        unsigned before = kMostCodes;  // none
        std::size_t bit = 0;
        while (out.size() < pixels && bit + bits <= data.size() * 8) {
            unsigned code = 0;
            for (unsigned i = 0; i < bits; ++i, ++bit)
                code |= ((static_cast<unsigned>(data[bit / 8]) >> (bit % 8)) & 1U) << i;
            if (code == clear) {
                bits = code_size + 1, next = clear + 2, before = kMostCodes;
                continue;
            }
            if (code == clear + 1 || code > next || (code == next && before == kMostCodes)) break;
            text.clear();
            const bool is_new = code == next;
            for (unsigned at = is_new ? before : code;; at = table[at].before) {
                text.push_back(table[at].last);
                if (at < clear) break;
            }
            std::reverse(text.begin(), text.end());
            if (is_new) text.push_back(text.front());
            out.insert(out.end(), text.begin(), text.end());
            if (before != kMostCodes && next < kMostCodes) {
                table[next++] = {static_cast<std::uint16_t>(before), text.front()};
                if (next == 1U << bits && bits < 12) ++bits;
            }
            before = code;
        }
        out.resize(pixels);
        return out;
    }

    static std::vector<std::uint8_t> deinterlaced(const IndexedImage& image) {
        std::vector<std::uint8_t> out(image.indices.size());
        std::size_t from = 0;
        constexpr std::array<std::array<std::uint32_t, 2>, 4> kPasses{{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
        for (const auto& [first, step] : kPasses) {
            for (std::uint32_t row = first; row < image.height; row += step) {
                std::copy_n(image.indices.begin() + static_cast<std::ptrdiff_t>(from), image.width,
                            out.begin() + static_cast<std::ptrdiff_t>(std::size_t{row} * image.width));
                from += image.width;
            }
        }
        return out;
    }

    Bytes bytes_;
    std::size_t at_ = 0;
};

[[noreturn]] void on_error(png_structp png, png_const_charp) { png_longjmp(png, 1); }
void on_warning(png_structp, png_const_charp) {}

// libpng's errors leave by longjmp: the functions that call setjmp own nothing.
struct PngReader {
    explicit PngReader(Bytes all) : rest(all) {}
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    Bytes rest;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, on_error, on_warning);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    int passes = 1;
};

void take_bytes(png_structp png, png_bytep to, std::size_t size) {
    auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
    if (size > reader->rest.size()) png_error(png, "the end is missing");
    std::memcpy(to, reader->rest.data(), size);
    reader->rest = reader->rest.subspan(size);
}

bool read_header(PngReader& reader) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_set_read_fn(reader.png, &reader, take_bytes);
    png_read_info(reader.png, reader.info);
    png_set_packing(reader.png);
    reader.passes = png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    return png_get_color_type(reader.png, reader.info) == PNG_COLOR_TYPE_PALETTE &&
           png_get_rowbytes(reader.png, reader.info) == png_get_image_width(reader.png, reader.info);
}

bool read_row(PngReader& reader, png_bytep row) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_read_row(reader.png, row, nullptr);
    return true;
}

std::optional<IndexedImage> read_png(Bytes bytes) {
    PngReader reader(bytes);
    if (reader.info == nullptr || !read_header(reader)) return std::nullopt;
    IndexedImage image;
    image.width = png_get_image_width(reader.png, reader.info);
    image.height = png_get_image_height(reader.png, reader.info);
    const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
    constexpr std::uint64_t kMostPixelsPerByte = 8 * 1032;  // as Deflate can't shrink more
    if (pixels == 0 || pixels > kMostPixels || pixels > bytes.size() * kMostPixelsPerByte) return std::nullopt;
    image.indices.resize(static_cast<std::size_t>(pixels));
    for (int pass = 0; pass < reader.passes; ++pass)
        for (std::size_t row = 0; row < image.height; ++row)
            if (!read_row(reader, image.indices.data() + row * image.width)) return std::nullopt;
    return image;
}

}  // namespace

std::optional<IndexedImage> read_indices(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::vector<char> content{std::istreambuf_iterator<char>(stream), {}};
    const Bytes bytes(reinterpret_cast<const unsigned char*>(content.data()), content.size());
    const auto begins_with = [&](std::string_view text) {
        return content.size() >= text.size() && std::equal(text.begin(), text.end(), content.begin());
    };
    if (begins_with("GIF8")) return GifReader(bytes).read();
    if (begins_with("\x89PNG\r\n\x1a\n")) return read_png(bytes);
    return std::nullopt;
}

}  // namespace sundog::output
