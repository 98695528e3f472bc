// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/mesh/mesh_arrays.h"
#include "core/project/piece_settings.h"

namespace toile {

/// A motion of the plane without reflection.
struct RigidMotion : Placement {
    /// The middle of the points that it was fitted to: what has no turn of its own follows this.
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
};

/// `geometry::fitMotion` with its middle.
RigidMotion bestMotion(const Points2& from, const Points2& to);

/// How far a point is at most from the one that it was to be brought to, mm.
double residual(const RigidMotion& motion, const Points2& from, const Points2& to);

/// Settings that were said about other flat coordinates of the same piece: the piece stays where it
/// is on the sheet, and the grain keeps its direction on the cloth. An unset grain stays
/// so. Exactly the same where nothing moves by more than `kUnmoved`.
/// @param oldOfNew  where points in the new coordinates were in the old ones
/// @param radius     mm: how far from the origin the piece reaches
PieceSettings movedSettings(PieceSettings settings, const RigidMotion& oldOfNew, double radius);

/// The same for a piece that must not be turned by the way: one whose turn is unset (its turn is
/// exactly 0) keeps that, and only its middle stays where it was. An unset grain then
/// runs exactly upwards.
PieceSettings uprightSettings(PieceSettings settings, const RigidMotion& oldOfNew, double radius);

/// Below this two places are the same, mm.
inline constexpr double kUnmoved = 1e-7;

/// Settings with anchors, for the flat piece found meanwhile: fitted to them, which then are gone.
/// Where the anchors cannot be trusted any more (vertices that are not there, or lie at distances
/// from each other that differ by more than `kAnchorDoubt`), the settings stay as they are.
/// @param Q         #V x 2, the piece's new flat coordinates
/// @param mostAway  mm: how far from its place a piece whose turn is unset may get so that it
///                  stays upright (`uprightSettings`)
/// Pure; linear in the anchors.
PieceSettings anchoredSettings(PieceSettings settings, const Points2& Q,
                               double mostAway = std::numeric_limits<double>::infinity());

/// How far the anchors are from where they were, once fitted: the change of shape, mm. None where
/// they cannot be trusted.
std::optional<double> anchorResidual(const std::vector<Anchor>& anchors, const Points2& Q);

/// By how much, as a part, anchors may have come nearer to or farther from each other: other
/// methods and other cuts give other shapes, another mesh any.
inline constexpr double kAnchorDoubt = 0.3;

/// How many times as far apart the anchors are now; none where they cannot be found in Q, or say
/// nothing (fewer than two, or all in one place).
std::optional<double> anchorGrowth(const std::vector<Anchor>& anchors, const Points2& Q);

/// The same settings for a garment that is `factor` times as large: the whole sheet grows about its
/// origin.
PieceSettings scaledSettings(PieceSettings settings, double factor);

/// Vertices spread evenly over the length of an outline, where they are now: all of a short
/// outline, else `kOutlineAnchors` at most. Deterministic; linear.
/// @param outline  of a piece, as vertex indices
std::vector<Anchor> outlineAnchors(const std::vector<int>& outline, const Points2& Q);

/// So many places tell how a piece lies as well as all do.
inline constexpr int kOutlineAnchors = 32;

}  // namespace toile
