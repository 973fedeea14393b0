// SPDX-License-Identifier: Apache-2.0
#include "import/obj/mtl_texture.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "base/paths.h"
#include "import/obj/textures.h"
#include "scene/stand_in.h"

namespace sundog::import {
namespace {

constexpr std::array<std::string_view, 13> kOptions = {
    "-s", "-o", "-t", "-mm", "-bm", "-clamp", "-imfchan", "-blendu", "-blendv", "-cc", "-boost", "-texres", "-type"};
constexpr std::uint8_t kAlphaChannel = 3;
constexpr std::uint8_t kLuminanceChannel = 4;
constexpr std::uint8_t kUnset = 0xff;

bool has_alpha(const scene::Texture& texture) {
    return std::any_of(texture.rgba8.begin(), texture.rgba8.end(),
                       [](std::uint32_t texel) { return texel >> 24U != 0xff; });
}

bool on_or_off(LineCursor& cursor, std::string_view option) {
    const char* const at = cursor.here();
    const std::string expected = std::string(option) + " on or " + std::string(option) + " off";
    const std::string_view word = cursor.token(expected);
    if (word != "on" && word != "off")
        cursor.fail(at, "expected on or off, found " + in_quotes(word), "expected " + expected);
    return word == "on";
}

/// One number and up to two more, of which only the first two count.
Vec2 pair(LineCursor& cursor, std::string_view option, Vec2 value) {
    value.x = cursor.number(std::string(option) + " u v w, one to three numbers");
    float third = 0;
    if (cursor.maybe_number(value.y)) cursor.maybe_number(third);
    return value;
}

std::uint8_t channel(LineCursor& cursor) {
    const char* const at = cursor.here();
    const std::string_view word = cursor.token("-imfchan and one of r, g, b, m, l, z");
    if (word == "r" || word == "z") return 0;
    if (word == "g") return 1;
    if (word == "b") return 2;
    if (word == "m") return kAlphaChannel;
    if (word == "l") return kLuminanceChannel;
    cursor.fail(at, "unknown channel " + in_quotes(word), "expected one of: r, g, b, m, l, z");
}

/// Reads one option; false where the file name starts instead.
bool option(LineCursor& cursor, scene::TextureUse& use, const KeyedWarningSink& warn) {
    const char* const at = cursor.here();
    const std::string_view word = cursor.peek();
    if (word.empty() || word.front() != '-') return false;
    if (std::find(kOptions.begin(), kOptions.end(), word) == kOptions.end()) {
        // A file name may start with a dash too; an option is a dash and letters.
        if (word.find('.') != std::string_view::npos) return false;
        cursor.fail(at, "unknown texture option " + in_quotes(word), suggest(word, kOptions));
    }
    cursor.token(word);
    const auto not_used = [&](const char* why) {
        warn(cursor.warning(at, in_quotes(word) + " is not used" + why), word);
    };
    if (word == "-s") {
        use.scale = pair(cursor, word, use.scale);
    } else if (word == "-o") {
        use.offset = pair(cursor, word, use.offset);
    } else if (word == "-t") {
        pair(cursor, word, {});
        not_used(": textures have no turbulence");
    } else if (word == "-mm") {
        const float base = cursor.number("-mm base gain");
        const float gain = cursor.number("-mm base gain");
        if (base != 0 || gain != 1) not_used("");
    } else if (word == "-bm") {
        use.strength = cursor.number("-bm and a factor");
    } else if (word == "-clamp") {
        use.wrap_u = use.wrap_v =
            on_or_off(cursor, word) ? scene::TextureUse::Wrap::clamp : scene::TextureUse::Wrap::repeat;
    } else if (word == "-imfchan") {
        use.channel = channel(cursor);
    } else if (word == "-blendu" || word == "-blendv") {
        on_or_off(cursor, word);
    } else if (word == "-cc") {
        if (on_or_off(cursor, word)) not_used("");
    } else if (word == "-boost" || word == "-texres") {
        cursor.number(std::string(word) + " and a number");
    } else {
        cursor.token("-type and a kind of map");
        not_used("");
    }
    return true;
}

}  // namespace

scene::TextureUse read_texture_use(LineCursor& cursor, MapKind kind, const std::filesystem::path& library,
                                   scene::Scene& scene, const KeyedWarningSink& warn) {
    scene::TextureUse use;
    use.channel = kUnset;
    while (option(cursor, use, warn)) {
    }
    const bool channel_unset = use.channel == kUnset;
    if (channel_unset) use.channel = kind == MapKind::height || kind == MapKind::opacity ? kLuminanceChannel : 0;
    const char* const at = cursor.here();
    const std::string_view name = cursor.rest("the name of a texture file");
    const std::filesystem::path file = find_file(library, name);
    std::string fault;
    if (file.empty()) {
        fault = "missing texture " + in_quotes(name);
    } else {
        try {
            use.texture = texture_from_file(scene, file, kind == MapKind::color, cursor.location(at));
            if (kind == MapKind::opacity && channel_unset && has_alpha(scene.textures[use.texture]))
                use.channel = kAlphaChannel;
            return use;
        } catch (const InputError& error) {
            fault = "unreadable texture " + in_quotes(name) + " (" + error.diagnostic().message + ')';
        }
    }
    const bool shown = kind == MapKind::color;
    warn(cursor.warning(at, fault, shown ? "a checker of magenta and black stands in" : "the map is left off"), name);
    if (shown) use.texture = scene::missing_texture(scene);
    return use;
}

}  // namespace sundog::import
