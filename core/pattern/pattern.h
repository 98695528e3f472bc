// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

struct Piece;
struct FlatPiece;
struct SeamGraph;

/// Where a seam runs along a piece's outline, so that it can be found again on the other piece.
struct SeamMark {
    int number = 0;    ///< of the seam in the garment, from 1: the same on both sides
    std::string name;  ///< "front / sleeve left"
    Points2 line;      ///< #n x 2, along the outline, from end to end
    bool closed = false;
};

/// One flat piece as a pattern maker knows it. Millimetres, y up, the fabric's right side facing
/// the reader unless it says otherwise.
struct PatternPiece {
    std::string name;  ///< as in the garment
    std::string id;    ///< unique slug, stable for the same garment
    Points2 outline;   ///< net outline (seam line), anti-clockwise, first vertex not repeated
    std::vector<Points2> holes{};   ///< closed lines inside it, clockwise
    std::vector<SeamMark> seams{};  ///< by number; free edges have none
    /// Direction of the warp where somebody has stated it: radians anti-clockwise from the x axis.
    std::optional<double> grain{};
    bool mirrored = false;      ///< the fabric's wrong side faces the reader
    int quantity = 1;           ///< how many are cut
    bool mirroredPair = false;  ///< each of them also mirrored: left and right
};

struct Pattern {
    std::string name;  ///< of the garment
    std::vector<PatternPiece> pieces;
};

/// The net outline and holes of a flattened piece, in boundary order, and the marks of its seams.
/// @param index  of the piece in the garment that the seams belong to
PatternPiece makePatternPiece(const Piece& piece, const FlatPiece& flat, const SeamGraph& seams,
                              int index);

/// The outline, then the rims of the holes; closed, first point not repeated.
/// @param Q  #V x 2, the piece's flat coordinates
std::vector<Points2> flatLoops(const Piece& piece, const Points2& Q);

/// Pieces whose names give the same slug get "-2", "-3" in pattern order.
void makeIdsUnique(Pattern& pattern);

}  // namespace toile
