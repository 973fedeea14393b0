// SPDX-License-Identifier: Apache-2.0
#include "session/error_driven.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "session/marked_regions.h"
#include "session/pixel_errors.h"

namespace sundog {
namespace {

/// Without a target the errors of all pixels are brought under this, then under half of it, and so on.
constexpr double kFirstTarget = 0.05, kLastTarget = 1e-5;

/// A picture under way.
class ErrorDriven {
public:
    ErrorDriven(Device& device, const Frame& frame, const ErrorTarget& target, const ProgressSink& progress,
                const StopFlag& stop, const PixelRect& picture)
        : device_(device),
          frame_(frame),
          target_(target),
          progress_(progress),
          stop_(stop),
          aim_(target.error > 0 ? target.error : kFirstTarget),
          errors_(picture, target.gain),
          marks_(static_cast<std::size_t>(picture.width()) * static_cast<std::size_t>(picture.height()), 1),
          marked_(marks_.size()),
          result_{{Film(picture, frame.params.aovs), {}, 0, false}} {
        frame_.params.sampling.pattern = kernel::SAMPLES_SOBOL;
        frame_.params.sampling.cells = kSampleBlock;
        std::iota(marked_.begin(), marked_.end(), 0U);
    }

    ErrorDrivenResult render() {
        for (std::uint32_t round = 0; render_round(round); ++round) {
            errors_.add_blocks(result_.film, marked_);
            if (over() || !mark_next()) break;
        }
        result_.stats.complete = !result_.stopped;
        result_.seconds = seconds();
        sum_up();
        result_.variance = errors_.variances();
        return std::move(result_);
    }

private:
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
    [[nodiscard]] bool over() const { return result_.stopped || seconds() >= target_.time_limit_s; }

    /// A block more for the marked pixels, for as many of them as there is time. False if nothing more can come: it was
    /// stopped or has had as many samples as can be counted.
    bool render_round(std::uint32_t round) {
        // Few enough that time and stops are heeded soon, enough to keep all threads busy.
        constexpr std::size_t kAtOnce = 64;
        if (round >= 0xffffffffU / kSampleBlock) return false;
        const std::vector<PixelRect> regions = marked_regions(result_.film.bounds, marks_);
        for (std::size_t done = 0; done < regions.size(); done += kAtOnce) {
            if (round > 0 && over()) break;
            const auto some = std::span(regions).subspan(done, std::min(kAtOnce, regions.size() - done));
            const RenderStats stats = device_.render_regions(
                frame_, some, {{}, round * kSampleBlock, kSampleBlock, marks_}, result_.film, stop_);
            result_.stats.rays += stats.rays;
            result_.stats.shadow_rays += stats.shadow_rays;
            result_.stopped = !stats.complete;
            if (result_.stopped) break;
            for (const PixelRect& region : some) done_ += static_cast<double>(region.width()) * region.height();
            report(round == 0 ? static_cast<double>(done + some.size()) / static_cast<double>(regions.size()) : 1);
        }
        return true;
    }

    /// Unmarks the pixels that need no further block; with no target, starts anew with a smaller one when none is left.
    /// False if none gets any.
    bool mark_next() {
        // Errors of pixels that get nothing stay what they are: of the others alone some are done.
        const std::uint32_t most_blocks = target_.most_samples / kSampleBlock;
        double need = 0;
        std::erase_if(marked_, [&](std::uint32_t i) {
            const float error = errors_.error_around(i);
            const auto blocks = static_cast<double>(errors_.blocks(i));
            const bool wanted = error > aim_ && errors_.blocks(i) < most_blocks;
            marks_[i] = wanted ? 1 : 0;
            if (wanted) {
                // Errors fall with the root of the number of blocks.
                const double ratio = std::isfinite(error) ? error / aim_ : 2;
                need += std::min(blocks * (ratio * ratio - 1), static_cast<double>(most_blocks) - blocks);
            }
            return !wanted;
        });
        need_ = need;
        if (!marked_.empty() || target_.error > 0 || aim_ < kLastTarget) return !marked_.empty();
        aim_ /= 2;
        marked_.resize(marks_.size());
        std::iota(marked_.begin(), marked_.end(), 0U);
        return mark_next();
    }

    /// `first_round`: share of it that is done.
    void report(double first_round) {
        if (!progress_) return;
        const double now = seconds();
        const double by_time = now / target_.time_limit_s;  // 0 without a limit
        const double by_error = target_.error > 0 ? done_ / (done_ + std::max(need_, 1.0)) : 0;
        shown_ = std::max(shown_, std::min(1.0, std::max(by_time, by_error)));
        progress_({std::max(shown_, first_round * 0.01), now, result_.stats.rays});
    }

    void sum_up() {
        double blocks = 0, met = 0;
        for (std::size_t i = 0; i < marks_.size(); ++i) {
            blocks += errors_.blocks(i);
            const double error = errors_.error(i);
            if (std::isfinite(error)) result_.largest_error = std::max(result_.largest_error, error);
            if (error <= (target_.error > 0 ? target_.error : aim_)) ++met;
        }
        const auto pixels = static_cast<double>(marks_.size());
        result_.mean_samples = blocks * kSampleBlock / pixels;
        result_.met = met / pixels;
    }

    Device& device_;
    Frame frame_;
    const ErrorTarget& target_;
    const ProgressSink& progress_;
    const StopFlag& stop_;
    double aim_;
    PixelErrors errors_;
    std::vector<std::uint8_t> marks_;    // 1 for pixels that get a block in the next round
    std::vector<std::uint32_t> marked_;  // their numbers
    ErrorDrivenResult result_;
    double done_ = 0, need_ = 0;  ///< Blocks.
    double shown_ = 0;            ///< Progress.
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

ErrorDrivenResult render_to_error(Device& device, const Frame& frame, const ErrorTarget& target,
                                  const ProgressSink& progress, const StopFlag& stop,
                                  const std::optional<PixelRect>& region) {
    return ErrorDriven(device, frame, target, progress, stop, picture_of(frame, region)).render();
}

}  // namespace sundog
