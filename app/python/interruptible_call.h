// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <future>
#include <utility>

#include <pybind11/pybind11.h>

#include "app/python/checked_call.h"
#include "app/python/running_calls.h"
#include "core/base/progress.h"

namespace toile::python {

inline constexpr std::chrono::milliseconds kBetweenLooks{50};

/// Runs work on its own thread with the GIL released. The caller waits, checks for signals (Ctrl-C)
/// and reports progress; an exception from either cancels the work and is rethrown.
/// @param onProgress  called with the fraction done, in [0, 1], finally 1; or None
/// @param work  takes a Progress&; must not use Python objects
template <class Work>
auto interruptible(const pybind11::object& onProgress, Work work) {
    checkProgress(onProgress);
    Progress progress;
    const RunningCall running(progress);
    auto result = std::async(std::launch::async, [&progress, &work] { return work(progress); });
    const auto isReady = [&result] {
        const pybind11::gil_scoped_release released;
        return result.wait_for(kBetweenLooks) == std::future_status::ready;
    };
    try {
        while (!isReady()) {
            if (PyErr_CheckSignals() != 0) {
                throw pybind11::error_already_set();
            }
            if (!onProgress.is_none()) {
                onProgress(progress.fraction());
            }
        }
    } catch (...) {
        progress.cancel();
        const pybind11::gil_scoped_release released;
        result.wait();
        throw;
    }
    auto done = result.get();
    if (!onProgress.is_none() && !progress.isCancelled()) {
        onProgress(1.0);
    }
    return done;
}

}  // namespace toile::python
