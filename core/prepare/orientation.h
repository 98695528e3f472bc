// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/wording.h"
#include "core/io/conventions.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// The up axis of a garment and the outer side of its cloth, derived from its surface alone.
/// Coinciding vertices must be joined (`weldedFaces`), so that panels sewn there are connected.

/// Proposes the up axis of a file that does not state one: the axis along which the openings of a
/// tube lie above each other, like waist and hem; else `guessUpAxis` of the extents. In doubt if
/// the openings contradict the proposal, or face to the side.
/// @param mesh  any unit, in the file's axes  Cost: n log n. Pure.
UpGuess guessUpAxis(const MeshArrays& mesh);

/// The side that the faces of a garment show.
struct ClothSide {
    enum class Way { Unknown, Outwards, Inwards };

    Way way = Way::Unknown;  ///< unknown: an open sheet, or mixed
    Wording evidence{};      ///< for a person: "97 % of the cloth that has an inside ..."

    bool operator==(const ClothSide&) const = default;
};

/// Looks from the cloth along its normal to both sides: on a worn garment, one side sees the
/// opposite cloth and the other nothing.
/// @param mesh  any unit, faces anticlockwise on the right side of the cloth
/// Cost: n log n, and rays of at most 2000 triangles. Deterministic. Pure.
ClothSide sideOfFaces(const MeshArrays& mesh);

}  // namespace toile
