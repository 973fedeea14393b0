// SPDX-License-Identifier: Apache-2.0
// Files: finding them, and #fopen, #fclose, #read and #write (manual, 3.3.2.3).
#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/paths.h"
#include "base/text_file.h"
#include "import/pov/interpreter_core.h"
#include "import/pov/literal_list.h"

namespace sundog::pov {
namespace fs = std::filesystem;

FileFinder::FileFinder(fs::path scene_folder, const PovOptions& options)
    : scene_folder_(std::move(scene_folder)),
      writable_(options.access.writable),
      library_paths_(options.library_paths) {
    if (options.access.sandbox) {
        std::vector<fs::path> readable = library_paths_;
        readable.push_back(scene_folder_);
        readable.insert(readable.end(), writable_.begin(), writable_.end());
        access_.confine_reading(readable);
    }
    for (const fs::path& folder : writable_) access_.allow_writing(folder);
}

std::vector<fs::path> FileFinder::candidates(std::string_view name, const fs::path& named_in) const {
    std::string text(name);
    std::replace(text.begin(), text.end(), '\\', '/');
    const fs::path path(text);
    if (path.is_absolute()) return {path};
    std::vector<fs::path> folders;
    if (!named_in.empty()) folders.push_back(named_in.parent_path());
    folders.push_back(scene_folder_);
    folders.insert(folders.end(), writable_.begin(), writable_.end());
    folders.insert(folders.end(), library_paths_.begin(), library_paths_.end());
    std::vector<fs::path> found;
    for (const fs::path& folder : folders) found.push_back(folder / path);
    return found;
}

fs::path FileFinder::find(std::string_view name, const fs::path& named_in) const {
    for (const fs::path& file : candidates(name, named_in))
        if (is_file(file) && !access_.why_unreadable(file)) return file;
    return {};
}

std::string FileFinder::why_not_found(std::string_view name, const fs::path& named_in) const {
    std::string folders;
    for (const fs::path& file : candidates(name, named_in)) {
        if (const auto reason = access_.why_unreadable(file); reason && fs::exists(fs::symlink_status(file)))
            return *reason;
        const std::string folder = file.parent_path().string();
        folders += (folders.empty() ? "" : ", ") + (folder.empty() ? "." : folder);
    }
    return "sought in " + folders;
}

fs::path FileFinder::output_path(std::string_view name) const {
    const fs::path path(name);
    return path.is_absolute() ? path : (writable_.empty() ? scene_folder_ : writable_.front()) / path;
}

fs::path Interpreter::find_file(const std::string& name, Spot where) {
    const fs::path named_in = frames_.empty() ? fs::path{} : frames_.back().file->path;
    fs::path found = finder_.find(name, named_in);
    if (found.empty()) fail(where, "can't find the file " + in_quotes(name), finder_.why_not_found(name, named_in));
    return found;
}

const TokenFile& Interpreter::tokens_of(const fs::path& path, Spot where) {
    const TokenFile*& known = tokens_by_path_[path.lexically_normal().string()];
    if (known != nullptr) return *known;
    if (const auto reason = finder_.access().why_unreadable(path))
        fail(where, "can't read the file " + in_quotes(path.string()), *reason);
    SourceText source = read_text_file(path);
    const std::uint32_t file = sources_.add(path, source);
    token_files_.push_back(tokenise(file, path, source, names_));
    check_memory();
    return *(known = token_files_.back().get());
}

void Interpreter::run_fopen() {
    const Spot where = raw_place();
    const NameId handle = raw_name("an identifier for the file");
    const std::string name = parse_string();
    const Lookahead& mode = peek();
    const bool reads = mode.is(Keyword::read), appends = mode.is(Keyword::append);
    if (!reads && !appends && !mode.is(Keyword::write)) fail_expected("read, write or append");
    take();
    auto file = std::make_shared<OpenFile>();
    file->path = name;
    if (reads) {
        const fs::path path = find_file(name, where);
        if (const auto reason = finder_.access().why_unreadable(path))
            fail(where, "can't read " + in_quotes(name), *reason);
        file->text = std::string(read_text_file(path).text);
        tick(file->text.size() / 16);
    } else {
        const fs::path path = finder_.output_path(name);
        if (const auto reason = finder_.access().why_unwritable(path))
            fail(where, "can't write to " + in_quotes(name), *reason);
        file->mode = OpenFile::Mode::write;
        file->out.open(path, appends ? std::ios::app | std::ios::binary : std::ios::binary);
        if (!file->out) fail(where, "can't open " + in_quotes(name) + " for writing");
        // What was read from it before is no longer what it holds.
        tokens_by_path_.erase(path.lexically_normal().string());
    }
    identifiers_.declare(handle) = std::move(file);
}

namespace {

std::shared_ptr<OpenFile> open_file(Entity* entity) {
    auto* file = entity == nullptr ? nullptr : std::get_if<std::shared_ptr<OpenFile>>(entity);
    return file == nullptr ? nullptr : *file;
}

/// A number with its sign, or nothing.
std::optional<double> signed_number(const char*& at, const char* end) {
    const char* p = at;
    if (!skip_blanks(p, end) || p >= end) return std::nullopt;
    const bool negative = *p == '-';
    if (*p == '-' || *p == '+') ++p;
    if (p >= end || !((*p >= '0' && *p <= '9') || (*p == '.' && p + 1 < end && p[1] >= '0' && p[1] <= '9')))
        return std::nullopt;
    const double number = scan_number(p);
    at = p;
    return negative ? -number : number;
}

}  // namespace

void Interpreter::run_fclose() {
    const Spot where = raw_place();
    const NameId handle = raw_name("an open file");
    if (open_file(identifiers_.find(handle)) == nullptr)
        return warn_once(where, "fclose", "#fclose of " + in_quotes(names_.text(handle)) + ", which is no open file");
    identifiers_.undefine(handle);
}

bool Interpreter::read_datum(OpenFile& file, Entity& into, Spot where) {
    const char* const begin = file.text.data();
    const char* const end = begin + file.text.size();
    const char* at = begin + file.next;
    const auto wrong = [&] {
        const auto line = 1 + std::count(begin, at, '\n');
        fail(where,
             "line " + std::to_string(line) + " of " + in_quotes(file.path) + " has no float, vector or string there");
    };
    skip_blanks(at, end);
    if (at < end && *at == ',') ++at;
    skip_blanks(at, end);
    if (at >= end) return false;
    if (*at == '"') {
        const char* const close = std::find(at + 1, end, '"');
        if (close == end) wrong();
        into = std::string(at + 1, close);
        at = close + 1;
    } else if (*at == '<') {
        Value value;
        value.count = 0;
        ++at;
        while (value.count < 5) {
            const auto number = signed_number(at, end);
            if (!number) wrong();
            value.v[value.count++] = *number;
            skip_blanks(at, end);
            if (at < end && *at == '>') break;
            if (at < end && *at == ',') ++at;
        }
        if (at >= end || *at != '>') wrong();
        ++at;
        into = value;
    } else {
        const auto number = signed_number(at, end);
        if (!number) wrong();
        into = number_value(*number);
    }
    skip_blanks(at, end);
    if (at < end && *at == ',') ++at;
    skip_blanks(at, end);
    file.next = static_cast<std::size_t>(at - begin);
    return true;
}

void Interpreter::run_read() {
    expect(TokenKind::left_paren, "after #read");
    const Spot where = raw_place();
    const NameId handle = raw_name("an open file");
    const std::shared_ptr<OpenFile> file = open_file(identifiers_.find(handle));
    if (!file || file->mode != OpenFile::Mode::read)
        fail(where, in_quotes(names_.text(handle)) + " is no file that was opened to read");
    bool more = true;
    while (accept(TokenKind::comma)) {
        const Spot place = raw_place();
        const NameId name = raw_name("an identifier to read into");
        Entity value;
        if (peek_raw_kind() == TokenKind::left_bracket) {
            const std::vector<std::size_t> path = parse_subscripts(name, place);
            more = more && read_datum(*file, value, place);
            if (more) element_at(name, path, place) = std::move(value);
        } else {
            more = more && read_datum(*file, value, place);
            if (more) identifiers_.declare(name) = std::move(value);
        }
    }
    expect(TokenKind::right_paren, "after the identifiers of #read");
    // The end of the file is told by its identifier being gone.
    if (!more || file->next >= file->text.size()) identifiers_.undefine(handle);
}

void Interpreter::run_write() {
    expect(TokenKind::left_paren, "after #write");
    const Spot where = raw_place();
    const NameId handle = raw_name("an open file");
    const std::shared_ptr<OpenFile> file = open_file(identifiers_.find(handle));
    if (!file || file->mode != OpenFile::Mode::write)
        fail(where, in_quotes(names_.text(handle)) + " is no file that was opened to write");
    while (peek().kind != TokenKind::right_paren) {
        if (accept(TokenKind::comma)) continue;
        if (const Lookahead& ahead = peek(); ahead.kind == TokenKind::keyword)
            if (const auto word = binary_word(static_cast<Keyword>(ahead.payload))) {
                take();
                accept(TokenKind::comma);
                while (peek().kind != TokenKind::comma && peek().kind != TokenKind::right_paren) {
                    const Value value = parse_expression();
                    for (std::uint8_t i = 0; i < value.count; ++i) file->out << word->bytes_of(value.v[i]);
                }
                continue;
            }
        if (starts_string()) {
            file->out << parse_string();
            continue;
        }
        const Value value = parse_expression();
        std::string text;
        for (std::uint8_t i = 0; i < value.count; ++i) {
            std::array<char, 40> buffer{};
            std::snprintf(buffer.data(), buffer.size(), "%.6g", value.v[i]);
            text += (i > 0 ? ", " : "") + std::string(buffer.data());
        }
        file->out << (value.count > 1 ? "<" + text + ">" : text);
        tick(4);
    }
    expect(TokenKind::right_paren, "after the data of #write");
    if (!file->out) fail(where, "can't write to " + in_quotes(file->path));
}

std::optional<Interpreter::BinaryWord> Interpreter::binary_word(Keyword keyword) {
    using enum Keyword;
    switch (keyword) {
        case uint8:
            return BinaryWord{1, false, false};
        case sint8:
            return BinaryWord{1, true, false};
        case uint16be:
            return BinaryWord{2, false, true};
        case uint16le:
            return BinaryWord{2, false, false};
        case sint16be:
            return BinaryWord{2, true, true};
        case sint16le:
            return BinaryWord{2, true, false};
        case sint32be:
            return BinaryWord{4, true, true};
        case sint32le:
            return BinaryWord{4, true, false};
        default:
            return std::nullopt;
    }
}

std::string Interpreter::BinaryWord::bytes_of(double number) const {
    const double states = std::ldexp(1.0, static_cast<int>(8 * bytes));
    const double least = is_signed ? -states / 2 : 0;
    const auto whole = static_cast<std::int64_t>(std::clamp(std::round(number), least, least + states - 1));
    std::string text;
    for (std::uint32_t i = 0; i < bytes; ++i) {
        const std::uint32_t shift = 8 * (big_endian ? bytes - 1 - i : i);
        text += static_cast<char>(static_cast<std::uint64_t>(whole) >> shift & 0xffU);
    }
    return text;
}

void interpret(const fs::path& file, const PovOptions& options, SourceFiles& sources, BlockSink& sink,
               GeometryQueries* queries, const WarningSink& warn) {
    SourceText source = read_text_file(file);
    fs::path folder = file.parent_path();
    if (folder.empty()) folder = ".";
    Interpreter(options, std::move(folder), sources, sink, queries, warn).run(file, source);
}

void interpret_text(std::string name, std::string_view text, const fs::path& folder, const PovOptions& options,
                    SourceFiles& sources, BlockSink& sink, GeometryQueries* queries, const WarningSink& warn) {
    const fs::path file = folder / name;
    Interpreter(options, folder, sources, sink, queries, warn).run(file, text_in_memory(std::move(name), text));
}

}  // namespace sundog::pov
