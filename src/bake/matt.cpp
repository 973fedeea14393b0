// SPDX-License-Identifier: Apache-2.0
#include "bake/matt.h"

namespace sundog::bake {
namespace {

constexpr Vec3 kWhite{1, 1, 1};

void make_matt(scene::MtlSurface& m) {
    if (m.illum == 0) return;
    // What the numbers of illum mean is MTL's: 3 to 8 mirror, these refract.
    const bool refracts = m.illum == 4 || m.illum == 6 || m.illum == 7 || m.illum == 9;
    const bool clear = refracts && (m.opacity < 1 || !(m.transmission_filter == kWhite) || m.ior != 1);
    if (clear) {
        m.diffuse = min(m.diffuse + m.transmission_filter, kWhite);
        m.opacity = 1;
        m.transmission_filter = kWhite;
        m.ior = 1;
    } else if (m.illum >= 3 && m.illum <= 8) {
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
