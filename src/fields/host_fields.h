// SPDX-License-Identifier: Apache-2.0
// Patterns and warps that only the host computes: what programs (pigment_code.h) ask for by number.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/diagnostics.h"
#include "kernel/patterns/host_fields.h"
#include "scene/pattern.h"
#include "scene/scene.h"

namespace sundog::fields {

/// Where a field is asked; of surfaces, world space: 0 off surfaces.
struct FieldPoint {
    Vec3d position, normal, direction, world;
};

/// One field, warp or normal. Immutable: any number of threads may ask at once.
class HostField {
public:
    HostField() = default;
    HostField(const HostField&) = delete;
    HostField& operator=(const HostField&) = delete;
    virtual ~HostField() = default;
    /// A field's value in x; a warp's point; what is added to a normal.
    [[nodiscard]] virtual Vec3d at(const FieldPoint& point) const = 0;
    /// The same at many points, into as many of `answers`.
    virtual void at_all(std::span<const FieldPoint> points, std::span<Vec3d> answers) const {
        for (std::size_t i = 0; i < points.size(); ++i) answers[i] = at(points[i]);
    }
};

/// True for patterns that are fields of the host's.
bool is_host_field(scene::Pattern::Kind kind);
/// A field of such a kind. `textures` are what images of a function's pigments are taken from; copied where needed.
std::unique_ptr<HostField> make_host_field(const scene::Pattern& pattern, std::span<const scene::Texture> textures);
std::unique_ptr<HostField> make_host_warp(const scene::Warp& warp);
/// What quilted and facets add to a normal.
std::unique_ptr<HostField> make_host_normal(const scene::Pattern& pattern);

/// A scene's host fields, numbered as they are added.
class HostFieldTable final : public kernel::HostFields {
public:
    explicit HostFieldTable(std::span<const scene::Texture> textures) : textures_(textures) {}

    /// `where` is the pigment or normal that needs it.
    std::uint32_t add(std::unique_ptr<HostField> field, const SourceLocation& where) {
        if (!first_where_) first_where_ = where;
        return add_shared(std::move(field));
    }
    /// One that shaders compute for themselves.
    std::uint32_t add_shared(std::unique_ptr<HostField> field) {
        fields_.push_back(std::move(field));
        return static_cast<std::uint32_t>(fields_.size() - 1);
    }
    std::uint32_t add_shared_field(const scene::Pattern& pattern) {
        return add_shared(make_host_field(pattern, textures_));
    }
    std::uint32_t add_field(const scene::Pattern& pattern, const SourceLocation& where) {
        return add(make_host_field(pattern, textures_), where);
    }
    [[nodiscard]] bool empty() const { return fields_.empty(); }
    /// Of what only the host can run: the first, if there is any.
    [[nodiscard]] const std::optional<SourceLocation>& first_where() const { return first_where_; }

    void at(kernel::uint index, std::span<const kernel::HostPoint> points,
            std::span<kernel::vec3> answers) const override;

private:
    std::span<const scene::Texture> textures_;  ///< Of use only while fields are added.
    std::vector<std::unique_ptr<HostField>> fields_;
    std::optional<SourceLocation> first_where_;
};

}  // namespace sundog::fields
