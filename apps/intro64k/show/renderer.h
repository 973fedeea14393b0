// SPDX-License-Identifier: Apache-2.0
// Draws frames of the film with all threads.
#pragma once

#include "show/crew.h"
#include "stage/block.h"
#include "trace/draw.h"

namespace sundog::intro {

class Renderer {
public:
    /// True if the processor has what the tracer is compiled for.
    static bool runs_here();

    /// Makes noise and palettes.
    explicit Renderer(unsigned threads);

    /// Draws the film's frame at `seconds`.
    void draw(float seconds, const Quality& quality, const Picture& picture);
    /// What all frames so far traced.
    [[nodiscard]] Counts counts() const;
    [[nodiscard]] unsigned threads() const { return crew_.threads(); }

private:
    static void draw_piece(void* job, unsigned piece, unsigned thread);
    static void make_noise_piece(void* job, unsigned piece, unsigned thread);

    Crew crew_;
    Block<uint> noise_, palettes_;
    Block<World> world_;
    Block<TileWork> work_;
    Tables tables_;
    Quality quality_{};
    Picture picture_{};
};

}  // namespace sundog::intro
