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

/// Why the length of a stretch of an outline differs between pattern and 3D: it equals its mirror
/// image, its length was set, its ease is drawn, or `improvePattern` has changed it.
enum class LengthCause { Mirroring, Length, Ease, Improving };

/// A part of an outline with a changed length: arc lengths in 3D, mm, from <= to. Parts of an
/// outline do not overlap.
struct ChangedPart {
    LengthCause cause = LengthCause::Mirroring;
    double from = 0, to = 0;
    double factor = 1;  ///< length in the pattern divided by length in 3D
    int change = 0;     ///< parts of the same change have the same number

    bool operator==(const ChangedPart&) const = default;
};

/// Target lengths of the edges of a piece's outline, if they differ from those on the garment: for
/// two sides of a seam that should be equally long, or for eased cloth. Methods with a free outline
/// (`MethodTraits::keepsLengths`) ignore them.
struct OutlineTargets {
    /// mm, positive; edge i leaves vertex i of `Piece::boundary`. Empty: the lengths in 3D.
    Eigen::VectorXd lengths{};
    std::vector<ChangedPart> changed{};  ///< where and why they differ

    bool operator==(const OutlineTargets& other) const {
        return lengths.size() == other.lengths.size() && lengths == other.lengths &&
               changed == other.changed;
    }
};

/// The target lengths of the outline in the pattern, mm, one per edge of `piece.boundary`.
Eigen::VectorXd outlineLengths(const Piece& piece, const OutlineTargets& targets);

/// NotFinite if a target is no positive number. Precondition: none, or one per edge.
std::optional<Error> faultOf(const Piece& piece, const OutlineTargets& targets);

/// Measures the drawn outline: perimeter, crossings, and the length errors against 3D and against
/// the targets. Changes nothing if it is the polygon of its vertices with its lengths in 3D.
/// Linear, except for crossings. Pure.
void measureOutline(const Piece& piece, const FlatPiece& flat, const OutlineTargets& targets,
                    PieceQuality& quality);

}  // namespace toile
