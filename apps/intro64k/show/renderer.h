// SPDX-License-Identifier: Apache-2.0
// Draws frames of the film with all threads.
#pragma once

#include "show/crew.h"
#include "stage/block.h"
#include "trace/draw.h"

namespace sundog::intro {

class Renderer {
public:
    /// Makes noise and palettes. `lanes`: 4, 8 or 16; 0: as many as the processor has.
    Renderer(unsigned threads, unsigned lanes);

    /// Draws the film's frame at `seconds`.
    void draw(float seconds, const Quality& quality, const Picture& picture);
    /// What all frames so far traced.
    [[nodiscard]] Counts counts() const;
    [[nodiscard]] unsigned lanes() const { return lanes_; }
    [[nodiscard]] unsigned threads() const { return crew_.threads(); }

private:
    static void draw_piece(void* job, unsigned piece, unsigned thread);
    static void make_noise_piece(void* job, unsigned piece, unsigned thread);

    Crew crew_;
    unsigned lanes_;
    DrawTile draw_tile_;
    Block<uint> noise_, palettes_;
    Block<World> world_;
    Block<TileWork> work_;
    Tables tables_;
    Quality quality_{};
    Picture picture_{};
};

}  // namespace sundog::intro
