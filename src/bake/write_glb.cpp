// SPDX-License-Identifier: Apache-2.0
#include "bake/write_glb.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "base/srgb.h"
#include "output/image.h"
#include "scene/environment.h"

namespace sundog::bake {
namespace {

using Json = nlohmann::ordered_json;

// Of the specification's section 3.6.2 and OpenGL's headers.
constexpr int kFloat = 5126, kUnsignedInt = 5125, kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr int kRepeat = 10497, kClampToEdge = 33071, kMirroredRepeat = 33648, kNearest = 9728, kLinear = 9729;

/// The axes of a scene's space in glTF's, in which Y is up and systems are right-handed.
struct Axes {
    explicit Axes(const scene::Scene& scene) {
        const scene::Compass compass = scene::compass_of(scene);
        up = compass.up;
        back = compass.middle * -1;
        right = compass.mirrored ? cross(up, compass.middle) : cross(compass.middle, up);
        mirrored = compass.mirrored;
    }
    [[nodiscard]] Vec3 operator()(Vec3 v) const { return {dot(right, v), dot(up, v), dot(back, v)}; }
    Vec3 up, back, right;
    bool mirrored;
};

class Glb {
public:
    Glb(const scene::Scene& scene, const Axes& axes) : scene_(scene), axes_(axes) {
        json_["asset"] = {{"version", "2.0"}, {"generator", "Sundog"}};
        json_["extensionsUsed"] = {"KHR_materials_unlit"};
        json_["scene"] = 0;
        json_["scenes"] = {{{"nodes", Json::array()}}};
    }

    void add(const Part& part) {
        std::vector<Vec3> positions, normals;
        Vec3 least = axes_(part.positions[0]), most = least;
        for (std::size_t i = 0; i < part.positions.size(); ++i) {
            positions.push_back(axes_(part.positions[i]));
            normals.push_back(axes_(part.normals[i]));
            least = min(least, positions.back());
            most = max(most, positions.back());
        }
        Json attributes;
        const std::size_t at = accessor(positions, "VEC3", kFloat, kArrayBuffer);
        json_["accessors"][at]["min"] = {least.x, least.y, least.z};
        json_["accessors"][at]["max"] = {most.x, most.y, most.z};
        attributes["POSITION"] = at;
        attributes["NORMAL"] = accessor(normals, "VEC3", kFloat, kArrayBuffer);
        attributes["COLOR_0"] = accessor(part.light, "VEC3", kFloat, kArrayBuffer);
        const scene::TextureUse* const map = map_of(part.material);
        if (map != nullptr) {
            std::vector<Vec2> places;
            // Turned and stretched as the material asks; v downwards.
            for (const Vec2 uv : part.texcoords)
                places.push_back({uv.x * map->scale.x + uv.y * map->shear.x + map->offset.x,
                                  1 - (uv.y * map->scale.y + uv.x * map->shear.y + map->offset.y)});
            attributes["TEXCOORD_0"] = accessor(places, "VEC2", kFloat, kArrayBuffer);
        }
        std::vector<std::array<std::uint32_t, 3>> triangles = part.triangles;
        if (axes_.mirrored)
            for (auto& t : triangles) std::swap(t[1], t[2]);
        const std::size_t indices = accessor(triangles, "SCALAR", kUnsignedInt, kElementArrayBuffer, 3);
        json_["meshes"].push_back(
            {{"name", part.object},
             {"primitives", {{{"attributes", attributes}, {"indices", indices}, {"material", material(part)}}}}});
        add_node({{"name", part.object}, {"mesh", json_["meshes"].size() - 1}});
    }

    void add_camera(const kernel::Camera& camera) {
        const auto vec = [](kernel::vec3 v) { return Vec3{v.x, v.y, v.z}; };
        const Vec3 center = axes_(vec(camera.center)), up = axes_(vec(camera.up)), right = axes_(vec(camera.right));
        const float ahead = length(center), high = length(up), wide = length(right);
        if (!(ahead > 0 && high > 0 && wide > 0)) return;
        json_["cameras"] = {
            {{"type", "perspective"},
             {"perspective", {{"yfov", 2 * std::atan(high / ahead)}, {"aspectRatio", wide / high}, {"znear", 0.01}}}}};
        const Vec3 x = right * (1 / wide), y = up * (1 / high), z = center * (-1 / ahead), t = axes_(vec(camera.eye));
        add_node({{"camera", 0}, {"matrix", {x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, t.x, t.y, t.z, 1}}});
    }

