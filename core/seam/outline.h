// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/garment/piece.h"
#include "core/garment/seam.h"
#include "core/geometry/line.h"

namespace toile::seam {

/// The boundary of a piece, or the rim of a hole in it, as a closed polyline, ready for measuring.
/// Arc lengths in mm.
struct Outline {
    int piece = -1;             ///< index of the piece
    int loop = 0;               ///< as in SeamSide
    std::vector<int> vertices;  ///< #n, of the piece, in loop order
    geometry::SpaceLine line = geometry::SpaceLine::closed({});  ///< #n points, in loop order
    Points3 inward;               ///< #n x 3, per edge: unit vector into the cloth
    std::vector<double> spacing;  ///< #n, per edge: mean edge length around it
    Eigen::VectorXd angle;        ///< #n, inner angle of each vertex, radians

    int size() const { return line.count(); }
    double length() const { return line.length(); }
    /// Index modulo the size, for any integer.
    int wrapIndex(int k) const { return (k % size() + size()) % size(); }
    /// Arc length modulo the perimeter, in [0, length).
    double wrap(double s) const { return line.wrap(s); }
    /// The edge that an arc length lies in.
    int edgeAt(double s) const { return line.edgeAt(s); }
    double spacingAt(double s) const { return spacing[edgeAt(s)]; }
    Eigen::Vector3d pointAt(double s) const { return line.pointAt(s).transpose(); }
    /// Arc length of vertex k over any number of turns: k may be negative or large.
    double arcOf(int k) const { return line.placeOf(k); }
    /// The arc length of the vertex nearest to `s`, counted on like `s`.
    double nearestVertex(double s) const;
};

/// The outlines of all pieces, one each (empty if the piece is no disk), then the rims of all
/// holes; edges are numbered across all of them.
struct Outlines {
    std::vector<Outline> list;
    std::vector<int> firstEdge;  ///< per outline, one more at the end
    std::vector<int> outlineOf;  ///< per edge
    std::vector<int> firstHole;  ///< per piece: the outline of its first hole
    double size = 0;             ///< diagonal of the garment's bounding box

    int edgeCount() const { return firstEdge.back(); }
    const Outline& of(int edge) const { return list[outlineOf[edge]]; }
    int local(int edge) const { return edge - firstEdge[outlineOf[edge]]; }
    double lengthOf(int edge) const {
        return of(edge).arcOf(local(edge) + 1) - of(edge).arcOf(local(edge));
    }
    /// The piece of an edge.
    int pieceOf(int edge) const { return of(edge).piece; }
    /// The index of the outline that a side runs along.
    int indexOf(const SeamSide& side) const {
        return side.loop == 0 ? side.piece : firstHole[side.piece] + side.loop - 1;
    }
};

Outlines buildOutlines(const Pieces& pieces);

}  // namespace toile::seam
