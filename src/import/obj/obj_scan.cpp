// SPDX-License-Identifier: Apache-2.0
#include "import/obj/obj_scan.h"

#include <algorithm>
#include <array>

#include "base/scan.h"

namespace sundog::import {
namespace {

/// Statements of the specification that describe no polygon; they are named once each and skipped.
constexpr std::array<std::string_view, 36> kNotDrawn = {
    "vp",       "p",    "l",     "curv",  "curv2",      "surf",      "cstype", "deg",    "bmat",
    "step",     "parm", "trim",  "hole",  "scrv",       "sp",        "end",    "con",    "mg",
    "bevel",    "lod",  "ctech", "stech", "shadow_obj", "trace_obj", "usemap", "maplib", "c_interp",
    "d_interp", "bsp",  "bzp",   "cdc",   "cdp",        "res",       "call",   "csh",    "scmp"};

constexpr std::size_t kMostOdditiesPerChunk = 64;

/// Reads one chunk. `at_` always stands inside the chunk or behind its last newline.
class ChunkScanner {
public:
    ChunkScanner(ObjChunk& chunk, std::string_view text)
        : chunk_(chunk), at_(text.data()), end_(text.data() + text.size()) {
        chunk_.text = text;
    }

    void run() {
        while (at_ < end_) {
            line_begin_ = at_;
            line_first_ = line_;
            statement();
            finish_line();
        }
        chunk_.line_count = line_;
    }

private:
    static bool continues(const char* p) { return *p == '\\' && (p[1] == '\n' || (p[1] == '\r' && p[2] == '\n')); }

    void skip_blanks() {
        while (is_blank(*at_)) ++at_;
        while (*at_ == '\\' && continues(at_)) {
            at_ += at_[1] == '\n' ? 2 : 3;
            ++line_;
            while (at_ < end_ && is_blank(*at_)) ++at_;
        }
    }

    [[nodiscard]] bool at_line_end() const { return *at_ == '\n' || *at_ == '#' || at_ >= end_; }

    void statement() {
        skip_blanks();
        if (at_line_end()) return;
        statement_begin_ = at_;
        const char first = *at_;
        if (first == 'v') {
            const char second = at_[1];
            if (is_blank(second)) return at_ += 1, position();
            if (second == 'n' && is_blank(at_[2])) return at_ += 2, normal();
            if (second == 't' && is_blank(at_[2])) return at_ += 2, texcoord();
        } else if (first == 'f' && is_blank(at_[1])) {
            return at_ += 1, face();
        }
        other_statement();
    }

    /// Leaves `at_` behind the line's newline. A comment goes to the end of its physical line.
    void finish_line() {
        const bool comment = *at_ == '#';
        while (at_ < end_ && *at_ != '\n') {
            if (!comment && *at_ == '\\' && continues(at_)) {
                at_ += at_[1] == '\n' ? 2 : 3;
                ++line_;
            } else {
                ++at_;
            }
        }
        ++at_;
        ++line_;
    }

    void fail(const char* at, std::string message, std::string hint = {}) {
        if (chunk_.fault) return;
        // The logical line's end: only for the message, so finding it may be slow.
        const char* end = at_;
        while (end < end_ && (*end != '\n' || end[-1] == '\\' || (end[-1] == '\r' && end[-2] == '\\'))) ++end;
        const std::string_view text(line_begin_, static_cast<std::size_t>(end - line_begin_));
        chunk_.fault = ObjFault{line_first_, text, at, std::move(message), std::move(hint)};
    }

    std::string_view token_at(const char* p) const {
        const char* last = p;
        while (last < end_ && !ends_token(*last)) ++last;
        return {p, static_cast<std::size_t>(last - p)};
    }

    void note(ObjOddity::Kind kind, const char* at, std::string_view name = {}) {
        for (const ObjOddity& known : chunk_.oddities)
            if (known.kind == kind && known.name == name) return;
        if (chunk_.oddities.size() < kMostOdditiesPerChunk) chunk_.oddities.push_back({kind, line_, at, name});
    }

