// SPDX-License-Identifier: Apache-2.0
// Netpbm pictures: PPM and PGM, binary (P6, P5) and as text (P3, P2). P6 is written.
#include "output/codec.h"
#include "output/encoding.h"

namespace sundog::output {
namespace {

class Tokens {
public:
    explicit Tokens(Bytes bytes) : left_(bytes) {}

    /// The next decimal number, after white space and '#' comments.
    std::uint64_t number() {
        skip_space();
        std::uint64_t value = 0;
        std::size_t digits = 0;
        for (; !left_.empty() && left_.front() >= '0' && left_.front() <= '9'; ++digits) {
            if (value > 1'000'000'000'000) throw DecodeError("damaged PPM: a number is too large");
            value = value * 10 + (left_.front() - '0');
            left_ = left_.subspan(1);
        }
        if (digits == 0)
            throw DecodeError(left_.empty() ? "damaged PPM: the file is cut off" : "damaged PPM: expected a number");
        return value;
    }
    /// The binary samples begin one byte of white space after the header.
    Bytes after_one_space() { return left_.empty() ? left_ : left_.subspan(1); }
    [[nodiscard]] std::size_t left() const { return left_.size(); }

private:
    void skip_space() {
        bool comment = false;
        while (!left_.empty()) {
            const unsigned char c = left_.front();
            if (c == '#') comment = true;
            else if (c == '\n' || c == '\r') comment = false;
            else if (!comment && c != ' ' && c != '\t' && c != '\v' && c != '\f') return;
            left_ = left_.subspan(1);
        }
    }
    Bytes left_;
};

/// Stores samples, each at most `scale_from`, as RGBA of type T, whose largest number means 1.
template <typename T, typename Next>
void read_samples(std::vector<T>& rgba, std::size_t pixel_count, bool gray, std::uint64_t scale_from, Next next) {
    constexpr std::uint64_t kWhite = static_cast<T>(-1);
    const auto sample = [&] {
        const std::uint64_t value = next();
        if (value > scale_from) throw DecodeError("damaged PPM: a sample is larger than the largest announced");
        return static_cast<T>((value * kWhite + scale_from / 2) / scale_from);
    };
    rgba.resize(pixel_count * 4);
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        rgba[i] = sample();
        rgba[i + 1] = gray ? rgba[i] : sample();
        rgba[i + 2] = gray ? rgba[i] : sample();
        rgba[i + 3] = static_cast<T>(kWhite);
    }
}

}  // namespace

std::string encode_ppm(const Image& image, const Encoding& encoding) {
    Image opaque = image;  // The format has no alpha.
    opaque.alpha.clear();
    std::string out = (encoding.grayscale ? "P5\n" : "P6\n") + std::to_string(image.width) + " " +
                      std::to_string(image.height) + "\n" + std::to_string((1 << encoding.bits) - 1) + "\n";
    if (encoding.bits == 8 && !encoding.grayscale) {
        const std::vector<std::uint8_t> codes = codes8_of(opaque, encoding);
        return out.append(reinterpret_cast<const char*>(codes.data()), codes.size());
    }
    for (const std::uint16_t code : codes_of(opaque, encoding, encoding.bits)) {
        if (encoding.bits > 8) out += static_cast<char>(code >> 8U);
        out += static_cast<char>(code & 0xFFU);
    }
    return out;
}

Decoded decode_pnm(Bytes bytes, std::size_t bytes_per_pixel) {
    const char kind = static_cast<char>(bytes[1]);
    const bool text = kind == '2' || kind == '3';
    const bool gray = kind == '2' || kind == '5';
    Tokens tokens(bytes.subspan(2));
    const std::uint64_t width = tokens.number();
    const std::uint64_t height = tokens.number();
    check_size(width, height, std::max<std::size_t>(bytes_per_pixel, 8));
    const std::uint64_t largest = tokens.number();
    if (largest == 0 || largest > 65535) throw DecodeError("damaged PPM: the largest sample must be 1 to 65535");
    const std::size_t pixel_count = width * height;
    const std::size_t bytes_per_sample = largest > 255 ? 2 : 1;
    const std::size_t sample_count = pixel_count * (gray ? 1 : 3);
    // As text, a digit and a space; the last space may be missing.
    if (tokens.left() < (text ? 2 * sample_count : 1 + bytes_per_sample * sample_count))
        throw DecodeError("damaged PPM: the file is cut off");
    Bytes samples = tokens.after_one_space();
    const auto next = [&]() -> std::uint64_t {
        if (text) return tokens.number();
        std::uint64_t value = samples[0];
        if (bytes_per_sample == 2) value = value << 8 | samples[1];
        samples = samples.subspan(bytes_per_sample);
        return value;
    };
    Decoded decoded;
    decoded.width = static_cast<std::uint32_t>(width);
    decoded.height = static_cast<std::uint32_t>(height);
    if (largest > 255) {
        read_samples(decoded.rgba16, pixel_count, gray, largest, next);
        return decoded;
    }
    std::vector<std::uint8_t> rgba;
    read_samples(rgba, pixel_count, gray, largest, next);
    decoded.rgba8.reserve(pixel_count);
    for (std::size_t i = 0; i < rgba.size(); i += 4)
        decoded.rgba8.push_back(rgba[i] | std::uint32_t{rgba[i + 1]} << 8 | std::uint32_t{rgba[i + 2]} << 16 |
                                std::uint32_t{rgba[i + 3]} << 24);
    return decoded;
}

}  // namespace sundog::output
