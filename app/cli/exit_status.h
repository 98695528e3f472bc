// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace toile::app {

/// With which the program ends; `exitMeanings` says what each stands for.
enum ExitStatus { kExitDone = 0, kExitSomeFailed = 1, kExitUsage = 2, kExitUnreadable = 3 };

struct ExitMeaning {
    const char* status;   ///< a number, or "128 + N"
    const char* meaning;  ///< without a full stop
};

/// Each status once, the least first: the one place that tells them. The help lists them, the
/// manual page takes them from there, and a test holds docs/report.md to them.
std::span<const ExitMeaning> exitMeanings();

}  // namespace toile::app
