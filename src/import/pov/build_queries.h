// SPDX-License-Identifier: Apache-2.0
// Answers to what a scene asks about its own objects while it is read: trace(), inside(), min_extent(), max_extent().
#pragma once

#include <map>
#include <memory>

#include "import/pov/build_context.h"
#include "import/pov/build_function.h"
#include "import/pov/build_object.h"
#include "import/pov/build_texture.h"
#include "import/pov/build_writer.h"
#include "import/pov/interpreter.h"
#include "solids/compiled_solid.h"

namespace sundog::pov {

/// Builds the objects asked about, each once, apart from the scene. Errors: InputError.
class ObjectQueries : public GeometryQueries {
public:
    ObjectQueries(const SourceFiles& sources, const FileFinder& files, const PovOptions& options)
        : context_(scratch_, sources, files, options, no_warnings_) {
        context_.inside_test = [this](const auto& object) { return inside_test(object); };
    }

    bool trace(const std::shared_ptr<const Block>& object, Vec3d origin, Vec3d direction, Hit& hit) override;
    bool inside(const std::shared_ptr<const Block>& object, Vec3d point) override;
    /// For object patterns, which may outlive this; null for objects without any surface.
    std::shared_ptr<const scene::InsideTest> inside_test(const std::shared_ptr<const Block>& object);
    Bounds3d extent(const std::shared_ptr<const Block>& object) override;
    std::shared_ptr<const scene::Pigment> pigment_of(const std::shared_ptr<const Block>& pigment) override {
        return pigments_.pigment_of(pigment);
    }
    std::shared_ptr<const scene::Pigment> pigment_of_pattern(const std::shared_ptr<const Block>& pattern) override {
        return pigments_.pigment_of_pattern(pattern);
    }
    [[nodiscard]] std::span<const scene::Texture> textures() const override { return pigments_.textures(); }

private:
    /// Null for objects without any surface.
    std::shared_ptr<const solids::CompiledSolid> compiled(const std::shared_ptr<const Block>& object);

    scene::Scene scratch_;  // Takes the materials, which nobody looks at.
    WarningSink no_warnings_;
    BuildContext context_;
    BlockPigments pigments_{context_};
    TextureReader textures_{context_};
    ObjectReader objects_{context_, textures_};
    SceneWriter writer_{context_};
    using WeakBlock = std::weak_ptr<const Block>;
    std::map<WeakBlock, std::shared_ptr<const solids::CompiledSolid>, std::owner_less<WeakBlock>> compiled_;
};

}  // namespace sundog::pov
