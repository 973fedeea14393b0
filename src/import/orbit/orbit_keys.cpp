// SPDX-License-Identifier: Apache-2.0
#include "import/orbit/orbit_keys.h"

#include <cfloat>

#include "import/orbit/orbit_values.h"

namespace sundog::import {

bool read_setting(std::string_view key, LineCursor& value, scene::Settings& settings) {
    constexpr int kMostPixels = 65535;
    constexpr int kMostDepth = 1000;
    if (key == "width") settings.width = read_int_in(value, "width = a whole number from 1 to 65535", 1, kMostPixels);
    else if (key == "height")
        settings.height = read_int_in(value, "height = a whole number from 1 to 65535", 1, kMostPixels);
    else if (key == "fullscreen") settings.fullscreen = read_bool(value, "fullscreen = true or false");
    else if (key == "freeze") settings.freeze_s = read_float(value, "freeze = a time in seconds");
    else if (key == "maxRayDepth")
        settings.max_depth = read_int_in(value, "maxRayDepth = a whole number from 0 to 1000", 0, kMostDepth);
    else if (key == "shadow") settings.shadows = read_bool(value, "shadow = true or false");
    else if (key == "reflThreshold")
        settings.min_weight = read_float_in(value, "reflThreshold = a number from 0 to 1", 0, 1);
    else if (key == "farZ") settings.far_z = read_positive(value, "farZ = a distance greater than 0");
    else return false;
    return true;
}

void fill_open_settings(scene::Settings& settings, const scene::Settings& fallback) {
    const auto fill = [](auto& open, const auto& from) {
        if (!open) open = from;
    };
    fill(settings.width, fallback.width);
    fill(settings.height, fallback.height);
    fill(settings.fullscreen, fallback.fullscreen);
    fill(settings.freeze_s, fallback.freeze_s);
    fill(settings.max_depth, fallback.max_depth);
    fill(settings.shadows, fallback.shadows);
    fill(settings.min_weight, fallback.min_weight);
    fill(settings.far_z, fallback.far_z);
}

void KeyBook::enter(std::string_view key, const LineCursor& value) {
    const auto [it, is_new] = lines_.try_emplace(key, value.line_number());
    if (is_new) return;
    value.fail(key.data(), "the key " + in_quotes(key) + " is given twice",
               "it was given in line " + std::to_string(it->second) + " before");
}

}  // namespace sundog::import
