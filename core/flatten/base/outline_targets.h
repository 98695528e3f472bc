// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/error.h"

namespace toile {

struct FlatPiece;
struct Piece;
struct PieceQuality;

/// Why a stretch of an outline has another length in the pattern than in 3D: it is made equal to
/// its mirror image, its length was typed, its ease is drawn, or `improvePattern` has changed it.
enum class LengthCause { Mirroring, Length, Ease, Improving };

/// A part of an outline whose length is changed: arc lengths in 3D, mm, from <= to. Parts of one
/// outline do not overlap.
struct ChangedPart {
    LengthCause cause = LengthCause::Mirroring;
    double from = 0, to = 0;
    double factor = 1;  ///< length in the pattern by length in 3D
    int change = 0;     ///< parts of one change have the same number

    bool operator==(const ChangedPart&) const = default;
};

/// What the edges of a piece's outline are to measure in the pattern, where that is not what they
/// measure on the garment: two sides of a seam that are to be equally long, cloth that is eased in.
/// Methods with a free outline (`MethodTraits::keepsLengths`) pass it over.
struct OutlineTargets {
    /// mm, positive; edge i leaves vertex i of `Piece::boundary`. Empty: the lengths in 3D.
    Eigen::VectorXd lengths{};
    std::vector<ChangedPart> changed{};  ///< where and why they differ

    bool operator==(const OutlineTargets& other) const {
        return lengths.size() == other.lengths.size() && lengths == other.lengths &&
               changed == other.changed;
    }
};

/// The lengths that the outline is to have in the pattern, mm, one per edge of `piece.boundary`.
Eigen::VectorXd outlineLengths(const Piece& piece, const OutlineTargets& targets);

/// NotFinite, where a target is no positive number. Precondition: none, or one per edge.
std::optional<Error> faultOf(const Piece& piece, const OutlineTargets& targets);

/// Measures the outline as it is drawn: perimeter, crossings, the length error against 3D and the
/// one against the targets. Nothing changes where it is the polygon of its vertices with its
/// lengths in 3D. Linear, but for crossings. Pure.
void measureOutline(const Piece& piece, const FlatPiece& flat, const OutlineTargets& targets,
                    PieceQuality& quality);

}  // namespace toile
