// SPDX-License-Identifier: Apache-2.0
// Progress and cancellation of long work, without knowing who watches.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

namespace sundog {

/// Set from any thread (or a signal handler) to ask long work to stop soon and keep what is done.
class StopFlag {
public:
    void request() noexcept { stop_.store(true, std::memory_order_relaxed); }
    void clear() noexcept { stop_.store(false, std::memory_order_relaxed); }
    [[nodiscard]] bool requested() const noexcept { return stop_.load(std::memory_order_relaxed); }

private:
    std::atomic<bool> stop_{false};
};

/// A report of how far a render is.
struct Progress {
    double fraction = 0;     ///< Done, 0 to 1.
    double seconds = 0;      ///< Since the start.
    std::uint64_t rays = 0;  ///< Traced so far, of all kinds.
};

/// Called now and then, from one thread at a time.
using ProgressSink = std::function<void(const Progress&)>;

}  // namespace sundog
