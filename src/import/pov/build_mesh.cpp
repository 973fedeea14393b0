// SPDX-License-Identifier: Apache-2.0
// Triangles: triangle, smooth_triangle, mesh and mesh2 (POV-Ray reference, sections 3.4.5.2.3 to 3.4.5.2.7).
#include <cmath>
#include <map>

#include "import/pov/build_corner_textures.h"
#include "import/pov/build_shape.h"

namespace sundog::pov {
namespace {

using scene::SolidMesh;
constexpr std::uint32_t kNone = SolidMesh::kNoIndex;

/// Collects triangles and their textures.
class MeshBuilder {
public:
    explicit MeshBuilder(ObjectReader& objects) : objects_(objects) {}

    std::uint32_t texture(const TexturePointer& texture) {
        const auto [known, is_new] = indices_.emplace(texture, static_cast<std::uint32_t>(mesh_.textures.size()));
        if (is_new) mesh_.textures.push_back(texture);
        return known->second;
    }

    std::uint32_t position(Vec3d p) {
        mesh_.triangles.positions.push_back(to_float(p));
        return static_cast<std::uint32_t>(mesh_.triangles.positions.size() - 1);
    }

    /// One `triangle { }` or `smooth_triangle { }` of a mesh, or on its own (then its modifiers are left).
    void read_triangle(ItemReader& items, Keyword keyword) {
        SolidMesh::Triangle triangle{{kNone, kNone, kNone}, {kNone, kNone, kNone}, {kNone, kNone, kNone}, kNone};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            triangle.position[corner] = position(items.vector("a corner of the triangle"));
            if (keyword != Keyword::triangle) {
                mesh_.triangles.normals.push_back(to_float(items.vector("the normal at a corner")));
                triangle.normal[corner] = static_cast<std::uint32_t>(mesh_.triangles.normals.size() - 1);
            }
            if (keyword == Keyword::smooth_color_triangle) items.color("the color at a corner");
        }
        mesh_.triangles.triangles.push_back(triangle);
    }

    /// What may follow a mesh's triangle in its block.
    void read_triangle_modifiers(ItemReader& items) {
        SolidMesh::Triangle& triangle = mesh_.triangles.triangles.back();
        while (!items.at_end()) {
            if (items.take(Keyword::uv_vectors)) {
                for (std::uint32_t& uv : triangle.uv) {
                    const std::array<double, 2> p = items.vector2("the uv coordinates of a corner");
                    uv = static_cast<std::uint32_t>(mesh_.triangles.uvs.size());
                    mesh_.triangles.uvs.push_back({static_cast<float>(p[0]), static_cast<float>(p[1])});
                }
            } else if (const auto block = items.take_block(Keyword::texture)) {
                triangle.material = texture(objects_.textures().read(block));
            } else if (const auto list = items.take_block(Keyword::texture_list)) {
                read_corner_textures(items, *list);
            } else {
                items.unexpected("texture { } or uv_vectors");
            }
        }
    }

    /// Gives the last triangle the textures of its corners.
    void set_corner_textures(ItemReader& items, const CornerTextures& corners) {
        SolidMesh::Triangle& triangle = mesh_.triangles.triangles.back();
        triangle.material = texture(corners[0]);
        if (corners[0] == corners[1] && corners[0] == corners[2]) return;
        if (const TexturePointer blended = blender_.blended(corners)) {
            triangle.material = texture(blended);
            blended_.push_back(mesh_.triangles.triangles.size() - 1);
            return;
        }
        // Each of these triangles has a texture of its own.
        constexpr std::size_t kMost = 100'000;
        const auto corner = [&](std::size_t i) { return to_double(mesh_.triangles.positions[triangle.position[i]]); };
        if (between_++ < kMost) {
            const SourceLocation where = objects_.context().location(items.taken_where());
            if (const TexturePointer blended = blended_between(corners, {corner(0), corner(1), corner(2)}, where)) {
                triangle.material = texture(blended);
                return;
            }
        }
        objects_.context().warn_once("triangle texture blending", items.taken_where(),
                                     "more textures between the corners of triangles than can be drawn",
                                     "the first corner's texture covers the triangle");
    }

    NodeMesh& mesh() { return mesh_; }

    NodeShape finish(ItemReader& items) {
        set_corner_uvs(mesh_.triangles, blended_);
        if (!mesh_.triangles.triangles.empty()) return std::make_shared<const NodeMesh>(std::move(mesh_));
        items.warn("a mesh without triangles; left out");
        return {};
    }

private:
    /// `texture_list { A B C }` in a triangle.
    void read_corner_textures(ItemReader& items, const Block& block) {
        ItemReader list(objects_.context(), block);
        CornerTextures corners;
        for (TexturePointer& corner : corners) {
            const auto texture = list.take_block(Keyword::texture);
            if (!texture) list.unexpected("three textures, one for each corner");
            corner = objects_.textures().read(texture);
        }
        set_corner_textures(items, corners);
    }

