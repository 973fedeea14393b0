// SPDX-License-Identifier: Apache-2.0
// POV-Ray's scene description language: runs a .pov file and hands out its blocks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/file_access.h"
#include "base/vec3d.h"
#include "import/pov/entity.h"
#include "import/pov/functions.h"
#include "import/pov/pov_options.h"
#include "import/pov/source_files.h"

namespace sundog::pov {

/// Where file names of scenes (includes, images, fonts, data) are looked for: as given if absolute, else in the folder
/// of the file that names it, the scene's folder, the folders that scenes may write to (what one has written it may
/// read again), and the library paths, in this order.
class FileFinder {
public:
    FileFinder(std::filesystem::path scene_folder, const PovOptions& options);
    /// The file, or an empty path.
    [[nodiscard]] std::filesystem::path find(std::string_view name, const std::filesystem::path& named_in = {}) const;
    /// Why find() gave nothing, for messages: forbidden, or sought where.
    [[nodiscard]] std::string why_not_found(std::string_view name, const std::filesystem::path& named_in = {}) const;
    /// Where a scene's output file of that name goes: if relative, into the first of the folders that may be written
    /// to.
    [[nodiscard]] std::filesystem::path output_path(std::string_view name) const;
    [[nodiscard]] const FileAccess& access() const { return access_; }

private:
    [[nodiscard]] std::vector<std::filesystem::path> candidates(std::string_view name,
                                                                const std::filesystem::path& named_in) const;
    std::filesystem::path scene_folder_;
    std::vector<std::filesystem::path> writable_, library_paths_;
    FileAccess access_;
};

/// Answers about objects, which the builder can give. Objects come by the same pointer while an identifier stands for
/// the same object, so that what was built for one question can be kept for the next. All may throw InputError.
class GeometryQueries : public FunctionPigments {
public:
    struct Hit {
        Vec3d point, normal;  ///< The unit normal points out.
    };
    /// The first hit of a ray with an object; false where there is none.
    virtual bool trace(const std::shared_ptr<const Block>& object, Vec3d origin, Vec3d direction, Hit& hit) = 0;
    virtual bool inside(const std::shared_ptr<const Block>& object, Vec3d point) = 0;
    /// The bounding box that min_extent() and max_extent() tell. Of a pigment with an image, the image's size in
    /// pixels.
    virtual Bounds3d extent(const std::shared_ptr<const Block>& object) = 0;
};

/// Takes what a scene consists of, in the order of the file.
class BlockSink {
public:
    virtual ~BlockSink() = default;
    /// A top-level block: camera, light_source, an object, global_settings, fog, …
    virtual void add(Block&& block) = 0;
};

/// The most levels of blocks, brackets, arrays and objects made of objects within each other.
inline constexpr std::uint32_t kNestingLimit = 400;

/// Runs a scene. Places in the blocks are of `sources`, to which the files read are added while it runs.
/// `queries` may be null: trace(), inside() and the extents are then errors. Functions of pigments and patterns, too.
/// Errors: InputError for what is wrong in a file, or for a limit that was hit.
void interpret(const std::filesystem::path& file, const PovOptions& options, SourceFiles& sources, BlockSink& sink,
               GeometryQueries* queries, const WarningSink& warn);

/// The same for text in memory; `folder` stands for the scene's.
void interpret_text(std::string name, std::string_view text, const std::filesystem::path& folder,
                    const PovOptions& options, SourceFiles& sources, BlockSink& sink, GeometryQueries* queries,
                    const WarningSink& warn);

}  // namespace sundog::pov