    /// One number of a vertex. False (and a fault) if there is none.
    bool number(float& value, std::string_view statement_form) {
        skip_blanks();
        const Scan scan = at_line_end() ? Scan::malformed : scan_float(at_, value);
        if (scan == Scan::ok && (ends_token(*at_) || continues(at_))) [[likely]]
            return true;
        if (at_line_end() && scan != Scan::ok)
            fail(at_, "the line ends too early", "expected " + std::string(statement_form));
        else if (scan == Scan::too_large)
            fail(at_, "number out of range: " + in_quotes(token_at(at_)), "magnitudes up to 3.4e38 are possible");
        else bad_number(statement_form);
        return false;
    }

    void bad_number(std::string_view statement_form) {
        const char* first = at_;
        while (first > line_begin_ && !ends_token(first[-1])) --first;
        fail(first, "bad number " + in_quotes(token_at(first)), "expected " + std::string(statement_form));
    }

    /// Reads the rest of the line's numbers into `extra`; returns how many there were or -1 after a fault.
    int more_numbers(std::array<float, 4>& extra, std::string_view statement_form) {
        int count = 0;
        for (skip_blanks(); !at_line_end(); skip_blanks()) {
            float value = 0;
            const char* const first = at_;
            if (!number(value, statement_form)) return -1;
            if (count == static_cast<int>(extra.size())) {
                fail(first, "too many numbers", "expected " + std::string(statement_form));
                return -1;
            }
            extra[static_cast<std::size_t>(count++)] = value;
        }
        return count;
    }

    void position() {
        constexpr std::string_view kForm = "v x y z, v x y z w or v x y z r g b";
        Vec3 p;
        ++chunk_.statement_count;
        const bool good = number(p.x, kForm) && number(p.y, kForm) && number(p.z, kForm);
        chunk_.positions.push_back(p);
        if (!good) return;
        skip_blanks();
        if (*at_ == '\n') [[likely]]
            return;
        const char* const first = at_;
        std::array<float, 4> extra{};
        const int count = more_numbers(extra, kForm);
        if (count == 1 && extra[0] != 1) note(ObjOddity::Kind::vertex_weight, first);
        if (count == 2) fail(first, "a vertex of five numbers", "expected " + std::string(kForm));
        if (count >= 3) note(ObjOddity::Kind::vertex_color, first);
    }

    void normal() {
        constexpr std::string_view kForm = "vn x y z";
        Vec3 n;
        ++chunk_.statement_count;
        const bool good = number(n.x, kForm) && number(n.y, kForm) && number(n.z, kForm);
        chunk_.normals.push_back(n);
        if (good) expect_line_end(kForm);
    }

    void texcoord() {
        constexpr std::string_view kForm = "vt u, vt u v or vt u v w";
        Vec2 uv;
        ++chunk_.statement_count;
        if (number(uv.x, kForm)) {
            std::array<float, 4> extra{};
            const char* const first = at_;
            const int count = more_numbers(extra, kForm);
            if (count >= 1) uv.y = extra[0];
            if (count > 2) fail(first, "too many numbers", "expected " + std::string(kForm));
        }
        chunk_.texcoords.push_back(uv);
    }

    void expect_line_end(std::string_view form) {
        skip_blanks();
        if (at_line_end()) return;
        fail(at_, "unexpected " + in_quotes(token_at(at_)) + " at the end of the line",
             "expected " + std::string(form));
    }

