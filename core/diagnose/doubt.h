// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/diagnose/finding.h"
#include "core/flatten/base/piece_result.h"
#include "core/garment/fabric.h"
#include "core/garment/garment.h"

namespace toile {

/// No cloth takes this strain. A smaller share of a piece's area than this is single triangles.
inline constexpr double kStrainBeyondCloth = 0.25, kStrainBeyondClothShare = 0.02;
/// The pattern is useless if the mean strain is above this, or if kStrainBeyondCloth is exceeded on
/// this share of the area, unless the chosen fabric stretches more. Both weighted by area.
inline constexpr double kMeanStrainFault = 0.06, kStrainFaultArea = 0.05;
/// Moving a crossing outline apart may raise the largest edge strain by this much; more is
/// compression, which needs a cut.
inline constexpr double kApartStrain = 0.1;
/// More scraps than this, each smaller than this area of worn cloth in mm2, are debris.
inline constexpr int kManyScraps = 20;
inline constexpr double kScrapArea = 100;
/// Longest cuts found by Toile itself, relative to all rims of a piece together.
inline constexpr double kLongCuts = 1;

/// Reasons to doubt a pattern although all pieces became flat, and faults (`Severity`) by which
/// cloth would be wasted: UpAxisInDoubt, InsideOut, StrainBeyondCloth, ManyScraps and LongCuts,
/// with the text in `Finding::reason`. Ignores pieces that are left out, and cuts by the user. A
/// closed piece has no rim to compare cuts with.
/// @param results  one per piece of the garment; null or of another shape: strain is not checked
/// @param fabrics  one per piece, as chosen; empty if no fabric is chosen
/// Cost: n log n in the triangles. Pure, thread-safe.
std::vector<Finding> findDoubts(const Garment& garment, const PieceResults& results,
                                const std::vector<Fabric>& fabrics = {});

/// Whether cloth would be wasted: a piece that is not flat, crosses itself or has flipped
/// triangles, a cut or a join that could not be made, or a doubt that is a fault. The rule for exit
/// status 1 (docs/report.md). @param doubts  of the same garment and results
bool hasFaults(const Garment& garment, const PieceResults& results,
               const std::vector<Finding>& doubts);

}  // namespace toile