    /// The file's bytes: a header, and two chunks padded to four bytes (section 4.4).
    [[nodiscard]] std::string bytes() {
        if (!json_.contains("meshes")) json_["meshes"] = Json::array();
        json_["buffers"] = {{{"byteLength", binary_.size()}}};
        std::string text = json_.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
        std::string out;
        const auto word = [&](std::size_t value) {
            const auto bits = static_cast<std::uint32_t>(value);
            out.append(reinterpret_cast<const char*>(&bits), sizeof(bits));
        };
        static_assert(std::endian::native == std::endian::little);
        const std::size_t total = 12 + 8 + text.size() + 8 + binary_.size();
        if (total > 0xffffffffU) throw OutputError("a binary glTF file holds at most 4 GiB; make patches larger");
        word(0x46546c67), word(2), word(total);
        word(text.size()), word(0x4e4f534a), out += text;
        word(binary_.size()), word(0x004e4942), out += binary_;
        return out;
    }

private:
    void add_node(Json node) {
        json_["scenes"][0]["nodes"].push_back(json_.contains("nodes") ? json_["nodes"].size() : 0);
        json_["nodes"].push_back(std::move(node));
    }

    std::size_t view(const void* data, std::size_t size, int target) {
        binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
        Json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", size}};
        if (target != 0) view["target"] = target;
        json_["bufferViews"].push_back(std::move(view));
        binary_.append(static_cast<const char*>(data), size);
        return json_["bufferViews"].size() - 1;
    }

    template <class T>
    std::size_t accessor(const std::vector<T>& values, const char* type, int component, int target,
                         std::size_t elements_each = 1) {
        const std::size_t at = view(values.data(), values.size() * sizeof(T), target);
        json_["accessors"].push_back({{"bufferView", at},
                                      {"componentType", component},
                                      {"count", values.size() * elements_each},
                                      {"type", type}});
        return json_["accessors"].size() - 1;
    }

    [[nodiscard]] const scene::TextureUse* map_of(scene::Index material) const {
        const scene::Material& m = scene_.materials[material];
        const scene::TextureUse* map = nullptr;
        if (m.principled) map = &m.principled->base_color_map;
        else if (!m.patterned) map = &m.mtl->map_diffuse;
        return map != nullptr && map->texture != scene::kNone ? map : nullptr;
    }

    std::size_t image(scene::Index texture) {
        const auto [known, is_new] = images_.try_emplace(texture, images_.size());
        if (!is_new) return known->second;
        const scene::Texture& t = scene_.textures[texture];
        output::Image picture;
        picture.width = static_cast<int>(t.width);
        picture.height = static_cast<int>(t.height);
        for (const std::uint32_t texel : t.rgba8) {
            const auto channel = [&](unsigned shift) {
                const std::uint32_t code = (texel >> shift) & 255U;
                // The file is encoded as sRGB: numbers that aren't are stored as if they were.
                return linear_of_srgb8()[code];
            };
            picture.pixels.push_back({channel(0), channel(8), channel(16)});
            picture.alpha.push_back(static_cast<float>(texel >> 24U) / 255);
        }
        const std::string png = output::encode(picture, output::Format::png);
        json_["images"].push_back({{"mimeType", "image/png"}, {"bufferView", view(png.data(), png.size(), 0)}});
        return known->second;
    }

    std::size_t texture_of(const scene::TextureUse& use) {
        const auto wrap = [](scene::TextureUse::Wrap w) {
            if (w == scene::TextureUse::Wrap::clamp) return kClampToEdge;
            return w == scene::TextureUse::Wrap::mirror ? kMirroredRepeat : kRepeat;
        };
        const std::size_t source = image(use.texture);
        const int filter = use.nearest ? kNearest : kLinear;
        json_["samplers"].push_back(
            {{"magFilter", filter}, {"minFilter", filter}, {"wrapS", wrap(use.wrap_u)}, {"wrapT", wrap(use.wrap_v)}});
        json_["textures"].push_back({{"sampler", json_["samplers"].size() - 1}, {"source", source}});
        return json_["textures"].size() - 1;
    }

    std::size_t material(const Part& part) {
        const auto [known, is_new] = materials_.try_emplace(part.material, materials_.size());
        if (!is_new) return known->second;
        Json m = {{"name", scene_.materials[part.material].name}, {"doubleSided", true}};
        m["pbrMetallicRoughness"] = {{"baseColorFactor", {1, 1, 1, 1}}};
        if (const scene::TextureUse* map = map_of(part.material))
            m["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", texture_of(*map)}};
        m["extensions"]["KHR_materials_unlit"] = Json::object();
        json_["materials"].push_back(std::move(m));
        return known->second;
    }

    const scene::Scene& scene_;
    const Axes& axes_;
    Json json_;
    std::string binary_;
    std::map<scene::Index, std::size_t> images_, materials_;
};

}  // namespace

void write_glb(const std::filesystem::path& file, const scene::Scene& scene, const BakedScene& baked,
               const Frame& frame) {
    const Axes axes(scene);
    Glb glb(scene, axes);
    for (const Part& part : baked.parts) glb.add(part);
    if (frame.params.camera_kind == kernel::CAMERA_PERSPECTIVE && !frame.camera_rays)
        glb.add_camera(frame.params.camera);
    output::write_file_atomically(file, glb.bytes());
}

}  // namespace sundog::bake
