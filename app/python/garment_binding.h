// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "app/cli/arguments.h"
#include "core/garment/garment.h"

namespace toile::python {

namespace py = pybind11;

/// A garment, and how it was read. Immutable, shared between threads.
struct HeldGarment {
    app::Arguments arguments;  ///< with what a project says
    Garment garment;
    Problems notes{};                   ///< of seams files and projects
    std::vector<std::string> said{};    ///< likewise, whole sentences
    std::vector<std::string> inputs{};  ///< files that it was read from
};

/// What Python holds. Wrappers, since what they share is const.
struct PyGarment {
    std::shared_ptr<const HeldGarment> held;
};

struct PyPiece {
    std::shared_ptr<const Piece> piece;
};

/// Of a garment.
struct PySeam {
    std::shared_ptr<const HeldGarment> held;
    std::size_t index;

    const Seam& seam() const { return held->garment.seams.seams[index]; }
};

/// `Garment`, `Piece`, `Seam`, `load` and `garment_of_arrays`.
void bindGarment(py::module_& module, py::class_<PyGarment>& garment);

/// What was to be said while it was read, in the order in which the command line says it.
Problems problemsOf(const HeldGarment& held);

/// By index, from the end where that is negative, or by name. Throws IndexError, KeyError,
/// TypeError.
template <class Item, class NameOf>
const Item& itemOf(const std::vector<Item>& items, const py::object& key, NameOf nameOf) {
    if (py::isinstance<py::str>(key)) {
        const auto name = key.cast<std::string>();
        for (const Item& item : items) {
            if (nameOf(item) == name) {
                return item;
            }
        }
        throw py::key_error(name);
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

}  // namespace toile::python
