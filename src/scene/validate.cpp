// SPDX-License-Identifier: Apache-2.0
#include "scene/validate.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace sundog::scene {
namespace {

[[noreturn]] void fail(const SourceLocation& where, std::string message) {
    Diagnostic diagnostic;
    diagnostic.where = where;
    diagnostic.message = std::move(message);
    throw InputError(std::move(diagnostic));
}

void require(bool holds, const SourceLocation& where, const std::string& thing, const char* fault) {
    if (!holds) fail(where, thing + ' ' + fault);
}

bool is_finite(const Motion& m) {
    return std::isfinite(m.base) && std::isfinite(m.speed) && std::isfinite(m.amplitude);
}

/// Three indices of a corner attribute: all in range, or (where allowed) all absent.
bool in_range(const std::uint32_t (&indices)[3], std::size_t count, bool may_be_absent) {
    if (may_be_absent && std::all_of(indices, indices + 3, [](std::uint32_t i) { return i == kNone; })) return true;
    return std::all_of(indices, indices + 3, [&](std::uint32_t i) { return i < count; });
}

struct ShapeCheck {
    const Scene& scene;
    const Object& object;
    const std::string thing;

    void operator()(const Boxed<Mesh>& boxed) const {
        const Mesh& mesh = *boxed;
        const auto finite = [](Vec3 v) { return sundog::is_finite(v); };
        const auto finite_uv = [](Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); };
        require(std::all_of(mesh.positions.begin(), mesh.positions.end(), finite) &&
                    std::all_of(mesh.normals.begin(), mesh.normals.end(), finite) &&
                    std::all_of(mesh.texcoords.begin(), mesh.texcoords.end(), finite_uv),
                object.where, thing, "holds a number that is not finite");
        const auto finite_attributes = [&](const Mesh::Attributes& a) {
            return finite(a.color) && finite(a.tangent) && finite_uv(a.second_texcoord) && std::isfinite(a.alpha) &&
                   std::isfinite(a.handedness);
        };
        require(std::all_of(mesh.attributes.begin(), mesh.attributes.end(), finite_attributes), object.where, thing,
                "holds a number that is not finite");
        require(mesh.attributes.empty() || mesh.attributes.size() == mesh.texcoords.size(), object.where, thing,
                "has attributes for other vertices than texture coordinates");
        for (const Mesh::Triangle& t : mesh.triangles) {
            require(in_range(t.position, mesh.positions.size(), false), object.where, thing, "lacks a vertex");
            require(in_range(t.normal, mesh.normals.size(), true), object.where, thing, "lacks a normal");
            require(in_range(t.texcoord, mesh.texcoords.size(), true), object.where, thing, "lacks a texture vertex");
            require(t.material < scene.materials.size(), object.where, thing, "lacks a material");
        }
    }
    void operator()(const Sphere& s) const {
        require(sundog::is_finite(s.center) && std::isfinite(s.radius) && s.radius > 0, object.where, thing,
                "is no sphere: its radius must be greater than 0");
        check_material();
    }
    void operator()(const Plane& p) const {
        require(std::isfinite(p.offset) && std::abs(length(p.normal) - 1) < 1e-3F, object.where, thing,
                "is no plane: its normal must have length 1");
        check_material();
    }
    void operator()(const Box& b) const {
        require(sundog::is_finite(b.lower) && sundog::is_finite(b.upper) && b.lower.x <= b.upper.x &&
                    b.lower.y <= b.upper.y && b.lower.z <= b.upper.z,
                object.where, thing, "is no box: its upper corner must lie above the lower one");
        check_material();
    }
    void operator()(const std::shared_ptr<const Solid>& solid) const {
        require(solid != nullptr, object.where, thing, "has no shape");
        check_material();
    }
    void check_material() const {
        require(object.material < scene.materials.size(), object.where, thing, "lacks a material");
    }
};

