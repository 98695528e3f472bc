// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/reference_lines.h"

#include "app/document/reference.h"
#include "core/formats/tables/pattern_match.h"

namespace toile::app {

ReferenceLines referenceLines(const PatternMatch& match) {
    ReferenceLines lines;
    for (const PieceMatch& pair : match.pairs) {
        if (!isSure(pair)) {
            continue;
        }
        const Points2& laid = pair.lines.front().fit.laid;
        const auto first = static_cast<std::uint32_t>(lines.vertices.size());
        double along = 0;
        for (Eigen::Index k = 0; k <= laid.rows(); ++k) {
            const Eigen::RowVector2d point = laid.row(k % laid.rows());
            along += k > 0 ? (point - laid.row(k - 1)).norm() : 0;
            LineVertex& vertex = lines.vertices.emplace_back();
            Eigen::Map<Eigen::RowVector2f>(vertex.flat) = point.cast<float>();
            vertex.piece = static_cast<float>(pair.piece);
            vertex.along = static_cast<float>(along);
            vertex.tint = kNoTint;
        }
        lines.runs.reference.push_back(
            {first, static_cast<std::uint32_t>(lines.vertices.size()) - first});
    }
    return lines;
}

}  // namespace toile::app
