// SPDX-License-Identifier: Apache-2.0
// Where in a JSON text a value stands.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sundog::import::gltf {

/// A step from a value into one of its parts: a member's name or an element's number.
using JsonStep = std::variant<std::string, std::size_t>;

/// "meshes[0].primitives"
std::string path_text(const std::vector<JsonStep>& steps);

/// Where in `text`, which is valid JSON, the value at the end of the steps begins; as far as they lead.
std::size_t place_of(std::string_view text, const std::vector<JsonStep>& steps);

/// How many arrays and objects lie within each other at most; of a text that need not be valid.
std::size_t level_count(std::string_view text);

/// Where each element of the array at `array_at` begins.
std::vector<std::size_t> element_places(std::string_view text, std::size_t array_at, std::size_t count);

}  // namespace sundog::import::gltf
