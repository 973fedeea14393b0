// SPDX-License-Identifier: Apache-2.0
// Colours of pigments at single points, by the kernel's own code: what a function or a parse-time call sees is what the
// picture shows.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/vec3d.h"
#include "fields/double_math.h"
#include "fields/host_fields.h"
#include "kernel/shared.h"
#include "scene/scene.h"

namespace sundog::kernel {
struct SceneView;
}

namespace sundog::fields {

/// Immutable: any number of threads may ask at once.
class PigmentEvaluator final : public PigmentSource {
public:
    /// Images are taken from `textures` and kept. Errors: those of write_pigment_code().
    PigmentEvaluator(std::span<const std::shared_ptr<const scene::Pigment>> pigments,
                     std::span<const scene::Texture> textures);

    [[nodiscard]] std::array<double, 5> color(std::uint32_t index, double x, double y, double z) const override;
    [[nodiscard]] std::vector<std::array<double, 5>> colors(std::uint32_t index,
                                                            std::span<const Vec3d> points) const override;
    [[nodiscard]] std::array<double, 2> range(std::uint32_t index, std::uint8_t component) const override;
    [[nodiscard]] double slope_limit(std::uint32_t index) const override { return slope_limits_[index]; }

private:
    [[nodiscard]] kernel::SceneView view() const;
    void keep_images(const scene::Pigment& pigment, std::span<const scene::Texture> textures);

    HostFieldTable host_;
    std::vector<std::uint32_t> code_, starts_;
    std::vector<kernel::TextureInfo> infos_;
    std::vector<std::uint32_t> texels_;
    std::vector<std::array<std::array<double, 2>, 5>> ranges_;
    std::vector<double> slope_limits_;
};

}  // namespace sundog::fields
