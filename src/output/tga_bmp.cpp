// SPDX-License-Identifier: Apache-2.0
// Writing Targa (Truevision, TGA file format specification 2.0, 1991) and BMP (Microsoft, BITMAPV4HEADER).
#include <cstring>

#include "base/diagnostics.h"
#include "output/codec.h"
#include "output/encoding.h"

namespace sundog::output {
namespace {

class LittleEndian {
public:
    explicit LittleEndian(std::string& out) : out_(out) {}
    void u8(unsigned value) { out_ += static_cast<char>(value & 0xFFU); }
    void u16(unsigned value) {
        u8(value);
        u8(value >> 8U);
    }
    void u32(std::uint32_t value) {
        u16(value);
        u16(value >> 16U);
    }

private:
    std::string& out_;
};

/// Blue first, as both formats want it.
std::string swapped_rows(const Image& image, const Encoding& encoding, std::size_t channels) {
    const std::vector<std::uint8_t> codes = codes8_of(image, encoding);
    std::string bytes(codes.begin(), codes.end());
    for (std::size_t i = 0; i < bytes.size(); i += channels) std::swap(bytes[i], bytes[i + 2]);
    return bytes;
}

std::size_t channels8(const Image& image) { return image.alpha.empty() ? 3 : 4; }

/// Packets of 1 to 128 pixels, of one colour or of many, that end with their row.
void append_packets(std::string& out, const char* row, std::size_t width, std::size_t channels) {
    constexpr std::size_t kLongest = 128;
    const auto same = [&](std::size_t a, std::size_t b) {
        return std::memcmp(row + a * channels, row + b * channels, channels) == 0;
    };
    for (std::size_t x = 0; x < width;) {
        std::size_t end = x + 1;
        if (end < width && same(x, end)) {
            while (end < width && end - x < kLongest && same(x, end)) ++end;
            out += static_cast<char>(0x80U | (end - x - 1));
            out.append(row + x * channels, channels);
        } else {
            while (end < width && end - x < kLongest && !(end + 1 < width && same(end, end + 1))) ++end;
            out += static_cast<char>(end - x - 1);
            out.append(row + x * channels, (end - x) * channels);
        }
        x = end;
    }
}

}  // namespace

std::string encode_tga(const Image& image, const Encoding& encoding) {
    if (image.width > 0xFFFF || image.height > 0xFFFF)
        throw OutputError("a Targa picture has at most 65535 pixels a side");
    const std::size_t channels = channels8(image);
    const auto width = static_cast<std::size_t>(image.width);
    std::string out;
    LittleEndian header(out);
    header.u8(0);                              // No text
    header.u8(0);                              // No palette
    header.u8(encoding.run_length ? 10 : 2);   // True colour
    for (int i = 0; i < 9; ++i) header.u8(0);  // Palette and place on the screen
    header.u16(static_cast<unsigned>(image.width));
    header.u16(static_cast<unsigned>(image.height));
    header.u8(static_cast<unsigned>(8 * channels));
    header.u8(0x20U | (channels == 4 ? 8U : 0U));  // Upper row first; bits of alpha
    const std::string pixels = swapped_rows(image, encoding, channels);
    if (!encoding.run_length) return out + pixels;
    for (std::size_t at = 0; at < pixels.size(); at += width * channels)
        append_packets(out, pixels.data() + at, width, channels);
    return out;
}

std::string encode_bmp(const Image& image, const Encoding& encoding) {
    constexpr std::uint32_t kFileHeader = 14, kV4Header = 108, kBitFields = 3, kSrgb = 0x73524742;
    const std::size_t channels = channels8(image);
    const std::size_t row = static_cast<std::size_t>(image.width) * channels;
    const std::size_t stride = (row + 3) / 4 * 4;
    const std::size_t size = kFileHeader + kV4Header + stride * static_cast<std::size_t>(image.height);
    if (size > 0xFFFFFFFFU) throw OutputError("a BMP picture has at most 4 GiB");
    std::string out = "BM";
    out.reserve(size);
    LittleEndian header(out);
    header.u32(static_cast<std::uint32_t>(size));
    header.u32(0);
    header.u32(kFileHeader + kV4Header);
    header.u32(kV4Header);
    header.u32(static_cast<std::uint32_t>(image.width));
    header.u32(static_cast<std::uint32_t>(image.height));
    header.u16(1);
    header.u16(static_cast<unsigned>(8 * channels));
    header.u32(channels == 4 ? kBitFields : 0);
    header.u32(static_cast<std::uint32_t>(stride) * static_cast<std::uint32_t>(image.height));
    for (const std::uint32_t value : {2835U, 2835U, 0U, 0U}) header.u32(value);  // 72 dots an inch; no palette
    for (const std::uint32_t mask : {0x00FF0000U, 0x0000FF00U, 0x000000FFU, 0xFF000000U})
        header.u32(channels == 4 ? mask : 0);
    header.u32(kSrgb);
    for (int i = 0; i < 12; ++i) header.u32(0);  // End points and gamma, which sRGB says already
    const std::string pixels = swapped_rows(image, encoding, channels);
    for (std::size_t y = static_cast<std::size_t>(image.height); y-- > 0;) {
        out.append(pixels, y * row, row);
        out.append(stride - row, '\0');
    }
    return out;
}

}  // namespace sundog::output
