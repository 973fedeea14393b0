// SPDX-License-Identifier: Apache-2.0
#include "base/text_file.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <new>
#include <system_error>

#include "base/scan.h"

namespace sundog {
namespace {

constexpr std::size_t kSentinelBytes = 2;

/// Reads up to `size` bytes; returns how many there were.
std::size_t read_up_to(std::ifstream& in, char* to, std::size_t size) {
    in.read(to, static_cast<std::streamsize>(size));
    return static_cast<std::size_t>(in.gcount());
}

void refuse_binary(std::string_view start, const std::shared_ptr<const std::string>& name) {
    if (start.starts_with("\xff\xfe") || start.starts_with("\xfe\xff"))
        fail_file(name, "the file is UTF-16 text", "save it as UTF-8 or ASCII");
    if (start.find('\0') != std::string_view::npos) fail_file(name, "not a text file: it holds binary data");
}

/// Finishes a buffer of `size` bytes and kSentinelBytes more.
SourceText make_text(std::shared_ptr<const std::string> name, const std::shared_ptr<char[]>& bytes, std::size_t size) {
    for (std::size_t i = 0; i < kSentinelBytes; ++i) bytes[size + i] = '\n';
    std::string_view text(bytes.get(), size);
    if (text.find('\n') == std::string_view::npos) std::replace(bytes.get(), bytes.get() + size, '\r', '\n');
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    return {std::move(name), bytes, text};
}

}  // namespace

std::size_t physical_memory_bytes() {
    std::ifstream in("/proc/meminfo");
    std::string label;
    std::size_t kibibytes = 0;
    return in >> label >> kibibytes && label == "MemTotal:" ? kibibytes * 1024 : SIZE_MAX;
}

Diagnostic diagnose_file(Severity severity, const std::shared_ptr<const std::string>& name, std::string message,
                         std::string hint) {
    Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.where.file = name;
    diagnostic.message = std::move(message);
    diagnostic.hint = std::move(hint);
    return diagnostic;
}

void fail_file(const std::shared_ptr<const std::string>& name, std::string message, std::string hint) {
    throw InputError(diagnose_file(Severity::error, name, std::move(message), std::move(hint)));
}

SourceText read_text_file(const std::filesystem::path& file) {
    auto name = std::make_shared<const std::string>(file.string());
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::not_found) fail_file(name, "no such file");
    if (error) fail_file(name, "can't open the file: " + error.message());
    if (std::filesystem::is_directory(status)) fail_file(name, "this is a folder", "name a file");
    // Reading a device may never end.
    if (!std::filesystem::is_regular_file(status))
        fail_file(name, "not a regular file", "devices and pipes are not read");
    std::ifstream in(file, std::ios::binary);
    const std::size_t size = std::filesystem::file_size(file, error);
    if (!in || error) {
        fail_file(name, "can't open the file: " +
                            (error ? error : std::error_code(errno, std::generic_category())).message());
    }
    char start[4096];
    const std::size_t start_size = read_up_to(in, start, std::min(size, sizeof start));
    refuse_binary({start, start_size}, name);
    if (size > physical_memory_bytes() / 2)
        fail_file(name,
                  "the file is larger than half of this machine's memory (" + std::to_string(size >> 20U) + " MiB)");

    std::shared_ptr<char[]> bytes;
    try {
        bytes = std::shared_ptr<char[]>(std::make_unique_for_overwrite<char[]>(size + kSentinelBytes));
    } catch (const std::bad_alloc&) {
        fail_file(name, "not enough memory for the file (" + std::to_string(size >> 20U) + " MiB)");
    }
    std::copy_n(start, start_size, bytes.get());
    const std::size_t rest = size > start_size ? size - start_size : 0;
    const std::size_t total = start_size + read_up_to(in, bytes.get() + start_size, rest);
    return make_text(std::move(name), bytes, total);
}

SourceText text_in_memory(std::string name, std::string_view text) {
    const std::shared_ptr<char[]> bytes(std::make_unique_for_overwrite<char[]>(text.size() + kSentinelBytes));
    std::copy(text.begin(), text.end(), bytes.get());
    return make_text(std::make_shared<const std::string>(std::move(name)), bytes, text.size());
}

