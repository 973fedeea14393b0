// SPDX-License-Identifier: Apache-2.0
// Walks along rays by how dense media can be at most: everywhere, or, where a list of media has a grid (made by
// compile/media_bound), in each of its cells (Amanatides and Woo, A Fast Voxel Traversal Algorithm, Eurographics 1987;
// Fong et al., Production Volume Rendering, SIGGRAPH 2017 course). Empty cells are passed without a look.
#ifndef SUNDOG_KERNEL_ATMOSPHERE_MAJORANTS_H
#define SUNDOG_KERNEL_ATMOSPHERE_MAJORANTS_H

#include "kernel/atmosphere/media_group.h"
#include "kernel/patterns/program.h"
#include "kernel/rays.h"

KERNEL_BEGIN

/// Farther than any place.
const float BEYOND_ALL = 1.0e30f;
/// So far, in cells, rays go on in a cell's stead in the one that they come to, so that rounding doesn't hold them up.
/// Cells' bounds hold that far around them.
const float CELL_OVERLAP = 0.015625f;

/// Where the walk along a ray has come to, and the density of places there by which it goes: no less than the media's
/// extinction.
struct Walk {
    real t;
    real density;
};

FN Walk begun_walk() {
    Walk walk;
    walk.t = real(0.0f);
    walk.density = real(0.0f);
    return walk;
}

/// How far along an axis a ray gets before it passes out of [low, high].
FN real way_to_wall(real origin, real direction, real low, real high) {
    real wall = select(direction > real(0.0f), high, low);
    mask goes = abs(direction) > real(0.0f);
    return select(goes, (wall - origin) / select(goes, direction, real(1.0f)), real(BEYOND_ALL));
}

/// The share of their bound that the media of a list with a grid have at most from t on until `until`, which it lowers.
FN real share_along(SCENE uint grid, Ray ray, real t, INOUT(real) until) {
    real3 to_x = real3(code_vec3(SCENE_ grid));
    real3 to_y = real3(code_vec3(SCENE_ grid + 3u));
    real3 to_z = real3(code_vec3(SCENE_ grid + 6u));
    real3 origin = to_x * ray.origin.x + to_y * ray.origin.y + to_z * ray.origin.z + real3(code_vec3(SCENE_ grid + 9u));
    real3 direction = to_x * ray.direction.x + to_y * ray.direction.y + to_z * ray.direction.z;
    real3 place = origin + direction * t;
    uint count_x = AT(code, grid + MEDIA_GRID_COUNTS);
    uint count_y = AT(code, grid + MEDIA_GRID_COUNTS + 1u);
    uint count_z = AT(code, grid + MEDIA_GRID_COUNTS + 2u);
    real3 count = real3(real(float(count_x)), real(float(count_y)), real(float(count_z)));
    real3 zero = real3(real(0.0f));
    mask inside = mask_and(
        mask_and(mask_and(place.x >= zero.x, place.x < count.x), mask_and(place.y >= zero.y, place.y < count.y)),
        mask_and(place.z >= zero.z, place.z < count.z));
    // A cell; and outside of the grid one of the 26 parts into which the planes of its sides divide space.
    real3 cell = real3(floor(place.x), floor(place.y), floor(place.z));
    real3 low = select(inside, cell, zero);
    real3 high = select(inside, cell + real3(real(1.0f)), count);
    low.x = select(place.x < zero.x, real(-BEYOND_ALL), select(place.x >= count.x, count.x, low.x));
    low.y = select(place.y < zero.y, real(-BEYOND_ALL), select(place.y >= count.y, count.y, low.y));
    low.z = select(place.z < zero.z, real(-BEYOND_ALL), select(place.z >= count.z, count.z, low.z));
    high.x = select(place.x < zero.x, real(0.0f), select(place.x >= count.x, real(BEYOND_ALL), high.x));
    high.y = select(place.y < zero.y, real(0.0f), select(place.y >= count.y, real(BEYOND_ALL), high.y));
    high.z = select(place.z < zero.z, real(0.0f), select(place.z >= count.z, real(BEYOND_ALL), high.z));
    real way =
        min(way_to_wall(origin.x, direction.x, low.x, high.x),
            min(way_to_wall(origin.y, direction.y, low.y, high.y), way_to_wall(origin.z, direction.z, low.z, high.z)));
    // In far places a step must be one to the numbers there, too.
    real overlap = max(CELL_OVERLAP / max(largest(abs(direction)), real(1e-30f)), t * 2.4e-7f);
    until = min(until, max(way, t) + overlap);
    real3 last = count - real3(real(1.0f));
    word x = word_from_real(clamp(cell.x, real(0.0f), last.x));
    word y = word_from_real(clamp(cell.y, real(0.0f), last.y));
    word z = word_from_real(clamp(cell.z, real(0.0f), last.z));
    word index = word(grid + MEDIA_GRID_WORDS) + x + (y + z * word(count_y)) * word(count_x);
    real share = as_real(GET(code, index));
    return select(inside, share, real(code_float(SCENE_ grid + MEDIA_GRID_OUTSIDE)));
}

/// Goes on by as much as it takes until the density of places adds up to `depth`, in the lanes of `going`, or up to
/// `reach` or beyond. The density is `factor` times the media's bound, and where they may be at all no less than
/// `least`.
FN_LARGE void walk_on(SCENE MediaGroup group, float factor, real least, Ray ray, real depth, real reach, mask going,
                      INOUT(Walk) walk) {
    mask walking = going;
    while (any_lane(walking)) {
        real until = real(BEYOND_ALL);
        real sum = real(0.0f);
        real most_share = real(0.0f);
        for (uint k = 0u; k < group.count; k = k + 1u) {
            uint list = group.list[k];
            real share = real(1.0f);
            uint grid = AT(code, list + MEDIA_LIST_GRID);
            if (grid != NONE) share = share_along(SCENE_ grid, ray, walk.t, until);
            sum = sum + share * (factor * code_float(SCENE_ list + MEDIA_LIST_MOST));
            most_share = max(most_share, share);
        }
        real density = select(most_share > real(0.0f), max(sum, least), real(0.0f));
        real left = until - walk.t;
        real way = select(density > real(0.0f), depth / max(density, real(1e-30f)), real(BEYOND_ALL));
        mask arrives = way <= left;
        walk.density = select(walking, density, walk.density);
        walk.t = select(walking, select(arrives, walk.t + way, until), walk.t);
        depth = depth - density * left;
        walking = mask_and(mask_and(walking, mask_not(arrives)), walk.t < reach);
    }
}

KERNEL_END

#endif
