// SPDX-License-Identifier: Apache-2.0
#include "device/accel/world.h"

namespace sundog::accel {
namespace {

kernel::vec3 transformed(const kernel::Instance& i, const kernel::vec3& v) {
    return kernel::vec3(i.object_from_world_x) * v.x + kernel::vec3(i.object_from_world_y) * v.y +
           kernel::vec3(i.object_from_world_z) * v.z;
}

/// The ray in the space of a moving object, where the same t are the same places.
kernel::Ray in_object(const kernel::Instance& i, kernel::Ray ray) {
    ray.origin = transformed(i, ray.origin) + kernel::vec3(i.object_from_world_t);
    ray.direction = transformed(i, ray.direction);
    return ray;
}

}  // namespace

World::Part::Part(Acceleration which, Primitives items) {
    endless = items.take_endless();
    primitives = std::make_unique<const Primitives>(std::move(items));
    structure = make_structure(which, *primitives);
}

void World::Part::walk(Search& search, Scratch& scratch) const {
    for (const Item& item : endless) search.test_endless(item);
    if (!search.done()) structure->walk(search, scratch);
}

World::World(Acceleration which, const RenderScene& scene) : scene_(scene) {
    Primitives resting(scene);
    for (std::uint32_t i = 0; i < scene.geometries.size(); ++i) {
        const kernel::Geometry& g = scene.geometries[i];
        if (g.kind == kernel::GEOMETRY_PLANE) continue;
        if (g.instance == kernel::NONE) {
            resting.add(i);
            continue;
        }
        Primitives moving(scene);
        moving.add(i);
        movers_.push_back({Part(which, std::move(moving)), g.instance, {}});
    }
    resting_.emplace(which, std::move(resting));
}

void World::update(const Frame& frame) {
    culls_ = (frame.params.features & kernel::FEATURE_CULL) != 0;
    one_sided_ = (frame.params.features & kernel::FEATURE_ONE_SIDED) != 0;
    for (Mover& mover : movers_) mover.placed = frame.instances[mover.instance];
}

void World::walk(const kernel::Ray& ray, Question question, Nearest& nearest, Scratch& scratch, Steps& steps,
                 bool& blocked) const {
    Search search(*resting_->primitives, ray, question, nearest, steps);
    resting_->walk(search, scratch);
    blocked = search.done();
    for (const Mover& mover : movers_) {
        if (blocked) return;
        Search there(*mover.part.primitives, in_object(mover.placed, ray), question, nearest, steps);
        mover.part.walk(there, scratch);
        blocked = there.done();
    }
}

std::optional<Found> World::nearest(const kernel::Ray& ray, std::uint32_t kind, Scratch& scratch, Steps& steps) const {
    Nearest nearest(ray.t_max);
    bool blocked = false;
    walk(ray, {kind, culls_, one_sided_, false}, nearest, scratch, steps, blocked);
    if (!nearest.found()) return std::nullopt;
    return nearest.best();
}

bool World::any(const kernel::Ray& ray, std::uint32_t kind, Scratch& scratch, Steps& steps) const {
    Nearest nearest(ray.t_max);
    bool blocked = false;
    walk(ray, {kind, culls_, one_sided_, true}, nearest, scratch, steps, blocked);
    return blocked;
}

std::size_t World::memory_bytes() const {
    std::size_t bytes = 0;
    const auto add = [&](const Part& part) {
        bytes += part.primitives->memory_bytes() + part.structure->memory_bytes();
    };
    add(*resting_);
    for (const Mover& mover : movers_) add(mover.part);
    return bytes;
}

}  // namespace sundog::accel