    ObjectReader& objects_;
    NodeMesh mesh_;
    CornerBlender blender_;
    std::vector<std::size_t> blended_;  ///< Triangles whose textures blend between their corners.
    std::size_t between_ = 0;           ///< Triangles with a texture of their own.
    std::map<TexturePointer, std::uint32_t> indices_;
};

/// The numbers of a mesh2 list in the order of the file, whatever items hold them.
class NumberList {
public:
    NumberList(BuildContext& context, const Block& block) : items_(context, block), context_(context) {}

    /// The components of the next value; empty at the end or where something else follows.
    std::span<const double> next() {
        while (true) {
            if (list_ && next_value_ < list_->counts.size()) {
                const std::size_t count = list_->counts[next_value_++];
                const std::span<const double> numbers(list_->numbers.data() + next_number_, count);
                next_number_ += count;
                return numbers;
            }
            list_ = nullptr;
            const Item* item = items_.peek();
            if (!item) return {};
            if (const auto* list = std::get_if<std::shared_ptr<const ValueList>>(&item->content)) {
                where_ = item->where;
                list_ = list->get();
                next_value_ = next_number_ = 0;
                items_.skip();
            } else if (const auto* value = std::get_if<Value>(&item->content)) {
                where_ = item->where;
                items_.skip();
                return {value->v.data(), value->count};
            } else {
                return {};
            }
        }
    }

    /// The number of entries that a list begins with.
    std::size_t count() {
        const std::span<const double> first = next();
        constexpr double kMost = 4e9;
        if (first.size() != 1 || !(first[0] >= 0 && first[0] < kMost))
            context_.fail(where(), "a list without its length", "expected a count before the entries");
        return static_cast<std::size_t>(first[0]);
    }

    [[nodiscard]] Place where() const { return where_.line != 0 ? where_ : items_.where(); }
    [[nodiscard]] BuildContext& context() const { return context_; }

private:
    ItemReader items_;
    BuildContext& context_;
    const ValueList* list_ = nullptr;
    std::size_t next_value_ = 0, next_number_ = 0;
    Place where_;
};

[[noreturn]] void fail_short(NumberList& list, std::size_t have, std::size_t expected) {
    list.context().fail(list.where(),
                        "a list of " + std::to_string(expected) + " entries that has " + std::to_string(have));
}

std::vector<Vec3> read_vectors(BuildContext& context, const Block& block) {
    NumberList list(context, block);
    const std::size_t count = list.count();
    std::vector<Vec3> vectors;
    for (std::size_t i = 0; i < count; ++i) {
        const std::span<const double> v = list.next();
        if (v.empty()) fail_short(list, i, count);
        const auto at = [&](std::size_t k) {
            return static_cast<float>(v.size() == 1 ? v[0] : k < v.size() ? v[k] : 0);
        };
        vectors.push_back({at(0), at(1), at(2)});
        if (!is_finite(vectors.back())) context.fail(list.where(), "a number that is not finite");
    }
    return vectors;
}

std::uint32_t index_of(NumberList& list, double number, std::size_t size, std::string_view what) {
    if (!(number >= 0 && number < static_cast<double>(size)))
        list.context().fail(list.where(), "an index out of range: " + std::to_string(static_cast<long long>(number)),
                            "there are " + std::to_string(size) + " " + std::string(what) + ", the first is 0");
    return static_cast<std::uint32_t>(number);
}

using Triple = std::array<std::uint32_t, 3>;

Triple triple_of(NumberList& list, std::span<const double> v, std::size_t size, std::string_view what) {
    const auto at = [&](std::size_t k) {
        return index_of(list, v.size() == 1 ? v[0] : k < v.size() ? v[k] : 0, size, what);
    };
    return {at(0), at(1), at(2)};
}

std::vector<Triple> read_triples(BuildContext& context, const Block& block, std::size_t size, std::string_view what) {
    NumberList list(context, block);
    const std::size_t count = list.count();
    std::vector<Triple> triples;
    for (std::size_t i = 0; i < count; ++i) {
        const std::span<const double> v = list.next();
        if (v.empty()) fail_short(list, i, count);
        triples.push_back(triple_of(list, v, size, what));
    }
    return triples;
}

/// One mesh2 while its lists are read.
class Mesh2Reader {
public:
    Mesh2Reader(ObjectReader& objects, ItemReader& items)
        : objects_(objects), context_(objects.context()), items_(items), builder_(objects) {}

