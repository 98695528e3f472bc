// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/pybind11.h>

#include "app/cli/arguments.h"
#include "core/garment/garment.h"

namespace toile::python {

namespace py = pybind11;

/// Identity of a wrapped object: its holder and an index. Each comparable wrapper has a function
/// `identityOf`.
using Identity = std::pair<const void*, std::size_t>;

/// Wrappers of the same object are equal and have the same hash. Copies return the immutable object
/// itself; pickling raises an error with advice. Precondition: `identityOf(Wrapper)`.
template <class Wrapper>
void bindIdentity(pybind11::class_<Wrapper>& type) {
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

/// A garment and the options it was read with. Immutable, shared between threads.
struct HeldGarment {
    app::Arguments arguments;  ///< including the project's settings
    Garment garment;
    Problems notes{};                   ///< about seams files and projects
    std::vector<std::string> inputs{};  ///< the files it was read from
};

/// Objects visible to Python. They are wrappers, since the shared objects are const.
struct PyGarment {
    std::shared_ptr<const HeldGarment> held;
};

struct PyPiece {
    std::shared_ptr<const Piece> piece;
};

inline Identity identityOf(const PyGarment& garment) {
    return {garment.held.get(), 0};
}
inline Identity identityOf(const PyPiece& piece) {
    return {piece.piece.get(), 0};
}

/// A seam of a garment.
struct PySeam {
    std::shared_ptr<const HeldGarment> held;
    std::size_t index;

    const Seam& seam() const { return held->garment.seams.seams[index]; }
};

inline Identity identityOf(const PySeam& seam) {
    return {seam.held.get(), seam.index};
}

/// The seam's `easeOf`; rounding errors around zero become zero.
double easeToldOf(const Seam& seam);

/// Binds `Garment`, `Piece`, `Seam`, `load` and `garment_of_arrays`.
void bindGarment(py::module_& module, py::class_<PyGarment>& garment);

/// The problems found while reading, in the command line's order.
Problems problemsOf(const HeldGarment& held);

/// The bytes of a name; nullopt if no item can have it.
std::optional<std::string> nameGiven(const py::object& key);

/// Finds an item by index (negative: from the end) or name. Throws IndexError, KeyError, TypeError.
template <class Item, class NameOf>
const Item& itemOf(const std::vector<Item>& items, const py::object& key, NameOf nameOf) {
    if (py::isinstance<py::str>(key)) {
        const auto name = nameGiven(key);
        for (const Item& item : items) {
            if (nameOf(item) == name) {
                return item;
            }
        }
        PyErr_SetObject(PyExc_KeyError, key.ptr());
        throw py::error_already_set();
    }
    if (PyIndex_Check(key.ptr()) == 0) {
        throw py::type_error("neither an index nor a name");
    }
    const py::ssize_t index = PyNumber_AsSsize_t(key.ptr(), PyExc_IndexError);
    if (index == -1 && PyErr_Occurred() != nullptr) {
        throw py::error_already_set();
    }
    const auto count = static_cast<py::ssize_t>(items.size());
    if (index >= count || index < -count) {
        throw py::index_error("there are " + std::to_string(count));
    }
    return items[static_cast<std::size_t>(index < 0 ? index + count : index)];
}

/// The item as a Python object; a list for a slice. @param wrapped  makes the wrapper
template <class Item, class NameOf, class Wrapped>
py::object itemsOf(const std::vector<Item>& items, const py::object& key, NameOf nameOf,
                   Wrapped wrapped) {
    if (!py::isinstance<py::slice>(key)) {
        return py::cast(wrapped(itemOf(items, key, nameOf)));
    }
    py::ssize_t from = 0, to = 0, step = 0, count = 0;
    if (!key.cast<py::slice>().compute(static_cast<py::ssize_t>(items.size()), &from, &to, &step,
                                       &count)) {
        throw py::error_already_set();
    }
    py::list part;
    for (; count > 0; --count, from += step) {
        part.append(wrapped(items[static_cast<std::size_t>(from)]));
    }
    return part;
}

/// Whether an item has this name or is this object.
template <class Item, class NameOf, class Wrapped>
bool hasItem(const std::vector<Item>& items, const py::object& key, NameOf nameOf,
             Wrapped wrapped) {
    using Wrapper = decltype(wrapped(items.front()));
    if (py::isinstance<py::str>(key)) {
        const auto name = nameGiven(key);
        return std::ranges::any_of(items, [&](const Item& item) { return nameOf(item) == name; });
    }
    return py::isinstance<Wrapper>(key) && std::ranges::any_of(items, [&](const Item& item) {
               return identityOf(wrapped(item)) == identityOf(key.cast<const Wrapper&>());
           });
}

}  // namespace toile::python
