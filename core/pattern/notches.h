// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/pattern/notch_settings.h"
#include "core/pattern/segments.h"
#include "core/symmetry/symmetry.h"

namespace toile {

/// A point of a seam that both its sides mark, to be laid on each other when sewing.
struct Notch {
    int seam = -1;     ///< index into the graph
    double share = 0;  ///< along the seam (`shareOf`)
    SeamMatch at{};    ///< arc lengths in 3D on either outline, mm, as SeamSide has them
    SeamMatch flat{};  ///< lengths along the outlines as drawn, from their first points, mm
    /// 2 where the seam lies towards the back of the garment, else 1; at the end of a seam 1.
    int count = 1;
    NotchReason reason = NotchReason::Balance;
    /// False where a corner marks the place on that side, or a notch of another seam.
    bool onLeft = true, onRight = true;
};

/// Along the lines in 3D no notch is nearer than this to another or to an end of its seam, and none
/// at an end to a corner, but those a person has placed, mm.
inline constexpr double kNotchGap = 15;
/// From these lengths on a seam has a notch in its middle, and at its quarters, mm.
inline constexpr double kHalvedSeam = 150, kQuarteredSeam = 300;

/// The notches of every sewn seam whose sides are both flat.
/// - Where a seam ends and the outline of one of its pieces runs on without a corner.
/// - Where drawn ease starts and ends.
/// - In the middle of seams, or at their quarters. Seams of one piece that are about as long as
///   each other and would have the same notches, read either way, get others, as far as there are
///   some: in the order of the graph. Darts and folds cannot be mistaken, nor can seams that mirror
///   each other.
/// - As a person has said. What is placed by hand displaces others nearer than kNotchGap.
/// Seams that mirror each other have notches at the same shares, and what is said of one of them
/// holds for both. A stacked seam has only those placed by hand.
/// @param results   one per piece, as drawn  @param segments  of the exact ones (`findSegments`)
/// @param symmetry  null: nothing is mirrored
/// @return per seam of the graph, from its start to its end
/// Cost: linear in the outlines, and the seams of a piece times each other.  Pure.
std::vector<std::vector<Notch>> findNotches(const Garment& garment, const PieceResults& results,
                                            const std::vector<OutlineSegments>& segments,
                                            const NotchRules& rules,
                                            const Symmetry* symmetry = nullptr);

/// What is to be kept of a notch that a person places: where on the seam's line it is.
/// @param share  along the seam  @return none where neither side's line is known
/// Cost: linear in the outlines of the garment. Pure.
std::optional<NotchSettings> notchSettingsAt(const Garment& garment, int seam, double share);

}  // namespace toile
