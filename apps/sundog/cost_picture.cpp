// SPDX-License-Identifier: Apache-2.0
#include "cost_picture.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <vector>

#include "console.h"
#include "exit_status.h"
#include "output/progress_line.h"

namespace sundog::app {
namespace {

constexpr std::array<Vec3, 6> kDecades{
    {{0, 0, 0.12F}, {0, 0.1F, 0.7F}, {0.02F, 0.45F, 0.08F}, {1, 0.75F, 0}, {0.8F, 0.03F, 0.01F}, {1, 1, 1}}};
/// Rows at a time: often enough to answer a stop.
constexpr int kRows = 16;

}  // namespace

Vec3 cost_color(double steps) {
    if (!(steps > 0)) return {0, 0, 0};
    if (steps < 1) return kDecades[0] * static_cast<float>(steps);
    const double decades = std::min(std::log10(steps), static_cast<double>(kDecades.size() - 1));
    const auto below = std::min(static_cast<std::size_t>(decades), kDecades.size() - 2);
    const auto part = static_cast<float>(decades - static_cast<double>(below));
    return kDecades[below] * (1 - part) + kDecades[below + 1] * part;
}

CostPicture cost_picture(Device& device, const Frame& frame, int samples, const ProgressSink& progress,
                         const StopFlag& stop) {
    const auto width = static_cast<int>(frame.params.width), height = static_cast<int>(frame.params.height);
    Film film({0, 0, width, height});
    std::vector<std::uint64_t> steps(film.radiance.size(), 0);
    CostPicture picture{output::Image(width, height)};
    const auto start = std::chrono::steady_clock::now();
    Progress done;
    for (int y = 0; y < height && !picture.stopped; y += kRows) {
        const RenderWork work{
            {0, y, width, std::min(height, y + kRows)}, 0, static_cast<std::uint32_t>(samples), {}, steps};
        const RenderStats stats = device.render(frame, work, film, stop);
        picture.stopped = !stats.complete;
        done.rays += stats.rays;
        done.fraction = static_cast<double>(work.region.y1) / height;
        done.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (progress) progress(done);
    }
    double sum = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double taken = static_cast<double>(steps[film.index(x, y)]) / samples;
            picture.image.at(x, y) = cost_color(taken);
            picture.most = std::max(picture.most, taken);
            sum += taken;
        }
    picture.mean = sum / static_cast<double>(steps.size());
    return picture;
}

int render_cost(const RenderArguments& arguments, const OutputPlan& plan, const Stage& stage) {
    const Frame frame = make_frame(stage.scene, stage.compiled, arguments.frame);
    const InterruptGuard interrupt;
    output::ProgressLine line(std::cerr, !arguments.quiet && isatty(STDERR_FILENO) == 1);
    const CostPicture picture = cost_picture(stage.session.device(), frame, arguments.sampling.most_samples(),
                                             std::ref(line), interrupt.flag());
    line.clear();
    const bool standard_output = plan.target == Target::standard_output;
    if (standard_output) output::write_file_atomically("-", output::encode(picture.image, plan.format, {}));
    else output::write_image(plan.file, picture.image, {});
    const std::string name = standard_output ? "standard output" : plan.file.string();
    if (picture.stopped) {
        print_note(fmt::format("interrupted: wrote what was done to {}", name));
        return kInterrupted;
    }
    if (!arguments.quiet)
        print_note(
            fmt::format("wrote {} ({}x{}, acceleration {}; steps a pixel: {:.1f} on average, {:.0f} at most)\n"
                        "  dark blue 1, blue 10, green 100, yellow 1,000, red 10,000, white 100,000 and more",
                        name, picture.image.width, picture.image.height,
                        name_of(arguments.acceleration.value_or(Acceleration::embree)), picture.mean, picture.most));
    return 0;
}

}  // namespace sundog::app
