// SPDX-License-Identifier: Apache-2.0
// Radiance pictures: a text header, then lines of 8-bit mantissas with a shared exponent (Ward, "Real Pixels",
// Graphics Gems II, 1991), run-length coded channel by channel (Radiance file formats, "Picture File Format").
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

#include "output/codec.h"

namespace sundog::output {
namespace {

constexpr std::size_t kShortestCodedLine = 8, kLongestCodedLine = 0x7FFF;
constexpr unsigned kLongestRun = 127, kLongestLiteral = 128;

using Rgbe = std::array<unsigned char, 4>;

Rgbe rgbe_of(Vec3 linear) {
    // No negative or infinite numbers in this format; NaN becomes black. The largest exponent is 127.
    constexpr float kLargest = 0x1.fep126F;
    const auto storable = [&](float v) { return v > 0 ? std::min(v, kLargest) : 0.0F; };
    const Vec3 colour{storable(linear.x), storable(linear.y), storable(linear.z)};
    const float largest = std::max({colour.x, colour.y, colour.z});
    if (largest < 1e-38F) return {0, 0, 0, 0};
    int exponent = 0;
    std::frexp(largest, &exponent);
    // Rounding may carry the largest mantissa to 256.
    if (std::lround(std::ldexp(largest, 8 - exponent)) == 256) ++exponent;
    const auto mantissa = [&](float v) { return static_cast<unsigned char>(std::lround(std::ldexp(v, 8 - exponent))); };
    return {mantissa(colour.x), mantissa(colour.y), mantissa(colour.z), static_cast<unsigned char>(exponent + 128)};
}

Vec3 linear_of(const Rgbe& rgbe) {
    if (rgbe[3] == 0) return {};
    const float step = std::ldexp(1.0F, rgbe[3] - 136);
    return Vec3{static_cast<float>(rgbe[0]), static_cast<float>(rgbe[1]), static_cast<float>(rgbe[2])} * step;
}

/// How many bytes from `first` on are equal, up to the longest run.
unsigned run_length(Bytes channel, std::size_t first) {
    unsigned length = 1;
    while (length < kLongestRun && first + length < channel.size() && channel[first + length] == channel[first])
        ++length;
    return length;
}

void append_coded(std::string& out, Bytes channel) {
    constexpr unsigned kWorthARun = 4;
    std::size_t i = 0;
    while (i < channel.size()) {
        const unsigned run = run_length(channel, i);
        if (run >= kWorthARun) {
            out += static_cast<char>(128 + run);
            out += static_cast<char>(channel[i]);
            i += run;
            continue;
        }
        std::size_t end = i + run;
        while (end < channel.size() && end - i < kLongestLiteral && run_length(channel, end) < kWorthARun) ++end;
        out += static_cast<char>(end - i);
        out.append(reinterpret_cast<const char*>(channel.data()) + i, end - i);
        i = end;
    }
}

/// Reads the file from front to back; past the end it throws.
class Cursor {
public:
    explicit Cursor(Bytes bytes) : left_(bytes) {}
    unsigned char byte() {
        if (left_.empty()) throw DecodeError("damaged Radiance picture: the file is cut off");
        const unsigned char value = left_.front();
        left_ = left_.subspan(1);
        return value;
    }
    Rgbe rgbe() {
        Rgbe value{};
        for (unsigned char& b : value) b = byte();
        return value;
    }
    std::string line() {
        constexpr std::size_t kLongestHeaderLine = 4096;
        std::string text;
        for (unsigned char c = byte(); c != '\n'; c = byte()) {
            if (text.size() == kLongestHeaderLine)
                throw DecodeError("damaged Radiance picture: an endless header line");
            text += static_cast<char>(c);
        }
        return text;
    }

private:
    Bytes left_;
};

/// One line of pixels. `first` is its first pixel as stored, which tells whether it is coded by channels.
void read_channels(Cursor& cursor, std::span<Rgbe> line) {
    for (std::size_t channel = 0; channel < 4; ++channel) {
        std::size_t x = 0;
        while (x < line.size()) {
            const unsigned code = cursor.byte();
            const bool run = code > kLongestLiteral;
            const std::size_t length = run ? code - 128 : code;
            if (length == 0 || length > line.size() - x)
                throw DecodeError("damaged Radiance picture: a run leaves its line");
            const unsigned char repeated = run ? cursor.byte() : static_cast<unsigned char>(0);
            for (const std::size_t end = x + length; x < end; ++x) line[x][channel] = run ? repeated : cursor.byte();
        }
    }
}

/// The older coding: a pixel (1, 1, 1, n) repeats the one before it n times; the next such pixel counts 256-fold.
void read_pixels(Cursor& cursor, std::span<Rgbe> line, Rgbe first) {
    unsigned shift = 0;
    Rgbe pixel = first;
    for (std::size_t x = 0; x < line.size();) {
        if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
            const std::size_t length = std::size_t{pixel[3]} << shift;
            if (x == 0 || shift > 24 || length > line.size() - x)
                throw DecodeError("damaged Radiance picture: a run leaves its line");
            std::fill_n(line.begin() + static_cast<std::ptrdiff_t>(x), length, line[x - 1]);
            x += length;
            shift += 8;
        } else {
            line[x++] = pixel;
            shift = 0;
        }
        if (x < line.size()) pixel = cursor.rgbe();
    }
}

void read_line(Cursor& cursor, std::span<Rgbe> line) {
    const Rgbe first = cursor.rgbe();
    const bool codable = line.size() >= kShortestCodedLine && line.size() <= kLongestCodedLine;
    if (!codable || first[0] != 2 || first[1] != 2 || first[2] >= 128) {
        read_pixels(cursor, line, first);
        return;
    }
    if ((std::size_t{first[2]} << 8 | first[3]) != line.size())
        throw DecodeError("damaged Radiance picture: a line of another length than the picture's width");
    read_channels(cursor, line);
}

struct Resolution {
    std::uint64_t width = 0, height = 0;
    bool bottom_first = false, right_first = false;
};

/// "-Y 480 +X 640": rows from the top, each from the left.
Resolution parse_resolution(const std::string& text) {
    Resolution resolution;
    const char* next = text.data();
    const char* end = next + text.size();
    const auto number_after = [&](char axis, bool& towards_plus) {
        std::uint64_t number = 0;
        while (next != end && *next == ' ') ++next;
        if (end - next < 3 || (next[0] != '-' && next[0] != '+') || next[1] != axis || next[2] != ' ')
            throw DecodeError("damaged or unsupported Radiance picture: expected a size like '-Y 480 +X 640'");
        towards_plus = next[0] == '+';
        next += 3;
        const auto [after, error] = std::from_chars(next, end, number);
        if (error != std::errc()) throw DecodeError("damaged Radiance picture: bad number in its size");
        next = after;
        return number;
    };
    bool rightwards = true;
    resolution.height = number_after('Y', resolution.bottom_first);
    resolution.width = number_after('X', rightwards);
    resolution.right_first = !rightwards;
    return resolution;
}

}  // namespace

