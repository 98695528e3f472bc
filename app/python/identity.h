// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

#include <pybind11/pybind11.h>

namespace toile::python {

/// Which thing a wrapper stands for: what holds it, and which of several. Each wrapper that Python
/// may compare has a function `identityOf`.
using Identity = std::pair<const void*, std::size_t>;

/// Wrappers of the same thing are equal and hash alike. What never changes is its own copy, and
/// pickling says what to do instead. Precondition: `identityOf(Wrapper)`.
template <class Wrapper>
void bindIdentity(pybind11::class_<Wrapper>& type) {
    namespace py = pybind11;
    type.def("__eq__",
             [](const Wrapper& self, const py::object& other) -> py::object {
                 if (!py::isinstance<Wrapper>(other)) {
                     return py::reinterpret_borrow<py::object>(Py_NotImplemented);
                 }
                 return py::bool_(identityOf(self) == identityOf(other.cast<const Wrapper&>()));
             })
        .def("__hash__",
             [](const Wrapper& self) {
                 const auto [holder, index] = identityOf(self);
                 return std::hash<const void*>()(holder) + index;
             })
        .def("__copy__", [](const py::object& self) { return self; })
        .def("__deepcopy__", [](const py::object& self, const py::object&) { return self; })
        .def("__reduce_ex__", [](const py::object& self, const py::object&) -> py::object {
            const auto name = py::type::of(self).attr("__name__").cast<std::string>();
            throw py::type_error("a toile." + name +
                                 " stays in its process; pass paths or arrays between processes, "
                                 "and load and flatten where they arrive");
        });
}

}  // namespace toile::python
