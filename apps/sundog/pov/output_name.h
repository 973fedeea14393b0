// SPDX-License-Identifier: Apache-2.0
// Where pictures go, and which part of them is drawn (POV-Ray 3.7 reference, sections 3.2.4.2 "Output File Name" and
// 3.2.2.3 "Partial Output Options"; details as povray 3.7 was seen to have them).
#pragma once

#include <filesystem>
#include <optional>

#include "animation.h"
#include "settings.h"

namespace sundog::app {

/// ".png", ".jpg", …
const char* ending_of(PovFileType type);

/// The picture's file; "-" for standard output. Without Output_File_Name: the scene's name and folder. A name that
/// ends in a slash is a folder. The format's ending is added where the name hasn't exactly that. Animations' frames
/// get their number before the ending.
std::filesystem::path picture_file(const PovSettings& settings, const PovAnimation& animation, int frame);

/// Columns and rows that are drawn, from 0, the ends not included; the rest of the picture is black.
struct PovRegion {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    [[nodiscard]] bool is_all_of(int width, int height) const {
        return x0 == 0 && y0 == 0 && x1 == width && y1 == height;
    }
};

/// Errors: UsageError where a column or row lies outside the picture, or the end before the start.
PovRegion region_of(const PovSettings& settings);

}  // namespace sundog::app
