// SPDX-License-Identifier: Apache-2.0
// The builder: takes the interpreter's blocks and makes a scene of them.
#pragma once

#include "import/pov/build_context.h"
#include "import/pov/build_object.h"
#include "import/pov/build_queries.h"
#include "import/pov/build_texture.h"
#include "import/pov/build_writer.h"
#include "import/pov/interpreter.h"

namespace sundog::pov {

/// Makes a scene of top-level blocks, in the order of the file. Errors: InputError at what has no place.
class SceneBuilder : public BlockSink {
public:
    SceneBuilder(scene::Scene& scene, const SourceFiles& sources, const FileFinder& files, const PovOptions& options,
                 const WarningSink& warn)
        : context_(scene, sources, files, options, warn) {}

    /// Where object patterns get their objects from; it must outlive the builder.
    void ask(ObjectQueries& queries) {
        context_.inside_test = [&queries](const auto& object) { return queries.inside_test(object); };
    }

    void add(Block&& block) override;
    /// Call after the last block: fills in what POV-Ray takes where a scene says nothing.
    void finish();

private:
    void read(const Block& block);

    BuildContext context_;
    TextureReader textures_{context_};
    ObjectReader objects_{context_, textures_};
    SceneWriter writer_{context_};
    std::uint16_t version_ = 370;
};

}  // namespace sundog::pov
