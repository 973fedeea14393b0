// SPDX-License-Identifier: Apache-2.0
// Text as prisms of its glyphs' outlines (POV-Ray reference, section 3.4.5.1.16 "Text").
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "import/pov/build_shape.h"

namespace sundog::pov {
namespace {

struct CloseLibrary {
    void operator()(FT_Library library) const { FT_Done_FreeType(library); }
};
struct CloseFace {
    void operator()(FT_Face face) const { FT_Done_Face(face); }
};
using Library = std::unique_ptr<FT_LibraryRec_, CloseLibrary>;
using Face = std::unique_ptr<FT_FaceRec_, CloseFace>;

using Point = std::array<double, 2>;

/// Collects an outline as the four points a curve that a prism's bezier_spline takes.
struct CurveCollector {
    std::vector<Point> points;
    Point current{}, start{};
    double scale = 1;

    [[nodiscard]] Point scaled(const FT_Vector& v) const {
        return {static_cast<double>(v.x) * scale, static_cast<double>(v.y) * scale};
    }
    void curve(Point a, Point b, Point end) {
        points.insert(points.end(), {current, a, b, end});
        current = end;
    }
    void line(Point end) {
        if (end == current) return;
        const auto between = [&](double t) {
            return Point{current[0] + t * (end[0] - current[0]), current[1] + t * (end[1] - current[1])};
        };
        curve(between(1.0 / 3), between(2.0 / 3), end);
    }
    void close() { line(start); }
};

CurveCollector& collector(void* user) { return *static_cast<CurveCollector*>(user); }

int move_to(const FT_Vector* to, void* user) {
    collector(user).close();
    collector(user).current = collector(user).start = collector(user).scaled(*to);
    return 0;
}
int line_to(const FT_Vector* to, void* user) {
    collector(user).line(collector(user).scaled(*to));
    return 0;
}
/// TrueType's quadratic curves, raised to cubic ones.
int conic_to(const FT_Vector* control, const FT_Vector* to, void* user) {
    CurveCollector& c = collector(user);
    const Point q = c.scaled(*control);
    const Point end = c.scaled(*to);
    const auto raised = [&](Point from) {
        return Point{from[0] + 2.0 / 3 * (q[0] - from[0]), from[1] + 2.0 / 3 * (q[1] - from[1])};
    };
    c.curve(raised(c.current), raised(end), end);
    return 0;
}
int cubic_to(const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* user) {
    CurveCollector& c = collector(user);
    c.curve(c.scaled(*a), c.scaled(*b), c.scaled(*to));
    return 0;
}

std::vector<Point> outline_of(FT_Outline& outline, double scale) {
    CurveCollector curves;
    curves.scale = scale;
    FT_Outline_Funcs functions{};
    functions.move_to = move_to, functions.line_to = line_to;
    functions.conic_to = conic_to, functions.cubic_to = cubic_to;
    FT_Outline_Decompose(&outline, &functions, &curves);
    curves.close();
    return std::move(curves.points);
}

/// The code points of UTF-8 text; bytes that are no UTF-8 stand for themselves (Latin-1).
std::vector<char32_t> code_points(const std::string& text) {
    std::vector<char32_t> result;
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t length = lead < 0x80        ? 1
                                   : lead >> 5U == 6  ? 2
                                   : lead >> 4U == 14 ? 3
                                   : lead >> 3U == 30 ? 4
                                                      : 0;
        char32_t point = length <= 1 ? lead : lead & (0x7FU >> length);
        bool valid = length > 0 && i + length <= text.size();
        for (std::size_t k = 1; valid && k < length; ++k) {
            const auto next = static_cast<unsigned char>(text[i + k]);
            valid = next >> 6U == 2;
            point = point << 6U | (next & 0x3FU);
        }
        result.push_back(valid ? point : lead);
        i += valid ? length : 1;
    }
    return result;
}

/// Where fonts are that scenes name without bringing them, with or without their suffix: POV-Ray's own, then what most
/// systems have.
std::filesystem::path find_font(BuildContext& context, const std::string& name, Place where) {
    const auto readable = [](const std::filesystem::path& file) {
        std::error_code error;
        return std::filesystem::is_regular_file(file, error);
    };
    for (const char* suffix : {"", ".ttf", ".ttc"}) {
        const std::string full = name + suffix;
        if (std::filesystem::path file = context.find_file(full, where); !file.empty()) return file;
        for (const char* folder : {"/usr/share/fonts/truetype/povray", "/usr/local/share/povray-3.7/include"}) {
            std::filesystem::path file = std::filesystem::path(folder) / std::filesystem::path(full).filename();
            if (readable(file)) return file;
        }
    }
    for (const char* font : {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                             "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
                             "/usr/share/fonts/truetype/freefont/FreeSans.ttf"}) {
        if (!readable(font)) continue;
        context.warn(where, "missing font '" + name + "', " + font + " stands in for it",
                     context.why_not_found(name, where));
        return font;
    }
    return {};
}

std::string built_in_font(int number) {
    constexpr std::array<const char*, 4> kNames{"povlogo.ttf", "timrom.ttf", "cyrvetic.ttf", "crystal.ttf"};
    return kNames[number >= 0 && number < 4 ? static_cast<std::size_t>(number) : 0];
}

/// A glyph's prism lies in x and z; the text's front is in x and y, and it goes back along z.
NodePointer glyph_node(std::vector<Point> outline, double thickness, Vec3d at, Place where) {
    auto node = std::make_shared<Node>();
    node->where = where;
    node->keyword = Keyword::text;
    scene::Prism prism;
    prism.spline = scene::SplineKind::bezier;
    prism.lower = std::min(0.0, thickness), prism.upper = std::max(0.0, thickness);
    prism.points = std::move(outline);
    node->shape = std::move(prism);
    node->parent_from_shape = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, at};
    return node;
}

}  // namespace

