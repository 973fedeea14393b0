// SPDX-License-Identifier: Apache-2.0
#include "import/gltf/images.h"

#include <array>
#include <cmath>

#include "output/file.h"
#include "output/image.h"
#include "scene/files.h"
#include "scene/stand_in.h"

namespace sundog::import::gltf {
namespace {

using Wrap = scene::TextureUse::Wrap;

Wrap wrap_of(const Json& sampler, const char* name) {
    const Json value = sampler ? sampler.member(name) : Json{};
    if (!value) return Wrap::repeat;
    switch (value.whole()) {
        case 10497:
            return Wrap::repeat;
        case 33071:
            return Wrap::clamp;
        case 33648:
            return Wrap::mirror;
        default:
            value.fail("unknown way to wrap", "expected one of: 10497, 33071, 33648");
    }
}

/// How the coordinates move, in glTF's space, where v points down: KHR_texture_transform's translation * rotation *
/// scale. Ours points up: v = 1 - v' on both sides.
void set_transform(const Json& transform, scene::TextureUse& use) {
    Vec2 offset{0, 0};
    Vec2 scale{1, 1};
    float angle_rad = 0;
    if (transform) {
        const auto pair = [&](const char* name, Vec2 otherwise) {
            const Json value = transform.member(name);
            if (!value) return otherwise;
            const std::vector<float> v = value.numbers(2);
            return Vec2{v[0], v[1]};
        };
        offset = pair("offset", offset);
        scale = pair("scale", scale);
        angle_rad = transform.number_or("rotation", 0);
    }
    const float c = std::cos(angle_rad);
    const float s = std::sin(angle_rad);
    // u' = c*sx*u + s*sy*v + ox;  v' = -s*sx*u + c*sy*v + oy, with v pointing down.
    const float m00 = c * scale.x;
    const float m01 = s * scale.y;
    const float m10 = -s * scale.x;
    const float m11 = c * scale.y;
    use.scale = {m00, m11};
    use.shear = {-m01, -m10};
    use.offset = {m01 + offset.x, 1 - m11 - offset.y};
    if (!std::isfinite(use.offset.x) || !std::isfinite(use.offset.y)) transform.fail("the numbers are too large");
}

/// What stands for a picture of what can't be read.
constexpr std::array<std::string_view, 3> kOtherPictures = {"KHR_texture_basisu", "EXT_texture_webp",
                                                            "EXT_texture_avif"};

}  // namespace

scene::TextureUse TextureReader::read(const Json& info, TextureMeaning meaning) {
    scene::TextureUse use;
    if (!info) return use;
    const std::size_t number = info.required_index("index", asset_.list("textures").size(), "textures");
    const Json texture = asset_.list("textures")[number];
    use.texture = picture(number, meaning);
    if (use.texture == scene::kNone) return use;
    const Json transform = info.extension("KHR_texture_transform");
    set_transform(transform, use);
    const Json set_json =
        transform && transform.member("texCoord") ? transform.member("texCoord") : info.member("texCoord");
    if (set_json) use.uv_set = static_cast<std::uint8_t>(set_json.whole(255));
    read_sampler(texture, use);
    return use;
}

void TextureReader::read_sampler(const Json& texture, scene::TextureUse& use) {
    const auto number = texture.index_or_none("sampler", asset_.list("samplers").size(), "samplers");
    if (!number) return;
    const Json sampler = asset_.list("samplers")[*number];
    use.wrap_u = wrap_of(sampler, "wrapS");
    use.wrap_v = wrap_of(sampler, "wrapT");
    const Json filter = sampler.member("magFilter");
    if (filter && filter.whole() != 9728 && filter.whole() != 9729)
        filter.fail("unknown filter", "expected one of: 9728, 9729");
    use.nearest = filter && filter.whole() == 9728;
}

scene::Index TextureReader::picture(std::size_t number, TextureMeaning meaning) {
    const Json texture = asset_.list("textures")[number];
    const std::size_t count = asset_.list("images").size();
    const auto source = texture.index_or_none("source", count, "images");
    if (source) return load(*source, meaning);
    std::string why = "the texture names no picture";
    for (const std::string_view name : kOtherPictures)
        if (texture.extension(std::string(name).c_str()))
            why = "the texture's only picture is one of " + std::string(name);
    const bool shown = meaning == TextureMeaning::color;
    asset_.warn_once("texture " + std::to_string(number) + (shown ? "" : " as data"), texture, why,
                     shown ? "a checker of magenta and black stands in" : "the map is left off");
    return shown ? scene::missing_texture(asset_.scene()) : scene::kNone;
}

scene::Index TextureReader::load(std::size_t image, TextureMeaning meaning) {
    const bool srgb = meaning == TextureMeaning::color;
    const std::size_t key = 2 * image + (srgb ? 0 : 1);
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    scene::Scene& scene = asset_.scene();
    const Json json = asset_.list("images")[image];
    scene::Texture texture;
    texture.srgb = srgb;
    texture.where = places_[image];
    texture.name = json.string_or("name", "images[" + std::to_string(image) + "]");
    std::string fault;
    if (const auto other = known_.find(key ^ 1U); other != known_.end() && other->second != scene::kNone &&
                                                  scene.textures[other->second].name != "(missing texture)") {
        const scene::Texture& same = scene.textures[other->second];
        texture.width = same.width, texture.height = same.height, texture.rgba8 = same.rgba8;
    } else {
        std::vector<unsigned char> own;
        Bytes bytes;
        const Json uri = json.member("uri");
        const auto view = json.index_or_none("bufferView", asset_.list("bufferViews").size(), "bufferViews");
        if (!uri && !view) json.fail("lacks 'uri' or 'bufferView'");
        try {
            if (view) {
                bytes = asset_.view(*view);
            } else if (auto data = decode_data_uri(uri)) {
                bytes = own = std::move(*data);
            } else {
                const std::filesystem::path file = file_of_uri(asset_.file(), uri.string());
                if (file.empty()) fault = "missing picture " + in_quotes(uri.string());
                else bytes = own = output::read_file(file), scene::add_file(scene, file), texture.name = file.string();
            }
            if (fault.empty()) {
                output::Rgba8 pixels = output::decode_rgba8(bytes, *asset_.name());
                texture.width = pixels.width, texture.height = pixels.height;
                texture.rgba8 = std::move(pixels.pixels);
            }
        } catch (const InputError& error) {
            fault = "unreadable picture (" + error.diagnostic().message + ')';
        }
    }
    scene::Index index = scene::kNone;
    if (fault.empty()) {
        asset_.take_memory(texture.rgba8.size() * sizeof(std::uint32_t), json);
        index = static_cast<scene::Index>(scene.textures.size());
        scene.textures.push_back(std::move(texture));
    } else {
        asset_.warn_once("image " + std::to_string(key), json, fault,
                         srgb ? "a checker of magenta and black stands in" : "the map is left off");
        if (srgb) index = scene::missing_texture(scene);
    }
    known_.emplace(key, index);
    return index;
}

}  // namespace sundog::import::gltf
