// SPDX-License-Identifier: Apache-2.0
#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>

#include "base/scan.h"
#include "import/obj/obj_build.h"

namespace sundog::import {
namespace {

/// A corner's index that refers to nothing.
struct BadIndex {
    std::uint32_t face;
    std::uint32_t corner;  ///< Of the face, from 0.
    const char* kind;
    std::int64_t written;  ///< From 1; 0 or less: before the file's first vertex.
    std::uint32_t count;   ///< Vertices of the kind in the file.
};

/// Turns the encoded index into one from 0 in the file, or keeps kAbsent. False if there is no such vertex.
bool resolve(std::uint32_t& index, std::uint32_t chunk_start, std::uint32_t count, std::int64_t& written) {
    if (index == ObjCorner::kAbsent) return true;
    std::int64_t in_file = index;
    if ((index & ObjCorner::kRelative) != 0)
        in_file = std::int64_t{index & ~ObjCorner::kRelative} - ObjCorner::kRelativeBias + chunk_start;
    written = in_file + 1;
    if (in_file < 0 || in_file >= count) return false;
    index = static_cast<std::uint32_t>(in_file);
    return true;
}

std::optional<BadIndex> resolve_chunk(ObjChunk& chunk, const ObjFile::Start& start, const ObjFile::Start& end) {
    std::uint32_t corner = 0;
    for (std::uint32_t face = 0; face < chunk.face_ends.size(); ++face) {
        const std::uint32_t first = corner;
        for (; corner < chunk.face_ends[face]; ++corner) {
            ObjCorner& c = chunk.corners[corner];
            std::int64_t written = 0;
            if (!resolve(c.position, start.position, end.position, written))
                return BadIndex{face, corner - first, "vertex", written, end.position};
            if (!resolve(c.texcoord, start.texcoord, end.texcoord, written))
                return BadIndex{face, corner - first, "texture vertex", written, end.texcoord};
            if (!resolve(c.normal, start.normal, end.normal, written))
                return BadIndex{face, corner - first, "normal", written, end.normal};
        }
    }
    return std::nullopt;
}

void add_up(ObjFile& file) {
    ObjFile::Start sum;
    std::uint64_t positions = 0, texcoords = 0, normals = 0, lines = 0;
    for (const ObjChunk& chunk : file.chunks) {
        file.starts.push_back(sum);
        positions += chunk.positions.size();
        texcoords += chunk.texcoords.size();
        normals += chunk.normals.size();
        lines += chunk.line_count;
        if (std::max({positions, texcoords, normals}) > kMostObjVertices || lines >= UINT32_MAX) {
            fail_file(file.source.name, "the file is too large",
                      "up to " + std::to_string(kMostObjVertices) + " vertices of a kind are possible");
        }
        sum = {static_cast<std::uint32_t>(positions), static_cast<std::uint32_t>(texcoords),
               static_cast<std::uint32_t>(normals), static_cast<std::uint32_t>(lines)};
    }
    file.starts.push_back(sum);
}

/// Where in a face's line its corner number `corner` stands.
const char* find_corner(std::string_view line, std::uint32_t corner) {
    std::size_t at = 0;
    const auto skip = [&](bool separators) {
        while (at < line.size() && separators == (ends_token(line[at]) || line[at] == '\\')) ++at;
    };
    skip(true);
    for (std::uint32_t words = 0; words <= corner; ++words) skip(false), skip(true);
    return line.data() + at;
}

[[noreturn]] void fail_index(const ObjFile& file, std::size_t chunk, const BadIndex& bad) {
    const ObjFaceLine line = find_face_line(file.chunks[chunk], bad.face);
    const std::string kind = bad.kind;
    std::string message = bad.written > 0 ? "there is no " + kind + ' ' + std::to_string(bad.written)
                                          : "the negative index of a " + kind + " reaches before the first one";
    throw InputError(diagnose(
        Severity::error, file.source, line.text, line_number(file, chunk, line.line),
        find_corner(line.text, bad.corner), std::move(message),
        bad.count == 0 ? "the file has none" : "the file has " + std::to_string(bad.count) + ", counted from 1"));
}

}  // namespace

std::uint32_t line_number(const ObjFile& file, std::size_t chunk, std::uint32_t line) {
    return file.starts[chunk].line + line + 1;
}

ObjFile scan_obj_file(const SourceText& source, std::size_t chunk_bytes) {
    ObjFile file{source, {}, {}};
    const std::vector<std::string_view> pieces = split_obj_text(source.text, chunk_bytes);
    file.chunks.resize(pieces.size());
    tbb::parallel_for(std::size_t{0}, pieces.size(),
                      [&](std::size_t i) { file.chunks[i] = scan_obj_chunk(pieces[i]); });
    add_up(file);

    std::vector<std::optional<BadIndex>> bad(file.chunks.size());
    tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
        bad[i] = resolve_chunk(file.chunks[i], file.starts[i], file.starts.back());
    });
    for (std::size_t i = 0; i < file.chunks.size(); ++i) {
        // Faces behind a faulty line are not kept, so a bad index in the same chunk is the earlier one.
        if (bad[i]) fail_index(file, i, *bad[i]);
        if (const std::optional<ObjFault>& fault = file.chunks[i].fault) {
            throw InputError(diagnose(Severity::error, source, fault->text, line_number(file, i, fault->line),
                                      fault->at, fault->message, fault->hint));
        }
    }
    return file;
}

}  // namespace sundog::import
