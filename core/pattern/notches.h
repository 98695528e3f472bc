// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/line_settings.h"
#include "core/pattern/segments.h"
#include "core/symmetry/symmetry.h"

namespace toile {

/// A point marked on both sides of a seam, to be aligned when sewing.
struct Notch {
    int seam = -1;     ///< index into the graph
    double share = 0;  ///< along the seam (`shareOf`)
    SeamMatch at{};    ///< arc lengths in 3D on both outlines, mm, as in SeamSide
    SeamMatch flat{};  ///< lengths along the drawn outlines, from their first points, mm
    /// 2 if the seam lies towards the back of the garment, else 1; 1 at the end of a seam.
    int count = 1;
    NotchReason reason = NotchReason::Balance;
    /// False if a corner or a notch of another seam marks the place on that side.
    bool onLeft = true, onRight = true;
};

/// Minimum distance along the lines in 3D between a notch and another notch or an end of its seam,
/// and between a notch at an end and a corner, mm. Notches placed by the user are exempt.
inline constexpr double kNotchGap = 15;
/// Minimum seam lengths for a notch in the middle, and for notches at the quarters, mm.
inline constexpr double kHalvedSeam = 150, kQuarteredSeam = 300;

/// The notches of every sewn seam whose sides are both flat.
/// - At the end of a seam if the outline of one of its pieces continues there without a corner.
/// - At the start and end of drawn ease.
/// - In the middle of seams, or at their quarters. If seams of a piece have similar lengths and
///   would have the same notches, read either way, the later ones in the order of the graph get
///   other notches, as far as possible. Darts and folds cannot be confused, nor can seams that
///   mirror each other.
/// - From the user's settings. A notch placed by the user displaces others nearer than kNotchGap.
/// Seams that mirror each other have notches at the same shares, and settings of one apply to both.
/// A stacked seam has only notches placed by the user.
/// @param results   one per piece, as drawn  @param segments  of exact results (`findSegments`)
/// @param symmetry  null: nothing is mirrored
/// @return per seam of the graph, from its start to its end
/// Cost: linear in the outlines, quadratic in the seams of a piece.  Pure.
std::vector<std::vector<Notch>> findNotches(const Garment& garment, const PieceResults& results,
                                            const std::vector<OutlineSegments>& segments,
                                            const NotchRules& rules,
                                            const Symmetry* symmetry = nullptr);

/// Settings that store a notch placed by the user: its place on the seam's line.
/// @param share  along the seam  @return nothing if neither side's line is known
/// Cost: linear in the outlines of the garment. Pure.
std::optional<NotchSettings> notchSettingsAt(const Garment& garment, int seam, double share);

}  // namespace toile
