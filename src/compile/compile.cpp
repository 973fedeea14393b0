// SPDX-License-Identifier: Apache-2.0
#include "compile/compile.h"
#include "base/srgb.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "compile/bodies.h"
#include "compile/bsdf.h"
#include "compile/bsdf_tables.h"
#include "compile/camera.h"
#include "compile/convert.h"
#include "compile/emitters.h"
#include "compile/interior_copies.h"
#include "compile/material.h"
#include "compile/media_bound.h"
#include "compile/mesh.h"
#include "compile/pattern_compiler.h"
#include "compile/photon_targets.h"
#include "compile/principled.h"
#include "compile/solid.h"
#include "scene/bounds.h"
#include "solids/compiled_solid.h"

namespace sundog {
namespace {

void compile_textures(const scene::Scene& scene, RenderScene& out) {
    std::size_t total = 0;
    for (const scene::Texture& t : scene.textures) {
        if (total + t.rgba8.size() >= kernel::NONE)
            throw InputError({Severity::error, t.where,
                              "texture '" + t.name + "': all textures together hold more than 4294967294 pixels", "",
                              "use smaller pictures"});
        out.textures.push_back(
            {static_cast<std::uint32_t>(total), t.width, t.height, t.srgb ? kernel::TEXTURE_SRGB : 0U});
        total += t.rgba8.size();
    }
    out.texels.reserve(total);
    for (const scene::Texture& t : scene.textures) out.texels.insert(out.texels.end(), t.rgba8.begin(), t.rgba8.end());
    out.tables.assign(linear_of_srgb8().begin(), linear_of_srgb8().end());
}

/// The material's reflection model, if it has one, as the last of them.
void append_bsdf(const scene::Material& m, const kernel::MaterialMaps& material_maps,
                 std::span<const scene::Texture> textures, bool tinted, RenderScene& out) {
    std::optional<kernel::Bsdf> bsdf = m.principled ? compile_bsdf(*m.principled, tinted) : compile_bsdf(*m.mtl);
    kernel::Material& material = out.materials.back();
    material.bsdf = kernel::NONE;
    if (!bsdf) return;
    const kernel::BsdfMaps maps =
        m.principled ? compile_bsdf_maps(*m.principled, textures, material_maps) : compile_bsdf_maps(material_maps);
    if (any_map(maps)) {
        bsdf->maps = static_cast<std::uint32_t>(out.bsdf_maps.size());
        out.bsdf_maps.push_back(maps);
    }
    // Which way a surface is brushed its texture coordinates say.
    if (any_map(maps) || bsdf->anisotropy > 0) material.flags |= kernel::MATERIAL_TEXTURED;
    if (bsdf->opacity < 1) material.flags |= kernel::MATERIAL_TRANSPARENT;
    material.bsdf = static_cast<std::uint32_t>(out.bsdfs.size());
    out.bsdfs.push_back(*bsdf);
}

/// Materials of triangles whose vertices have colours.
std::vector<bool> tinted_materials(const scene::Scene& scene) {
    std::vector<bool> tinted(scene.materials.size());
    const auto has_color = [](const scene::Mesh::Attributes& a) { return !(a.color == Vec3{1, 1, 1} && a.alpha == 1); };
    for (const scene::Object& object : scene.objects) {
        const auto* boxed = std::get_if<Boxed<scene::Mesh>>(&object.shape);
        if (boxed == nullptr || (*boxed)->attributes.empty()) continue;
        const scene::Mesh& mesh = **boxed;
        for (const scene::Mesh::Triangle& t : mesh.triangles)
            for (const std::uint32_t corner : t.texcoord)
                if (corner != scene::kNone && has_color(mesh.attributes[corner])) tinted[t.material] = true;
    }
    return tinted;
}

/// Returns the lists of media.
std::vector<MediaList> compile_materials(const scene::Scene& scene, const InteriorCopies& copies, RenderScene& out) {
    PatternCompiler patterns(scene, copies, out);
    const std::vector<bool> tinted = tinted_materials(scene);
    out.material_maps.push_back(no_maps());
    out.materials.reserve(scene.materials.size());
    for (const scene::Material& m : scene.materials) {
        if (m.patterned && !m.principled) {
            out.materials.push_back(patterns.compile_surface(m));
            out.materials.back().bsdf = kernel::NONE;
        } else {
            const bool tints = tinted[static_cast<std::size_t>(&m - scene.materials.data())];
            const kernel::MaterialMaps maps = m.principled ? compile_maps(*m.principled, scene.textures, tints)
                                                           : compile_maps(*m.mtl, scene.textures);
            out.materials.push_back(m.principled ? compile_material(*m.principled, maps, scene.textures, tints)
                                                 : compile_material(*m.mtl, maps));
            kernel::Material& compiled = out.materials.back();
            compiled.emission_power = emission_power({compiled.emission.x, compiled.emission.y, compiled.emission.z},
                                                     maps.emission.texture, scene.textures);
            append_bsdf(m, maps, scene.textures, tints, out);
            if (any_map(maps)) {
                out.materials.back().maps = static_cast<std::uint32_t>(out.material_maps.size());
                out.material_maps.push_back(maps);
            }
        }
    }
    patterns.compile_sky();
    if (scene.projection_camera && scene.projection_camera->normal)
        out.camera_normal = patterns.normals_of(*scene.projection_camera->normal);
    if (out.materials.empty()) {
        out.materials.push_back(compile_material(scene::MtlSurface{}, no_maps()));
        out.materials.back().bsdf = kernel::NONE;
    }
    if (!out.bsdfs.empty()) out.tables.insert(out.tables.end(), bsdf_tables().begin(), bsdf_tables().end());
    return patterns.take_media_lists();
}

/// What of the camera the kernel doesn't have.
void compile_camera(const scene::Scene& scene, RenderScene& out) {
    if (!scene.projection_camera) return;
    const scene::ProjectionCamera& camera = *scene.projection_camera;
    out.camera_where = camera.where;
    if (camera.mesh) {
        out.camera_rays = make_mesh_camera(camera);
        out.camera_feature = "rays of a mesh";
    } else if (camera.function) {
        out.camera_rays = make_function_camera(camera, scene.textures);
        out.camera_feature = "rays of functions";
    } else if (camera.blur.aperture > 0 && camera.blur.most_samples > 0) {
        out.camera_rays = make_lens_camera(camera, scene.textures);
        out.camera_feature = "focal blur";
    } else if (camera.normal) {
        out.camera_feature = "a normal";
    }
}

/// Normals cost memory and time: they are kept only if some triangle refers to them, uvs only if something uses them.
MeshAttributes attributes_of(const scene::Scene& scene, const RenderScene& out) {
    MeshAttributes attributes;
    for (const kernel::Material& m : out.materials)
        if ((m.flags & kernel::MATERIAL_TEXTURED) || (pattern_features(out, m) & kernel::FEATURE_TEXTURES))
            attributes.uvs = true;
    for (const scene::Object& object : scene.objects)
        if (const auto* mesh = std::get_if<Boxed<scene::Mesh>>(&object.shape)) {
            attributes.normals = attributes.normals || !(*mesh)->normals.empty();
            attributes.further = attributes.further || (attributes.uvs && !(*mesh)->attributes.empty());
        } else if (const auto* solid = std::get_if<std::shared_ptr<const scene::Solid>>(&object.shape)) {
            attributes.normals = attributes.normals || solid_attributes(**solid).normals;
        }
    return attributes;
}

/// Appends the primitives of one object that is not a solid; `geometry` says where it will stand.
class PrimitiveWriter {
public:
    PrimitiveWriter(const scene::Object& object, MeshAttributes attributes, RenderScene& out, const WarningSink& warn)
        : object_(object), attributes_(attributes), out_(out), warn_(warn) {}