void check(const Scene& scene, const Material& material, const TextureUse& use) {
    const std::string thing = "material '" + material.name + "'";
    require(use.texture == kNone || use.texture < scene.textures.size(), material.where, thing, "lacks a texture");
    const auto finite = [](Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); };
    require(finite(use.scale) && finite(use.shear) && finite(use.offset) && std::isfinite(use.strength), material.where,
            thing, "holds a number that is not finite");
}

void check_principled(const Scene& scene, const Material& material) {
    const PrincipledSurface& s = *material.principled;
    for (const Vec3 color : {s.base_color, s.emission, s.specular_color, s.attenuation_color, s.sheen_color})
        require(sundog::is_finite(color), material.where, "material '" + material.name + "'",
                "holds a number that is not finite");
    for (const TextureUse* use : maps_of(s)) check(scene, material, *use);
}

void check(const Scene& scene, const Material& material) {
    if (material.principled) check_principled(scene, material);
    const MtlSurface& m = *material.mtl;
    const std::string thing = "material '" + material.name + "'";
    const bool finite = sundog::is_finite(m.ambient.value_or(Vec3{})) && sundog::is_finite(m.diffuse) &&
                        sundog::is_finite(m.specular) && sundog::is_finite(m.emission) &&
                        sundog::is_finite(m.transmission_filter) && std::isfinite(m.shininess) &&
                        std::isfinite(m.ior) && std::isfinite(m.opacity) &&
                        sundog::is_finite(m.checker.value_or(Checker{}).other);
    require(finite, material.where, thing, "holds a number that is not finite");
    require(m.ior > 0, material.where, thing, "has an index of refraction of 0 or less");
    require(m.opacity >= 0 && m.opacity <= 1, material.where, thing, "has an opacity outside of 0 to 1");
    for (const TextureUse* use :
         {&m.map_diffuse, &m.map_specular, &m.map_bump, &m.map_normal, &m.map_opacity, &m.map_emission})
        check(scene, material, *use);
}

}  // namespace

void validate(const Scene& scene) {
    require(!scene.materials.empty(), {}, "the scene", "has no material");
    for (const Texture& t : scene.textures) {
        require(t.width > 0 && t.height > 0 && t.rgba8.size() == std::size_t{t.width} * t.height, t.where,
                "texture '" + t.name + "'", "has not as many pixels as its size says");
    }
    for (const Material& m : scene.materials) check(scene, m);
    for (const Object& object : scene.objects) {
        const std::string thing = "object '" + object.name + "'";
        std::visit(ShapeCheck{scene, object, thing}, object.shape);
        if (object.node_motion) {
            const NodeMotion& motion = *object.node_motion;
            require(motion.tree && motion.node < motion.tree->nodes.size(), object.where, thing,
                    "moves with a node that doesn't exist");
        }
        if (!object.motion) continue;
        const ObjectMotion& m = *object.motion;
        require(sundog::is_finite(m.center) && sundog::is_finite(m.move_speed) && sundog::is_finite(m.move_amplitude) &&
                    is_finite(m.rot_x_deg) && is_finite(m.rot_y_deg) && is_finite(m.rot_z_deg),
                object.where, thing, "moves by a number that is not finite");
    }
    for (const Light& light : scene.lights) {
        require(sundog::is_finite(light.place) && sundog::is_finite(light.color) && sundog::is_finite(light.speed) &&
                    sundog::is_finite(light.amplitude),
                light.where, "a light", "holds a number that is not finite");
    }
    const OrbitCamera& camera = scene.camera;
    require(std::isfinite(camera.focus) && camera.focus > 0 && std::isfinite(camera.distance) &&
                sundog::is_finite(camera.origin) && is_finite(camera.rot_x_deg) && is_finite(camera.rot_z_deg),
            camera.where, "the camera", "needs finite numbers and a focus greater than 0");
    require(sundog::is_finite(scene.ambient) && sundog::is_finite(scene.sky), {}, "the scene",
            "has ambient or sky light that is not finite");
}

}  // namespace sundog::scene
