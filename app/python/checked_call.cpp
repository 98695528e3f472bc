// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/checked_call.h"

#include <string>

#include "app/cli/arguments.h"

namespace toile::python {
namespace {

namespace py = pybind11;

[[noreturn]] void refuseCall(const std::string& wanted, const py::object& given) {
    const py::object type = py::module_::import("toile.errors").attr("UsageError");
    const py::str said = py::str("{}, not {:.60}").format(wanted, py::repr(given));
    PyErr_SetObject(type.ptr(), type(said, app::kWrongUsage).ptr());
    throw py::error_already_set();
}

}  // namespace

int threadsOf(const py::object& given) {
    int isTooLarge = 0;
    const long count =
        PyIndex_Check(given.ptr()) == 0
            ? -1
            : PyLong_AsLongAndOverflow(
                  py::reinterpret_steal<py::object>(PyNumber_Index(given.ptr())).ptr(),
                  &isTooLarge);
    if (isTooLarge != 0 || count < 0 || count > app::kMaxThreads) {
        PyErr_Clear();
        refuseCall("threads is a whole number from 0 to " + std::to_string(app::kMaxThreads),
                   given);
    }
    return static_cast<int>(count);
}

void checkProgress(const py::object& onProgress) {
    if (!onProgress.is_none() && PyCallable_Check(onProgress.ptr()) == 0) {
        refuseCall("progress is a function that is called with the fraction done", onProgress);
    }
}

}  // namespace toile::python
