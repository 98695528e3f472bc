// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/cut_advice.h"

#include <algorithm>
#include <utility>

namespace toile {
namespace {

/// From here on a line of the mesh is named as the reason for a cut.
constexpr double kSeamLikely = 0.6;

}  // namespace

CutAdvice adviseCuts(const std::shared_ptr<const Piece>& piece, const std::vector<UserCut>&,
                     const AdviceOptions&, const Progress& progress) {
    CutAdvice advice;
    for (TailorCut& cut : tailorCuts(piece, progress)) {
        AdvisedCut& made = advice.cuts.emplace_back();
        made.evidence = cut.likeliness > kSeamLikely
                            ? worded("the mesh has a line there that looks like a seam (%1)",
                                     {figure(cut.likeliness, 2)})
                            : worded("by the form");
        for (std::size_t k = 1; k < cut.cut.points.size(); ++k) {
            made.length += (cut.cut.points[k] - cut.cut.points[k - 1]).norm();
        }
        made.what = std::move(cut);
    }
    return advice;
}

}  // namespace toile
