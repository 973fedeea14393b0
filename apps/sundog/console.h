// SPDX-License-Identifier: Apache-2.0
// What the program says on standard error, and Ctrl-C.
#pragma once

#include <string>

#include "base/diagnostics.h"
#include "base/progress.h"

namespace sundog::app {

/// "sundog: error: message", and the hint on a line of its own.
void print_error(const std::string& message, const std::string& hint = {});
/// One line of news; not an error.
void print_note(const std::string& message);

/// Prints warnings; after the first 20 it only counts them.
class WarningPrinter {
public:
    WarningPrinter() = default;
    WarningPrinter(const WarningPrinter&) = delete;
    WarningPrinter& operator=(const WarningPrinter&) = delete;
    /// Says how many warnings were not printed.
    ~WarningPrinter();
    [[nodiscard]] WarningSink sink();

private:
    int count_ = 0;
};

/// While one stands, the first SIGINT or SIGTERM sets its flag and the second ends the program. Only one at a time.
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    [[nodiscard]] const StopFlag& flag() const;
};

}  // namespace sundog::app