    NodeShape read() {
        SolidMesh& mesh = builder_.mesh().triangles;
        while (!items_.at_end()) {
            auto base = items_.take_block(Keyword::mesh2);
            if (!base) base = items_.take_block(Keyword::mesh);
            if (base) {
                const Node node = objects_.read(*base);
                if (const auto* shared = std::get_if<std::shared_ptr<const NodeMesh>>(&node.shape)) return *shared;
            } else if (const auto vertices = items_.take_block(Keyword::vertex_vectors)) {
                mesh.positions = read_vectors(context_, *vertices);
            } else if (const auto normals = items_.take_block(Keyword::normal_vectors)) {
                mesh.normals = read_vectors(context_, *normals);
            } else if (const auto uvs = items_.take_block(Keyword::uv_vectors)) {
                for (const Vec3 uv : read_vectors(context_, *uvs)) mesh.uvs.push_back({uv.x, uv.y});
            } else if (const auto list = items_.take_block(Keyword::texture_list)) {
                read_textures(*list);
            } else if (const auto faces = items_.take_block(Keyword::face_indices)) {
                read_faces(*faces);
            } else if (const auto normal_indices = items_.take_block(Keyword::normal_indices)) {
                normal_indices_ = read_triples(context_, *normal_indices, mesh.normals.size(), "normals");
            } else if (const auto uv_indices = items_.take_block(Keyword::uv_indices)) {
                uv_indices_ = read_triples(context_, *uv_indices, mesh.uvs.size(), "uv coordinates");
            } else if (items_.take(Keyword::inside_vector)) {
                mesh.inside_vector = items_.vector("an inside_vector");
                mesh.has_inside = length(mesh.inside_vector) > 0;
            } else {
                break;
            }
        }
        join(mesh);
        return builder_.finish(items_);
    }

private:
    void read_textures(const Block& block) {
        ItemReader items(context_, block);
        items.number("the number of textures");
        while (!items.at_end()) {
            const auto texture = items.take_block(Keyword::texture);
            if (!texture) items.unexpected("texture { }");
            textures_.push_back(objects_.textures().read(texture));
        }
    }

    /// Triples of vertices, each followed by up to three indices of textures (single numbers).
    void read_faces(const Block& block) {
        SolidMesh& mesh = builder_.mesh().triangles;
        NumberList list(context_, block);
        const std::size_t count = list.count();
        std::span<const double> v = list.next();
        for (std::size_t i = 0; i < count; ++i) {
            if (v.empty()) fail_short(list, i, count);
            mesh.triangles.push_back({triple_of(list, v, mesh.positions.size(), "vertices"),
                                      {kNone, kNone, kNone},
                                      {kNone, kNone, kNone},
                                      kNone});
            std::size_t corner = 0;
            CornerTextures corners;
            for (v = list.next(); v.size() == 1; v = list.next(), ++corner) {
                if (corner < corners.size())
                    corners[corner] = textures_.at(index_of(list, v[0], textures_.size(), "textures"));
            }
            if (corner == 0) continue;
            for (TexturePointer& texture : corners)
                if (!texture) texture = corners[0];
            builder_.set_corner_textures(items_, corners);
        }
    }

    /// Normals and uvs, by their own indices or by those of the faces.
    void join(SolidMesh& mesh) {
        const bool normals_by_face = normal_indices_.empty() && mesh.normals.size() >= mesh.positions.size();
        const bool uvs_by_face = uv_indices_.empty() && mesh.uvs.size() >= mesh.positions.size();
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            SolidMesh::Triangle& triangle = mesh.triangles[i];
            if (i < normal_indices_.size()) triangle.normal = normal_indices_[i];
            else if (normals_by_face && !mesh.normals.empty()) triangle.normal = triangle.position;
            if (i < uv_indices_.size()) triangle.uv = uv_indices_[i];
            else if (uvs_by_face && !mesh.uvs.empty()) triangle.uv = triangle.position;
        }
    }

    ObjectReader& objects_;
    BuildContext& context_;
    ItemReader& items_;
    MeshBuilder builder_;
    std::vector<TexturePointer> textures_;
    std::vector<Triple> normal_indices_, uv_indices_;
};

}  // namespace

NodeShape read_triangle(ObjectReader& objects, ItemReader& items, Keyword keyword) {
    MeshBuilder builder(objects);
    builder.read_triangle(items, keyword);
    return builder.finish(items);
}

NodeShape read_mesh(ObjectReader& objects, ItemReader& items) {
    MeshBuilder builder(objects);
    SolidMesh& mesh = builder.mesh().triangles;
    while (!items.at_end()) {
        auto base = items.take_block(Keyword::mesh);
        if (!base) base = items.take_block(Keyword::mesh2);
        if (base) {
            const Node node = objects.read(*base);
            if (const auto* shared = std::get_if<std::shared_ptr<const NodeMesh>>(&node.shape)) return *shared;
            continue;
        }
        if (items.take(Keyword::inside_vector)) {
            mesh.inside_vector = items.vector("an inside_vector");
            mesh.has_inside = length(mesh.inside_vector) > 0;
            continue;
        }
        const Item* item = items.peek();
        const auto* block = std::get_if<std::shared_ptr<const Block>>(&item->content);
        if (!block) break;
        const Keyword keyword = (*block)->keyword;
        if (keyword != Keyword::triangle && keyword != Keyword::smooth_triangle &&
            keyword != Keyword::smooth_color_triangle)
            break;
        ItemReader triangle(objects.context(), **block);
        builder.read_triangle(triangle, keyword);
        builder.read_triangle_modifiers(triangle);
        items.skip();
    }
    return builder.finish(items);
}

NodeShape read_mesh2(ObjectReader& objects, ItemReader& items) { return Mesh2Reader(objects, items).read(); }

}  // namespace sundog::pov
