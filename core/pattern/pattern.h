// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/id.h"
#include "core/garment/seam.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

struct Garment;
struct FlatPiece;
struct Piece;
struct PieceResult;
using PieceResults = std::vector<std::shared_ptr<const PieceResult>>;

/// Where the warp runs where it is unset: up the piece's own y axis, radians.
inline constexpr double kGrainUpwards = 1.5707963267948966;

/// How a piece is to be cut, as a person has said it.
struct Cutting {
    /// Direction of the warp, radians anti-clockwise from the x axis of the piece's own
    /// coordinates; none where it is unset (kGrainUpwards).
    std::optional<double> grain{};
    int quantity = 1;           ///< how many are cut
    bool mirroredPair = false;  ///< each of them also mirrored: left and right

    bool operator==(const Cutting&) const = default;
};

inline double grainOf(const Cutting& cutting) {
    return cutting.grain.value_or(kGrainUpwards);
}

/// One side of a seam, or a free edge, along a piece's outline or the rim of a hole in it.
struct SeamLine {
    int number = 0;    ///< of the seam in the garment, from 1: the same on both sides
    std::string name;  ///< "front / sleeve left"
    Points2 line;      ///< #n x 2, along the outline, from end to end
    bool closed = false;
    SeamKind kind = SeamKind::Seam;
    bool isRight = false;  ///< of the two sides of the seam
    SeamId seam{};
};

/// One flat piece as a pattern maker knows it, in its own coordinates wherever copies of it lie:
/// millimetres, y up, the fabric's right side facing the reader.
struct PatternPiece : Cutting {
    std::string name;  ///< as it is called
    std::string slug;  ///< unique in the pattern, stable for the same garment
    Points2 outline;   ///< seam line, anti-clockwise, first vertex not repeated; empty: not flat
    std::vector<Points2> holes{};  ///< closed lines inside it, clockwise
    /// By number. They cover outline and rims, but for what is too short to be a free edge and
    /// for rims that nothing is sewn to.
    std::vector<SeamLine> seams{};
    PieceId id{};
};

struct Pattern {
    std::string name;                  ///< of the garment
    std::vector<PatternPiece> pieces;  ///< one per piece of the garment, in its order
};

/// Everything of a garment that is flat, in its own coordinates. Pieces whose names give the same
/// slug get "-2", "-3" in order.
/// @param results  one per piece; null where there is none  Cost: linear in the outlines. Pure.
Pattern makePattern(const Garment& garment, const PieceResults& results);

/// The outline as it is drawn, then the rims of the holes; closed, first point not repeated.
std::vector<Points2> flatLoops(const Piece& piece, const FlatPiece& flat);

}  // namespace toile
