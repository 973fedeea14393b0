// SPDX-License-Identifier: Apache-2.0
// PNG through libpng. Its errors leave by longjmp: the functions that call setjmp own nothing.
#include <png.h>

#include <csetjmp>
#include <cstring>

#include "base/diagnostics.h"
#include "output/codec.h"
#include "output/encoding.h"

namespace sundog::output {
namespace {

// Deflate can't shrink data by more than this factor (RFC 1951: 258 bytes from a 2-bit code at best).
constexpr std::uint64_t kBestDeflateRatio = 1032;

struct ErrorText {
    char text[200] = "";
};

[[noreturn]] void on_error(png_structp png, png_const_charp message) {
    auto* error = static_cast<ErrorText*>(png_get_error_ptr(png));
    std::strncpy(error->text, message, sizeof(error->text) - 1);
    png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

struct Writer {
    ErrorText error;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &error, on_error, on_warning);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    std::string bytes;

    Writer() = default;
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
};

void append_bytes(png_structp png, png_bytep data, std::size_t size) {
    bool appended = false;
    try {
        static_cast<Writer*>(png_get_io_ptr(png))->bytes.append(reinterpret_cast<const char*>(data), size);
        appended = true;
    } catch (const std::bad_alloc&) {
        // An exception may not pass through libpng; its own way out is below.
    }
    if (!appended) png_error(png, "out of memory");
}

void flush_nothing(png_structp) {}

/// What the header says of the pixels.
struct Layout {
    png_uint_32 width = 0, height = 0;
    int depth = 8, color_type = PNG_COLOR_TYPE_RGB;
    std::size_t bytes_per_row = 0;
    int significant_bits = 8;
    double file_gamma = 0;  // 0: sRGB
};

bool write_rows(Writer& writer, const Layout& layout, const std::uint8_t* bytes) {
    if (setjmp(png_jmpbuf(writer.png)) != 0) return false;
    png_set_write_fn(writer.png, &writer, append_bytes, flush_nothing);
    png_set_IHDR(writer.png, writer.info, layout.width, layout.height, layout.depth, layout.color_type,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (layout.file_gamma > 0) png_set_gAMA(writer.png, writer.info, layout.file_gamma);
    else png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    if (layout.significant_bits != layout.depth) {
        const auto bits = static_cast<png_byte>(layout.significant_bits);
        const png_color_8 significant{bits, bits, bits, bits, bits};
        png_set_sBIT(writer.png, writer.info, &significant);
    }
    png_set_compression_level(writer.png, 4);
    png_set_filter(writer.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB | PNG_FILTER_UP);
    png_write_info(writer.png, writer.info);
    for (png_uint_32 y = 0; y < layout.height; ++y) png_write_row(writer.png, bytes + layout.bytes_per_row * y);
    png_write_end(writer.png, nullptr);
    return true;
}

/// Codes of fewer bits fill 8 or 16 by repeating (PNG specification 12.4), big end first.
std::vector<std::uint8_t> png_bytes(const std::vector<std::uint16_t>& codes, int bits) {
    const unsigned largest = (1U << static_cast<unsigned>(bits)) - 1;
    std::vector<std::uint8_t> bytes;
    bytes.reserve(codes.size() * 2);
    for (const std::uint16_t code : codes) {
        const unsigned scaled = (code * (bits > 8 ? 0xFFFFU : 0xFFU) + largest / 2) / largest;
        if (bits > 8) bytes.push_back(static_cast<std::uint8_t>(scaled >> 8U));
        bytes.push_back(static_cast<std::uint8_t>(scaled));
    }
    return bytes;
}

struct Reader {
    explicit Reader(Bytes bytes) : left(bytes) {}
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    ErrorText error;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &error, on_error, on_warning);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    Bytes left;
    png_uint_32 width = 0, height = 0;
    int passes = 1;
    bool deep = false;  // 16 bits a channel
    bool opaque = false;
};

void take_bytes(png_structp png, png_bytep data, std::size_t size) {
    auto* reader = static_cast<Reader*>(png_get_io_ptr(png));
    if (size > reader->left.size()) png_error(png, "the file is cut off");
    std::memcpy(data, reader->left.data(), size);
    reader->left = reader->left.subspan(size);
}

bool read_header(Reader& reader) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_set_read_fn(reader.png, &reader, take_bytes);
    png_read_info(reader.png, reader.info);
    reader.width = png_get_image_width(reader.png, reader.info);
    reader.height = png_get_image_height(reader.png, reader.info);
    reader.deep = png_get_bit_depth(reader.png, reader.info) == 16;
    return true;
}

/// Asks libpng for RGBA with 8 or 16 bits a channel.
bool prepare_rows(Reader& reader) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_set_expand(reader.png);
    png_set_gray_to_rgb(reader.png);
    png_set_add_alpha(reader.png, 0xFFFF, PNG_FILLER_AFTER);
    if (reader.deep) png_set_swap(reader.png);
    reader.passes = png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    if (png_get_rowbytes(reader.png, reader.info) != std::size_t{reader.width} * (reader.deep ? 8 : 4))
        png_error(reader.png, "rows of an unexpected length");
    return true;
}