    kernel::Geometry operator()(const Boxed<scene::Mesh>& mesh) {
        const auto first = static_cast<std::uint32_t>(out_.triangles.size());
        const std::uint32_t count = append_mesh(object_, *mesh, attributes_, out_, warn_);
        return {kernel::GEOMETRY_TRIANGLES, first, count, kernel::NONE, 0, 0, 0};
    }
    kernel::Geometry operator()(const scene::Sphere& sphere) {
        if (!(sphere.radius > 0)) return none("a sphere of no radius");
        out_.spheres.push_back({to_kernel(sphere.center), sphere.radius, object_.material});
        return {kernel::GEOMETRY_SPHERE, last(out_.spheres), 1, kernel::NONE, 0, 0, 0};
    }
    kernel::Geometry operator()(const scene::Box& box) {
        const Vec3 size = box.upper - box.lower;
        if (!(size.x >= 0 && size.y >= 0 && size.z >= 0)) return none("a box whose corners are the wrong way round");
        out_.boxes.push_back({to_kernel(box.lower), to_kernel(box.upper), object_.material});
        return {kernel::GEOMETRY_BOX, last(out_.boxes), 1, kernel::NONE, 0, 0, 0};
    }
    kernel::Geometry operator()(const scene::Plane& plane) {
        const float len = length(plane.normal);
        if (!(len > 0)) return none("a plane whose normal has no direction");
        out_.planes.push_back({to_kernel(plane.normal / len), plane.offset / len, object_.material,
                               static_cast<std::uint32_t>(out_.geometries.size())});
        return {kernel::GEOMETRY_PLANE, last(out_.planes), 1, kernel::NONE, 0, 0, 0};
    }
    /// Solids are append_solid's.
    kernel::Geometry operator()(const std::shared_ptr<const scene::Solid>&) { return none("a solid"); }

private:
    template <class T>
    static std::uint32_t last(const std::vector<T>& array) {
        return static_cast<std::uint32_t>(array.size() - 1);
    }
    kernel::Geometry none(const char* what) {
        if (warn_)
            warn_(
                {Severity::warning, object_.where, "object '" + object_.name + "' is " + what + "; left out", "", ""});
        return {kernel::GEOMETRY_TRIANGLES, 0, 0, kernel::NONE, 0, 0, 0};
    }