NodeShape read_text(ItemReader& items) {
    BuildContext& context = items.context();
    std::string name;
    if (items.take(Keyword::internal)) {
        name = built_in_font(items.integer("the number of a font", -1000000, 1000000));
    } else {
        items.take(Keyword::ttf);
        name = items.text("the name of a font file in quotes");
    }
    const Place where = items.taken_where();
    const std::string text = items.text("the text in quotes");
    const double thickness = items.number("the thickness of the text");
    const Vec3d offset = items.vector("the extra space between letters");

    const std::filesystem::path file = find_font(context, name, where);
    FT_Library raw_library = nullptr;
    if (file.empty() || FT_Init_FreeType(&raw_library) != 0) {
        context.warn(where, "missing font '" + name + "', its text is left out", context.why_not_found(name, where));
        return {};
    }
    const Library library(raw_library);
    FT_Face raw_face = nullptr;
    if (FT_New_Face(library.get(), file.c_str(), 0, &raw_face) != 0) {
        context.warn(where, "'" + file.string() + "' is no font, its text is left out");
        return {};
    }
    const Face face(raw_face);
    const double scale = 1.0 / std::max<int>(face->units_per_EM, 1);
    NodeGroup group;
    Vec3d pen;
    FT_UInt before = 0;
    bool is_first = true;
    for (const char32_t point : code_points(text)) {
        const FT_UInt glyph = FT_Get_Char_Index(face.get(), point);
        FT_Vector kerning{};
        if (before != 0 && glyph != 0) FT_Get_Kerning(face.get(), before, glyph, FT_KERNING_UNSCALED, &kerning);
        pen.x += static_cast<double>(kerning.x) * scale;
        before = glyph;
        if (FT_Load_Glyph(face.get(), glyph, FT_LOAD_NO_SCALE) != 0) continue;
        // The first letter begins at 0: povray takes its left side bearing back, from the whole text.
        if (is_first) pen.x -= static_cast<double>(face->glyph->metrics.horiBearingX) * scale;
        is_first = false;
        if (std::vector<Point> outline = outline_of(face->glyph->outline, scale); !outline.empty())
            group.children.push_back(glyph_node(std::move(outline), thickness, pen, where));
        // povray heeds no space between letters along z.
        pen += Vec3d{offset.x, offset.y, 0};
        pen.x += static_cast<double>(face->glyph->metrics.horiAdvance) * scale;
    }
    if (!group.children.empty()) return group;
    items.warn("a text without visible letters; left out");
    return {};
}

}  // namespace sundog::pov
