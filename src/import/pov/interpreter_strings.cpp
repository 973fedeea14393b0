// SPDX-License-Identifier: Apache-2.0
// Strings (manual, 3.3.1.9).
#include <algorithm>
#include <charconv>
#include <cmath>
#include <ctime>

#include "import/pov/interpreter_core.h"
#include "import/pov/word_use.h"

namespace sundog::pov {
namespace {

/// As C's "%*.*f" writes it: `length` the least width, zeros for padding where negative; negative digits mean 6.
std::string formatted(double number, double length, double digits) {
    const int width = static_cast<int>(std::clamp(std::fabs(length), 0.0, 1000.0));
    const int precision = digits < 0 ? 6 : static_cast<int>(std::min(digits, 100.0));
    std::array<char, 1500> buffer{};
    const int size =
        std::snprintf(buffer.data(), buffer.size(), length < 0 ? "%0*.*f" : "%*.*f", width, precision, number);
    return {buffer.data(), static_cast<std::size_t>(std::clamp(size, 0, static_cast<int>(buffer.size()) - 1))};
}

std::string in_utf8(std::uint32_t code) {
    std::string text;
    const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) put(code);
    else if (code < 0x800) put(0xc0U | code >> 6U), put(0x80U | (code & 0x3fU));
    else put(0xe0U | code >> 12U), put(0x80U | (code >> 6U & 0x3fU)), put(0x80U | (code & 0x3fU));
    return text;
}

}  // namespace

std::string Interpreter::checked(std::string text, Spot where) {
    constexpr std::size_t kLongest = std::size_t{64} << 20U;
    if (text.size() > kLongest) fail(where, "a string of more than 64 MiB");
    tick(text.size() / 16 + 1);
    return text;
}

std::string Interpreter::parse_string() {
    const Lookahead& ahead = peek();
    if (ahead.kind == TokenKind::string) {
        const TokenFile* file = ahead.file;
        const std::uint32_t payload = ahead.payload;
        take();
        return file->strings[payload];
    }
    const Spot where = here();
    if (ahead.kind == TokenKind::keyword && word_use(static_cast<Keyword>(ahead.payload)) == WordUse::string) {
        const auto keyword = static_cast<Keyword>(ahead.payload);
        const Level level(*this);
        take();
        return checked(call_string_builtin(keyword, where), where);
    }
    if (ahead.kind == TokenKind::name) {
        const NameId name = ahead.payload;
        const Entity* entity = identifiers_.find(name);
        if (entity == nullptr) fail_undeclared(where, name);
        if (const auto* text = std::get_if<std::string>(entity)) {
            std::string copy = *text;
            take();
            return copy;
        }
        if (const auto* array = std::get_if<std::shared_ptr<Array>>(entity)) {
            const std::shared_ptr<Array> kept = *array;
            take();
            Entity value = element(kept, name, where);
            if (auto* text = std::get_if<std::string>(&value)) return std::move(*text);
            fail(where, "expected a string, found " + describe(value));
        }
    }
    if (ahead.kind == TokenKind::left_paren) {
        const Level level(*this);
        take();
        std::string text = parse_string();
        expect(TokenKind::right_paren, "to close the parenthesis");
        return text;
    }
    fail_expected("a string");
}

