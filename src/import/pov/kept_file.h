// SPDX-License-Identifier: Apache-2.0
// Files of Sundog's own that keep what one picture has computed for another one: numbers, lowest byte first.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "import/pov/build_context.h"

namespace sundog::pov {

inline void append_word(std::uint32_t word, std::string& bytes) {
    for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 255U);
}
inline void append_float(float value, std::string& bytes) { append_word(std::bit_cast<std::uint32_t>(value), bytes); }

inline std::uint32_t word_at(const char* bytes) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k)
        word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[k])) << (8 * k);
    return word;
}
inline float float_at(const char* bytes) { return std::bit_cast<float>(word_at(bytes)); }

/// The contents of the file that a scene names at a place; `what` is told in messages ("photons"). The scene's list of
/// files gets it. Errors: InputError at that place.
std::string read_kept_file(BuildContext& context, std::string_view name, Place where, const std::string& what);

/// Where the file that a scene wants to write at a place is to be. Errors: InputError there for what may not be
/// written.
std::filesystem::path kept_file(BuildContext& context, std::string_view name, Place where);

/// Writes a file, whole or not at all.
void write_kept_file(const std::filesystem::path& file, const std::string& bytes);

}  // namespace sundog::pov
