// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/running_calls.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <thread>
#include <vector>

#include "app/python/raised.h"

// Only exists if the BLAS is OpenBLAS, so it is declared weak.
#ifdef __ELF__
extern "C" {
// NOLINTBEGIN(readability-identifier-naming): OpenBLAS names them
int openblas_get_num_threads() __attribute__((weak));
void openblas_set_num_threads(int count) __attribute__((weak));
// NOLINTEND(readability-identifier-naming)
}
#else
static int (*const openblas_get_num_threads)() = nullptr;
static void (*const openblas_set_num_threads)(int) = nullptr;
#endif

namespace toile::python {
namespace {

namespace py = pybind11;

constexpr std::chrono::milliseconds kBetweenLooksAtEnd{5};
constexpr std::chrono::seconds kLongestEnd{30};  // a callback may wait for an ended thread

// Guarded by the GIL.
std::vector<Progress*> runningNow;
std::thread::id endedBy;          ///< empty while the interpreter lives
std::uint64_t lastBeforeEnd = 0;  ///< highest Python thread id at that time
int blasThreadsBefore = 0;

void endCalls() {
    endedBy = std::this_thread::get_id();
    for (PyThreadState* each = PyInterpreterState_ThreadHead(PyInterpreterState_Get());
         each != nullptr; each = PyThreadState_Next(each)) {
        lastBeforeEnd = std::max(lastBeforeEnd, PyThreadState_GetID(each));
    }
    const auto latest = std::chrono::steady_clock::now() + kLongestEnd;
    while (!runningNow.empty() && std::chrono::steady_clock::now() < latest) {
        for (Progress* const progress : runningNow) {
            progress->cancel();
        }
        const py::gil_scoped_release released;
        std::this_thread::sleep_for(kBetweenLooksAtEnd);
    }
}

/// Whether this thread was started after the interpreter's end. Others may wait for it.
bool isStartedSinceEnd() {
    return endedBy != std::thread::id() && PyThreadState_GetID(PyThreadState_Get()) > lastBeforeEnd;
}

/// Blocks a daemon thread after the interpreter's end until the process exits. Taking the GIL would
/// kill the thread inside C++ code, and so call std::terminate.
void stayWhereEnded() {
    if (endedBy == std::thread::id() || endedBy == std::this_thread::get_id()) {
        return;
    }
    const py::gil_scoped_release released;
    while (true) {
        std::this_thread::sleep_for(kLongestEnd);
    }
}

}  // namespace

RunningCall::RunningCall(Progress& progress) : progress_(&progress) {
    if (isStartedSinceEnd()) {
        throw Raised(Error{ErrorCode::Cancelled});
    }
    stayWhereEnded();
    if (runningNow.empty() && openblas_get_num_threads != nullptr) {
        blasThreadsBefore = openblas_get_num_threads();
    }
    runningNow.push_back(&progress);
}

RunningCall::~RunningCall() {
    std::erase(runningNow, progress_);
    if (runningNow.empty() && blasThreadsBefore > 0 && openblas_set_num_threads != nullptr) {
        openblas_set_num_threads(blasThreadsBefore);
    }
    stayWhereEnded();
}

void endCallsWithInterpreter() {
    py::module_::import("atexit").attr("register")(py::cpp_function(&endCalls));
    // After a fork, the child only has the forking thread.
    py::module_::import("os").attr("register_at_fork")(
        py::arg("after_in_child") = py::cpp_function([] { runningNow.clear(); }));
}

}  // namespace toile::python