    const scene::Object& object_;
    MeshAttributes attributes_;
    RenderScene& out_;
    const WarningSink& warn_;
};

/// Which rays don't see an object. Where `some_project`, some rays see only objects that lights are projected through.
std::uint32_t hidden_from(const scene::Object& object, bool some_project) {
    if (object.projects > 0) return ~(kernel::RAY_PROJECTION << (object.projects - 1));
    return (some_project ? kernel::RAY_ANY_PROJECTION : 0U) | (object.seen_by_camera ? 0U : kernel::RAY_CAMERA) |
           (object.seen_in_reflections ? 0U : kernel::RAY_REFLECTED) | (object.casts_shadow ? 0U : kernel::RAY_SHADOW) |
           (object.seen_by_radiosity ? 0U : kernel::RAY_RADIOSITY);
}

/// Bounds in the world, at first.
Bounds3 world_bounds_of(const scene::Object& object, const Bounds3& bounds) {
    return scene::moves(object) ? transformed(scene::transform_at(object, 0), bounds) : bounds;
}

/// Lists the geometries of the scene's objects.
class GeometryList {
public:
    GeometryList(const scene::Scene& scene, const InteriorCopies& copies, RenderScene& out)
        : copies_(copies),
          out_(out),
          targets_(scene, out),
          some_project_(std::any_of(scene.objects.begin(), scene.objects.end(),
                                    [](const scene::Object& object) { return object.projects > 0; })) {}

