// SPDX-License-Identifier: Apache-2.0
// What is fuzzed of POV-Ray scenes: lexer, interpreter and builder, with limits that keep a run short.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace sundog::fuzz {

/// Reads `text` as a scene that may read and write no file. Whatever it holds must end in a scene or in an InputError;
/// another exception passes on. Returns the error's message; nothing for a scene.
std::optional<std::string> refusal_of_pov_scene(std::string_view text);

}  // namespace sundog::fuzz