std::string Interpreter::call_string_builtin(Keyword keyword, Spot where) {
    if (keyword == Keyword::input_file_name) return input_file_name_;
    const GuardScope no_guard(guard_, {});
    expect(TokenKind::left_paren, "after ", spelling(keyword));
    std::string text;
    switch (keyword) {
        case Keyword::str: {
            const double number = argument(true).v[0];
            const double length = argument(false).v[0];
            text = formatted(number, length, argument(false).v[0]);
            break;
        }
        case Keyword::vstr: {
            const auto count = static_cast<std::uint8_t>(std::clamp(parse_number(), 2.0, 5.0));
            const Value vector = promoted(argument(false), count);
            accept(TokenKind::comma);
            const std::string separator = parse_string();
            const double length = argument(false).v[0];
            const double digits = argument(false).v[0];
            for (std::uint8_t i = 0; i < count; ++i)
                text += (i > 0 ? separator : "") + formatted(vector.v[i], length, digits);
            break;
        }
        case Keyword::concat:
            while (peek().kind != TokenKind::right_paren) {
                text += parse_string();
                text = checked(std::move(text), where);
                accept(TokenKind::comma);
            }
            break;
        case Keyword::substr: {
            const std::string whole = parse_string();
            const double start = argument(false).v[0];
            const double length = argument(false).v[0];
            if (!(start >= 1) || !(length >= 0) || start + length - 1 > static_cast<double>(whole.size()))
                fail(where, "substr beyond a string of " + std::to_string(whole.size()) + " characters");
            text = whole.substr(static_cast<std::size_t>(start) - 1, static_cast<std::size_t>(length));
            break;
        }
        case Keyword::chr: {
            const double code = parse_number();
            if (!(code >= 0) || code > 0xffff) fail(where, "chr takes a number from 0 to 65535");
            text = in_utf8(static_cast<std::uint32_t>(code));
            break;
        }
        case Keyword::strlwr:
        case Keyword::strupr:
            text = parse_string();
            for (char& c : text) {
                if (keyword == Keyword::strlwr && c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
                if (keyword == Keyword::strupr && c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
            }
            break;
        default: {  // datetime(days [, format])
            const double days = parse_number();
            const std::string format = accept(TokenKind::comma) ? parse_string() : "%Y-%m-%d %H:%M:%SZ";
            text = date_text(days, format, where);
        }
    }
    expect(TokenKind::right_paren, "after the arguments of ", spelling(keyword));
    return text;
}

std::string Interpreter::date_text(double days_since_2000, const std::string& format, Spot where) {
    constexpr double kSecondsADay = 86400, kDays1970To2000 = 10957;
    if (!(std::fabs(days_since_2000) < 3e6)) fail(where, "datetime of a day too far away");
    const auto seconds = static_cast<std::time_t>(std::floor((days_since_2000 + kDays1970To2000) * kSecondsADay));
    std::tm utc{};
    ::gmtime_r(&seconds, &utc);
    std::array<char, 400> buffer{};
    const std::size_t size = std::strftime(buffer.data(), buffer.size(), format.c_str(), &utc);
    if (size == 0 && !format.empty()) fail(where, "a date of more than 399 characters, or of none");
    return {buffer.data(), size};
}

Value Interpreter::call_of_strings(Keyword keyword, Spot where) {
    const GuardScope no_guard(guard_, {});
    expect(TokenKind::left_paren, "after ", spelling(keyword));
    const std::string text = parse_string();
    double result = 0;
    switch (keyword) {
        case Keyword::strlen:
            result = static_cast<double>(text.size());
            break;
        case Keyword::strcmp: {
            accept(TokenKind::comma);
            const int order = text.compare(parse_string());
            result = order < 0 ? -1 : order > 0 ? 1 : 0;
            break;
        }
        case Keyword::asc:
            if (text.empty()) fail(where, "asc of an empty string");
            result = static_cast<unsigned char>(text.front());
            break;
        case Keyword::file_exists:
            result = finder_.find(text, frames_.back().file->path).empty() ? 0 : 1;
            break;
        default: {  // val: the number that the text starts with
            std::string_view digits = text;
            while (!digits.empty() && (digits.front() == ' ' || digits.front() == '+')) digits.remove_prefix(1);
            if (std::from_chars(digits.data(), digits.data() + digits.size(), result).ec != std::errc()) result = 0;
            if (!std::isfinite(result)) result = 0;
        }
    }
    expect(TokenKind::right_paren, "after the arguments of ", spelling(keyword));
    return number_value(result);
}

}  // namespace sundog::pov
