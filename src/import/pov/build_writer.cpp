// SPDX-License-Identifier: Apache-2.0
#include "import/pov/build_writer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

#include "import/pov/solid_test.h"

namespace sundog::pov {
namespace {

using scene::Index;
using scene::Object;
using scene::Solid;

/// The factor by which a map scales all lengths, if it scales all alike.
std::optional<double> uniform_scale(const Affine3d& map) {
    constexpr double kRelativeError = 1e-9;
    const double xx = dot(map.x, map.x);
    const double error = kRelativeError * xx;
    const auto is_near = [&](double value, double expected) { return std::abs(value - expected) <= error; };
    if (!is_near(dot(map.y, map.y), xx) || !is_near(dot(map.z, map.z), xx) || !is_near(dot(map.x, map.y), 0) ||
        !is_near(dot(map.y, map.z), 0) || !is_near(dot(map.z, map.x), 0))
        return std::nullopt;
    return std::sqrt(xx);
}

/// True if a map takes each axis to an axis.
bool keeps_axes(const Affine3d& map) {
    for (const Vec3d& column : {map.x, map.y, map.z}) {
        const int zeros = (column.x == 0) + (column.y == 0) + (column.z == 0);
        if (zeros != 2) return false;
    }
    return true;
}

std::optional<scene::Sphere> placed(const scene::SolidSphere& sphere, const Affine3d& world) {
    const std::optional<double> scale = uniform_scale(world);
    if (!scale) return std::nullopt;
    return scene::Sphere{to_float(transform_point(world, sphere.center)), static_cast<float>(sphere.radius * *scale)};
}

std::optional<scene::Box> placed(const scene::SolidBox& box, const Affine3d& world) {
    if (!keeps_axes(world)) return std::nullopt;
    const Vec3 a = to_float(transform_point(world, box.lower));
    const Vec3 b = to_float(transform_point(world, box.upper));
    return scene::Box{min(a, b), max(a, b)};
}

std::optional<scene::Plane> placed(const scene::HalfSpace& plane, const Affine3d& world) {
    const Vec3d normal = transform_normal(inverse(world), plane.normal);
    const double len = length(normal);
    return scene::Plane{to_float(normal / len), static_cast<float>((plane.distance + dot(normal, world.t)) / len)};
}

/// Exact shapes that the scene holds without a solid around them.
std::optional<decltype(Object::shape)> simple_shape(const Node& node, const Affine3d& world) {
    if (node.inverted || !node.clipped_by.empty()) return std::nullopt;
    const auto wrapped = [](auto shape) -> std::optional<decltype(Object::shape)> {
        if (!shape) return std::nullopt;
        return decltype(Object::shape)(*shape);
    };
    if (const auto* sphere = std::get_if<scene::SolidSphere>(&node.shape)) return wrapped(placed(*sphere, world));
    if (const auto* box = std::get_if<scene::SolidBox>(&node.shape)) return wrapped(placed(*box, world));
    if (const auto* plane = std::get_if<scene::HalfSpace>(&node.shape)) return wrapped(placed(*plane, world));
    return std::nullopt;
}

}  // namespace

SceneWriter::Surroundings SceneWriter::within(const Surroundings& around, const Node& node) {
    Surroundings inside = around;
    if (node.texture.texture) {
        inside.texture = node.texture.texture;
        inside.world_from_texture = around.world_from_parent * node.texture.parent_from_texture;
    }
    if (node.interior_texture.texture) {
        inside.interior_texture = node.interior_texture.texture;
        inside.world_from_interior_texture = around.world_from_parent * node.interior_texture.parent_from_texture;
    }
    if (node.interior) {
        inside.interior.interior = node.interior;
        inside.interior_owner = ++interior_owners_;
        inside.interior.world_from_interior = around.world_from_parent * node.parent_from_interior;
    }
    inside.interior.hollow |= node.hollow;
    inside.no_shadow |= node.no_shadow;
    inside.no_image |= node.no_image;
    inside.no_reflection |= node.no_reflection;
    inside.no_radiosity |= node.no_radiosity;
    if (node.photons) {
        inside.photons = *node.photons;
        inside.photons.whole = around.photons.whole;
    }
    if (!node.split_union && inside.photons.whole == 0) inside.photons.whole = ++whole_targets_;
    inside.interior.double_illuminate |= node.double_illuminate;
    inside.world_from_parent = around.world_from_parent * node.parent_from_shape;
    if (const auto* group = std::get_if<NodeGroup>(&node.shape)) {
        inside.light_group = 0;  // A union's lights shine for all.
        if (node.keyword == Keyword::light_group) enter_light_group(node, *group, inside);
    }
    return inside;
}

void SceneWriter::enter_light_group(const Node& node, const NodeGroup& group, Surroundings& inside) {
    const auto is_light = [](const NodePointer& child) {
        return std::holds_alternative<std::shared_ptr<const NodeLight>>(child->shape);
    };
    // light_group { A_DECLARED_ONE } is that group, changed.
    const bool is_changed_group = group.children.size() == 1 && group.children[0]->keyword == Keyword::light_group;
    // As povray's pictures show it: the outermost group says whether the scene's lights reach what is in it; lights of
    // outer groups reach objects of declared groups in them, but not of groups that are written out there.
    if (!inside.in_light_group && !(is_changed_group && !node.global_lights)) {
        inside.in_light_group = true;
        inside.lights.scene_lights = node.global_lights.value_or(false);
    } else if (!is_changed_group && !node.declared) {
        inside.lights.groups.clear();
    }
    if (std::any_of(group.children.begin(), group.children.end(), is_light)) {
        inside.light_group = ++light_groups_;
        inside.lights.groups.push_back(inside.light_group);
    }
    inside.interior.light_set = number_of(inside.lights);
}

std::uint32_t SceneWriter::number_of(const scene::LightSet& lights) {
    std::vector<std::uint32_t> key = lights.groups;
    key.push_back(lights.scene_lights ? 1 : 0);
    std::vector<scene::LightSet>& sets = context_.scene.light_sets;
    const auto [known, is_new] = light_sets_.try_emplace(std::move(key), static_cast<std::uint32_t>(sets.size() + 1));
    if (is_new) sets.push_back(lights);
    return known->second;
}

Index SceneWriter::blob_material(const NodeBlob& blob, const Surroundings& inside, Place where) {
    auto own = std::make_shared<scene::LayeredTexture>(inside.texture ? *inside.texture : *inside.fallback);
    if (inside.texture) move_texture(*own, inverse(inside.world_from_texture) * inside.world_from_parent);
    std::optional<scene::LayeredTexture> blended = blob_texture(blob, own, context_.location(where));
    if (!blended) {
        context_.warn_once("blob component texture", where, "a blob with more textures than can be blended",
                           "the texture of the component that is strongest shows");
        return materials_.of(own, inside.world_from_parent, inside.interior);
    }
    return materials_.of(std::make_shared<const scene::LayeredTexture>(*std::move(blended)), inside.world_from_parent,
                         inside.interior);
}

scene::Blob SceneWriter::blob_of(const NodeBlob& blob, const Surroundings& inside) {
    scene::Blob out = blob.blob;
    if (blob.textures.empty() || blob_texture(blob, inside.fallback, {})) return out;
    for (std::size_t i = 0; i < blob.textures.size(); ++i)
        if (blob.textures[i])
            out.components[i].material = materials_.of(blob.textures[i], inside.world_from_parent, inside.interior);
    return out;
}

Index SceneWriter::material_of(const Node& node, const Surroundings& inside) {
    if (const auto* blob = std::get_if<NodeBlob>(&node.shape); blob && !blob->textures.empty())
        return blob_material(*blob, inside, node.where);
    if (inside.texture) return materials_.of(inside.texture, inside.world_from_texture, inside.interior);
    return materials_.of(inside.fallback, inside.world_from_parent, inside.interior);
}

void SceneWriter::add(const Node& node, const Surroundings& around) {
    const Surroundings inside = within(around, node);
    if (std::holds_alternative<std::monostate>(node.shape)) return;
    if (const auto* light = std::get_if<std::shared_ptr<const NodeLight>>(&node.shape)) {
        add_light(**light, inside);
        return;
    }
    const bool plain = !node.inverted && node.clipped_by.empty();
    if (const auto* group = std::get_if<NodeGroup>(&node.shape);
        group && plain && (group->kind == scene::SolidGroup::Kind::combined || group->children.size() == 1)) {
        for (const NodePointer& child : group->children) add(*child, inside);
        return;
    }
    Object object;
    object.name = spelling(node.keyword);
    object.where = context_.location(node.where);
    object.material = material_of(node, inside);
    object.casts_shadow = !inside.no_shadow;
    object.seen_by_camera = !inside.no_image;
    object.seen_in_reflections = !inside.no_reflection;
    object.seen_by_radiosity = !inside.no_radiosity;
    if (!(inside.photons == scene::ObjectPhotons{})) object.photons = inside.photons;
    object.projects = inside.projects;
    object.interior_owner = inside.interior_owner;
    const auto* mesh = std::get_if<std::shared_ptr<const NodeMesh>>(&node.shape);
    if (mesh && plain && !inside.interior_texture) {
        object.shape = mesh_of(**mesh, inside, object.material);
    } else if (auto simple = inside.interior_texture || (inside.texture && scene::uses_uv(*inside.texture))
                                 ? std::nullopt
                                 : simple_shape(node, inside.world_from_parent)) {
        object.shape = std::move(*simple);
    } else {
        auto solid = solid_of(node, around);
        if (!solid) return;
        if (!(around.world_from_parent == Affine3d{})) {
            auto moved = std::make_shared<Solid>(*solid);
            moved->parent_from_shape = around.world_from_parent * moved->parent_from_shape;
            for (auto* clips : {&moved->clipped_by, &moved->bounded_by}) {
                for (auto& clip : *clips) {
                    auto moved_clip = std::make_shared<Solid>(*clip);
                    moved_clip->parent_from_shape = around.world_from_parent * moved_clip->parent_from_shape;
                    clip = std::move(moved_clip);
                }
            }
            solid = std::move(moved);
        }
        object.shape = std::move(solid);
    }
    context_.scene.objects.push_back(std::move(object));
}

void SceneWriter::add_light(const NodeLight& node, const Surroundings& inside) {
    const Affine3d& world = inside.world_from_parent;
    scene::Light light = node.light;
    light.place = to_float(transform_point(world, to_double(light.place)));
    light.point_at = to_float(transform_point(world, to_double(light.point_at)));
    if (light.area) {
        light.area->axis1 = to_float(transform_vector(world, to_double(light.area->axis1)));
        light.area->axis2 = to_float(transform_vector(world, to_double(light.area->axis2)));
    }
    if (light.kind == scene::Light::Kind::sun) light.place = normalize(light.place - light.point_at);
    light.group = inside.light_group;
    if (!node.projected_through.empty()) project(node, inside, light);
    context_.scene.lights.push_back(light);
    if (node.looks_like) add(*node.looks_like, inside);
}

void SceneWriter::project(const NodeLight& node, const Surroundings& inside, scene::Light& light) {
    constexpr std::uint32_t kMost = 24;
    if (projectors_ == kMost) {
        context_.warn_once("projected_through", node.projected_through.front()->where,
                           "more lights are projected through objects than can be drawn",
                           "those after " + std::to_string(kMost) + " shine everywhere");
        return;
    }
    light.projection = ++projectors_;
    Surroundings unseen{.fallback = inside.fallback};
    unseen.world_from_parent = inside.world_from_parent * node.parent_from_projector;
    unseen.interior.hollow = true;
    unseen.projects = projectors_;
    for (const NodePointer& projector : node.projected_through) add(*projector, unseen);
}

scene::Mesh SceneWriter::mesh_of(const NodeMesh& mesh, const Surroundings& inside, Index material) {
    const Affine3d& world = inside.world_from_parent;
    const Affine3d mesh_from_world = inverse(world);
    const bool moved = !(world == Affine3d{});
    std::vector<Index> materials;
    for (const TexturePointer& texture : mesh.textures)
        materials.push_back(materials_.of(texture, world, inside.interior));
    scene::Mesh out;
    out.positions = mesh.triangles.positions;
    out.normals = mesh.triangles.normals;
    out.texcoords = mesh.triangles.uvs;
    if (moved) {
        for (Vec3& p : out.positions) p = to_float(transform_point(world, to_double(p)));
        for (Vec3& n : out.normals) n = to_float(normalize(transform_normal(mesh_from_world, to_double(n))));
    }
    out.triangles.reserve(mesh.triangles.triangles.size());
    for (const scene::SolidMesh::Triangle& t : mesh.triangles.triangles)
        out.triangles.push_back({{t.position[0], t.position[1], t.position[2]},
                                 {t.normal[0], t.normal[1], t.normal[2]},
                                 {t.uv[0], t.uv[1], t.uv[2]},
                                 t.material == scene::SolidMesh::kNoIndex ? material : materials[t.material]});
    return out;
}

std::shared_ptr<const scene::SolidMesh> SceneWriter::solid_mesh_of(const NodeMesh& mesh, const Surroundings& inside) {
    // Shares the triangles with the node where they need no materials of their own.
    auto out = std::make_shared<scene::SolidMesh>(mesh.triangles);
    std::vector<Index> materials;
    for (const TexturePointer& texture : mesh.textures)
        materials.push_back(materials_.of(texture, inside.world_from_parent, inside.interior));
    for (scene::SolidMesh::Triangle& t : out->triangles)
        if (t.material != scene::SolidMesh::kNoIndex) t.material = materials[t.material];
    return out;
}

std::shared_ptr<const scene::InsideTest> SceneWriter::inside_test_of(const TexturedPart& part,
                                                                     const Surroundings& inside) {
    // What shines among the parts is in the scene once.
    const std::size_t lights = context_.scene.lights.size(), objects = context_.scene.objects.size();
    auto common = std::make_shared<Solid>();
    scene::SolidGroup group;
    group.kind = scene::SolidGroup::Kind::common;
    for (const auto& [node, group_from_parent] : part.nodes) {
        const std::shared_ptr<const Solid> solid = solid_of(*node, Surroundings{.fallback = inside.fallback});
        if (!solid) continue;
        auto placed_part = std::make_shared<Solid>(*solid);
        placed_part->parent_from_shape = group_from_parent * solid->parent_from_shape;
        for (auto* clips : {&placed_part->clipped_by, &placed_part->bounded_by}) {
            for (auto& clip : *clips) {
                auto moved = std::make_shared<Solid>(*clip);
                moved->parent_from_shape = group_from_parent * moved->parent_from_shape;
                clip = std::move(moved);
            }
        }
        group.children.push_back(std::move(placed_part));
    }
    context_.scene.lights.resize(lights);
    context_.scene.objects.resize(objects);
    common->shape = std::move(group);
    return std::make_shared<const SolidTest>(solids::compile_solid(*common, 0, context_.scene.textures));
}

SceneWriter::Surroundings SceneWriter::cutaway(const Node& node, const NodeGroup& group, const Surroundings& inside) {
    Surroundings parts = inside;
    if (!node.cutaway_textures || inside.texture) return parts;
    const std::vector<TexturedPart> textured = textured_parts(group);
    const auto first = std::find_if(textured.begin(), textured.end(), [](const auto& part) { return part.texture; });
    if (first == textured.end()) return parts;
    parts.texture = first->texture;
    parts.world_from_texture = inside.world_from_parent * first->group_from_texture;
    const auto is_first = [&](const TexturedPart& part) {
        return part.texture == first->texture && part.group_from_texture == first->group_from_texture;
    };
    if (std::all_of(textured.begin(), textured.end(), is_first)) return parts;
    std::vector<std::shared_ptr<const scene::InsideTest>> insides;
    for (const TexturedPart& part : textured) insides.push_back(inside_test_of(part, inside));
    if (auto blended = cutaway_texture(textured, insides, context_.location(node.where))) {
        parts.texture = std::make_shared<const scene::LayeredTexture>(*std::move(blended));
        parts.world_from_texture = inside.world_from_parent;
    } else {
        context_.warn_once("cutaway_textures", node.where, "more textures are cut through than can be drawn",
                           "what is cut shows the first part's");
    }
    return parts;
}

std::shared_ptr<const Solid> SceneWriter::solid_of(const Node& node, const Surroundings& around) {
    const Surroundings inside = within(around, node);
    auto solid = std::make_shared<Solid>();
    solid->where = context_.location(node.where);
    solid->parent_from_shape = node.parent_from_shape;
    solid->inverted = node.inverted;
    solid->cutaway_textures = node.cutaway_textures;
    solid->material = material_of(node, inside);
    if (inside.interior_texture)
        solid->interior_material =
            materials_.of(inside.interior_texture, inside.world_from_interior_texture, inside.interior);
    const bool drawn = std::visit(
        [&](const auto& shape) {
            using Shape = std::decay_t<decltype(shape)>;
            if constexpr (std::is_same_v<Shape, std::monostate>) {
                return false;
            } else if constexpr (std::is_same_v<Shape, std::shared_ptr<const NodeLight>>) {
                add_light(*shape, inside);
                return false;
            } else if constexpr (std::is_same_v<Shape, std::shared_ptr<const NodeMesh>>) {
                solid->shape = solid_mesh_of(*shape, inside);
                return true;
            } else if constexpr (std::is_same_v<Shape, NodeGroup>) {
                scene::SolidGroup group;
                group.kind = shape.kind;
                const Surroundings parts = cutaway(node, shape, inside);
                for (const NodePointer& child : shape.children)
                    if (auto part = solid_of(*child, parts)) group.children.push_back(std::move(part));
                if (group.children.empty()) return false;
                solid->shape = std::move(group);
                return true;
            } else if constexpr (std::is_same_v<Shape, NodeBlob>) {
                solid->shape = blob_of(shape, inside);
                return true;
            } else {
                solid->shape = shape;
                return true;
            }
        },
        node.shape);
    if (!drawn) return nullptr;
    const auto place_clips = [&](const std::vector<Node::Clip>& clips, auto& out) {
        for (const Node::Clip& clip : clips) {
            Surroundings clip_around = around;
            clip_around.world_from_parent = around.world_from_parent * clip.parent_from_clip;
            auto part = solid_of(*clip.node, clip_around);
            if (!part) continue;
            auto placed_part = std::make_shared<Solid>(*part);
            placed_part->parent_from_shape = clip.parent_from_clip * placed_part->parent_from_shape;
            out.push_back(std::move(placed_part));
        }
    };
    place_clips(node.clipped_by, solid->clipped_by);
    place_clips(node.bounded_by, solid->bounded_by);
    return solid;
}

}  // namespace sundog::pov
