// SPDX-License-Identifier: Apache-2.0
#include "bake/matt.h"

#include "compile/material.h"

namespace sundog::bake {
namespace {

constexpr Vec3 kWhite{1, 1, 1};

void make_matt(scene::MtlSurface& m) {
    if (m.illum == 0) return;
    const Vec3 passes = mtl_refracts(m.illum) ? mtl_transmittance(m) : Vec3{};
    if (passes.x > 0 || passes.y > 0 || passes.z > 0) {
        m.diffuse = min(m.diffuse + passes, kWhite);
        m.opacity = 1;
        m.transmission_filter = kWhite;
        m.ior = 1;
    } else if (mtl_mirrors(m.illum)) {
        m.diffuse = min(m.diffuse + m.specular, kWhite);
    }
    if (m.illum >= 3) m.illum = 1;
    m.roughness = m.metallic = m.clearcoat = std::nullopt;
}

void make_matt(scene::PrincipledSurface& p) {
    p.metallic = 0;
    p.transmission = 0;
    p.clearcoat = 0;
}

}  // namespace

void make_matt(scene::Scene& scene) {
    for (scene::Material& material : scene.materials) {
        if (material.principled) make_matt(*material.principled);
        else if (!material.patterned) make_matt(*material.mtl);
    }
}

}  // namespace sundog::bake
