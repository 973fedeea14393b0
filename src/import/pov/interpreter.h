// SPDX-License-Identifier: Apache-2.0
// POV-Ray's scene description language: runs a .pov file and hands out its blocks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/diagnostics.h"
#include "base/vec3d.h"
#include "import/pov/entity.h"
#include "import/pov/functions.h"
#include "import/pov/source_files.h"

namespace sundog::pov {

/// Which files a scene may touch. Paths come absolute and normal, links resolved.
struct FileAccess {
    std::function<bool(const std::filesystem::path&)> may_read;   ///< Empty: every regular file.
    std::function<bool(const std::filesystem::path&)> may_write;  ///< Empty: none.
};

/// Where file names of scenes (includes, images, fonts, data) are looked for: as given if absolute, else in the folder
/// of the scene, the folder of the file that names it, and the library paths, in this order.
class FileFinder {
public:
    FileFinder(std::filesystem::path scene_folder, std::vector<std::filesystem::path> library_paths, FileAccess access);
    /// The file, or an empty path. Throws nothing.
    [[nodiscard]] std::filesystem::path find(std::string_view name, const std::filesystem::path& named_in = {}) const;
    /// True where find() fails only because FileAccess::may_read forbids the file.
    [[nodiscard]] bool forbidden(std::string_view name, const std::filesystem::path& named_in = {}) const;
    /// Where a scene's output file of that name goes, or an empty path where it may not be written.
    [[nodiscard]] std::filesystem::path writable(std::string_view name) const;
    /// The folders, for messages.
    [[nodiscard]] std::string places() const;

private:
    [[nodiscard]] std::vector<std::filesystem::path> candidates(std::string_view name,
                                                                const std::filesystem::path& named_in) const;
    std::filesystem::path scene_folder_;
    std::vector<std::filesystem::path> library_paths_;
    FileAccess access_;
};

/// What stops runaway scenes. Messages name the limit that was hit.
struct InterpreterLimits {
    std::uint64_t steps = 4'000'000'000;                    ///< Tokens, loop passes and function operations.
    std::uint64_t memory_bytes = std::uint64_t{16} << 30U;  ///< By which the process may grow meanwhile.
    std::uint32_t macro_depth = 500;
    std::uint32_t include_depth = 100;
    std::uint32_t nesting = 400;  ///< Of blocks, brackets, arrays and objects made of objects.
};

/// An identifier declared before the scene starts (`Declare=Name=Value`).
struct Declaration {
    std::string name;
    std::variant<double, std::string> value;
};

struct InterpreterOptions {
    std::vector<std::filesystem::path> library_paths;
    FileAccess access;
    double version = 3.7;  ///< In force until the scene's #version.
    double clock = 0, clock_delta = 0;
    bool clock_on = false;
    int frame_number = 1, initial_frame = 1, final_frame = 1;
    double initial_clock = 0, final_clock = 1;
    int image_width = 320, image_height = 240;
    std::string input_file_name;  ///< What the identifier of that name says; empty: the scene's path.
    std::vector<Declaration> declares;
    InterpreterLimits limits;
};

/// Answers about objects, which the builder can give. Objects come by the same pointer while an identifier stands for
/// the same object, so that what was built for one question can be kept for the next. All may throw InputError.
class GeometryQueries : public PatternQueries {
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

/// The streams that #debug, #warning and the others write to.
enum class TextStream : std::uint8_t { debug, warning, render, statistics };

/// Takes what a scene consists of, in the order of the file.
class BlockSink {
public:
    virtual ~BlockSink() = default;
    /// A top-level block: camera, light_source, an object, global_settings, fog, … `version` is the #version in force.
    virtual void add(Block&& block, double version) = 0;
    /// A block in `#default { … }`: texture, pigment, normal, finish, …
    virtual void set_default(Block&& block, double version) = 0;
    /// Text of a message directive.
    virtual void text(TextStream stream, std::string_view text) = 0;
};

/// Runs a scene. Places in the blocks are of `sources`, to which the files read are added while it runs.
/// `queries` may be null: trace(), inside() and the extents are then errors. Functions of pigments and patterns, too.
/// rand() is Sundog's own generator: another sequence than POV-Ray's, the same on every machine.
/// Errors: InputError for what is wrong in a file, or for a limit that was hit.
void interpret(const std::filesystem::path& file, const InterpreterOptions& options, SourceFiles& sources,
               BlockSink& sink, GeometryQueries* queries, const WarningSink& warn);

/// The same for text in memory; `folder` stands for the scene's.
void interpret_text(std::string name, std::string_view text, const std::filesystem::path& folder,
                    const InterpreterOptions& options, SourceFiles& sources, BlockSink& sink, GeometryQueries* queries,
                    const WarningSink& warn);

}  // namespace sundog::pov
