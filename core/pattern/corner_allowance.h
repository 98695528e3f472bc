// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/wording.h"

namespace toile {

/// How the cutting line goes round a corner of the seam line. The first stretch ends there and the
/// second one starts: widths a and b, unit directions u and v along the seam line, m and n out of
/// the piece at right angles to them, t the turn from u to v. Places are relative to the corner V.
///
///     a m ────── X        X = a m + u (b - a cos t) / sin t: intersection of the cutting lines
///      │ first   │        R = u b / sin t: intersection of the first seam line, prolonged, with
///   ─u─V╌╌╌╌╌╌╌╌╌R            second cutting line
///      │ second
///      v
///
/// - Mitre: to X; if X is farther from V than kMitreLimit times the greater width, the mitre is cut
///   off there, at right angles to VX.
/// - Square: cut off at the greater width from V. Blunt.
/// - RightAngleFirst: the first allowance is prolonged to R, and ends there at right angles to its
///   seam line. RightAngleSecond: the other way round, as below.
/// - MirrorFirst: the first allowance is prolonged or cut back to end on the second cutting line
///   mirrored in the first seam line, through R and a m + u (b + a cos t) / sin t. Folded up along
///   its seam line, it then matches the piece edge to edge. For hems.
/// - Stepped: the narrower width goes round with a mitre; the wider one ends at V, at right angles
///   to its own seam line.
///
/// If b < a cos t, or a < b cos t, X lies beside a seam line and must not be cut off: mitre and
/// square become stepped. So do two widths that meet without a turn, under any rule. Right angles
/// and mirrors without width, or beyond that limit, become mitres. At a concave corner all rules
/// are alike: the allowances overlap, and their common outer line is cut.
enum class CornerRule {
    Mitre,
    Square,
    RightAngleFirst,
    RightAngleSecond,
    MirrorFirst,
    MirrorSecond,
    Stepped,
};

/// Their names in project files.
inline constexpr Word<CornerRule> kCornerRuleWords[] = {
    {CornerRule::Mitre, "mitre"},
    {CornerRule::Square, "square"},
    {CornerRule::RightAngleFirst, "right-angle-first"},
    {CornerRule::RightAngleSecond, "right-angle-second"},
    {CornerRule::MirrorFirst, "mirror-first"},
    {CornerRule::MirrorSecond, "mirror-second"},
    {CornerRule::Stepped, "stepped"}};

/// Times the greater width: a mitre is cut off at angles below 52 degrees. The ends of the cut are
/// hypot(2.29, 1) = 2.5 times that width from the corner, and no join is farther.
inline constexpr double kMitreLimit = 2.29;

/// mm: rounding may separate parts of an allowance that overlap by less.
inline constexpr double kAllowanceOverlap = 5e-5;

/// An edge of the seam line, as seen from one of its ends.
struct AllowanceSide {
    Eigen::Vector2d onward;   ///< direction away from that end, unit length
    Eigen::Vector2d outward;  ///< out of the piece, unit length
    double width = 0;         ///< mm
    double length = 0;        ///< of the edge, mm
};

/// The join of two allowances at a corner; places are relative to the corner.
struct CornerJoin {
    /// From the first cutting line to the second; through the corner if the allowances do not meet
    /// or would overlap.
    std::vector<Eigen::Vector2d> path;
    bool stepsFirst = false;   ///< the path starts with the end of the first allowance
    bool stepsSecond = false;  ///< and ends with the start of the second
    /// Parallelogram that is removed from the allowance that is cut back, as far as it belongs to
    /// edges within `reach` of the corner along the seam line.
    std::vector<Eigen::Vector2d> cut{};
    double reach = 0;
    bool cutsFirst = false;
};

/// @param limit  of mitres, times the greater width, >= 1; other rules have their own
/// Cost: constant. Pure.
CornerJoin joinAllowances(const AllowanceSide& first, const AllowanceSide& second, CornerRule rule,
                          double limit = kMitreLimit);

}  // namespace toile
