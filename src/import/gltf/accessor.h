// SPDX-License-Identifier: Apache-2.0
// Typed views of buffers (glTF 2.0, section 3.6.2 "Accessors").
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "import/gltf/asset.h"

namespace sundog::import::gltf {

/// Numbers of an accessor, element by element.
struct Numbers {
    std::size_t count = 0;
    std::size_t width = 1;  ///< Numbers an element.
    std::vector<float> values;
    [[nodiscard]] std::span<const float> operator[](std::size_t i) const {
        return std::span(values).subspan(i * width, width);
    }
};

/// What the one who asks expects.
struct AccessorKind {
    std::vector<std::string_view> types;  ///< "SCALAR", "VEC3", … One of them.
    bool may_be_whole = false;            ///< Whole numbers that are not `normalized` are numbers, too.
};

/// An accessor's elements as floats, integers normalised where it says so, sparse ones filled in. `user` is the value
/// that holds the accessor's index. Errors: InputError, for what isn't finite too.
Numbers read_numbers(Asset& asset, const Json& user, const AccessorKind& kind);

/// The same for unsigned whole numbers: indices of vertices and joints.
std::vector<std::uint32_t> read_whole_numbers(Asset& asset, const Json& user, std::string_view type);

/// How many elements an accessor has, before it is read.
std::size_t accessor_count(Asset& asset, const Json& user);

}  // namespace sundog::import::gltf
