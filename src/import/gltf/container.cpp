// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cctype>

#include "base/paths.h"
#include "import/gltf/asset.h"
#include "output/file.h"

namespace sundog::import::gltf {
namespace {

constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534AU;
constexpr std::uint32_t kBinaryChunk = 0x004E4942U;

std::uint32_t word_at(Bytes bytes, std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at]) | static_cast<std::uint32_t>(bytes[at + 1]) << 8U |
           static_cast<std::uint32_t>(bytes[at + 2]) << 16U | static_cast<std::uint32_t>(bytes[at + 3]) << 24U;
}

/// Section 4.4 "Binary glTF Layout".
Container split_binary(const std::string& file, Bytes bytes) {
    const auto name = std::make_shared<const std::string>(file);
    if (bytes.size() < kHeaderBytes) fail_file(name, "the file ends within its header");
    if (word_at(bytes, 4) != 2)
        fail_file(name, "binary glTF of version " + std::to_string(word_at(bytes, 4)), "version 2 is read");
    const std::size_t length = word_at(bytes, 8);
    if (length > bytes.size())
        fail_file(name, "the file is cut off: it has " + std::to_string(bytes.size()) + " of " +
                            std::to_string(length) + " bytes");
    Container container;
    std::size_t at = kHeaderBytes;
    for (std::size_t chunk = 0; at + kChunkHeaderBytes <= length; ++chunk) {
        const std::size_t size = word_at(bytes, at);
        const std::uint32_t type = word_at(bytes, at + 4);
        at += kChunkHeaderBytes;
        if (size > length - at)
            fail_file(name, "chunk " + std::to_string(chunk) + " of " + std::to_string(size) +
                                " bytes reaches beyond the file's end");
        const Bytes content = bytes.subspan(at, size);
        if ((chunk == 0) != (type == kJsonChunk)) fail_file(name, "the first chunk, and no other, must be JSON");
        if (chunk == 0) {
            container.json =
                text_in_memory(file, std::string_view(reinterpret_cast<const char*>(content.data()), content.size()));
        } else if (type == kBinaryChunk && !container.has_binary) {
            container.binary.assign(content.begin(), content.end());
            container.has_binary = true;
        }
        at += size;
    }
    if (!container.json.name) fail_file(name, "the file has no JSON chunk");
    return container;
}

/// The value of a digit in base 64; 64 for others.
constexpr std::array<std::uint8_t, 256> base64_values() {
    std::array<std::uint8_t, 256> values{};
    values.fill(64);
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < kDigits.size(); ++i)
        values[static_cast<unsigned char>(kDigits[i])] = static_cast<std::uint8_t>(i);
    values['-'] = 62, values['_'] = 63;  // RFC 4648's alphabet for URLs.
    return values;
}

std::vector<unsigned char> decode_base64(const Json& uri, std::string_view text) {
    static constexpr std::array<std::uint8_t, 256> kValues = base64_values();
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    std::vector<unsigned char> bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const std::uint8_t value = kValues[static_cast<unsigned char>(c)];
        if (value > 63) uri.fail("the data URI holds " + in_quotes({&c, 1}) + ", which is no base 64");
        bits = bits << 6U | value;
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<unsigned char>(bits >> static_cast<unsigned>(count)));
    }
    return bytes;
}

int hex_value(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    const int lower = std::tolower(static_cast<unsigned char>(c));
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// "a%20b" becomes "a b" (RFC 3986, section 2.1).
std::string percent_decoded(std::string_view uri) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool escape =
            uri[i] == '%' && i + 2 < uri.size() && hex_value(uri[i + 1]) >= 0 && hex_value(uri[i + 2]) >= 0;
        if (!escape) {
            text += uri[i];
            continue;
        }
        text += static_cast<char>(hex_value(uri[i + 1]) * 16 + hex_value(uri[i + 2]));
        i += 2;
    }
    return text;
}

}  // namespace

Container read_container(const std::filesystem::path& file) {
    std::error_code ignored;
    if (is_file(file) && std::filesystem::file_size(file, ignored) > physical_memory_bytes() / 2)
        fail_file(std::make_shared<const std::string>(file.string()),
                  "the file is larger than half of this machine's memory");
    // A text file's own reader explains what else the file may be.
    if (is_file(file)) {
        const std::vector<unsigned char> bytes = output::read_file(file);
        if (bytes.size() >= 4 && word_at(bytes, 0) == 0x46546C67U) return split_binary(file.string(), bytes);
    }
    return {read_text_file(file), {}, false};
}

std::optional<std::vector<unsigned char>> decode_data_uri(const Json& uri) {
    const std::string_view text = uri.string();
    if (!text.starts_with("data:")) return std::nullopt;
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos) uri.fail("the data URI has no ','");
    if (text.substr(0, comma).ends_with(";base64")) return decode_base64(uri, text.substr(comma + 1));
    const std::string plain = percent_decoded(text.substr(comma + 1));
    return std::vector<unsigned char>(plain.begin(), plain.end());
}

std::filesystem::path file_of_uri(const std::filesystem::path& named_in, std::string_view uri) {
    const std::filesystem::path decoded = find_file(named_in, percent_decoded(uri));
    return decoded.empty() ? find_file(named_in, uri) : decoded;
}

}  // namespace sundog::import::gltf
