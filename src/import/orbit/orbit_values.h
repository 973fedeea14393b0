// SPDX-License-Identifier: Apache-2.0
// Lines and values of orbit files (docs/orbit.md).
#pragma once

#include <optional>
#include <string_view>

#include "base/text_file.h"
#include "scene/scene.h"

namespace sundog::import {

/// A line `key = value`.
struct OrbitLine {
    std::string_view key;
    LineCursor value;  ///< Stands behind the '='.
};

/// Reads the lines of an orbit file, without comments and empty lines.
class OrbitLineReader {
public:
    explicit OrbitLineReader(const SourceText& source) : source_(source), lines_(source) {}
    /// The next line; nothing at the end. `keys` are the valid keys, for the hint. Errors: InputError for a line
    /// without '=' or without key.
    std::optional<OrbitLine> next(std::span<const std::string_view> keys);

private:
    const SourceText& source_;
    LineReader lines_;
};

/// Each of these takes one value (three for a vector) and nothing after it. `form` is the whole line as it should be,
/// for the message. Errors: InputError.
float read_float(LineCursor& value, std::string_view form);
/// A number greater than 0.
float read_positive(LineCursor& value, std::string_view form);
float read_float_in(LineCursor& value, std::string_view form, float low, float high);
int read_int_in(LineCursor& value, std::string_view form, int low, int high);
bool read_bool(LineCursor& value, std::string_view form);
Vec3 read_vec3(LineCursor& value, std::string_view form);
/// Three numbers of 0 or more.
Vec3 read_color(LineCursor& value, std::string_view form);
/// const deg | wave speed deg amplitude | linear speed (where allowed)
scene::Motion read_motion(LineCursor& value, std::string_view form, bool may_be_linear);
/// Three numbers inside a line, more may follow.
Vec3 take_vec3(LineCursor& value, std::string_view form);

}  // namespace sundog::import