Diagnostic diagnose(Severity severity, const SourceText& source, std::string_view line, std::uint32_t line_number,
                    const char* at, std::string message, std::string hint) {
    const char* begin = line.data();
    const char* const end = line.data() + line.size();
    for (const char* p = begin; p < at; ++p) {
        if (*p != '\n') continue;
        ++line_number;
        begin = p + 1;
    }
    const char* shown_end = std::find(begin, std::max(begin, end), '\n');
    if (shown_end > begin && shown_end[-1] == '\r') --shown_end;
    const auto column = static_cast<std::uint32_t>(at - begin) + 1;
    // A hostile line may be as long as the file: keep what format() can show.
    constexpr std::ptrdiff_t kKeptAround = 400;
    Diagnostic diagnostic{severity, {source.name, line_number, column}, std::move(message), {}, std::move(hint)};
    if (at - begin <= kKeptAround) diagnostic.source_line.assign(begin, std::min(shown_end, begin + 2 * kKeptAround));
    else diagnostic.source_line.assign(begin, std::min(shown_end, at + kKeptAround));
    return diagnostic;
}

std::string in_quotes(std::string_view token) {
    constexpr std::size_t kMost = 40;
    std::string text = "'";
    for (const char c : token.substr(0, kMost)) text += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
    return text + (token.size() > kMost ? "...'" : "'");
}

LineCursor::LineCursor(const SourceText& source, std::string_view line, std::uint32_t number, const char* at)
    : source_(&source),
      line_(line),
      at_(at != nullptr ? at : line.data()),
      end_(line.data() + line.size()),
      number_(number) {}

const char* LineCursor::here() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
    return at_;
}

std::string_view LineCursor::peek() {
    const char* const first = here();
    const char* last = first;
    while (last != end_ && !is_blank(*last)) ++last;
    return {first, static_cast<std::size_t>(last - first)};
}

std::string_view LineCursor::token(std::string_view expected) {
    const std::string_view next = peek();
    if (next.empty()) fail(at_, "the line ends too early", "expected " + std::string(expected));
    at_ += next.size();
    return next;
}

std::string_view LineCursor::name(std::string_view expected) {
    if (at_end() || *at_ != '"') return token(expected);
    const char* const close = std::find(at_ + 1, end_, '"');
    if (close == end_) fail(at_, "the quote is never closed", "expected " + std::string(expected));
    const std::string_view inside(at_ + 1, static_cast<std::size_t>(close - at_ - 1));
    if (inside.empty()) fail(at_, "empty name", "expected " + std::string(expected));
    at_ = close + 1;
    return inside;
}

std::string_view LineCursor::rest(std::string_view expected) {
    const char* const first = here();
    const char* last = end_;
    while (last != first && is_blank(last[-1])) --last;
    std::string_view text(first, static_cast<std::size_t>(last - first));
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    if (text.empty()) fail(first, "the line ends too early", "expected " + std::string(expected));
    at_ = end_;
    return text;
}

float LineCursor::number(std::string_view expected) {
    const std::string_view next = token(expected);
    const char* p = next.data();
    float value = 0;
    const Scan scan = scan_float(p, value);
    if (scan == Scan::too_large)
        fail(next.data(), "number out of range: " + in_quotes(next), "magnitudes up to 3.4e38 are possible");
    if (scan != Scan::ok || p != next.data() + next.size())
        fail(next.data(), "bad number " + in_quotes(next), "expected " + std::string(expected));
    return value;
}

int LineCursor::integer(std::string_view expected) {
    const std::string_view next = token(expected);
    const char* p = next.data();
    std::int32_t value = 0;
    const Scan scan = scan_int(p, value);
    if (scan == Scan::too_large) fail(next.data(), "number out of range: " + in_quotes(next));
    if (scan != Scan::ok || p != next.data() + next.size())
        fail(next.data(), "bad whole number " + in_quotes(next), "expected " + std::string(expected));
    return value;
}

bool LineCursor::maybe_number(float& value) {
    const std::string_view next = peek();
    const char* p = next.data();
    if (next.empty() || scan_float(p, value) != Scan::ok || p != next.data() + next.size()) return false;
    at_ = p;
    return true;
}

void LineCursor::expect_end(std::string_view expected) {
    if (at_end()) return;
    fail(at_, "unexpected " + in_quotes(peek()) + " at the end of the line", "expected " + std::string(expected));
}

SourceLocation LineCursor::location(const char* at) const {
    return {source_->name, number_, static_cast<std::uint32_t>(at - line_.data()) + 1};
}

Diagnostic LineCursor::warning(const char* at, std::string message, std::string hint) const {
    return diagnose(Severity::warning, *source_, line_, number_, at, std::move(message), std::move(hint));
}

void LineCursor::fail(const char* at, std::string message, std::string hint) const {
    throw InputError(diagnose(Severity::error, *source_, line_, number_, at, std::move(message), std::move(hint)));
}

bool LineReader::next(std::string_view& line) {
    if (rest_.empty()) return false;
    ++number_;
    const std::size_t newline = rest_.find('\n');
    line = rest_.substr(0, newline);
    rest_.remove_prefix(newline == std::string_view::npos ? rest_.size() : newline + 1);
    return true;
}

}  // namespace sundog
