// SPDX-License-Identifier: Apache-2.0
#include "output/progress_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace sundog::output {
namespace {

constexpr double kRedrawSeconds = 0.1;
constexpr int kBarLength = 10;

template <typename... Values>
std::string print(const char* format, Values... values) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format, values...);
    return text.data();
}

}  // namespace

std::string format_duration(double seconds) {
    constexpr double kLongest = 3600.0 * 1000;
    if (!(seconds >= 0) || seconds > kLongest) return "-:--";
    const long whole = std::lround(seconds);
    if (whole < 3600) return print("%ld:%02ld", whole / 60, whole % 60);
    return print("%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string format_rate(double per_second, const std::string& what) {
    constexpr std::array<const char*, 5> kUnits{"", "k", "M", "G", "T"};
    double number = per_second > 0 && std::isfinite(per_second) ? per_second : 0;
    std::size_t unit = 0;
    // 999.5 would be shown as 1000.
    for (; number >= 999.5 && unit + 1 < kUnits.size(); ++unit) number /= 1000;
    const int decimals = unit == 0 || number >= 99.95 ? 0 : number >= 9.995 ? 1 : 2;
    return print("%.*f %s", decimals, number, kUnits[unit]) + what + "/s";
}

std::string progress_text(const Progress& progress) {
    const double fraction = progress.fraction > 0 ? std::min(progress.fraction, 1.0) : 0;
    // Rounded down: a full bar and 100% mean that it is done.
    const auto filled = static_cast<std::size_t>(fraction * kBarLength);
    std::string text = "[";
    text.append(filled, '#').append(kBarLength - filled, '-').append("] ");
    text += print("%3d%%  ", static_cast<int>(fraction * 100));
    text += format_rate(static_cast<double>(progress.rays) / progress.seconds, "rays") + "  ";
    return text + format_duration(progress.seconds * (1 - fraction) / fraction) + " left";
}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::operator()(const Progress& progress) {
    if (!is_terminal_) return;
    const bool done = progress.fraction >= 1;
    // A later render starts its own time again.
    const bool restarted = progress.seconds < drawn_at_seconds_;
    if (!done && !restarted && drawn_at_seconds_ >= 0 && progress.seconds < drawn_at_seconds_ + kRedrawSeconds) return;
    drawn_at_seconds_ = progress.seconds;
    const std::string text = progress_text(progress);
    const std::size_t longer = shown_length_ > text.size() ? shown_length_ - text.size() : 0;
    out_ << '\r' << text << std::string(longer, ' ') << std::flush;
    shown_length_ = text.size() + longer;
}

void ProgressLine::clear() {
    if (shown_length_ == 0) return;
    out_ << '\r' << std::string(shown_length_, ' ') << '\r' << std::flush;
    shown_length_ = 0;
}

}  // namespace sundog::output
