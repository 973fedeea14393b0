// SPDX-License-Identifier: Apache-2.0
#include "output/image.h"

#include <array>
#include <cctype>
#include <cstring>
#include <new>

#include "base/diagnostics.h"
#include "output/codec.h"
#include "output/file.h"
#include "output/srgb.h"

namespace sundog::output {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostPixels = 1'000'000'000;
constexpr std::uint64_t kMostDecodedBytes = std::uint64_t{1} << 32;

struct Ending {
    std::string_view text;
    Format format;
};
constexpr std::array<Ending, 8> kEndings{{{".png", Format::png},
                                          {".jpg", Format::jpg},
                                          {".jpeg", Format::jpg},
                                          {".exr", Format::exr},
                                          {".hdr", Format::hdr},
                                          {".ppm", Format::ppm},
                                          {".tga", Format::tga},
                                          {".bmp", Format::bmp}}};

/// OpenEXR's alpha: the colours are multiplied by it (OpenEXR, "Technical Introduction", Alpha).
std::string encode_exr_alpha(const Image& image, std::vector<Layer> layers) {
    Image associated(image.width, image.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) associated.pixels[i] = image.pixels[i] * image.alpha[i];
    layers.push_back({"A", {""}, image.alpha});
    return encode_exr(associated, layers);
}

std::string lower_case_ending(const fs::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

constexpr std::string_view kPngMagic = "\x89PNG\r\n\x1a\n";

bool starts_with(Bytes bytes, std::string_view magic) {
    return bytes.size() >= magic.size() && std::memcmp(bytes.data(), magic.data(), magic.size()) == 0;
}

/// Calls decode(bytes); turns what goes wrong into an InputError with the file's name.
template <class Decode>
auto decode_of(const fs::path& file, Bytes bytes, const Decode& decode) {
    try {
        return decode(bytes);
    } catch (const DecodeError& error) {
        fail_to_read(file, error.what());
    } catch (const std::bad_alloc&) {
        fail_to_read(file, "there is too little memory for the picture");
    }
}

template <class Decode>
auto read_and(const fs::path& file, const Decode& decode) {
    const std::vector<unsigned char> bytes = read_file(file);
    return decode_of(file, bytes, decode);
}

Decoded read_decoded(const fs::path& file, std::size_t bytes_per_pixel) {
    return read_and(file, [&](Bytes bytes) { return decode(bytes, bytes_per_pixel); });
}

/// As 8-bit texels.
Rgba8 rgba8_of(Decoded decoded) {
    Rgba8 texture{decoded.width, decoded.height, std::move(decoded.rgba8)};
    if (!texture.pixels.empty()) return texture;
    texture.pixels.resize(static_cast<std::size_t>(decoded.width) * decoded.height);
    if (!decoded.rgba16.empty()) {
        const auto code8 = [&](std::size_t i) { return (decoded.rgba16[i] * 255U + 32767U) / 65535U; };
        for (std::size_t i = 0; i < texture.pixels.size(); ++i)
            texture.pixels[i] = code8(4 * i) | code8(4 * i + 1) << 8 | code8(4 * i + 2) << 16 | code8(4 * i + 3) << 24;
        return texture;
    }
    std::array<std::uint8_t, 3> code{};
    for (std::size_t i = 0; i < texture.pixels.size(); ++i) {
        encode_srgb8({&decoded.linear[i], 1}, code);
        texture.pixels[i] = code[0] | static_cast<std::uint32_t>(code[1]) << 8 |
                            static_cast<std::uint32_t>(code[2]) << 16 | 0xFF000000U;
    }
    return texture;
}

}  // namespace

void check_size(std::uint64_t width, std::uint64_t height, std::size_t bytes_per_pixel) {
    const auto fail = [&](const char* why) {
        throw DecodeError("the picture of " + std::to_string(width) + "x" + std::to_string(height) + " pixels " + why);
    };
    if (width == 0 || height == 0) fail("is empty");
    if (width > kMostPixels || height > kMostPixels || width * height > kMostPixels) fail("has more than a gigapixel");
    if (width * height * bytes_per_pixel > kMostDecodedBytes) fail("would take more than 4 GiB");
}

void check_plausible(std::uint64_t width, std::uint64_t height, std::size_t file_size,
                     std::uint64_t most_pixels_per_byte) {
    if (width * height / most_pixels_per_byte > file_size)
        throw DecodeError("damaged picture: " + std::to_string(file_size) + " bytes are too few for " +
                          std::to_string(width) + "x" + std::to_string(height) + " pixels");
}

Decoded decode(Bytes bytes, std::size_t bytes_per_pixel) {
    if (bytes.empty()) throw DecodeError("the file is empty");
    if (starts_with(bytes, kPngMagic)) return decode_png(bytes, bytes_per_pixel);
    if (starts_with(bytes, "\xFF\xD8\xFF")) return decode_jpeg(bytes, bytes_per_pixel);
    if (starts_with(bytes, "\x76\x2F\x31\x01")) return decode_exr(bytes, bytes_per_pixel);
    if (starts_with(bytes, "#?RADIANCE") || starts_with(bytes, "#?RGBE"))
        return decode_radiance(bytes, bytes_per_pixel);
    if (bytes[0] == 'P' && bytes.size() > 2 && std::isspace(bytes[2]) != 0 &&
        (bytes[1] == '2' || bytes[1] == '3' || bytes[1] == '5' || bytes[1] == '6'))
        return decode_pnm(bytes, bytes_per_pixel);
    // The best that each coding can do: a bit a pixel in BMP, a 12-bit code for 4096 pixels in GIF, two bytes for 128
    // pixels in TGA.
    if (starts_with(bytes, "BM")) return decode_small_format(bytes, bytes_per_pixel, 8);
    if (starts_with(bytes, "GIF8")) return decode_small_format(bytes, bytes_per_pixel, 4096);
    if (looks_like_tga(bytes)) return decode_small_format(bytes, bytes_per_pixel, 64);
    throw DecodeError("not a picture of a known format (PNG, JPEG, EXR, Radiance HDR, PPM, PGM, BMP, GIF, TGA)");
}

Format format_of(const fs::path& file) {
    const std::string ending = lower_case_ending(file);
    std::string known;
    for (const Ending& candidate : kEndings) {
        if (candidate.text == ending) return candidate.format;
        known.append(" ").append(candidate.text);
    }
    throw OutputError("can't tell the picture format of '" + file.string() + "' by its ending; there are" + known);
}

std::vector<std::uint8_t> to_srgb8(const Image& image) {
    std::vector<std::uint8_t> codes(image.pixels.size() * 3);
    encode_srgb8(image.pixels, codes);
    return codes;
}

std::string encode(const Image& image, Format format, const std::vector<Layer>& layers, const Encoding& encoding) {
    if (image.width <= 0 || image.height <= 0) throw OutputError("can't write a picture without pixels");
    if (image.pixels.size() != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))
        throw OutputError("can't write a picture whose number of pixels is not width * height");
    if (!image.alpha.empty() && image.alpha.size() != image.pixels.size())
        throw OutputError("can't write a picture whose number of alpha values is not its number of pixels");
    switch (format) {
        case Format::png:
            return encode_png(image, encoding);
        case Format::jpg:
            return encode_jpeg(image, encoding);
        case Format::exr:
            return image.alpha.empty() ? encode_exr(image, layers) : encode_exr_alpha(image, layers);
        case Format::hdr:
            return encode_radiance(image);
        case Format::ppm:
            return encode_ppm(image, encoding);
        case Format::tga:
            return encode_tga(image, encoding);
        case Format::bmp:
            return encode_bmp(image, encoding);
    }
    throw OutputError("can't write a picture of an unknown format");
}

