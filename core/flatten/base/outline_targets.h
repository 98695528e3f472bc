// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/base/error.h"

namespace toile {

struct FlatPiece;
struct Piece;
struct PieceQuality;

/// What the edges of a piece's outline are to measure in the pattern, where that is not what they
/// measure on the garment: two sides of a seam that are to be equally long, cloth that is eased in.
/// Methods with a free outline (`MethodTraits::keepsLengths`) pass it over.
struct OutlineTargets {
    /// mm, positive; edge i leaves vertex i of `Piece::boundary`. Empty: the lengths in 3D.
    Eigen::VectorXd lengths{};

    bool operator==(const OutlineTargets& other) const {
        return lengths.size() == other.lengths.size() && lengths == other.lengths;
    }
};

/// The lengths that the outline is to have in the pattern, mm, one per edge of `piece.boundary`.
Eigen::VectorXd outlineLengths(const Piece& piece, const OutlineTargets& targets);

/// NotFinite, where a target is no positive number. Precondition: none, or one per edge.
std::optional<Error> faultOf(const Piece& piece, const OutlineTargets& targets);

/// The figures of the outline as it is drawn, against the lengths that it is to have: perimeter,
/// length errors, crossings. Nothing changes where it is the polygon of its vertices with its
/// lengths in 3D. Linear, but for crossings. Pure.
void measureOutline(const Piece& piece, const FlatPiece& flat, const OutlineTargets& targets,
                    PieceQuality& quality);

}  // namespace toile
