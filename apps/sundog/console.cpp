// SPDX-License-Identifier: Apache-2.0
#include "console.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>

namespace sundog::app {
namespace {

constexpr int kMostWarnings = 20;

/// Signal handlers reach nothing but statics; this is the only one of the program.
StopFlag& interrupt_flag() {
    static StopFlag flag;
    return flag;
}

extern "C" void sundog_on_interrupt(int) { interrupt_flag().request(); }

void handle(int signal_number, void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = static_cast<int>(SA_RESETHAND);  // The second signal meets the default: the program ends.
    sigemptyset(&action.sa_mask);
    sigaction(signal_number, &action, nullptr);
}

}  // namespace

void print_error(const std::string& message, const std::string& hint) {
    fmt::print(stderr, "sundog: error: {}\n", message);
    if (!hint.empty()) fmt::print(stderr, "hint: {}\n", hint);
}

void print_note(const std::string& message) { fmt::print(stderr, "{}\n", message); }

WarningSink WarningPrinter::sink() {
    return [this](const Diagnostic& diagnostic) {
        if (++count_ <= kMostWarnings) fmt::print(stderr, "{}\n", format(diagnostic));
    };
}

WarningPrinter::~WarningPrinter() {
    if (count_ > kMostWarnings) std::fprintf(stderr, "… and %d more warnings\n", count_ - kMostWarnings);
}

InterruptGuard::InterruptGuard() {
    interrupt_flag().clear();
    handle(SIGINT, sundog_on_interrupt);
    handle(SIGTERM, sundog_on_interrupt);
}

InterruptGuard::~InterruptGuard() {
    handle(SIGINT, SIG_DFL);
    handle(SIGTERM, SIG_DFL);
}

const StopFlag& InterruptGuard::flag() const { return interrupt_flag(); }

}  // namespace sundog::app
