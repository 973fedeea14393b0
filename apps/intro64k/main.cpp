// SPDX-License-Identifier: Apache-2.0
// The 64 kB demo: a film that is ray traced while it plays.
#include <SDL.h>

#include <cstdio>
#include <ctime>

#include "film/film.h"
#include "show/options.h"
#include "show/player.h"
#include "show/renderer.h"

namespace sundog::intro {
namespace {

constexpr uint kWidth = 1280, kHeight = 720;

Quality quality_of(const Options& options) { return {options.refinement, options.shows_traced, 0.1F}; }

int write_frame(Renderer& renderer, const Options& options, uint width, uint height) {
    const Block<uint> pixels(static_cast<std::size_t>(width) * height);
    renderer.draw(options.seconds, quality_of(options), {pixels.get(), width, height, width});
    // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): gsl::owner is no part of this project
    std::FILE* file = std::fopen(options.file, "wb");
    bool good = file != nullptr;
    if (good) {
        std::fprintf(file, "P6\n%u %u\n255\n", width, height);
        for (std::size_t i = 0; i < static_cast<std::size_t>(width) * height; ++i)
            for (int shift = 16; shift >= 0; shift -= 8) std::fputc(static_cast<int>(pixels[i] >> shift & 255), file);
        good = std::ferror(file) == 0;
        good = std::fclose(file) == 0 && good;  // NOLINT(cppcoreguidelines-owning-memory)
    }
    if (good) return 0;
    std::perror(options.file);
    return 3;
}

int benchmark(Renderer& renderer, const Options& options, uint width, uint height) {
    const Block<uint> pixels(static_cast<std::size_t>(width) * height);
    const double per_second = static_cast<double>(SDL_GetPerformanceFrequency());
    const std::clock_t processor_start = std::clock();
    double total = 0;
    double slowest = 0;
    float slowest_at = 0;
    for (uint i = 0; i < options.frames; ++i) {
        const float at = kFilmSeconds * (static_cast<float>(i) + 0.5F) / static_cast<float>(options.frames);
        const Uint64 start = SDL_GetPerformanceCounter();
        renderer.draw(at, quality_of(options), {pixels.get(), width, height, width});
        const double seconds = static_cast<double>(SDL_GetPerformanceCounter() - start) / per_second;
        total += seconds;
        if (seconds > slowest) {
            slowest = seconds;
            slowest_at = at;
        }
    }
    const double processor = static_cast<double>(std::clock() - processor_start) / CLOCKS_PER_SEC;
    const Counts counts = renderer.counts();
    const double frames = options.frames;
    std::printf("%u frames of %ux%u, %u threads, refinement %s\n", options.frames, width, height, renderer.threads(),
                options.refinement ? "on" : "off");
    std::printf("frames per second: %.1f on average, %.1f at the slowest (%.2f s)\n", frames / total, 1 / slowest,
                static_cast<double>(slowest_at));
    std::printf("processor time: %.1f ms a frame, all threads together\n", processor / frames * 1e3);
    std::printf("rays per second: %.2f million\n", static_cast<double>(counts.rays) / total * 1e-6);
    std::printf("traced points: %.1f of 100 pixels\n",
                static_cast<double>(counts.points) / frames / width / height * 100);
    return 0;
}

int run(int count, char** words) {
    const Options options = read_options(count, words);
    if (options.task == Task::kWrong) return 2;
    if (options.task == Task::kHelp) {
        std::fputs(help(), stdout);
        return 0;
    }
    const uint cores = static_cast<uint>(SDL_GetCPUCount());
    if (!Renderer::runs_here()) {
        std::fputs("sundog-intro: sorry, this film needs a processor with AVX2 and FMA (of 2013 or later)\n", stderr);
        return 1;
    }
    Renderer renderer(options.threads != 0 ? options.threads : cores);
    const uint width = options.width != 0 ? options.width : kWidth;
    const uint height = options.height != 0 ? options.height : kHeight;
    if (options.task == Task::kFrame) return write_frame(renderer, options, width, height);
    if (options.task == Task::kBenchmark) return benchmark(renderer, options, width, height);
    return play(renderer, quality_of(options), options);
}

}  // namespace
}  // namespace sundog::intro

int main(int count, char** words) { return sundog::intro::run(count, words); }
