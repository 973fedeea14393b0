// SPDX-License-Identifier: Apache-2.0
#include "show/options.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "film/film.h"
#include "show/crew.h"

namespace sundog::intro {

const char* help() {
    return "sundog-intro: a film, ray traced while you watch. Escape ends it.\n"
           "  --window WxH        in a window, not over the full screen\n"
           "  --benchmark [N]     N frames (6000) as fast as it can, then frames and rays per second\n"
           "  --frame T FILE.ppm  writes the frame at T seconds (0 to 100), 1280x720 or as --window says\n"
           "  --no-refinement     traces every pixel\n"
           "  --show-rays         paints traced pixels white\n"
           "  --threads N         1 to 64 (as many as there are cores)\n"
           "  --silent            without sound\n";
}

namespace {

/// A number from `low` to `high` that is all of `word` up to `end`.
bool read_number(const char* word, float low, float high, float& value, char end = 0, const char** rest = nullptr) {
    if (word == nullptr) return false;
    char* stop = nullptr;
    value = std::strtof(word, &stop);
    if (stop == word || *stop != end || !(value >= low && value <= high)) return false;
    if (rest != nullptr) *rest = stop + 1;
    return true;
}

bool read_count(const char* word, uint low, uint high, uint& value, char end = 0, const char** rest = nullptr) {
    float number = 0;
    if (!read_number(word, static_cast<float>(low), static_cast<float>(high), number, end, rest)) return false;
    value = static_cast<uint>(number);
    return static_cast<float>(value) == number;
}

}  // namespace

Options read_options(int count, char** words) {
    Options options;
    const auto wrong = [&options](const char* word, const char* expected) {
        std::fprintf(stderr, "sundog-intro: %s: %s\n", word, expected);
        options.task = Task::kWrong;
        return options;
    };
    for (int i = 1; i < count && words[i] != nullptr; ++i) {
        const char* word = words[i];
        const char* next = i + 1 < count ? words[i + 1] : nullptr;
        const auto is = [word](const char* name) { return std::strcmp(word, name) == 0; };
        if (is("--window")) {
            const char* height = nullptr;
            if (!read_count(next, 16, 8192, options.width, 'x', &height) ||
                !read_count(height, 16, 8192, options.height))
                return wrong(word, "expected WxH, from 16x16 to 8192x8192, such as 1280x720");
            ++i;
        } else if (is("--benchmark")) {
            options.task = Task::kBenchmark;
            options.frames = 6000;
            if (next != nullptr && next[0] != '-') {
                if (!read_count(next, 1, 1000000, options.frames)) return wrong(word, "expected 1 to 1000000 frames");
                ++i;
            }
        } else if (is("--frame")) {
            options.task = Task::kFrame;
            if (!read_number(next, 0, kFilmSeconds, options.seconds) || i + 2 >= count)
                return wrong(word, "expected seconds from 0 to 100 and a file");
            options.file = words[i + 2];
            i += 2;
        } else if (is("--threads")) {
            if (!read_count(next, 1, Crew::kMost, options.threads)) return wrong(word, "expected 1 to 64");
            ++i;
        } else if (is("--no-refinement")) {
            options.refinement = false;
        } else if (is("--show-rays")) {
            options.shows_traced = true;
        } else if (is("--silent")) {
            options.sound = false;
        } else if (is("--help")) {
            options.task = Task::kHelp;
        } else {
            return wrong(word, "unknown; --help lists what there is");
        }
    }
    return options;
}

}  // namespace sundog::intro