    /// One index of a corner, resolved against `count` vertices of this chunk where written from the end.
    bool index(std::uint32_t& encoded, std::size_t count) {
        const char* const first = at_;
        std::int32_t written = 0;
        const Scan scan = scan_int(at_, written);
        if (scan == Scan::ok && written > 0 && written <= static_cast<std::int32_t>(kMostObjVertices)) [[likely]] {
            encoded = static_cast<std::uint32_t>(written) - 1;
            return true;
        }
        if (scan == Scan::ok && written < 0 && written >= -static_cast<std::int32_t>(kMostObjVertices)) {
            encoded = ObjCorner::kRelative | (static_cast<std::uint32_t>(count) + ObjCorner::kRelativeBias -
                                              static_cast<std::uint32_t>(-written));
            return true;
        }
        if (scan == Scan::malformed)
            fail(first, "bad corner " + in_quotes(token_at(corner_)), "expected v, v/t, v//n or v/t/n, whole numbers");
        else if (scan == Scan::ok && written == 0)
            fail(first, "index 0", "indices count from 1, or from -1 for the last vertex so far");
        else fail(first, "index out of range: " + in_quotes(token_at(first)));
        return false;
    }

    bool corner(ObjCorner& c) {
        corner_ = at_;
        c = {ObjCorner::kAbsent, ObjCorner::kAbsent, ObjCorner::kAbsent};
        if (!index(c.position, chunk_.positions.size())) return false;
        if (*at_ == '/') {
            ++at_;
            if (*at_ != '/' && !index(c.texcoord, chunk_.texcoords.size())) return false;
            if (*at_ == '/') {
                ++at_;
                if (!index(c.normal, chunk_.normals.size())) return false;
            }
        }
        if (ends_token(*at_) || continues(at_)) [[likely]]
            return true;
        fail(corner_, "bad corner " + in_quotes(token_at(corner_)), "expected v, v/t, v//n or v/t/n, whole numbers");
        return false;
    }

    void face() {
        ++chunk_.statement_count;
        const char* const keyword = statement_begin_;
        const std::size_t first_corner = chunk_.corners.size();
        bool all_texcoords = true, all_normals = true, any_texcoord = false, any_normal = false;
        for (skip_blanks(); !at_line_end(); skip_blanks()) {
            ObjCorner c;
            if (!corner(c)) break;
            const bool has_texcoord = c.texcoord != ObjCorner::kAbsent;
            const bool has_normal = c.normal != ObjCorner::kAbsent;
            all_texcoords &= has_texcoord, any_texcoord |= has_texcoord;
            all_normals &= has_normal, any_normal |= has_normal;
            chunk_.corners.push_back(c);
        }
        const std::size_t count = chunk_.corners.size() - first_corner;
        if (count < 3 && at_line_end()) {
            fail(keyword, "a face of " + std::to_string(count) + (count == 1 ? " corner" : " corners"),
                 "a face has three or more corners");
        }
        if (count < 3 || chunk_.fault) {
            chunk_.corners.resize(first_corner);
            return;
        }
        if (any_texcoord != all_texcoords || any_normal != all_normals) {
            note(ObjOddity::Kind::mixed_corners, keyword);
            for (std::size_t i = first_corner; i < chunk_.corners.size(); ++i) {
                if (!all_texcoords) chunk_.corners[i].texcoord = ObjCorner::kAbsent;
                if (!all_normals) chunk_.corners[i].normal = ObjCorner::kAbsent;
            }
        }
        chunk_.face_ends.push_back(static_cast<std::uint32_t>(chunk_.corners.size()));
    }

    /// The rest of the logical line, trimmed.
    std::string_view rest() {
        skip_blanks();
        const char* const first = at_;
        const char* last = first;
        while (last < end_ && *last != '\n') ++last;
        at_ = last;
        while (last > first && is_blank(last[-1])) --last;
        return {first, static_cast<std::size_t>(last - first)};
    }

    void change(ObjChange::Kind kind, std::string_view text, std::uint32_t smoothing_group = 0) {
        ++chunk_.statement_count;
        chunk_.changes.push_back(
            {kind, line_first_, static_cast<std::uint32_t>(chunk_.face_ends.size()), smoothing_group, text});
    }

