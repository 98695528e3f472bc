// SPDX-License-Identifier: GPL-3.0-or-later
// The Python module: a thin face over the pipeline, as the command line is. What it takes goes
// through the command line's own parser; what it gives are views of what the core made.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "app/python/flat_binding.h"
#include "app/python/load_garment.h"
#include "app/python/raised.h"
#include "app/python/running_calls.h"
#include "core/base/version.h"

PYBIND11_MODULE(_core, module) {
    using namespace toile;
    namespace py = pybind11;
    module.doc() = "The compiled part of the package toile.";
    module.attr("__version__") = std::string(version());
    python::endCallsWithInterpreter();
    python::bindProblems(module);
    py::class_<python::PyGarment> garment(
        module, "Garment",
        "The pieces of one or several mesh files, cut and sewn. Immutable; may be used on several "
        "threads. Made by load() and garment().");
    py::class_<python::PyFlat> flat(
        module, "FlatGarment",
        "A garment whose pieces lie flat. Immutable; may be used on several threads. Made by "
        "Garment.flatten().");
    python::bindGarment(module, garment);
    python::bindLoading(module);
    python::bindFlat(module, garment, flat);
    python::bindWriting(module, flat);
    python::bindPattern(module, flat);
    python::bindProof(module, flat);
    module.def(
        "methods",
        [] {
            std::vector<std::string> names;
            for (const MethodTraits& method : allMethods()) {
                names.emplace_back(method.name);
            }
            return names;
        },
        "List of the names of methods, the one recommended first.");
}
