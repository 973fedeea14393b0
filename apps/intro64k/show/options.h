// SPDX-License-Identifier: Apache-2.0
// The command line.
#pragma once

#include "stage/world.h"

namespace sundog::intro {

enum class Task { kPlay, kBenchmark, kFrame, kHelp, kWrong };

struct Options {
    Task task = Task::kPlay;
    uint width = 0, height = 0;  ///< 0: full screen; else the window's or the picture's size.
    float seconds = 0;           ///< kFrame: the moment.
    const char* file = nullptr;  ///< kFrame: where to.
    uint frames = 0;             ///< kBenchmark: how many, evenly over the film.
    uint threads = 0;            ///< 0: as many as there are cores.
    bool refinement = true;
    bool shows_traced = false;
    bool sound = true;
};

/// Reads the command line; says on stderr what was wrong with it (Task::kWrong).
Options read_options(int count, char** words);

/// What the options are.
const char* help();

}  // namespace sundog::intro
