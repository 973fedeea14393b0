// SPDX-License-Identifier: Apache-2.0
// What all parts of the builder share: the scene being made, messages about places, what was warned of already.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "import/pov/entity.h"
#include "import/pov/interpreter.h"
#include "import/pov/pov_options.h"
#include "scene/pattern.h"
#include "scene/scene.h"

namespace sundog::pov {

/// Settings of global_settings that change how what follows is read.
struct ColorSpace {
    /// Exponent from the scene's numbers to linear light; nothing set: 1 from version 3.7 on; before, the
    /// numbers go to the file as they are.
    std::optional<double> assumed_gamma;
};
/// The gamma that `assumed_gamma srgb` is taken for.
inline constexpr double kLegacyGamma = 2.2;

/// Shared by the readers of all blocks. One for a scene.
class BuildContext {
public:
    BuildContext(scene::Scene& scene, const SourceFiles& sources, const FileFinder& files, const PovOptions& options,
                 const WarningSink& warn)
        : scene(scene), options(options), files(files), sources_(sources), warn_(warn) {}

    scene::Scene& scene;
    const PovOptions& options;
    const FileFinder& files;
    ColorSpace color_space;
    int noise_generator = 2;  ///< global_settings' noise_generator: of patterns that name none.
    /// Density files by their names.
    std::map<std::string, std::shared_ptr<const scene::DensityGrid>> densities;
    /// Makes the test of an object pattern; null for objects without inside.
    std::function<std::shared_ptr<const scene::InsideTest>(const std::shared_ptr<const Block>&)> inside_test;

    [[nodiscard]] SourceLocation location(Place place) const;
    /// A file that the scene names at a place; empty if there is none or it may not be read.
    [[nodiscard]] std::filesystem::path find_file(std::string_view name, Place where) const;
    /// Why find_file() gave nothing, for messages.
    [[nodiscard]] std::string why_not_found(std::string_view name, Place where) const;
    [[noreturn]] void fail(Place place, std::string message, std::string hint = {}) const;
    void warn(Place place, std::string message, std::string hint = {}) const;
    /// Warns at the first place where a scene uses something that Sundog doesn't draw.
    void warn_once(std::string_view feature, Place place, std::string message, std::string hint = {});
    /// True for scenes whose image files are used as they are stored: gamma 2.2 in, gamma 2.2 out.
    [[nodiscard]] bool stored_colors(std::uint16_t version) const;

private:
    const SourceFiles& sources_;
    const WarningSink& warn_;
    std::set<std::string, std::less<>> warned_;
};

}  // namespace sundog::pov
