// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cut/surface_point.h"

namespace toile {

/// A place on the garment that a person points at.
struct ClothPoint {
    /// What the pointer was drawn to.
    enum class On {
        Cloth,   ///< nothing: just where it is
        Rim,     ///< an edge of the piece
        Corner,  ///< a corner of its outline
        Own,     ///< a place pointed at before
    };

    int piece = -1;   ///< index into the garment's pieces
    SurfacePoint at;  ///< on its mesh
    On on = On::Cloth;
    int own = -1;  ///< which place, where drawn to one

    bool isOnRim() const { return on == On::Rim || on == On::Corner; }
};

inline bool samePlace(const SurfacePoint& a, const SurfacePoint& b) {
    return a.face == b.face && a.barycentric == b.barycentric;
}

}  // namespace toile
