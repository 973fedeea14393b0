// SPDX-License-Identifier: Apache-2.0
#include "import/obj/obj_import.h"

#include <algorithm>
#include <array>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "base/paths.h"
#include "import/obj/library_names.h"
#include "import/obj/mtl.h"
#include "import/obj/obj_build.h"
#include "scene/files.h"
#include "scene/stand_in.h"

namespace sundog::import {
namespace {

using scene::Index;

constexpr std::array<std::string_view, 10> kStatements = {"v", "vt", "vn", "f", "o", "g", "s", "usemtl", "mtllib", "l"};

/// A change of state and the chunk that holds it.
struct PlacedChange {
    std::size_t chunk;
    const ObjChange* change;
};

/// Turns a scanned file into entries of a scene.
class ObjImporter {
public:
    ObjImporter(ObjFile& file, const std::filesystem::path& path, scene::Scene& scene, const WarningSink& warn)
        : file_(file), path_(path), scene_(scene), warn_(warn) {}

    void run() {
        refuse_other_formats();
        warn_oddities();
        load_libraries();
        std::vector<ObjRun> runs = collect_runs();
        if (runs.empty()) {
            warn(diagnose_file(Severity::warning, file_.source.name, "the file has no faces"));
            return;
        }
        build_meshes(file_, runs, objects_, warn_);
        std::move(objects_.begin(), objects_.end(), std::back_inserter(scene_.objects));
    }

private:
    void warn(const Diagnostic& diagnostic) const {
        if (warn_) warn_(diagnostic);
    }

    /// The physical line that holds `at`, for messages.
    [[nodiscard]] std::string_view line_around(const char* at) const {
        const std::string_view text = file_.source.text;
        const char* first = at;
        while (first > text.data() && first[-1] != '\n') --first;
        const char* const last = std::find(at, text.data() + text.size(), '\n');
        return {first, static_cast<std::size_t>(last - first)};
    }

    [[nodiscard]] Diagnostic message(Severity severity, std::size_t chunk, std::uint32_t line, const char* at,
                                     std::string what, std::string hint = {}) const {
        return diagnose(severity, file_.source, line_around(at), line_number(file_, chunk, line), at, std::move(what),
                        std::move(hint));
    }

    void refuse_other_formats() const {
        for (const ObjChunk& chunk : file_.chunks)
            if (chunk.statement_count > 0) return;
        for (std::size_t i = 0; i < file_.chunks.size(); ++i) {
            if (file_.chunks[i].oddities.empty()) continue;
            const ObjOddity& first = file_.chunks[i].oddities.front();
            throw InputError(message(Severity::error, i, first.line, first.at,
                                     "not an OBJ file: none of its lines is an OBJ statement"));
        }
    }

    void warn_oddities() const {
        constexpr std::size_t kMostWarnings = 64;
        std::unordered_set<std::string> said;
        for (std::size_t i = 0; i < file_.chunks.size(); ++i) {
            for (const ObjOddity& oddity : file_.chunks[i].oddities) {
                std::string key(oddity.name);
                key += static_cast<char>('0' + static_cast<int>(oddity.kind));
                if (said.size() >= kMostWarnings || !said.insert(key).second) continue;
                auto [what, hint] = describe(oddity);
                warn(message(Severity::warning, i, oddity.line, oddity.at, std::move(what), std::move(hint)));
            }
        }
    }

    static std::pair<std::string, std::string> describe(const ObjOddity& oddity) {
        using Kind = ObjOddity::Kind;
        switch (oddity.kind) {
            case Kind::unknown_statement:
                return {"unknown statement " + in_quotes(oddity.name) + " is skipped",
                        suggest(oddity.name, kStatements)};
            case Kind::not_drawn:
                return {in_quotes(oddity.name) + " statements are not drawn", "faces (f) are what is drawn"};
            case Kind::vertex_weight:
                return {"weights of vertices are not used", {}};
            case Kind::vertex_color:
                return {"colours of vertices are not used", {}};
            case Kind::mixed_corners:
                return {"corners with and without a texture vertex or normal in one face: it is drawn without them",
                        {}};
        }
        return {};
    }

    void load_libraries() {
        std::unordered_set<std::string> loaded;
        for (std::size_t i = 0; i < file_.chunks.size(); ++i) {
            for (const ObjChange& change : file_.chunks[i].changes) {
                if (change.kind != ObjChange::Kind::library || !loaded.insert(std::string(change.text)).second)
                    continue;
                for (const std::string& name : split_library_names(path_, change.text))
                    load_library(i, change, name, loaded);
            }
        }
    }

    void load_library(std::size_t chunk, const ObjChange& change, const std::string& name,
                      std::unordered_set<std::string>& loaded) {
        const auto warn_here = [&](std::string what, std::string hint) {
            warn(message(Severity::warning, chunk, change.line, change.text.data(), std::move(what), std::move(hint)));
        };
        const std::filesystem::path library = find_file(path_, name);
        if (library.empty())
            return warn_here("missing material library " + in_quotes(name), "its materials are shown in magenta");
        if (!loaded.insert(library.string().append("\n")).second) return;
        if (library.lexically_normal() == path_.lexically_normal())
            return warn_here("the file names itself as its material library", "expected an .mtl file");
        // Materials that another model of the scene has read serve here too.
        const auto from_library = [&](Index i) {
            const scene::Material& m = scene_.materials[i];
            return m.where.file && *m.where.file == library.string();
        };
        const auto register_from = [&](Index first) {
            bool any = false;
            for (Index i = first; i < scene_.materials.size(); ++i) {
                if (!from_library(i)) continue;
                materials_.emplace(scene_.materials[i].name, i);
                any = true;
            }
            return any;
        };
        if (register_from(0)) return;
        const auto first = static_cast<Index>(scene_.materials.size());
        import_mtl(library, scene_, warn_);
        if (!register_from(first))
            warn_here("no materials in " + in_quotes(name), "a library defines them with newmtl");
    }

