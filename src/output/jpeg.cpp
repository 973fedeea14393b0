// SPDX-License-Identifier: Apache-2.0
// JPEG through libjpeg-turbo. Its errors leave by longjmp: the functions that call setjmp own nothing.
#include <csetjmp>
#include <cstdio>  // jpeglib.h needs FILE, but doesn't include it.
#include <cstdlib>
// Apart, as jpeglib.h must come first.
#include <jpeglib.h>
// After it.
#include <jerror.h>

#include "base/diagnostics.h"
#include "output/codec.h"
#include "output/encoding.h"

namespace sundog::output {
namespace {

constexpr int kMostScans = 200;
// A block of 8x8 pixels takes at least one bit of Huffman code in some component.
constexpr std::uint64_t kMostPixelsPerByte = 512;

struct ErrorManager {
    jpeg_error_mgr manager{};  // First, as libjpeg hands out pointers to it.
    std::jmp_buf escape{};
    char text[JMSG_LENGTH_MAX] = "";
};

[[noreturn]] void on_error(j_common_ptr codec) {
    auto* error = reinterpret_cast<ErrorManager*>(codec->err);
    codec->err->format_message(codec, error->text);
    std::longjmp(error->escape, 1);
}

/// libjpeg fills in what is missing and only warns; a picture that is cut off or broken is no picture here.
void on_message(j_common_ptr codec, int level) {
    if (level >= 0) return;
    const int code = codec->err->msg_code;
    if (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER || code == JWRN_HUFF_BAD_CODE) on_error(codec);
}

/// Small files can ask for hundreds of passes over a huge picture.
void limit_scans(j_common_ptr codec) {
    const auto* decoder = reinterpret_cast<j_decompress_ptr>(codec);
    if (decoder->input_scan_number > kMostScans) ERREXIT(codec, JERR_BAD_PROGRESSION);
}

void install(ErrorManager& error) {
    jpeg_std_error(&error.manager);
    error.manager.error_exit = on_error;
    error.manager.emit_message = on_message;
}

struct Encoder {
    ErrorManager error;
    jpeg_compress_struct codec{};
    unsigned char* bytes = nullptr;  // From malloc, by jpeg_mem_dest.
    unsigned long size = 0;

    Encoder() {
        install(error);
        codec.err = &error.manager;
    }
    ~Encoder() {
        jpeg_destroy_compress(&codec);
        std::free(bytes);  // NOLINT(cppcoreguidelines-owning-memory): libjpeg's interface
    }
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
};

bool run_encoder(Encoder& encoder, JDIMENSION width, JDIMENSION height, const std::uint8_t* codes, int quality) {
    if (setjmp(encoder.error.escape) != 0) return false;
    jpeg_compress_struct& codec = encoder.codec;
    jpeg_create_compress(&codec);
    jpeg_mem_dest(&codec, &encoder.bytes, &encoder.size);
    codec.image_width = width;
    codec.image_height = height;
    codec.input_components = 3;
    codec.in_color_space = JCS_RGB;
    jpeg_set_defaults(&codec);
    jpeg_set_quality(&codec, quality, TRUE);
    // No subsampling: colour as sharp as brightness.
    codec.comp_info[0].h_samp_factor = 1;
    codec.comp_info[0].v_samp_factor = 1;
    codec.dct_method = JDCT_ISLOW;
    jpeg_start_compress(&codec, TRUE);
    while (codec.next_scanline < codec.image_height) {
        auto* row = const_cast<JSAMPROW>(codes + std::size_t{3} * width * codec.next_scanline);
        jpeg_write_scanlines(&codec, &row, 1);
    }
    jpeg_finish_compress(&codec);
    return true;
}

struct Decoder {
    ErrorManager error;
    jpeg_decompress_struct codec{};
    jpeg_progress_mgr progress{};

