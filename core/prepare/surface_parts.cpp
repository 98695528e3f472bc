// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/surface_parts.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "core/mesh/edge_table.h"

namespace toile {

FileSurface withoutDoubles(const FileSurface& file) {
    std::vector<std::pair<std::array<int, 3>, int>> corners;
    for (int f = 0; f < file.mesh.F.rows(); ++f) {
        std::array<int, 3> own{file.mesh.F(f, 0), file.mesh.F(f, 1), file.mesh.F(f, 2)};
        std::ranges::sort(own);
        corners.emplace_back(own, f);
    }
    std::ranges::sort(corners);
    std::vector<int> kept;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        if (k == 0 || corners[k].first != corners[k - 1].first) {
            kept.push_back(corners[k].second);
        }
    }
    std::ranges::sort(kept);
    FileSurface single{{file.mesh.V, file.mesh.F(kept, Eigen::all)}, {}};
    for (const int f : kept) {
        single.face.push_back(file.face[f]);
    }
    return single;
}

double SurfaceParts::closedShare() const {
    double closed = 0;
    for (std::size_t p = 0; p < area.size(); ++p) {
        closed += isClosed[p] ? area[p] : 0;
    }
    return total > 0 ? closed / total : 0;
}

SurfaceParts partsOf(const MeshArrays& mesh) {
    const auto vertices = static_cast<int>(mesh.V.rows());
    SurfaceParts parts{faceComponents(mesh.F, vertices)};
    const int count = parts.of.empty() ? 0 : *std::ranges::max_element(parts.of) + 1;
    parts.area.assign(static_cast<std::size_t>(count), 0);
    parts.isClosed.assign(static_cast<std::size_t>(count), 1);
    for (int f = 0; f < mesh.F.rows(); ++f) {
        parts.area[parts.of[f]] += doubleAreaNormal(mesh, f).norm() / 2;
    }
    const EdgeTable table = buildEdgeTable(mesh.F, vertices);
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        if (table.isBorder(e)) {
            parts.isClosed[parts.of[table.usesOf(e).front() / 3]] = 0;
        }
    }
    parts.total = std::accumulate(parts.area.begin(), parts.area.end(), 0.0);
    return parts;
}

}  // namespace toile
