// SPDX-License-Identifier: Apache-2.0
// A whole RenderScene in structures of ours: one over all that rests, one for each geometry that moves.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "device/accel/structure.h"
#include "device/render_scene.h"

namespace sundog::accel {

/// Planes are not in it (the kernel asks them one by one). Asking is thread-safe; each thread brings its own Scratch.
class World {
public:
    /// Builds over the scene, which must outlive this. Any structure but Embree's.
    World(Acceleration which, const RenderScene& scene);

    /// Brings moving geometries to their places, and culling to what the frame says. Builds nothing: the structure of
    /// what moves stays in its own space, and rays are carried there.
    void update(const Frame& frame);

    /// The nearest hit in (t_min, t_max) of a ray of that kind (RAY_*).
    std::optional<Found> nearest(const kernel::Ray& ray, std::uint32_t kind, Scratch& scratch, Steps& steps) const;
    /// Whether there is any.
    bool any(const kernel::Ray& ray, std::uint32_t kind, Scratch& scratch, Steps& steps) const;

    /// Of the structures and the boxes of what is in them.
    [[nodiscard]] std::size_t memory_bytes() const;

private:
    /// What is in one space: the structure is tested by all rays that come by, `endless` by all.
    struct Part {
        Part(Acceleration which, Primitives items);
        void walk(Search& search, Scratch& scratch) const;

        std::vector<Item> endless;
        std::unique_ptr<const Primitives> primitives;
        std::unique_ptr<const Structure> structure;
    };
    struct Mover {
        Part part;
        std::uint32_t instance;
        kernel::Instance placed;
    };

    void walk(const kernel::Ray& ray, Question question, Nearest& nearest, Scratch& scratch, Steps& steps,
              bool& blocked) const;

    const RenderScene& scene_;
    std::optional<Part> resting_;
    std::vector<Mover> movers_;
    bool culls_ = false;
    bool one_sided_ = false;
};

}  // namespace sundog::accel