    void begin_object(std::uint32_t index) { object_ = index; }
    void add(kernel::Geometry geometry, const scene::Object& object) {
        if (scene::moves(object)) geometry.instance = instance_count_++;
        geometry.hidden_from = hidden_from_rays(object);
        geometry.photons = targets_.photons_of(object_);
        geometry.interior_copy = copies_.of(object_);
        out_.geometries.push_back(geometry);
        out_.geometry_names.push_back(object.name);
        out_.geometry_objects.push_back(object_);
    }
    void add(const SolidPart& part, const scene::Object& object) {
        if (part.solid) {
            const Bounds3d& bounds = part.solid->bounds();
            out_.solids.push_back({part.solid,
                                   static_cast<std::uint32_t>(out_.geometries.size()),
                                   object.where,
                                   {to_float(bounds.lower), to_float(bounds.upper)}});
        }
        if (!continues_run(part.geometry, object)) add(part.geometry, object);
        else out_.geometries.back().primitive_count += part.geometry.primitive_count;
    }
    /// Of the geometry that was added last, in the object's space.
    void add_bounds(const Bounds3& bounds, const scene::Object& object) {
        out_.bounds.include(world_bounds_of(object, bounds));
        targets_.add_bounds(object_, bounds, out_.geometries.back().instance);
    }
    void finish(const WarningSink& warn) { targets_.finish(warn); }
    [[nodiscard]] bool moving() const { return instance_count_ > 0; }

private:
    /// A scene may consist of a million spheres, each an object: those in a row that go by one name are one geometry.
    [[nodiscard]] bool continues_run(const kernel::Geometry& g, const scene::Object& object) const {
        if (g.kind == kernel::GEOMETRY_SOLID || g.kind == kernel::GEOMETRY_PLANE || out_.geometries.empty() ||
            scene::moves(object))
            return false;
        const kernel::Geometry& last = out_.geometries.back();
        return last.kind == g.kind && last.first_primitive + last.primitive_count == g.first_primitive &&
               last.instance == kernel::NONE && out_.geometry_names.back() == object.name &&
               last.hidden_from == hidden_from_rays(object) && last.photons == targets_.photons_of(object_) &&
               last.interior_copy == copies_.of(object_);
    }
    [[nodiscard]] std::uint32_t hidden_from_rays(const scene::Object& object) const {
        return hidden_from(object, some_project_) | (object.projects == 0 ? targets_.hidden_from(object_) : 0U);
    }

    const InteriorCopies& copies_;
    RenderScene& out_;
    PhotonTargets targets_;
    bool some_project_;
    std::uint32_t object_ = 0;
    std::uint32_t instance_count_ = 0;
};

bool has_map(const RenderScene& scene, const kernel::Bsdf& bsdf, std::uint32_t which) {
    return bsdf.maps != kernel::NONE && scene.bsdf_maps[bsdf.maps].map[which].texture != kernel::NONE;
}

/// Whether light may pass a material without being bent, as kernel/materials/veils.h has it.
bool is_veil(const RenderScene& scene, const kernel::Material& material) {
    if ((material.flags & kernel::MATERIAL_TRANSPARENT) == 0) return false;
    if (material.bsdf != kernel::NONE) {
        const kernel::Bsdf& bsdf = scene.bsdfs[material.bsdf];
        return bsdf.opacity < 1 || (material.flags & kernel::MATERIAL_VERTEX_ALPHA) != 0 ||
               has_map(scene, bsdf, kernel::BSDF_MAP_OPACITY);
    }
    if ((material.flags & kernel::MATERIAL_PATTERNED) != 0)
        return scene.interiors[scene.patterned[material.patterned].interior].ior == 1;
    return material.ior == 1;
}

std::uint32_t features_of(const RenderScene& scene, const kernel::Material& material) {
    std::uint32_t features = material.bsdf != kernel::NONE ? kernel::FEATURE_BSDF : 0U;
    if (is_veil(scene, material)) features |= kernel::FEATURE_VEILS;
    if (features & kernel::FEATURE_BSDF) {
        const kernel::Bsdf& bsdf = scene.bsdfs[material.bsdf];
        if (bsdf.dispersion > 0) features |= kernel::FEATURE_DISPERSION;
        if (has_map(scene, bsdf, kernel::BSDF_MAP_COAT_NORMAL)) features |= kernel::FEATURE_BUMP;
    }
    return features | material_features(material, scene.material_maps[material.maps]) |
           pattern_features(scene, material);
}

std::uint32_t features_of(const RenderScene& scene, MeshAttributes attributes, bool moving) {
    std::vector<bool> used(scene.materials.size());
    for (const kernel::Triangle& t : scene.triangles) used[t.material] = true;
    for (const kernel::Sphere& s : scene.spheres) used[s.material] = true;
    for (const kernel::Box& b : scene.boxes) used[b.material] = true;
    for (const kernel::Plane& p : scene.planes) used[p.material] = true;
    for (const PlacedSolid& s : scene.solids)
        for (const std::uint32_t material : s.solid->materials()) used[material] = true;

    std::uint32_t features = 0;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) features |= features_of(scene, scene.materials[i]);
    if (attributes.normals && !scene.triangles.empty()) features |= kernel::FEATURE_SMOOTH;
    if (attributes.further && !scene.triangles.empty()) features |= kernel::FEATURE_VERTEX_ATTRIBUTES;
    if (!scene.spheres.empty() || !scene.boxes.empty() || !scene.planes.empty() || !scene.solids.empty())
        features |= kernel::FEATURE_ANALYTIC;
    for (const kernel::Geometry& g : scene.geometries)
        if (g.hidden_from != 0) features |= kernel::FEATURE_HIDDEN;
    if (moving) features |= kernel::FEATURE_INSTANCES;
    // Fog isn't in what isn't hollow.
    const bool in_fog =
        (!scene.fogs.empty() || scene.rainbows != kernel::NONE) && (features & kernel::FEATURE_PATTERNED) != 0;
    if (scene.has_media) features |= kernel::FEATURE_MEDIA | kernel::FEATURE_HOLLOW;
    if (in_fog) features |= kernel::FEATURE_HOLLOW;
    return features;
}

/// What of a mesh, about to be listed as `geometry`, can't be seen from behind, and where that has to be looked for.
void note_one_sided(const scene::Object& object, const kernel::Geometry& geometry, RenderScene& out) {
    const auto* mesh = std::get_if<Boxed<scene::Mesh>>(&object.shape);
    if (mesh == nullptr) return;
    const auto first = out.triangles.begin() + geometry.first_primitive;
    const bool one_sided = std::any_of(first, first + geometry.primitive_count, [&](const kernel::Triangle& t) {
        return (out.materials[t.material].flags & kernel::MATERIAL_ONE_SIDED) != 0;
    });
    if (!one_sided) return;
    if (!is_closed(**mesh)) out.features |= kernel::FEATURE_ONE_SIDED;
    else out.closed_one_sided.push_back({static_cast<std::uint32_t>(out.geometries.size()), scene::bounds_of(object)});
}

}  // namespace