    void smoothing() {
        const std::string_view text = rest();
        std::int32_t group = 0;
        const char* p = text.data();
        if (text != "off" && text != "on") {
            const bool good = scan_int(p, group) == Scan::ok && p == text.data() + text.size() && group >= 0;
            if (!good) {
                at_ = text.data();
                fail(at_, "bad smoothing group " + in_quotes(text), "expected a number, or off");
                return;
            }
        } else if (text == "on") {
            group = 1;
        }
        change(ObjChange::Kind::smoothing, text, static_cast<std::uint32_t>(group));
    }

    void named(ObjChange::Kind kind, std::string_view form) {
        const std::string_view text = rest();
        if (text.empty()) fail(at_, "the line ends too early", "expected " + std::string(form));
        else change(kind, text);
    }

    void other_statement() {
        const char* const first = at_;
        const std::string_view keyword = token_at(first);
        at_ += keyword.size();
        if (keyword == "usemtl") return named(ObjChange::Kind::material, "usemtl and a material's name");
        if (keyword == "mtllib") return named(ObjChange::Kind::library, "mtllib and file names");
        if (keyword == "s") return smoothing();
        if (keyword == "fo") return face();
        // A nameless group or object is the default one.
        if (keyword == "g") return change(ObjChange::Kind::group, rest());
        if (keyword == "o") return change(ObjChange::Kind::object, rest());
        if (keyword == "v" || keyword == "vn" || keyword == "vt" || keyword == "f") {
            // Only the line's end can follow: with a blank behind it, statement() would have known it.
            fail(at_, "the line ends too early", "expected numbers after " + in_quotes(keyword));
            return;
        }
        if (std::find(kNotDrawn.begin(), kNotDrawn.end(), keyword) != kNotDrawn.end()) {
            ++chunk_.statement_count;
            return note(ObjOddity::Kind::not_drawn, first, keyword);
        }
        note(ObjOddity::Kind::unknown_statement, first, keyword);
    }

    ObjChunk& chunk_;
    const char* at_;
    const char* end_;
    const char* line_begin_ = nullptr;
    const char* statement_begin_ = nullptr;
    const char* corner_ = nullptr;
    std::uint32_t line_ = 0;        ///< Newlines passed.
    std::uint32_t line_first_ = 0;  ///< Newlines before the logical line.
};

}  // namespace

std::vector<std::string_view> split_obj_text(std::string_view text, std::size_t chunk_bytes) {
    std::vector<std::string_view> pieces;
    while (!text.empty()) {
        std::size_t end = text.size();
        for (std::size_t from = chunk_bytes; from < text.size();) {
            const std::size_t newline = text.find('\n', from);
            if (newline == std::string_view::npos) break;
            // Not behind a backslash: it might continue the line (or end a comment; the next newline is as good).
            std::size_t before = newline;
            if (before > 0 && text[before - 1] == '\r') --before;
            if (before == 0 || text[before - 1] != '\\') {
                end = newline + 1;
                break;
            }
            from = newline + 1;
        }
        pieces.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return pieces;
}

ObjChunk scan_obj_chunk(std::string_view text) {
    ObjChunk chunk;
    ChunkScanner(chunk, text).run();
    return chunk;
}

ObjFaceLine find_face_line(const ObjChunk& chunk, std::size_t face) {
    // Scanning ever longer prefixes would be slow; scan line by line instead, each as a chunk of its own.
    ObjFaceLine found;
    std::string_view rest = chunk.text;
    std::size_t faces = 0;
    while (!rest.empty()) {
        std::string_view line = split_obj_text(rest, 1).front();
        // Blank first lines of one byte: split_obj_text looks for a newline from byte 1 on.
        if (rest.front() == '\n') line = rest.substr(0, 1);
        const ObjChunk one = scan_obj_chunk(line);
        if (faces + one.face_ends.size() > face) {
            found.text = line.substr(0, line.find_last_not_of('\n') + 1);
            return found;
        }
        faces += one.face_ends.size();
        found.line += one.line_count;
        rest.remove_prefix(line.size());
    }
    return found;
}

}  // namespace sundog::import
