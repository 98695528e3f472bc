// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/repair_part.h"

#include <algorithm>
#include <numeric>

#include <Eigen/Geometry>

#include "core/base/tolerances.h"
#include "core/mesh/edge_table.h"

namespace toile {

std::vector<char> usedVertices(const Triangles& F, Eigen::Index vertexCount) {
    std::vector<char> used(vertexCount, 0);
    for (Eigen::Index corner = 0; corner < F.size(); ++corner) {
        used[F.data()[corner]] = 1;
    }
    return used;
}

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
    const std::vector<char> isUsed = usedVertices(part.mesh.F, before);
    std::vector<int> newIndex(before, -1);
    int kept = 0;
    for (int v = 0; v < before; ++v) {
        if (isUsed[v] != 0) {
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

namespace {

/// Vertex of each part by vertex of the whole, and the vertices of each part in their order.
std::vector<int> distributeVertices(const MeshPart& whole, const std::vector<int>& partOfFace,
                                    std::vector<ConnectedPart>& parts) {
    std::vector<int> partOfVertex(static_cast<std::size_t>(whole.mesh.V.rows()), -1);
    for (int f = 0; f < whole.mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            partOfVertex[whole.mesh.F(f, k)] = partOfFace[f];
        }
    }
    std::vector<int> newIndex(partOfVertex.size(), -1);
    for (std::size_t v = 0; v < partOfVertex.size(); ++v) {
        if (partOfVertex[v] >= 0) {
            ConnectedPart& to = parts[partOfVertex[v]];
            newIndex[v] = static_cast<int>(to.vertex.size());
            to.vertex.push_back(static_cast<int>(v));
            to.part.sourceVertex.push_back(whole.sourceVertex[v]);
        }
    }
    for (ConnectedPart& to : parts) {
        to.part.mesh.V = whole.mesh.V(to.vertex, Eigen::all);
    }
    return newIndex;
}

}  // namespace

std::vector<ConnectedPart> connectedParts(MeshPart part) {
    const std::vector<int> label =
        faceComponents(part.mesh.F, static_cast<int>(part.mesh.V.rows()));
    const int count = label.empty() ? 0 : 1 + *std::max_element(label.begin(), label.end());
    std::vector<ConnectedPart> parts(count);
    if (count == 1) {
        parts[0].vertex.resize(static_cast<std::size_t>(part.mesh.V.rows()));
        std::iota(parts[0].vertex.begin(), parts[0].vertex.end(), 0);
        parts[0].part = std::move(part);
        return parts;
    }
    const std::vector<int> newIndex = distributeVertices(part, label, parts);
    std::vector<int> faces(count, 0);
    for (const int p : label) {
        ++faces[p];
    }
    for (int p = 0; p < count; ++p) {
        parts[p].part.mesh.F.resize(faces[p], 3);
    }
    for (int f = 0; f < part.mesh.F.rows(); ++f) {
        MeshPart& to = parts[label[f]].part;
        const auto row = static_cast<Eigen::Index>(to.sourceFace.size());
        for (int k = 0; k < 3; ++k) {
            to.mesh.F(row, k) = newIndex[part.mesh.F(f, k)];
        }
        to.sourceFace.push_back(part.sourceFace[f]);
    }
    return parts;
}

}  // namespace toile
