// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Checks on plain arrays whether a mesh can be flattened, so that the fault can be named before a
/// half-edge structure would tear or reject the faces.
struct DiskCheck {
    std::optional<Error> defect;  ///< the first fault found, with counts and a place; none if valid
    std::vector<int> boundary;    ///< the boundary loop, surface on its left, if it is a disk
    EdgeTable table;              ///< the edges, always set
};

/// Checks a connected mesh for: non-finite positions, repeated or zero-height triangles, duplicate
/// faces, edges with more than two faces, opposed windings (or no orientation at all), pinched
/// vertices, no or several boundary loops, handles, boundary edges without length.
/// `name` is the piece for the message; places are given as coordinates in mm.
/// @param validTable  the edges of a mesh that is known to be a valid surface (`isValidSurface`):
///                    then only loops, handles and boundary edges are checked
/// Errors in `defect`: any of the piece codes of ErrorCode. Cost: linear.
DiskCheck checkDisk(const MeshArrays& mesh, const std::string& name,
                    std::optional<EdgeTable> validTable = std::nullopt);

/// True if a mesh is an oriented manifold with boundary whose vertices are all used and whose
/// triangles all have a height: then `repair` changes nothing, and `checkDisk` only counts loops.
/// @param table  the edges of `mesh`
/// Cost: linear, a few passes. Pure.
bool isValidSurface(const MeshArrays& mesh, const EdgeTable& table);

}  // namespace toile
