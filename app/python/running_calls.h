// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include "core/base/progress.h"

namespace toile::python {

/// A call that gives Python's lock away meanwhile, from here to its end. With Python's lock held
/// when it is made and when it goes. While any lives, the BLAS that numpy shares has one thread;
/// after the last it has as many as before the first.
class RunningCall {
public:
    /// @param progress  of the call; outlives this. Once the interpreter ends no thread but the one
    /// that ends it comes back, from here or from the end; but one that is started after that gets
    /// Raised from here, Cancelled
    explicit RunningCall(Progress& progress);
    ~RunningCall();
    RunningCall(const RunningCall&) = delete;
    RunningCall& operator=(const RunningCall&) = delete;

private:
    Progress* progress_;
};

/// From now on the end of the interpreter cancels the calls of daemon threads and waits for them:
/// a thread that asks for Python's lock after the end is ended itself, in the midst of C++.
void endCallsWithInterpreter();

}  // namespace toile::python
