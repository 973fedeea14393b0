// SPDX-License-Identifier: Apache-2.0
// Threads that share a job of numbered pieces.
#pragma once

#include <SDL.h>

namespace sundog::intro {

class Crew {
public:
    /// A job's piece `piece`, done by thread `thread`.
    using Work = void (*)(void* job, unsigned piece, unsigned thread);

    static constexpr unsigned kMost = 64;

    /// `threads` of them, 1 to kMost, the caller's own among them.
    explicit Crew(unsigned threads);
    ~Crew();
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    [[nodiscard]] unsigned threads() const { return count_; }
    /// Does all pieces and returns when they are done.
    void run(Work work, void* job, unsigned pieces);

private:
    struct Member {
        Crew* crew;
        SDL_Thread* thread;
        unsigned number;
    };
    static int enter(void* member);
    void take_pieces(unsigned thread);

    unsigned count_ = 1;
    Member members_[kMost] = {};
    SDL_sem* start_;
    SDL_sem* done_;
    Work work_ = nullptr;  ///< Null: go home.
    void* job_ = nullptr;
    int pieces_ = 0;
    SDL_atomic_t next_ = {};
};

}  // namespace sundog::intro
