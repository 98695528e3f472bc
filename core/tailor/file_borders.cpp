// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tailor/file_borders.h"

#include "core/assemble/corner_uv.h"

namespace toile {
namespace {

/// Largest share of borders among the edges inside a piece. More are no seams.
constexpr double kMaxFileBorders = 0.2;

bool differs(const std::vector<int>& ofFace, int f, int g) {
    return !ofFace.empty() &&
           ofFace[static_cast<std::size_t>(f)] != ofFace[static_cast<std::size_t>(g)];
}

}  // namespace

std::vector<char> fileBorders(const Piece& piece, const PolygonSoup& soup) {
    const Edges& edges = piece.table.edges;
    std::vector<char> isBorder(static_cast<std::size_t>(edges.rows()), 0);
    CornerUvs uvs(soup);
    Eigen::Index inner = 0, borders = 0;
    for (Eigen::Index e = 0; e < edges.rows(); ++e) {
        const auto uses = piece.table.usesOf(e);
        if (uses.size() != 2) {
            continue;
        }
        ++inner;
        const int f = piece.sourceFace[static_cast<std::size_t>(uses[0] / 3)];
        const int g = piece.sourceFace[static_cast<std::size_t>(uses[1] / 3)];
        bool isOther = f != g && f >= 0 && g >= 0 &&
                       (differs(soup.faceMaterial, f, g) || differs(soup.faceGroup, f, g) ||
                        differs(soup.faceObject, f, g));
        for (int k = 0; k < 2 && !isOther && f != g && f >= 0 && g >= 0; ++k) {
            const int position = piece.sourceVertex[static_cast<std::size_t>(edges(e, k))];
            isOther = position >= 0 && uvs.at(f, position) != uvs.at(g, position);
        }
        isBorder[static_cast<std::size_t>(e)] = isOther ? 1 : 0;
        borders += isOther ? 1 : 0;
    }
    return borders > 0 &&
                   static_cast<double>(borders) < kMaxFileBorders * static_cast<double>(inner)
               ? isBorder
               : std::vector<char>{};
}

}  // namespace toile
