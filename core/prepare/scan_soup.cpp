// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/prepare/scan_soup.h"

#include <algorithm>

namespace toile {
namespace {

/// The UV of a face of the file at a position, or at another one in the same place, since they were
/// welded; -1 if it has none.
int uvAt(const PolygonSoup& file, int face, int position) {
    for (int corner = file.faceStart[face]; corner < file.faceStart[face + 1]; ++corner) {
        if (file.corners[corner] == position ||
            file.positions[static_cast<std::size_t>(file.corners[corner])] ==
                file.positions[static_cast<std::size_t>(position)]) {
            return file.cornerUvs[corner];
        }
    }
    return -1;
}

void nameFaces(const std::vector<int>& sourceFace, const std::vector<int>& before,
               std::vector<int>& names) {
    if (before.empty()) {
        return;
    }
    for (const int face : sourceFace) {
        names.push_back(face < 0 ? -1 : before[face]);
    }
}

}  // namespace

PolygonSoup soupOf(const MeshPart& part, const PolygonSoup& file, double millimetres,
                   bool keepsUvs) {
    PolygonSoup soup;
    soup.contentHash = file.contentHash;
    soup.statedUnit = file.statedUnit;
    soup.problems = file.problems;
    for (int v = 0; v < part.mesh.V.rows(); ++v) {
        const Eigen::Vector3d here = part.mesh.V.row(v).transpose();
        const int source = part.sourceVertex[v];
        const bool stays =
            source >= 0 && here == millimetres * file.positions[static_cast<std::size_t>(source)];
        soup.positions.push_back(stays ? file.positions[static_cast<std::size_t>(source)]
                                       : Eigen::Vector3d(here / millimetres));
    }
    soup.corners.assign(part.mesh.F.data(), part.mesh.F.data() + part.mesh.F.size());
    for (int f = 0; f < part.mesh.F.rows(); ++f) {
        soup.faceStart.push_back(3 * (f + 1));
    }
    if (std::ranges::any_of(part.sourceFace, [](int face) { return face >= 0; })) {
        nameFaces(part.sourceFace, file.faceObject, soup.faceObject);
        nameFaces(part.sourceFace, file.faceGroup, soup.faceGroup);
        nameFaces(part.sourceFace, file.faceMaterial, soup.faceMaterial);
        soup.objects = file.objects;
        soup.groups = file.groups;
        soup.materials = file.materials;
    }
    if (keepsUvs && !file.cornerUvs.empty()) {
        soup.uvs = file.uvs;
        for (int f = 0; f < part.mesh.F.rows(); ++f) {
            for (int k = 0; k < 3; ++k) {
                const int source = part.sourceVertex[part.mesh.F(f, k)];
                const int face = part.sourceFace[f];
                soup.cornerUvs.push_back(source < 0 || face < 0 ? -1 : uvAt(file, face, source));
            }
        }
    }
    return soup;
}

}  // namespace toile
