// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace sundog::app {

/// Exit statuses, beside 0 for success.
inline constexpr int kBadInput = 1;
inline constexpr int kBadUsage = 2;
inline constexpr int kNotWritten = 3;
inline constexpr int kInterrupted = 130;  // As shells report a program that SIGINT ended.

}  // namespace sundog::app
