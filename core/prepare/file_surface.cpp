// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/file_surface.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "core/io/triangulate.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/repair.h"
#include "core/mesh/weld.h"

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

FileSurface surfaceOf(const PolygonSoup& soup, double millimetres) {
    Triangulation triangles = triangulate(soup, {});
    Points3 V(std::ssize(soup.positions), 3);
    for (Eigen::Index v = 0; v < V.rows(); ++v) {
        const Eigen::Vector3d& position = soup.positions[static_cast<std::size_t>(v)];
        V.row(v) = position.allFinite() ? Eigen::Vector3d(millimetres * position)
                                        : Eigen::Vector3d(0, 0, 0);
    }
    return {{std::move(V), std::move(triangles.F)}, std::move(triangles.sourceFace)};
}

Triangles weldedFaces(const MeshArrays& mesh) {
    const Weld weld = findWeld(mesh.F, mesh.V, {});
    Triangles F = mesh.F;
    for (int& v : cornersOf(F)) {
        v = weld.target[v];
    }
    return F;
}

PolygonSoup withFaces(const PolygonSoup& soup, const std::vector<int>& faces) {
    PolygonSoup kept = soup;
    kept.faceStart = {0};
    kept.corners.clear();
    kept.cornerUvs.clear();
    const auto keep = [&faces](std::vector<int>& perFace, const std::vector<int>& before) {
        if (!before.empty()) {
            perFace.clear();
            for (const int face : faces) {
                perFace.push_back(before[face]);
            }
        }
    };
    keep(kept.faceObject, soup.faceObject);
    keep(kept.faceGroup, soup.faceGroup);
    keep(kept.faceMaterial, soup.faceMaterial);
    for (const int face : faces) {
        for (int corner = soup.faceStart[face]; corner < soup.faceStart[face + 1]; ++corner) {
            kept.corners.push_back(soup.corners[corner]);
            if (!soup.cornerUvs.empty()) {
                kept.cornerUvs.push_back(soup.cornerUvs[corner]);
            }
        }
        kept.faceStart.push_back(static_cast<int>(kept.corners.size()));
    }
    return kept;
}

PolygonSoup turnedOver(PolygonSoup soup) {
    for (int face = 0; face < soup.faceCount(); ++face) {
        const auto from = soup.faceStart[face], to = soup.faceStart[face + 1];
        std::reverse(soup.corners.begin() + from, soup.corners.begin() + to);
        if (!soup.cornerUvs.empty()) {
            std::reverse(soup.cornerUvs.begin() + from, soup.cornerUvs.begin() + to);
        }
    }
    return soup;
}

}  // namespace toile
