// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/repair_part.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "core/base/tolerances.h"

namespace toile {

void eraseFaces(MeshPart& part, const std::vector<char>& erased) {
    int kept = 0;
    for (int f = 0; f < part.mesh.F.rows(); ++f) {
        if (erased[f] == 0) {
            part.mesh.F.row(kept) = part.mesh.F.row(f).eval();
            part.sourceFace[kept++] = part.sourceFace[f];
        }
    }
    part.mesh.F.conservativeResize(kept, 3);
    part.sourceFace.resize(kept);
}

int eraseUnusedVertices(MeshPart& part) {
    const int before = static_cast<int>(part.mesh.V.rows());
    std::vector<int> newIndex(before, -1);
    for (const int v : cornersOf(part.mesh.F)) {
        newIndex[v] = 0;
    }
    int kept = 0;
    for (int v = 0; v < before; ++v) {
        if (newIndex[v] == 0) {
            part.mesh.V.row(kept) = part.mesh.V.row(v).eval();
            part.sourceVertex[kept] = part.sourceVertex[v];
            newIndex[v] = kept++;
        }
    }
    if (kept < before) {
        part.mesh.V.conservativeResize(kept, 3);
        part.sourceVertex.resize(kept);
        for (int& v : cornersOf(part.mesh.F)) {
            v = newIndex[v];
        }
    }
    return before - kept;
}

void appendCopies(MeshPart& part, const std::vector<int>& originals) {
    const auto first = part.mesh.V.rows();
    const auto added = static_cast<Eigen::Index>(originals.size());
    part.mesh.V.conservativeResize(first + added, 3);
    part.sourceVertex.reserve(part.sourceVertex.size() + originals.size());
    for (Eigen::Index i = 0; i < added; ++i) {
        part.mesh.V.row(first + i) = part.mesh.V.row(originals[i]).eval();
        part.sourceVertex.push_back(part.sourceVertex[originals[i]]);
    }
}

FaceShape shapeOf(const MeshArrays& mesh, int face) {
    const Eigen::RowVector3d a = mesh.V.row(mesh.F(face, 0));
    const Eigen::RowVector3d b = mesh.V.row(mesh.F(face, 1));
    const Eigen::RowVector3d c = mesh.V.row(mesh.F(face, 2));
    const double length[3] = {(b - a).norm(), (c - b).norm(), (a - c).norm()};
    FaceShape shape;
    shape.longestSide = static_cast<int>(std::max_element(length, length + 3) - length);
    shape.longest = length[shape.longestSide];
    shape.shortest = *std::min_element(length, length + 3);
    const double doubleArea = (b - a).cross(c - a).norm();
    shape.flat = !(doubleArea > kDegenerateHeight * shape.longest * shape.longest);
    return shape;
}

}  // namespace toile
