// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

struct Piece;

/// Maps the vertices of a piece to an earlier version of it, by their numbers in the file
/// (`Piece::sourceVertex`, `sourceFace`; by index if neither version has any) and by position; by
/// position alone if the file was renumbered.
struct VersionMatch {
    /// A vertex that the earlier version did not have, inside one of its triangles.
    struct Placed {
        int vertex;
        int face;  ///< of the earlier version
        Eigen::RowVector3d barycentric;
    };

    std::vector<int> vertex;     ///< per vertex: the earlier one, or -1; copies have the same one
    std::vector<Placed> placed;  ///< for vertices with -1
    bool complete = false;       ///< every vertex is in one of the two
};

/// The two sides of a cut are distinguished by their triangles. Vertices that were only moved
/// match. If the versions have little in common, the match is a guess. Vertices within a face of
/// the file that was divided into very many triangles may be missing.
/// Cost: linear. Pure.
VersionMatch matchVersions(const Piece& piece, const Piece& before);

/// Positions transferred from the earlier version; nothing if the match is incomplete.
/// @param Q  one per vertex of `before`
std::optional<Points2> carriedOver(const VersionMatch& match, const Piece& before,
                                   const Points2& Q);

}  // namespace toile
