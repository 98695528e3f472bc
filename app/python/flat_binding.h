// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>

#include <pybind11/pybind11.h>

#include "app/python/garment_binding.h"
#include "core/toile/toile.h"

namespace toile::python {

/// A flat garment and its pattern. Immutable, except that the pattern is made on first use; shared
/// between threads.
struct HeldFlat {
    std::shared_ptr<const HeldGarment> of;
    app::Arguments arguments;  ///< of the garment, with how it was flattened
    PieceResults results;

    const Garment& garment() const { return of->garment; }
    /// Made on first use; waits for another thread that is making it, without Python's lock.
    const FinishedPattern& pattern() const;
    const LaidOutPattern& laid() const { return pattern().laid; }

private:
    mutable std::once_flag isMade_;
    mutable FinishedPattern pattern_;
};

struct PyFlat {
    std::shared_ptr<const HeldFlat> held;
};

/// A piece of it.
struct PyFlatPiece {
    std::shared_ptr<const PieceResult> result;
};

inline Identity identityOf(const PyFlat& flat) {
    return {flat.held.get(), 0};
}
inline Identity identityOf(const PyFlatPiece& piece) {
    return {piece.result.get(), 0};
}

/// `FlatPiece`, `FlatSeam`, what a flat garment has, and `Garment.flatten`.
void bindFlat(py::module_& module, py::class_<PyGarment>& garment, py::class_<PyFlat>& flat);
/// `Written` and `FlatGarment.write`.
void bindWriting(py::module_& module, py::class_<PyFlat>& flat);
/// `Pattern` and its parts.
void bindPattern(py::module_& module, py::class_<PyFlat>& flat);
/// `Proof` and its parts, `FlatGarment.prove`.
void bindProof(py::module_& module, py::class_<PyFlat>& flat);

}  // namespace toile::python
