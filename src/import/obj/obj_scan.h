// SPDX-License-Identifier: Apache-2.0
// The first step of reading an OBJ file: text to numbers, one chunk of the file at a time, in parallel.
// A chunk knows nothing of the others: what refers across chunks stays as written, for obj_build.h to resolve.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text_file.h"
#include "base/vec.h"

namespace sundog::import {

/// A corner's indices. Written from 1: kept minus 1. Written from the end (negative): kept with kRelative set, as the
/// distance from this chunk's own first vertex plus kRelativeBias. kAbsent where the corner has none.
struct ObjCorner {
    static constexpr std::uint32_t kAbsent = 0xffffffffU;
    static constexpr std::uint32_t kRelative = 0x80000000U;
    static constexpr std::uint32_t kRelativeBias = 0x40000000U;
    std::uint32_t position, texcoord, normal;
};
/// Most vertices of a kind that a file may have, so that indices fit ObjCorner.
inline constexpr std::uint32_t kMostObjVertices = 0x3fffffffU;

/// A statement that changes what the faces after it belong to.
struct ObjChange {
    enum class Kind : std::uint8_t { object, group, smoothing, material, library } kind;
    std::uint32_t line;  ///< Lines of the chunk before it.
    std::uint32_t face;  ///< Faces of the chunk before it.
    std::uint32_t smoothing_group;
    std::string_view text;  ///< The rest of the line, trimmed.
};

/// Something strange but not wrong, kept once a kind (and name) in a chunk.
struct ObjOddity {
    enum class Kind : std::uint8_t {
        unknown_statement,  ///< `name` says which
        not_drawn,          ///< A statement of the specification that makes no surface; `name` says which.
        vertex_weight,
        vertex_color,
        mixed_corners,
    } kind;
    std::uint32_t line;
    const char* at;
    std::string_view name;
};

/// What is wrong with a chunk's first bad line.
struct ObjFault {
    std::uint32_t line;  ///< Lines of the chunk before the (logical) line.
    std::string_view text;
    const char* at;
    std::string message, hint;
};

/// The numbers of one chunk.
struct ObjChunk {
    std::string_view text;
    std::vector<Vec3> positions, normals;
    std::vector<Vec2> texcoords;
    std::vector<ObjCorner> corners;
    std::vector<std::uint32_t> face_ends;  ///< Where in `corners` each face ends.
    std::vector<ObjChange> changes;
    std::vector<ObjOddity> oddities;
    std::optional<ObjFault> fault;
    std::uint32_t line_count = 0;
    std::size_t statement_count = 0;  ///< Known statements.
};

/// Cuts a text into pieces of about `chunk_bytes` that each end where a line ends for sure.
std::vector<std::string_view> split_obj_text(std::string_view text, std::size_t chunk_bytes);

/// Reads one piece. After a faulty line it goes on, so that the counts of vertices stay those of the file.
ObjChunk scan_obj_chunk(std::string_view text);

/// The logical line of a chunk that holds its face number `face` (from 0) and the lines before it: for messages, found
/// by reading again.
struct ObjFaceLine {
    std::string_view text;
    std::uint32_t line = 0;
};
ObjFaceLine find_face_line(const ObjChunk& chunk, std::size_t face);

}  // namespace sundog::import