    Decoder() {
        install(error);
        codec.err = &error.manager;
        progress.progress_monitor = limit_scans;
    }
    ~Decoder() { jpeg_destroy_decompress(&codec); }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
};

bool read_header(Decoder& decoder, Bytes bytes) {
    if (setjmp(decoder.error.escape) != 0) return false;
    jpeg_create_decompress(&decoder.codec);
    decoder.codec.progress = &decoder.progress;
    jpeg_mem_src(&decoder.codec, bytes.data(), static_cast<unsigned long>(bytes.size()));
    jpeg_read_header(&decoder.codec, TRUE);
    const J_COLOR_SPACE stored = decoder.codec.jpeg_color_space;
    decoder.codec.out_color_space = stored == JCS_CMYK || stored == JCS_YCCK ? JCS_CMYK : JCS_EXT_RGBA;
    return true;
}

bool start(Decoder& decoder) {
    if (setjmp(decoder.error.escape) != 0) return false;
    jpeg_start_decompress(&decoder.codec);
    if (decoder.codec.output_components != 4) ERREXIT(&decoder.codec, JERR_CONVERSION_NOTIMPL);
    return true;
}

bool read_row(Decoder& decoder, JSAMPROW row) {
    if (setjmp(decoder.error.escape) != 0) return false;
    jpeg_read_scanlines(&decoder.codec, &row, 1);
    return true;
}

bool finish(Decoder& decoder) {
    if (setjmp(decoder.error.escape) != 0) return false;
    jpeg_finish_decompress(&decoder.codec);
    return true;
}

void require(bool done, const Decoder& decoder) {
    if (!done) throw DecodeError(std::string("damaged JPEG: ") + decoder.error.text);
}

/// Adobe's programs store ink inverted (255 is none), others not.
std::uint32_t rgba_of_cmyk(std::uint32_t cmyk, bool inverted) {
    if (!inverted) cmyk = ~cmyk;
    const std::uint32_t k = cmyk >> 24;
    const auto channel = [&](unsigned shift) { return ((cmyk >> shift & 0xFF) * k + 127) / 255; };
    return channel(0) | channel(8) << 8 | channel(16) << 16 | 0xFF000000U;
}

}  // namespace

std::string encode_jpeg(const Image& image, const Encoding& encoding) {
    Image opaque = image;  // The format has no alpha.
    opaque.alpha.clear();
    const std::vector<std::uint8_t> codes = codes8_of(opaque, encoding);
    Encoder encoder;
    if (!run_encoder(encoder, static_cast<JDIMENSION>(image.width), static_cast<JDIMENSION>(image.height), codes.data(),
                     encoding.jpeg_quality))
        throw OutputError(std::string("can't encode a JPEG: ") + encoder.error.text);
    return {reinterpret_cast<const char*>(encoder.bytes), encoder.size};
}

Decoded decode_jpeg(Bytes bytes, std::size_t bytes_per_pixel) {
    Decoder decoder;
    require(read_header(decoder, bytes), decoder);
    Decoded decoded;
    decoded.width = decoder.codec.image_width;
    decoded.height = decoder.codec.image_height;
    check_size(decoded.width, decoded.height, std::max<std::size_t>(bytes_per_pixel, 4));
    check_plausible(decoded.width, decoded.height, bytes.size(), kMostPixelsPerByte);
    require(start(decoder), decoder);
    const std::size_t width = decoded.width;
    for (std::size_t y = 0; y < decoded.height; ++y) {
        grow(decoded.rgba8, (y + 1) * width, decoded.height * width);
        require(read_row(decoder, reinterpret_cast<JSAMPROW>(decoded.rgba8.data() + y * width)), decoder);
    }
    require(finish(decoder), decoder);
    if (decoder.codec.out_color_space == JCS_CMYK) {
        const bool inverted = decoder.codec.saw_Adobe_marker != 0;
        for (std::uint32_t& pixel : decoded.rgba8) pixel = rgba_of_cmyk(pixel, inverted);
    }
    return decoded;
}

}  // namespace sundog::output