/// Asks libpng for the palette's numbers, a byte each. False if there is no palette, too.
bool prepare_indices(Reader& reader) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_set_packing(reader.png);
    reader.passes = png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    return png_get_color_type(reader.png, reader.info) == PNG_COLOR_TYPE_PALETTE &&
           png_get_rowbytes(reader.png, reader.info) == reader.width;
}

bool read_row(Reader& reader, png_bytep row) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_read_row(reader.png, row, nullptr);
    return true;
}

bool read_end(Reader& reader) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
    png_read_end(reader.png, nullptr);
    return true;
}

void require(bool done, const Reader& reader) {
    if (!done) throw DecodeError(std::string("damaged PNG: ") + reader.error.text);
}

template <typename T>
void read_pixels(Reader& reader, std::vector<T>& values, std::size_t values_per_row) {
    for (int pass = 0; pass < reader.passes; ++pass) {
        for (std::size_t y = 0; y < reader.height; ++y) {
            if (pass == 0) grow(values, (y + 1) * values_per_row, reader.height * values_per_row);
            require(read_row(reader, reinterpret_cast<png_bytep>(values.data() + y * values_per_row)), reader);
        }
    }
}

}  // namespace

std::string encode_png(const Image& image, const Encoding& encoding) {
    const int channels = channels_of(image, encoding);
    Layout layout{static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height)};
    layout.depth = encoding.bits > 8 ? 16 : 8;
    layout.color_type =
        (encoding.grayscale ? 0 : PNG_COLOR_MASK_COLOR) | (image.alpha.empty() ? 0 : PNG_COLOR_MASK_ALPHA);
    layout.bytes_per_row = std::size_t{layout.width} * static_cast<std::size_t>(channels * layout.depth / 8);
    layout.significant_bits = encoding.bits;
    if (encoding.gamma) layout.file_gamma = 1 / *encoding.gamma;
    std::vector<std::uint8_t> bytes;
    if (encoding.bits == 8 && !encoding.grayscale) bytes = codes8_of(image, encoding);
    else bytes = png_bytes(codes_of(image, encoding, encoding.bits), encoding.bits);
    Writer writer;
    if (writer.info == nullptr) throw std::bad_alloc();
    if (!write_rows(writer, layout, bytes.data()))
        throw OutputError(std::string("can't encode a PNG: ") + writer.error.text);
    return std::move(writer.bytes);
}

Decoded decode_png(Bytes bytes, std::size_t bytes_per_pixel) {
    Reader reader(bytes);
    if (reader.info == nullptr) throw std::bad_alloc();
    require(read_header(reader), reader);
    check_size(reader.width, reader.height, std::max<std::size_t>(bytes_per_pixel, reader.deep ? 8 : 4));
    // At least one bit a pixel before compression.
    check_plausible(reader.width, reader.height, bytes.size(), kBestDeflateRatio * 8);
    require(prepare_rows(reader), reader);
    Decoded decoded;
    decoded.width = reader.width;
    decoded.height = reader.height;
    if (reader.deep) read_pixels(reader, decoded.rgba16, std::size_t{4} * reader.width);
    else read_pixels(reader, decoded.rgba8, std::size_t{reader.width});
    require(read_end(reader), reader);
    return decoded;
}

bool png_tells_encoding(Bytes bytes) {
    Reader reader(bytes);
    if (reader.info == nullptr) throw std::bad_alloc();
    require(read_header(reader), reader);
    return png_get_valid(reader.png, reader.info, PNG_INFO_gAMA | PNG_INFO_sRGB) != 0;
}

std::optional<IndexedImage> decode_png_indices(Bytes bytes) {
    Reader reader(bytes);
    if (reader.info == nullptr) throw std::bad_alloc();
    require(read_header(reader), reader);
    check_size(reader.width, reader.height, 1);
    check_plausible(reader.width, reader.height, bytes.size(), kBestDeflateRatio * 8);
    if (!prepare_indices(reader)) return std::nullopt;
    IndexedImage image;
    image.width = reader.width;
    image.height = reader.height;
    read_pixels(reader, image.indices, std::size_t{reader.width});
    return image;
}

}  // namespace sundog::output
