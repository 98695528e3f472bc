// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/toile/solve_advice.h"

#include <algorithm>
#include <utility>

#include "core/assemble/cut_pieces.h"
#include "core/flatten/flatten.h"
#include "core/mesh/cotangents.h"
#include "core/quality/piece_quality.h"

namespace toile {

Result<StrainFigures> solvedStrain(const std::shared_ptr<const Piece>& piece,
                                   const std::vector<UserCut>& own, const CutAdvice& advice,
                                   std::size_t count, const FlattenOptions& options,
                                   Progress& progress) {
    std::vector<UserCut> cuts = own;
    for (std::size_t k = 0; k < std::min(count, advice.cuts.size()); ++k) {
        cuts.push_back(advice.cuts[k].what.cut);
        cuts.back().id = {};
    }
    const CutPieces made = cutPieces({piece}, cuts, true, Progress(progress, 0.3));
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    std::vector<std::pair<double, double>> strains;
    for (const auto& part : made.pieces) {
        const auto flat = flatten(
            *part, options, Progress(progress, 0.7 / static_cast<double>(made.pieces.size())));
        if (!flat) {
            return flat.error();
        }
        const Eigen::VectorXd ofEdges = distortionFields(*part, flat->Q).edgeStrain;
        for (int f = 0; f < part->mesh.F.rows(); ++f) {
            const double third = cornerProducts(part->mesh, f).doubledArea / 6;
            for (int k = 0; k < 3; ++k) {
                strains.emplace_back(ofEdges[part->table.faceEdges(f, k)], third);
            }
        }
    }
    return strainFigures(std::move(strains));
}

}  // namespace toile
