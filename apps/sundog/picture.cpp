// SPDX-License-Identifier: Apache-2.0
#include "picture.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "usage_error.h"

namespace sundog::app {
namespace {

void append(std::vector<float>& values, Vec3 v) { values.insert(values.end(), {v.x, v.y, v.z}); }

float number_or_none(std::uint32_t index) { return index == kernel::NONE ? -1.0F : static_cast<float>(index); }

output::Layer vectors(const char* name, std::vector<std::string> channels, const std::vector<Vec3>& plane) {
    output::Layer layer{name, std::move(channels), {}};
    layer.values.reserve(3 * plane.size());
    for (const Vec3 v : plane) append(layer.values, v);
    return layer;
}

}  // namespace

output::Image image_of(const Film& film, float exposure_ev) {
    const float scale = std::exp2(exposure_ev);
    output::Image image(film.bounds.width(), film.bounds.height());
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            image.at(x, y) = film.mean(film.bounds.x0 + x, film.bounds.y0 + y) * scale;
    return image;
}

void paint_traced(const Film& film, output::Image& image) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (film.cost[film.index(film.bounds.x0 + x, film.bounds.y0 + y)] > 0) image.at(x, y) = {1, 1, 1};
}

std::vector<output::Layer> layers_of(const Film& film, const AovChoice& aovs) {
    std::vector<output::Layer> layers;
    if (aovs.planes & kernel::AOV_DEPTH) layers.push_back({"depth", {"Z"}, film.depth});
    if (aovs.planes & kernel::AOV_NORMAL) layers.push_back(vectors("normal", {"X", "Y", "Z"}, film.normal));
    if (aovs.planes & kernel::AOV_ALBEDO) layers.push_back(vectors("albedo", {"R", "G", "B"}, film.albedo));
    if (aovs.planes & kernel::AOV_OBJECT) {
        output::Layer layer{"object", {"id", "primitive", "material"}, {}};
        layer.values.reserve(3 * film.object.size());
        for (std::size_t i = 0; i < film.object.size(); ++i)
            append(layer.values, {number_or_none(film.object[i]), number_or_none(film.primitive[i]),
                                  number_or_none(film.material[i])});
        layers.push_back(std::move(layer));
    }
    if (aovs.samples) {
        output::Layer layer{"samples", {"count"}, {}};
        layer.values.reserve(film.radiance.size());
        for (const auto& sum : film.radiance) layer.values.push_back(sum[3]);
        layers.push_back(std::move(layer));
    }
    if (aovs.planes & kernel::AOV_COST) layers.push_back({"cost", {"rays"}, film.cost});
    return layers;
}

std::size_t picture_memory(Size size, const AovChoice& aovs, bool denoise) {
    // The film's sums, the picture made of it and the encoded file; each plane in the film and as a layer.
    std::size_t bytes = sizeof(std::array<float, 4>) + sizeof(Vec3) + sizeof(Vec3);
    const auto plane = [&](std::uint32_t bit, std::size_t size_of_one) {
        if (aovs.planes & bit) bytes += 3 * size_of_one;
    };
    plane(kernel::AOV_DEPTH, sizeof(float));
    plane(kernel::AOV_NORMAL, sizeof(Vec3));
    plane(kernel::AOV_ALBEDO, sizeof(Vec3));
    plane(kernel::AOV_OBJECT, 3 * sizeof(std::uint32_t));
    plane(kernel::AOV_COST, sizeof(float));
    // Blocks' spread and its variance, guides, and light and guides as the filter has them.
    if (denoise) bytes += 44 + 5 * sizeof(Vec3) + sizeof(float) + 12 * sizeof(float);
    if (aovs.samples) bytes += 2 * sizeof(float);
    return bytes * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
}

std::size_t usable_memory() {
    auto bytes = static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
        bytes = std::min<std::size_t>(bytes, limit.rlim_cur);
    std::size_t group_limit = 0;
    for (const char* file : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"})
        if (std::ifstream in(file); in >> group_limit) bytes = std::min(bytes, group_limit);
    return bytes;
}

void check_picture_memory(Size size, const AovChoice& aovs, bool denoise) {
    constexpr double kGigabyte = 1e9;
    const std::size_t needed = picture_memory(size, aovs, denoise);
    const std::size_t usable = usable_memory();
    // The rest of the machine and the scene need some of it too.
    if (needed <= usable / 4 * 3) return;
    const double pixels = static_cast<double>(usable) * 0.75 / (static_cast<double>(needed) / size.width / size.height);
    const int square = std::min(kLargestSide, static_cast<int>(std::sqrt(pixels)));
    throw UsageError(
        fmt::format("a picture of {}x{} takes about {:.1f} GB, and this machine has {:.1f} GB", size.width, size.height,
                    static_cast<double>(needed) / kGigabyte, static_cast<double>(usable) / kGigabyte),
        fmt::format("--size from 1x1 to about {}x{} is possible here", square, square));
}

}  // namespace sundog::app
