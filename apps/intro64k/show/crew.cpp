// SPDX-License-Identifier: Apache-2.0
#include "show/crew.h"

namespace sundog::intro {

Crew::Crew(unsigned threads) : start_(SDL_CreateSemaphore(0)), done_(SDL_CreateSemaphore(0)) {
    // Fewer threads than asked for draw the same picture.
    while (count_ < threads && count_ < kMost) {
        Member& member = members_[count_];
        member = {this, nullptr, count_};
        member.thread = SDL_CreateThread(enter, "tracer", &member);
        if (member.thread == nullptr) break;
        ++count_;
    }
}

Crew::~Crew() {
    work_ = nullptr;
    for (unsigned i = 1; i < count_; ++i) SDL_SemPost(start_);
    for (unsigned i = 1; i < count_; ++i) SDL_WaitThread(members_[i].thread, nullptr);
    SDL_DestroySemaphore(start_);
    SDL_DestroySemaphore(done_);
}

int Crew::enter(void* member) {
    const Member& self = *static_cast<Member*>(member);
    for (;;) {
        SDL_SemWait(self.crew->start_);
        if (self.crew->work_ == nullptr) return 0;
        self.crew->take_pieces(self.number);
        SDL_SemPost(self.crew->done_);
    }
}

void Crew::take_pieces(unsigned thread) {
    for (;;) {
        const int piece = SDL_AtomicAdd(&next_, 1);
        if (piece >= pieces_) return;
        work_(job_, static_cast<unsigned>(piece), thread);
    }
}

void Crew::run(Work work, void* job, unsigned pieces) {
    work_ = work;
    job_ = job;
    pieces_ = static_cast<int>(pieces);
    SDL_AtomicSet(&next_, 0);
    for (unsigned i = 1; i < count_; ++i) SDL_SemPost(start_);
    take_pieces(0);
    for (unsigned i = 1; i < count_; ++i) SDL_SemWait(done_);
}

}  // namespace sundog::intro