std::shared_ptr<const RenderScene> compile(const scene::Scene& scene, const WarningSink& warn, bool for_paths) {
    auto out = std::make_shared<RenderScene>();
    compile_textures(scene, *out);
    const InteriorCopies copies = interior_copies(scene);
    const std::vector<MediaList> media = compile_materials(scene, copies, *out);
    compile_camera(scene, *out);

    const MeshAttributes attributes = attributes_of(scene, *out);
    GeometryList list(scene, copies, *out);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const scene::Object& object = scene.objects[i];
        list.begin_object(static_cast<std::uint32_t>(i));
        if (const auto* solid = std::get_if<std::shared_ptr<const scene::Solid>>(&object.shape)) {
            append_solid(scene, object, **solid, attributes, *out, warn, [&](const SolidPart& part) {
                list.add(part, object);
                list.add_bounds(part.bounds, object);
            });
            continue;
        }
        const kernel::Geometry geometry = std::visit(PrimitiveWriter{object, attributes, *out, warn}, object.shape);
        if (geometry.primitive_count == 0) continue;
        note_one_sided(object, geometry, *out);
        list.add(geometry, object);
        list.add_bounds(scene::bounds_of(object), object);
    }
    list.finish(warn);
    find_bodies(scene, *out);
    find_shining(*out);
    if (for_paths) add_majorant_grids(media, scene.textures, *out);
    if (scene.environment) compile_environment(*scene.environment, *out);
    out->features |= features_of(*out, attributes, list.moving());
    const auto grouped = [](const scene::Light& light) { return light.group != 0; };
    if (!scene.light_sets.empty() || std::any_of(scene.lights.begin(), scene.lights.end(), grouped))
        out->features |= kernel::FEATURE_LIGHT_GROUPS;
    if (scene.radiosity) out->radiosity = scene.radiosity->where;
    if (scene.photons) out->photons = scene.photons->where;

    // Arrays bound to a kernel are never empty, and positions are read four floats at a time.
    out->positions.push_back({0, 0, 0});
#define KERNEL_ARRAYS_SCENE_ONLY
#define KERNEL_ARRAY(type, name, binding) \
    if (out->name.empty()) out->name.resize(1);
#include "kernel/arrays.h"
#undef KERNEL_ARRAY
#undef KERNEL_ARRAYS_SCENE_ONLY
    return out;
}

}  // namespace sundog
