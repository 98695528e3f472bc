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
    /// Mean of the fitted points; a piece without a turn of its own follows it.
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
};

/// `geometry::fitMotion` with its middle.
RigidMotion bestMotion(const Points2& from, const Points2& to);

/// Largest distance of a moved point from its target, mm.
double residual(const RigidMotion& motion, const Points2& from, const Points2& to);

/// Transfers settings to new flat coordinates of the same piece: the piece stays where it is on the
/// sheet, and the grain keeps its direction on the cloth. An unset grain stays unset. Unchanged to
/// the last bit if nothing moves by more than `kUnmoved`.
/// @param oldOfNew  maps new coordinates to old ones
/// @param radius    mm: largest distance of the piece from the origin
PieceSettings movedSettings(PieceSettings settings, const RigidMotion& oldOfNew, double radius);

/// The same for a piece that must not turn: one whose turn is unset (exactly 0) keeps it, and only
/// its middle stays in place. An unset grain then runs exactly upwards.
PieceSettings uprightSettings(PieceSettings settings, const RigidMotion& oldOfNew, double radius);

/// Places nearer to each other than this are the same, mm.
inline constexpr double kUnmoved = 1e-7;

/// Fits settings to their anchors in the new flat piece and clears the anchors. If the anchors
/// cannot be trusted (missing vertices, or a spread that differs by more than `kAnchorDoubt`), the
/// settings stay unchanged.
/// @param Q         #V x 2, the piece's new flat coordinates
/// @param mostAway  mm: a piece whose turn is unset stays upright (`uprightSettings`) if that
///                  moves it by no more than this
/// Pure; linear in the anchors.
PieceSettings anchoredSettings(PieceSettings settings, const Points2& Q,
                               double mostAway = std::numeric_limits<double>::infinity());

/// Residual of the anchors after the fit, which is the change of shape, mm. Empty if they cannot be
/// trusted.
std::optional<double> anchorResidual(const std::vector<Anchor>& anchors, const Points2& Q);

/// Largest relative change of the anchors' spread: other methods and cuts change the shape, and
/// another mesh may give any spread.
inline constexpr double kAnchorDoubt = 0.3;

/// Growth factor of the anchors' spread; empty if they are not in Q or too few (fewer than two, or
/// all in one place).
std::optional<double> anchorGrowth(const std::vector<Anchor>& anchors, const Points2& Q);

/// The settings for a garment scaled by `factor`: the whole sheet grows about its origin.
PieceSettings scaledSettings(PieceSettings settings, double factor);

/// Vertices spread evenly over the length of an outline, with their present positions: all of a
/// short outline, else `kOutlineAnchors` at most. Deterministic; linear.
/// @param outline  of a piece, as vertex indices
std::vector<Anchor> outlineAnchors(const std::vector<int>& outline, const Points2& Q);

/// So many places determine the position of a piece as well as all would.
inline constexpr int kOutlineAnchors = 32;

}  // namespace toile
