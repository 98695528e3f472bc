// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>

#include <pybind11/pybind11.h>

#include "app/python/garment_binding.h"
#include "core/toile/toile.h"

namespace toile::python {

/// A flat garment and its pattern. Immutable and shared between threads; the pattern is made on
/// first use.
struct HeldFlat {
    std::shared_ptr<const HeldGarment> of;
    app::Arguments arguments;  ///< of the garment and its flattening
    PieceResults results;

    const Garment& garment() const { return of->garment; }
    /// Made on first use. Waits for another thread making it, with the GIL released.
    const FinishedPattern& pattern() const;
    const LaidOutPattern& laid() const { return pattern().laid; }

private:
    mutable std::once_flag isMade_;
    mutable FinishedPattern pattern_;
};

struct PyFlat {
    std::shared_ptr<const HeldFlat> held;
};

struct PyFlatPiece {
    std::shared_ptr<const PieceResult> result;
};

inline Identity identityOf(const PyFlat& flat) {
    return {flat.held.get(), 0};
}
inline Identity identityOf(const PyFlatPiece& piece) {
    return {piece.result.get(), 0};
}

/// Binds `FlatPiece`, `FlatSeam`, `FlatGarment` and `Garment.flatten`.
void bindFlat(py::module_& module, py::class_<PyGarment>& garment, py::class_<PyFlat>& flat);
/// Binds `Written` and `FlatGarment.write`.
void bindWriting(py::module_& module, py::class_<PyFlat>& flat);
/// Binds `Pattern` and its parts.
void bindPattern(py::module_& module, py::class_<PyFlat>& flat);
/// Binds `Proof` and its parts, and `FlatGarment.prove`.
void bindProof(py::module_& module, py::class_<PyFlat>& flat);

}  // namespace toile::python
