// SPDX-License-Identifier: Apache-2.0
// A mistake in how the program was called (exit status 2).
#pragma once

#include <stdexcept>
#include <string>

namespace sundog::app {

/// what() is one sentence without a full stop; hint() says what would have been right, and may be empty.
class UsageError : public std::runtime_error {
public:
    explicit UsageError(const std::string& message, std::string hint = {})
        : std::runtime_error(message), hint_(std::move(hint)) {}
    [[nodiscard]] const std::string& hint() const { return hint_; }

private:
    std::string hint_;
};

}  // namespace sundog::app
