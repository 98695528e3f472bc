// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

struct Piece;

/// Where the vertices of a piece were in an earlier version of it, by what both have from the file
/// (`Piece::sourceVertex`, `sourceFace`; where neither version has any, by index) and by place; by
/// place alone where the file has other numbers now.
struct VersionMatch {
    /// A vertex that the earlier version did not have, within one of its triangles.
    struct Placed {
        int vertex;
        int face;  ///< of the earlier version
        Eigen::RowVector3d barycentric;
    };

    std::vector<int> vertex;     ///< per vertex: the one before, or -1; copies have the same one
    std::vector<Placed> placed;  ///< of those with -1
    bool complete = false;       ///< every vertex is in one of the two
};

/// The two sides of a cut are told apart by the triangles they belong to. Vertices that were only
/// moved match. A guess where the versions have little in common; never wrong by more than that.
/// Vertices within a face of the file that was divided into very many triangles may be left out.
/// Cost: linear. Pure.
VersionMatch matchVersions(const Piece& piece, const Piece& before);

/// Positions of the earlier version carried over; nothing where the match is not complete.
/// @param Q  one per vertex of `before`
std::optional<Points2> carriedOver(const VersionMatch& match, const Piece& before,
                                   const Points2& Q);

}  // namespace toile
