// SPDX-License-Identifier: Apache-2.0
#include "film/film.h"

#include <cstring>

#include "film/scenes.h"
#include "stage/curves.h"

namespace sundog::intro {
namespace {

struct Scene {
    void (*set_up)(World&, const Moment&);
    float start;    ///< Seconds into the film; it ends where the next one starts.
    float in, out;  ///< Seconds that its fades from and to black take.
    float exposure;
};

constexpr Scene kScenes[] = {
    {sea, 0, 3.5F, 0.6F, 0.95F},      {rings, 16, 0.6F, 0.5F, 1.0F},   {colonnade, 32, 0.6F, 0.5F, 1.05F},
    {carvings, 48, 0.5F, 0.5F, 0.9F}, {mirrors, 64, 0.5F, 0.8F, 1.0F}, {evening, 80, 1.2F, 4.0F, 1.0F},
    {nullptr, kFilmSeconds, 0, 0, 0},
};

}  // namespace

void set_up(World& world, float seconds, float aspect) {
    std::memset(static_cast<void*>(&world), 0, sizeof world);
    seconds = kernel::min(kernel::max(seconds, 0.0F), kFilmSeconds);
    const Scene* scene = kScenes;
    while (scene[1].set_up != nullptr && scene[1].start <= seconds) ++scene;
    const float since = seconds - scene->start;
    world.seconds = seconds;
    scene->set_up(world, {since, since * kBeatsPerSecond, aspect});
    world.exposure = scene->exposure * ramp(0, scene->in, since) * (1 - ramp(-scene->out, 0, seconds - scene[1].start));
}

}  // namespace sundog::intro
