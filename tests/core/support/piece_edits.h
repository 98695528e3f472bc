// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/cut/surface_point.h"
#include "core/garment/piece.h"

namespace toile::test {

/// Small edits of a piece, each a new version that knows what it comes from, as cutting and
/// reading make them.

/// A version zero: every vertex and face is its own source.
std::shared_ptr<const Piece> originalPiece(MeshArrays mesh);

/// A way along edges from the outline's vertex `start` (index into Piece::boundary) into the
/// inside: of all ways of so many edges, or of the longest where there is none, the one that ends
/// farthest from the outline.
PathPolyline dartAlongEdges(const Piece& piece, int start, int edges);
/// The same two ends, joined straight across the triangles.
PathPolyline straightDart(const Piece& piece, int start, int edges);

/// The piece cut along the paths; of several parts the largest.
std::shared_ptr<const Piece> opened(const Piece& piece, const std::vector<PathPolyline>& paths);

/// One vertex moved.
std::shared_ptr<const Piece> dragged(const Piece& piece, int vertex,
                                     const Eigen::RowVector3d& offset);

/// The inside vertex farthest from the outline.
int deepestVertex(const Piece& piece);

}  // namespace toile::test
