// SPDX-License-Identifier: Apache-2.0
#include "alpha.h"

#include <algorithm>
#include <map>
#include <memory>

namespace sundog::app {
namespace {

/// The texture with its pigments, which filter light, and nothing that gives or mirrors any.
std::shared_ptr<const scene::LayeredTexture> unlit(const scene::LayeredTexture& texture) {
    auto copy = std::make_shared<scene::LayeredTexture>(texture);
    for (scene::TextureLayer& layer : copy->layers) {
        layer.finish = {};
        layer.finish.ambient = {0, 0, 0};
        layer.finish.diffuse = 0;
    }
    return copy;
}

}  // namespace

bool shows_transparent_sky(const scene::Scene& scene) {
    return scene.sky_alpha < 1 && scene.sky_spheres.empty() && scene.fogs.empty();
}

void leave_only_the_sky(scene::Scene& scene) {
    std::map<const scene::LayeredTexture*, std::shared_ptr<const scene::LayeredTexture>> unlit_textures;
    for (scene::Material& material : scene.materials) {
        if (!material.patterned) continue;
        auto& texture = material.patterned->texture;
        auto& replacement = unlit_textures[texture.get()];
        if (!replacement) replacement = unlit(*texture);
        texture = replacement;
    }
    scene.lights.clear();
    scene.radiosity.reset();
    scene.photons.reset();
    scene.ambient = {0, 0, 0};
    scene.sky = {1, 1, 1};
}

void add_alpha(output::Image& image, const Film& sky_share, const scene::Scene& scene) {
    image.alpha.assign(image.pixels.size(), 1.0F);
    const PixelRect& bounds = sky_share.bounds;
    for (int y = 0; y < bounds.height(); ++y) {
        for (int x = 0; x < bounds.width(); ++x) {
            const Vec3 seen = sky_share.mean(bounds.x0 + x, bounds.y0 + y);
            const float clear = 1 - scene.sky_alpha;
            const float share = std::clamp((seen.x + seen.y + seen.z) / 3, 0.0F, 1.0F);
            const float alpha = 1 - share * clear;
            Vec3& pixel = image.at(x, y);
            const Vec3 without_sky =
                pixel - Vec3{seen.x * scene.sky.x, seen.y * scene.sky.y, seen.z * scene.sky.z} * clear;
            pixel = alpha > 0 ? without_sky * (1 / alpha) : Vec3{};
            image.alpha[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                        static_cast<std::size_t>(x)] = alpha;
        }
    }
}

}  // namespace sundog::app
