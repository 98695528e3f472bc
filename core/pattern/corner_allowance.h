// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/words.h"

namespace toile {

/// How the cutting line goes round a corner of the seam line. The stretch that ends there is the
/// first, the one that begins there the second: widths a and b, unit directions u and v along the
/// seam line, m and n out of the piece at right angles to them, t the turn from u to v. Places are
/// from the corner V on.
///
///     a m ────── X        X = a m + u (b - a cos t) / sin t: where both cutting lines meet
///      │ first   │        R = u b / sin t: where the first seam line, prolonged, meets the
///   ─u─V╌╌╌╌╌╌╌╌╌R            second cutting line
///      │ second
///      v
///
/// - Mitre: to X; one farther from V than kMitreLimit times the greater width is cut off there,
///   at right angles to VX.
/// - Square: cut off as soon as that, the greater width from V. Blunt.
/// - RightAngleFirst: the first one's allowance is prolonged to R, and ends there at right angles
///   to its seam line. RightAngleSecond: the other way round, as below.
/// - MirrorFirst: it is prolonged or cut back to end in the line that is the second cutting line
///   mirrored in the first seam line, through R and a m + u (b + a cos t) / sin t: folded up along
///   its seam line, the first allowance lies on the piece edge to edge. For hems.
/// - Stepped: the narrower width goes round with a mitre; the wider one ends at right angles to its
///   own seam line, in V.
///
/// Where b < a cos t, or a < b cos t, X lies beside a seam line, where nothing is to be cut off:
/// mitre and square are stepped. So are two widths that meet without a turn, whatever the rule.
/// Right angles and mirrors of no width, or that would reach farther than the limit, are mitres. At
/// a concave corner all are alike: the allowances overlap, and the outer line of both is cut.
enum class CornerRule {
    Mitre,
    Square,
    RightAngleFirst,
    RightAngleSecond,
    MirrorFirst,
    MirrorSecond,
    Stepped,
};

/// What they are called in project files.
inline constexpr Word<CornerRule> kCornerRuleWords[] = {
    {CornerRule::Mitre, "mitre"},
    {CornerRule::Square, "square"},
    {CornerRule::RightAngleFirst, "right-angle-first"},
    {CornerRule::RightAngleSecond, "right-angle-second"},
    {CornerRule::MirrorFirst, "mirror-first"},
    {CornerRule::MirrorSecond, "mirror-second"},
    {CornerRule::Stepped, "stepped"}};

/// Times the greater width: a mitre is cut off below an angle of 39 degrees.
inline constexpr double kMitreLimit = 3;

/// mm: parts of an allowance that lie on each other by less may be parted by rounding.
inline constexpr double kAllowanceOverlap = 5e-5;

/// An edge of the seam line, as seen from one of its ends.
struct AllowanceSide {
    Eigen::Vector2d onward;   ///< the way on beyond that end, of length 1
    Eigen::Vector2d outward;  ///< out of the piece, of length 1
    double width = 0;         ///< mm
    double length = 0;        ///< of the edge, mm
};

/// How two allowances meet at a corner; places as seen from it.
struct CornerJoin {
    /// From the first cutting line to the second, by way of the corner where the allowances do not
    /// meet or would lie on each other.
    std::vector<Eigen::Vector2d> path;
    bool stepsFirst = false;   ///< the path begins with the end of the first allowance
    bool stepsSecond = false;  ///< and ends with the beginning of the second
    /// Of the allowance that is cut back, what lies in this parallelogram goes, as far as it
    /// belongs to edges within `reach` of the corner along the seam line.
    std::vector<Eigen::Vector2d> cut{};
    double reach = 0;
    bool cutsFirst = false;
};

/// @param limit  of mitres, times the greater width, >= 1; other rules have their own
/// Cost: constant. Pure.
CornerJoin joinAllowances(const AllowanceSide& first, const AllowanceSide& second, CornerRule rule,
                          double limit = kMitreLimit);

}  // namespace toile
