// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/check/ready_to_cut.h"
#include "tests/core/support/shapes.h"

namespace toile::test {

/// Flat squares of 2 x 2 cells, 100 mm wide, with given names, flattened exactly, laid side by side
/// with the grain stated: ready to cut. Tests spoil one thing of it.
inline CutPlan readyPlan(const std::vector<std::string>& names = {"front", "back"}) {
    CutPlan plan;
    auto garment = std::make_shared<Garment>();
    auto file = std::make_shared<SourceFile>();
    file->path = "shirt.obj";
    garment->files = {file};
    for (const std::string& name : names) {
        const auto piece = std::make_shared<Piece>(makePiece(name, planeGrid(2, 2, 50)));
        piece->id = {plan.results.size() + 1};
        auto result = std::make_shared<PieceResult>();
        result->piece = piece;
        result->flat.emplace();
        result->flat->Q = piece->mesh.V.leftCols<2>();
        PieceSettings settings;
        settings.placement = Placement{{150.0 * static_cast<double>(plan.results.size()), 0}};
        settings.grain = kGrainUpwards;
        garment->pieces.push_back(piece);
        plan.results.push_back(std::move(result));
        plan.settings.push_back(settings);
    }
    plan.garment = std::move(garment);
    plan.fabric = *fabricPreset("woven");
    return plan;
}

inline std::shared_ptr<PieceResult> copyOfResult(const CutPlan& plan, std::size_t piece) {
    return std::make_shared<PieceResult>(*plan.results[piece]);
}

inline std::vector<Finding> findingsOf(const Readiness& readiness, FindingKind kind) {
    std::vector<Finding> found;
    for (const Finding& finding : readiness.findings) {
        if (finding.kind == kind) {
            found.push_back(finding);
        }
    }
    return found;
}

}  // namespace toile::test