void write_image(const fs::path& file, const Image& image, const std::vector<Layer>& layers) {
    const bool unnamed = is_special_file(file) && lower_case_ending(file).empty();
    const Format format = unnamed ? Format::png : format_of(file);
    // Known before the picture is encoded, which may take a while.
    if (fs::is_directory(file)) fail_to_write(file, "it is a folder");
    write_file_atomically(file, encode(image, format, layers));
}

Image read_image(const fs::path& file) {
    Decoded decoded = read_decoded(file, sizeof(Vec3));
    Image image;
    image.width = static_cast<int>(decoded.width);
    image.height = static_cast<int>(decoded.height);
    if (!decoded.linear.empty()) {
        image.pixels = std::move(decoded.linear);
        return image;
    }
    image.pixels.reserve(static_cast<std::size_t>(decoded.width) * decoded.height);
    if (!decoded.rgba16.empty()) {
        const auto linear = [](std::uint16_t code) { return static_cast<float>(linear_from_srgb(code / 65535.0)); };
        for (std::size_t i = 0; i < decoded.rgba16.size(); i += 4)
            image.pixels.push_back(
                {linear(decoded.rgba16[i]), linear(decoded.rgba16[i + 1]), linear(decoded.rgba16[i + 2])});
        return image;
    }
    const std::array<float, 256>& linear = linear_of_srgb8();
    for (const std::uint32_t rgba : decoded.rgba8)
        image.pixels.push_back({linear[rgba & 0xFF], linear[(rgba >> 8) & 0xFF], linear[(rgba >> 16) & 0xFF]});
    return image;
}

Rgba8 read_rgba8(const fs::path& file) { return rgba8_of(read_decoded(file, sizeof(std::uint32_t))); }

Rgba8 decode_rgba8(std::span<const unsigned char> bytes, const std::string& name) {
    return rgba8_of(decode_of(name, bytes, [](Bytes b) { return decode(b, sizeof(std::uint32_t)); }));
}

bool tells_encoding(const fs::path& file) {
    return read_and(file, [](Bytes bytes) { return starts_with(bytes, kPngMagic) && png_tells_encoding(bytes); });
}

std::optional<IndexedImage> read_indices(const fs::path& file) {
    return read_and(file, [](Bytes bytes) -> std::optional<IndexedImage> {
        if (starts_with(bytes, kPngMagic)) return decode_png_indices(bytes);
        if (starts_with(bytes, "GIF8")) return decode_gif_indices(bytes);
        return std::nullopt;
    });
}

}  // namespace sundog::output
