// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/wording.h"
#include "core/io/conventions.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// How a garment stands and which side of its cloth is outside, read from its surface alone.
/// Vertices that coincide are to be joined (`weldedFaces`), so that panels sewn there count as one.

/// Proposes the up axis of a file that states none: the axis along which the openings of a tube
/// lie one above the other, as waist and hem do; else as `guessUpAxis` reads the extents. In doubt
/// where the openings contradict the proposal, or face to the side.
/// @param mesh  any unit, in the file's axes  Cost: n log n. Pure.
UpGuess guessUpAxis(const MeshArrays& mesh);

/// Which way the faces of a garment look.
struct ClothSide {
    enum class Way { Unknown, Outwards, Inwards };

    Way way = Way::Unknown;  ///< unknown: an open sheet, or about as much to either side
    Wording evidence{};      ///< for a person: "97 % of the cloth that has an inside ..."

    bool operator==(const ClothSide&) const = default;
};

/// Looks from the cloth to both sides, along its normal: of what is worn, one side sees the cloth
/// opposite and the other nothing.
/// @param mesh  any unit, faces anticlockwise on the right side of the cloth
/// Cost: n log n, and rays of at most 2000 triangles. Deterministic. Pure.
ClothSide sideOfFaces(const MeshArrays& mesh);

}  // namespace toile
