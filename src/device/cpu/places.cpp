// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/places.h"

#include <vector>

#include "kernel/cameras/projections.h"

namespace sundog::cpu {

BatchRays trace_places(const kernel::SceneView& scene, RayKernel kernel, std::span<const PicturePlace> places,
                       std::span<Vec3> radiance) {
    const kernel::FrameParams& frame = scene.frame;
    const float per_width = 1.0F / static_cast<float>(frame.width);
    const float per_height = 1.0F / static_cast<float>(frame.height);
    std::vector<BatchRay> rays;
    rays.reserve(places.size());
    for (const PicturePlace& place : places) {
        const kernel::Ray ray = kernel::camera_ray(frame, place.x * per_width, place.y * per_height);
        const bool shows = ray.t_max > ray.t_min;
        rays.push_back({{ray.origin.x, ray.origin.y, ray.origin.z},
                        {ray.direction.x, ray.direction.y, ray.direction.z},
                        shows ? ray.t_max : -1.0F});
    }
    std::vector<BatchAnswer> answers(places.size());
    const BatchRays done = kernel(scene, rays, answers);
    for (std::size_t i = 0; i < places.size(); ++i) radiance[i] = answers[i].radiance;
    return done;
}

}  // namespace sundog::cpu
