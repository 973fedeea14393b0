// SPDX-License-Identifier: Apache-2.0
// The settings that raytracer.conf and .scene files share.
#pragma once

#include <array>
#include <string_view>
#include <unordered_map>

#include "base/text_file.h"
#include "scene/scene.h"

namespace sundog::import {

inline constexpr std::array<std::string_view, 8> kSettingKeys = {"width",       "height", "fullscreen",    "freeze",
                                                                 "maxRayDepth", "shadow", "reflThreshold", "farZ"};

/// Reads the value of a setting. False if `key` is none. Errors: InputError.
bool read_setting(std::string_view key, LineCursor& value, scene::Settings& settings);

/// What `settings` leaves open, from `fallback`.
void fill_open_settings(scene::Settings& settings, const scene::Settings& fallback);

/// Finds keys that are given twice.
class KeyBook {
public:
    /// Errors: InputError if the key was entered before.
    void enter(std::string_view key, const LineCursor& value);
    [[nodiscard]] bool has(std::string_view key) const { return lines_.contains(key); }
    void clear() { lines_.clear(); }

private:
    std::unordered_map<std::string_view, std::uint32_t> lines_;
};

}  // namespace sundog::import
