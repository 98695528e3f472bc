// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "app/cli/batch_record.h"

namespace toile::app {

/// While there is one, Ctrl-C, SIGTERM and SIGHUP are taken note of instead of ending the program;
/// those that it was started to ignore it ignores. One at a time.
class BatchSignals {
public:
    BatchSignals();
    ~BatchSignals();
    BatchSignals(const BatchSignals&) = delete;
    BatchSignals& operator=(const BatchSignals&) = delete;

    /// The signal that came; 0: none.
    static int received();
    /// Until a signal comes, a process ends, or so many seconds are over; negative: for ever.
    static void wait(double seconds);
};

/// How a process ended.
struct ProcessEnd {
    int status = 0;                                  ///< exit status; where `signal` is 0
    int signal = 0;                                  ///< that ended it
    bool isTimedOut = false, isInterrupted = false;  ///< `signal` is ours then
    BatchCost cost{};
};

/// What a process may take; 0: all there is.
struct ProcessLimits {
    double seconds = 0;
    int memoryMib = 0;  ///< as `limitMemory`
    int threads = 1;    ///< that work in it; for its memory
};

/// Does the work in a process of its own, and waits for it. The process ends with this one.
/// Precondition: there are BatchSignals; no other thread works.
/// @param work  gives the exit status  @return a signal of -1 where there is no process to be had
ProcessEnd inOwnProcess(const std::function<int()>& work, const ProcessLimits& limits);

/// The same for work that finds a short text, at most 4096 bytes: empty where it does not come to
/// its end.
ProcessEnd textOfOwnProcess(const std::function<std::string()>& work, const ProcessLimits& limits,
                            std::string& text);

}  // namespace toile::app
