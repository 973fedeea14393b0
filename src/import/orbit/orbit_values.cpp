// SPDX-License-Identifier: Apache-2.0
#include "import/orbit/orbit_values.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/scan.h"

namespace sundog::import {
namespace {

/// The line up to its comment: a '#' outside of double quotes.
std::string_view without_comment(std::string_view line) {
    bool in_quotes = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') in_quotes = !in_quotes;
        if (line[i] == '#' && !in_quotes) return line.substr(0, i);
    }
    return line;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

}  // namespace

std::optional<OrbitLine> OrbitLineReader::next(std::span<const std::string_view> keys) {
    for (std::string_view line; lines_.next(line);) {
        const std::string_view code = without_comment(line);
        LineCursor cursor(source_, code, lines_.number());
        if (cursor.at_end()) continue;
        const char* const first = cursor.here();
        const std::size_t equals = code.find('=');
        if (equals == std::string_view::npos) {
            const std::string_view word = cursor.peek();
            const bool known = std::find(keys.begin(), keys.end(), word) != keys.end();
            cursor.fail(first, "expected 'key = value', found no '='",
                        known ? "write '" + std::string(word) + " = ...'" : suggest(word, keys));
        }
        const std::string_view key = trimmed(code.substr(0, equals));
        if (key.empty()) cursor.fail(first, "no key before the '='", suggest("", keys));
        return OrbitLine{key, LineCursor(source_, code, lines_.number(), code.data() + equals + 1)};
    }
    return std::nullopt;
}

float read_float(LineCursor& value, std::string_view form) {
    const float number = value.number(form);
    value.expect_end(form);
    return number;
}

float read_positive(LineCursor& value, std::string_view form) {
    const char* const at = value.here();
    const float number = read_float(value, form);
    if (!(number > 0)) value.fail(at, "the number must be greater than 0", "expected " + std::string(form));
    return number;
}

float read_float_in(LineCursor& value, std::string_view form, float low, float high) {
    const char* const at = value.here();
    const float number = read_float(value, form);
    if (number < low || number > high) value.fail(at, "number out of range", "expected " + std::string(form));
    return number;
}

int read_int_in(LineCursor& value, std::string_view form, int low, int high) {
    const char* const at = value.here();
    const int number = value.integer(form);
    if (number < low || number > high) value.fail(at, "number out of range", "expected " + std::string(form));
    value.expect_end(form);
    return number;
}

bool read_bool(LineCursor& value, std::string_view form) {
    const char* const at = value.here();
    const std::string_view word = value.token(form);
    const bool is_true = word == "true" || word == "1";
    if (!is_true && word != "false" && word != "0")
        value.fail(at, "expected true or false, found " + in_quotes(word), "expected " + std::string(form));
    value.expect_end(form);
    return is_true;
}

Vec3 take_vec3(LineCursor& value, std::string_view form) {
    Vec3 v;
    v.x = value.number(form);
    v.y = value.number(form);
    v.z = value.number(form);
    return v;
}

Vec3 read_vec3(LineCursor& value, std::string_view form) {
    const Vec3 v = take_vec3(value, form);
    value.expect_end(form);
    return v;
}

Vec3 read_color(LineCursor& value, std::string_view form) {
    const char* const at = value.here();
    const Vec3 color = read_vec3(value, form);
    if (color.x < 0 || color.y < 0 || color.z < 0)
        value.fail(at, "a colour can't be negative", "expected " + std::string(form));
    return color;
}

scene::Motion read_motion(LineCursor& value, std::string_view form, bool may_be_linear) {
    using Kind = scene::Motion::Kind;
    constexpr std::array<std::string_view, 3> kKinds = {"const", "wave", "linear"};
    scene::Motion motion;
    const char* const at = value.here();
    const std::string_view kind = value.token(form);
    if (kind == "const") {
        motion.base = value.number(form);
    } else if (kind == "wave") {
        motion.kind = Kind::wave;
        motion.speed = value.number(form);
        motion.base = value.number(form);
        motion.amplitude = value.number(form);
    } else if (kind == "linear" && may_be_linear) {
        motion.kind = Kind::linear;
        motion.speed = value.number(form);
    } else if (kind == "linear") {
        value.fail(at, "'linear' is not possible here", "expected " + std::string(form));
    } else {
        value.fail(at, "unknown motion " + in_quotes(kind),
                   suggest(kind, std::span(kKinds).first(may_be_linear ? 3 : 2)));
    }
    value.expect_end(form);
    return motion;
}

}  // namespace sundog::import
