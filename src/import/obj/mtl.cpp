// SPDX-License-Identifier: Apache-2.0
#include "import/obj/mtl.h"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_set>

#include "import/obj/mtl_model.h"
#include "import/obj/mtl_texture.h"

namespace sundog::import {
namespace {

using scene::Material;

constexpr std::array<std::string_view, 29> kStatements = {
    "newmtl", "Ka",    "Kd",     "Ks",     "Ke",     "Tf",         "Ns",        "Ni",          "d",        "Tr",
    "illum",  "Pr",    "Pm",     "Pc",     "map_Kd", "map_Ks",     "map_Ke",    "map_Bump",    "map_bump", "bump",
    "norm",   "map_d", "map_Ka", "map_Tr", "map_Kn", "checker_Kd", "highlight", "map_opacity", "bsdf"};

/// Statements that other programs know and that mean nothing here: named once each.
constexpr std::array<std::string_view, 18> kNotUsed = {"Ps",      "Pcr",    "aniso",  "anisor", "sharpness", "map_Ns",
                                                       "map_Pr",  "map_Pm", "map_Ps", "map_Pc", "map_Pcr",   "map_RMA",
                                                       "map_ORM", "refl",   "disp",   "decal",  "map_aat",   "map_Tf"};

template <std::size_t N>
bool holds(const std::array<std::string_view, N>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Linear sRGB of CIE XYZ (IEC 61966-2-1, D65), without the negative parts of colours outside its gamut.
Vec3 rgb_from_xyz(Vec3 c) {
    return max({3.2406F * c.x - 1.5372F * c.y - 0.4986F * c.z, -0.9689F * c.x + 1.8758F * c.y + 0.0415F * c.z,
                0.0557F * c.x - 0.2040F * c.y + 1.0570F * c.z},
               {0, 0, 0});
}

/// Reads one library.
class MtlReader {
public:
    MtlReader(const SourceText& source, const std::filesystem::path& file, scene::Scene& scene, const WarningSink& warn)
        : source_(source), file_(file), scene_(scene), warn_(warn) {}

    void run() {
        LineReader lines(source_);
        for (std::string_view line; lines.next(line);) {
            // Only a whole line is a comment: names of materials and files may hold a '#'.
            LineCursor cursor = lines.cursor(line);
            if (cursor.at_end() || *cursor.here() == '#') continue;
            statement(cursor);
        }
        finish_material();
    }

private:
    scene::MtlSurface& material() { return *scene_.materials.back().mtl; }

    void warn(const Diagnostic& diagnostic) const {
        if (warn_) warn_(diagnostic);
    }

    /// Says something once a library for each `key`; a library can't flood the caller.
    void warn_once(const LineCursor& cursor, const char* at, std::string_view key, std::string message,
                   std::string hint = {}) {
        constexpr std::size_t kMostWarnings = 64;
        if (warned_.size() >= kMostWarnings || !warned_.insert(std::string(key.substr(0, 100))).second) return;
        warn(cursor.warning(at, std::move(message), std::move(hint)));
    }

    void statement(LineCursor& cursor) {
        const char* const at = cursor.here();
        const std::string_view keyword = cursor.token("a statement");
        if (keyword == "newmtl") return new_material(cursor);
        if (!holds(kStatements, keyword)) {
            if (holds(kNotUsed, keyword)) warn_once(cursor, at, keyword, in_quotes(keyword) + " is not used");
            else
                warn_once(cursor, at, keyword, "unknown statement " + in_quotes(keyword) + " is skipped",
                          suggest(keyword, kStatements));
            return;
        }
        if (!in_material_) {
            warn_once(cursor, at, "\nnewmtl", in_quotes(keyword) + " before the first newmtl is skipped");
            return;
        }
        if (keyword.starts_with("map_") || keyword == "bump" || keyword == "norm") return map(cursor, keyword);
        property(cursor, at, keyword);
    }

    void new_material(LineCursor& cursor) {
        finish_material();
        const char* const at = cursor.here();
        const std::string_view name = cursor.rest("newmtl and a material's name");
        if (!names_.insert(std::string(name)).second)
            warn_once(cursor, at, "\nduplicate", "a second material " + in_quotes(name), "the first one counts");
        Material material;
        material.name = name;
        material.where = cursor.location(at);
        scene_.materials.push_back(std::move(material));
        in_material_ = true;
        dissolve_.reset();
        transparency_.reset();
    }

    /// Tr only counts where there is no d: several exporters write a Tr that contradicts it.
    void finish_material() {
        if (!in_material_) return;
        if (dissolve_) material().opacity = *dissolve_;
        else if (transparency_) material().opacity = 1 - *transparency_;
    }

    void property(LineCursor& cursor, const char* at, std::string_view keyword) {
        scene::MtlSurface& m = material();
        if (keyword == "Kd") color(cursor, at, keyword, m.diffuse);
        else if (keyword == "Ks") color(cursor, at, keyword, m.specular);
        else if (keyword == "Ke") color(cursor, at, keyword, m.emission);
        else if (keyword == "Tf") color(cursor, at, keyword, m.transmission_filter);
        else if (keyword == "Ka") {
            Vec3 ambient;
            if (color(cursor, at, keyword, ambient)) m.ambient = ambient;
        } else if (keyword == "Ns") {
            m.shininess = number_in(cursor, "Ns and an exponent", 0, 1e6F);
        } else if (keyword == "Ni") {
            const char* const value_at = cursor.here();
            m.ior = number_in(cursor, "Ni and an index of refraction", 0, 100);
            if (m.ior < 0.001F) {
                warn_once(cursor, value_at, "\nNi", "an index of refraction under 0.001; 1 is used");
                m.ior = 1;
            }
        } else if (keyword == "d") {
            if (cursor.peek() == "-halo") {
                warn_once(cursor, cursor.here(), "\nhalo", "'-halo' is not used");
                cursor.token("-halo");
            }
            dissolve_ = number_in(cursor, "d and an opacity", 0, 1);
        } else if (keyword == "Tr") {
            transparency_ = number_in(cursor, "Tr and a transparency", 0, 1);
        } else if (keyword == "illum") {
            illumination(cursor);
        } else if (keyword == "Pr") {
            m.roughness = number_in(cursor, "Pr and a roughness", 0, 1);
        } else if (keyword == "Pm") {
            m.metallic = number_in(cursor, "Pm and a metalness", 0, 1);
        } else if (keyword == "Pc") {
            m.clearcoat = number_in(cursor, "Pc and a clearcoat", 0, 1);
        } else if (keyword == "checker_Kd") {
            checker(cursor);
        } else if (keyword == "highlight") {
            highlight(cursor);
        } else if (keyword == "bsdf") {
            m.model = read_reflection_model(cursor);
        }
        cursor.expect_end("the end of the line");
    }

    void illumination(LineCursor& cursor) {
        const char* const at = cursor.here();
        const int illum = cursor.integer("illum and a number from 0 to 10");
        if (illum >= 0 && illum <= 10) material().illum = illum;
        else warn_once(cursor, at, "\nillum", "no such illumination model; 2 is used", "expected 0 to 10");
    }

    void checker(LineCursor& cursor) {
        constexpr std::string_view kForm = "checker_Kd cells_u cells_v r g b";
        scene::Checker checker;
        checker.cells_u = number_in(cursor, kForm, 0, 1e6F);
        checker.cells_v = number_in(cursor, kForm, 0, 1e6F);
        for (std::size_t i = 0; i < 3; ++i) checker.other[i] = number_in(cursor, kForm, 0, 1e6F);
        material().checker = checker;
    }

    void highlight(LineCursor& cursor) {
        const char* const at = cursor.here();
        const std::string_view kind = cursor.token("highlight phong or highlight blinn");
        if (kind != "phong" && kind != "blinn") {
            constexpr std::array<std::string_view, 2> kKinds = {"phong", "blinn"};
            cursor.fail(at, "unknown highlight " + in_quotes(kind), suggest(kind, kKinds));
        }
        material().phong_highlight = kind == "phong";
    }

    /// A number that is moved to the nearest end of its range, with a warning, where it lies outside.
    float number_in(LineCursor& cursor, std::string_view expected, float low, float high) {
        const char* const at = cursor.here();
        const float value = cursor.number(expected);
        const float inside = std::clamp(value, low, high);
        if (inside != value) {
            std::string range = high >= 1e6F ? "0 or more" : "0 to " + std::to_string(static_cast<int>(high));
            warn_once(cursor, at, expected, "number out of its range; the nearest possible one is used",
                      "expected " + std::move(range));
        }
        return inside;
    }

    /// r g b | v (for all three) | xyz x y z | spectral file (not supported: false).
    bool color(LineCursor& cursor, const char* at, std::string_view keyword, Vec3& value) {
        const std::string form = std::string(keyword) + " r g b, with numbers of 0 or more";
        if (cursor.peek() == "spectral") {
            warn_once(cursor, at, "\nspectral",
                      "spectral curves are not used; " + in_quotes(keyword) + " stays as it was");
            cursor.rest("spectral and a file");
            return false;
        }
        const bool xyz = cursor.peek() == "xyz";
        if (xyz) cursor.token("xyz");
        Vec3 c;
        c.x = number_in(cursor, form, 0, 1e6F);
        if (cursor.at_end()) {
            c.y = c.z = c.x;
        } else {
            c.y = number_in(cursor, form, 0, 1e6F);
            c.z = number_in(cursor, form, 0, 1e6F);
        }
        value = xyz ? rgb_from_xyz(c) : c;
        return true;
    }

    void map(LineCursor& cursor, std::string_view keyword) {
        scene::MtlSurface& m = material();
        // Ambient light takes the diffuse texture, as nearly all files mean it.
        if (keyword == "map_Ka") return;
        MapKind kind = MapKind::color;
        scene::TextureUse* use = nullptr;
        if (keyword == "map_Kd") use = &m.map_diffuse;
        else if (keyword == "map_Ks") use = &m.map_specular;
        else if (keyword == "map_Ke") use = &m.map_emission;
        else if (keyword == "norm" || keyword == "map_Kn") use = &m.map_normal, kind = MapKind::normal;
        else if (keyword == "map_d" || keyword == "map_Tr" || keyword == "map_opacity")
            use = &m.map_opacity, kind = MapKind::opacity;
        else use = &m.map_bump, kind = MapKind::height;
        *use = read_texture_use(cursor, kind, file_, scene_, [&](const Diagnostic& diagnostic, std::string_view key) {
            constexpr std::size_t kMostWarnings = 64;
            if (warned_.size() < kMostWarnings && warned_.insert(std::string(key)).second) warn(diagnostic);
        });
    }

    const SourceText& source_;
    const std::filesystem::path& file_;
    scene::Scene& scene_;
    const WarningSink& warn_;
    bool in_material_ = false;
    std::optional<float> dissolve_, transparency_;
    std::unordered_set<std::string> names_;
    std::unordered_set<std::string> warned_;
};

}  // namespace

void read_mtl(const SourceText& source, const std::filesystem::path& file, scene::Scene& scene,
              const WarningSink& warn) {
    MtlReader(source, file, scene, warn).run();
}

}  // namespace sundog::import