std::string encode_radiance(const Image& image) {
    std::string out = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ";
    out.append(std::to_string(image.height)).append(" +X ").append(std::to_string(image.width)).append("\n");
    const auto width = static_cast<std::size_t>(image.width);
    const bool coded = width >= kShortestCodedLine && width <= kLongestCodedLine;
    std::array<std::vector<unsigned char>, 4> channels;
    for (auto& channel : channels) channel.resize(width);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Rgbe rgbe = rgbe_of(image.at(x, y));
            for (std::size_t c = 0; c < 4; ++c) channels[c][static_cast<std::size_t>(x)] = rgbe[c];
            if (!coded) out.append(reinterpret_cast<const char*>(rgbe.data()), rgbe.size());
        }
        if (!coded) continue;
        out += {2, 2, static_cast<char>(width >> 8), static_cast<char>(width & 0xFF)};
        for (const auto& channel : channels) append_coded(out, channel);
    }
    return out;
}

Decoded decode_radiance(Bytes bytes, std::size_t bytes_per_pixel) {
    Cursor cursor(bytes);
    for (std::string line = cursor.line(); !line.empty(); line = cursor.line())
        if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe")
            throw DecodeError("the Radiance picture is not in RGB ('" + line.substr(0, 40) + "')");
    const Resolution resolution = parse_resolution(cursor.line());
    check_size(resolution.width, resolution.height, std::max(bytes_per_pixel, sizeof(Vec3)));
    Decoded decoded;
    decoded.width = static_cast<std::uint32_t>(resolution.width);
    decoded.height = static_cast<std::uint32_t>(resolution.height);
    const std::size_t width = decoded.width;
    std::vector<Rgbe> line;
    for (std::size_t y = 0; y < decoded.height; ++y) {
        line.resize(width);
        read_line(cursor, line);
        grow(decoded.linear, (y + 1) * width, decoded.height * width);
        Vec3* row = decoded.linear.data() + y * width;
        for (std::size_t x = 0; x < width; ++x) row[x] = linear_of(line[x]);
        if (resolution.right_first) std::reverse(row, row + width);
    }
    if (resolution.bottom_first) {
        for (std::size_t y = 0; y < decoded.height / 2; ++y) {
            Vec3* above = decoded.linear.data() + y * width;
            std::swap_ranges(above, above + width, decoded.linear.data() + (decoded.height - 1 - y) * width);
        }
    }
    return decoded;
}

}  // namespace sundog::output