    Index material_named(std::size_t chunk, const ObjChange& change) {
        const auto [it, is_new] = materials_.try_emplace(std::string(change.text), 0);
        if (!is_new) return it->second;
        std::string hint;
        if (materials_.size() > 1 && materials_.size() < 1000) {
            std::vector<std::string_view> names;
            for (const auto& [name, index] : materials_)
                if (name != change.text) names.push_back(name);
            std::sort(names.begin(), names.end());
            if (!nearest_names(change.text, names).empty()) hint = suggest(change.text, names).append(" ");
        }
        constexpr std::size_t kMostWarnings = 64;
        if (missing_materials_++ < kMostWarnings) {
            warn(message(Severity::warning, chunk, change.line, change.text.data(),
                         "missing material " + in_quotes(change.text), hint.append("it is shown in magenta")));
        }
        it->second = static_cast<Index>(scene_.materials.size());
        scene_.materials.push_back(
            missing_material(std::string(change.text), {file_.source.name, line_number(file_, chunk, change.line), 0}));
        return it->second;
    }

    Index default_material() {
        if (default_material_ == scene::kNone) {
            default_material_ = static_cast<Index>(scene_.materials.size());
            scene::Material material;
            material.name = "default";
            material.where = {file_.source.name, 0, 0};
            scene_.materials.push_back(std::move(material));
        }
        return default_material_;
    }

    /// Number of the object of that name, made where it is first named.
    std::uint32_t object_named(std::string_view name, std::uint32_t line) {
        const std::string key = name.empty() ? path_.stem().string() : std::string(name);
        const auto [it, is_new] = object_numbers_.try_emplace(key, static_cast<std::uint32_t>(objects_.size()));
        if (is_new) {
            scene::Object object;
            object.name = key;
            object.where = {file_.source.name, line, 0};
            object.shape = scene::Mesh{};
            objects_.push_back(std::move(object));
        }
        return it->second;
    }

    /// What faces belong to at some place of the file; entries are made when a face needs them.
    struct State {
        std::string_view object;
        std::uint32_t object_line = 0;
        const ObjChange* material = nullptr;
        std::size_t material_chunk = 0;
        std::uint32_t smoothing_group = 0;
    };

    std::vector<ObjRun> collect_runs() {
        const bool has_objects = std::any_of(file_.chunks.begin(), file_.chunks.end(), [](const ObjChunk& chunk) {
            return std::any_of(chunk.changes.begin(), chunk.changes.end(),
                               [](const ObjChange& c) { return c.kind == ObjChange::Kind::object; });
        });
        const auto names_objects = has_objects ? ObjChange::Kind::object : ObjChange::Kind::group;
        std::vector<ObjRun> runs;
        State state;
        for (std::size_t i = 0; i < file_.chunks.size(); ++i) {
            const ObjChunk& chunk = file_.chunks[i];
            std::uint32_t first_face = 0;
            const auto finish = [&](std::uint32_t end_face) {
                if (end_face == first_face) return;
                const Index material = state.material != nullptr ? material_named(state.material_chunk, *state.material)
                                                                 : default_material();
                runs.push_back({static_cast<std::uint32_t>(i), first_face, end_face,
                                object_named(state.object, state.object_line), material, state.smoothing_group, 0});
                first_face = end_face;
            };
            for (const ObjChange& change : chunk.changes) {
                finish(change.face);
                if (change.kind == names_objects)
                    state.object = change.text, state.object_line = line_number(file_, i, change.line);
                else if (change.kind == ObjChange::Kind::material) state.material = &change, state.material_chunk = i;
                else if (change.kind == ObjChange::Kind::smoothing) state.smoothing_group = change.smoothing_group;
            }
            finish(static_cast<std::uint32_t>(chunk.face_ends.size()));
        }
        return runs;
    }

    ObjFile& file_;
    const std::filesystem::path& path_;
    scene::Scene& scene_;
    const WarningSink& warn_;
    std::unordered_map<std::string, Index> materials_;
    std::unordered_map<std::string, std::uint32_t> object_numbers_;
    std::vector<scene::Object> objects_;
    std::size_t missing_materials_ = 0;
    Index default_material_ = scene::kNone;
};

}  // namespace

void import_obj(const std::filesystem::path& file, scene::Scene& scene, const WarningSink& warn) {
    const SourceText source = read_text_file(file);
    scene::add_file(scene, file);
    ObjFile scanned = scan_obj_file(source);
    ObjImporter(scanned, file, scene, warn).run();
}

void import_mtl(const std::filesystem::path& file, scene::Scene& scene, const WarningSink& warn) {
    const SourceText source = read_text_file(file);
    scene::add_file(scene, file);
    read_mtl(source, file, scene, warn);
}

}  // namespace sundog::import
