// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <future>
#include <mutex>
#include <vector>

namespace toile {

/// Threads of cancelled calls that are still in a stage that cannot be interrupted (a
/// factorisation). They share ownership of their data, end soon, and their results are dropped.
/// The owner of this object decides how long they may run: its destructor waits for them.
/// Thread-safe.
class EndingWorkers {
public:
    void take(std::vector<std::future<void>> more);
    /// How many are still busy and use cores and memory.
    int count() const;

private:
    mutable std::mutex mutex_;
    std::vector<std::future<void>> workers_;  ///< of std::async: their destructors join
};

}  // namespace toile
