// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "core/flatten/base/flat_piece.h"
#include "core/garment/piece.h"
#include "core/geometry/line.h"

namespace toile {

/// The outline near which a line is drawn: closed, in the plane, with the place of each of its
/// points on the outline in 3D.
struct OutlineReference {
    Points2 points{};           ///< #n x 2, mm, anti-clockwise; starts at the outline's vertex 0
    std::vector<double> arc{};  ///< #n + 1, mm, starting at 0: arc length in 3D, over one turn
    /// #n, radians: turn of the cloth at each point, to resolve full turns; 0 if the outline in 3D
    /// has no vertex there.
    std::vector<double> turn{};

    bool operator==(const OutlineReference& other) const {
        return arc == other.arc && turn == other.turn && points == other.points;
    }
};

/// An outline with two measures along it: arc length in 3D and length in the plane.
class ExactOutline {
public:
    explicit ExactOutline(const OutlineReference& reference)
        : byArc_(geometry::Line::closed(reference.points, reference.arc)),
          flat_(geometry::Line::closed(reference.points)),
          turnIn3d_(reference.turn) {}

    const geometry::Line& flat() const { return flat_; }
    const geometry::Line& byArc() const { return byArc_; }

    /// Converts an arc length in 3D to a length in the plane, over any number of turns; and back.
    double flatAt(double arc) const { return byArc_.placeOn(flat_, arc); }
    double arcAt(double flat) const { return flat_.placeOn(byArc_, flat); }
    /// Turn at a vertex; ambiguous by full turns, which are chosen as in 3D.
    double turnAt(int k) const {
        return turnIn3d_[k] + std::remainder(flat_.turnAt(k) - turnIn3d_[k], 2 * std::numbers::pi);
    }

private:
    geometry::Line byArc_, flat_;
    std::vector<double> turnIn3d_;
};

/// Arc lengths in 3D of the outline's vertices, and the perimeter.  Cost: linear. Pure.
std::vector<double> outlineArc(const Piece& piece);

/// The outline as solved.  Cost: that of the angles in 3D. Pure.
OutlineReference referenceOf(const Piece& piece, const FlatPiece& exact);

/// The points moved by the rigid motion that fits them best to others.
/// @param points, onto  #n x 2
Points2 laidOver(const Points2& points, const Points2& onto);
/// The same for a line that represents the 3D outline of a reference.
void layOver(FlatLine& line, const OutlineReference& onto);

}  // namespace toile
