// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include "core/base/progress.h"

namespace toile::python {

/// A call that releases the GIL meanwhile. Construct and destroy it with the GIL held. While any
/// exists, the BLAS shared with numpy uses one thread; the last one restores the previous number.
class RunningCall {
public:
    /// @param progress  of the call; outlives this. After the interpreter's end, only the thread
    /// that ends it returns from here or the destructor. A thread started after that gets Raised
    /// with Cancelled from here
    explicit RunningCall(Progress& progress);
    ~RunningCall();
    RunningCall(const RunningCall&) = delete;
    RunningCall& operator=(const RunningCall&) = delete;

private:
    Progress* progress_;
};

/// At exit, the interpreter cancels the calls of daemon threads and waits for them. Otherwise a
/// thread that requests the GIL after the end would be killed inside C++ code.
void endCallsWithInterpreter();

}  // namespace toile::python
