// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/file_surface.h"

#include <algorithm>
#include <utility>

#include "core/io/triangulate.h"
#include "core/mesh/repair.h"
#include "core/mesh/weld.h"

namespace toile {

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
