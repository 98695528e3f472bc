// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include <Eigen/Geometry>

#include "core/base/tolerances.h"
#include "core/geometry/buckets.h"
#include "core/mesh/mesh_arrays.h"
#include "core/mesh/repair.h"

namespace toile {

std::vector<char> usedVertices(const Triangles& F, Eigen::Index vertexCount) {
    std::vector<char> used(vertexCount, 0);
    for (Eigen::Index corner = 0; corner < F.size(); ++corner) {
        used[F.data()[corner]] = 1;
    }
    return used;
}

bool eraseFaces(MeshPart& part, const std::vector<char>& erased) {
    if (std::ranges::find(erased, 1) == erased.end()) {
        return false;
    }
    int kept = 0;
    for (int f = 0; f < part.mesh.F.rows(); ++f) {
        if (erased[f] == 0) {
            part.mesh.F.row(kept) = part.mesh.F.row(f).eval();
            part.sourceFace[kept++] = part.sourceFace[f];
        }
    }
    part.mesh.F.conservativeResize(kept, 3);
    part.sourceFace.resize(kept);
    return true;
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

std::vector<int> doubledFaces(const Triangles& F, const EdgeTable& table, Eigen::Index edge) {
    std::vector<int> doubled;
    const auto uses = table.usesOf(edge);
    if (uses.size() < 2 || (uses.size() == 2 && apexOf(F, uses[0]) != apexOf(F, uses[1]))) {
        return doubled;  // true for most edges
    }
    std::vector<std::pair<int, int>> apexes;  // third vertex, face
    for (const int side : uses) {
        if (apexOf(F, side) > table.edges(edge, 1)) {
            apexes.emplace_back(apexOf(F, side), side / 3);
        }
    }
    std::ranges::sort(apexes);
    for (std::size_t i = 1; i < apexes.size(); ++i) {
        if (apexes[i].first == apexes[i - 1].first) {
            doubled.push_back(apexes[i].second);
        }
    }
    return doubled;
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
    std::vector<int> partOfVertex(static_cast<std::size_t>(part.mesh.V.rows()), -1);
    for (Eigen::Index corner = 0; corner < part.mesh.F.size(); ++corner) {
        partOfVertex[part.mesh.F.data()[corner]] = label[corner / 3];
    }
    std::vector<int> newIndex(partOfVertex.size(), -1);
    for (std::size_t v = 0; v < partOfVertex.size(); ++v) {
        if (partOfVertex[v] >= 0) {
            ConnectedPart& to = parts[partOfVertex[v]];
            newIndex[v] = static_cast<int>(to.vertex.size());
            to.vertex.push_back(static_cast<int>(v));
            to.part.sourceVertex.push_back(part.sourceVertex[v]);
        }
    }
    const geometry::Buckets<> faces(count, [&label](auto add) {
        for (std::size_t f = 0; f < label.size(); ++f) {
            add(label[f], static_cast<int>(f));
        }
    });
    for (int p = 0; p < count; ++p) {
        MeshPart& to = parts[p].part;
        to.mesh.V = part.mesh.V(parts[p].vertex, Eigen::all);
        to.mesh.F = part.mesh.F(faces[p], Eigen::all);
        for (int& v : cornersOf(to.mesh.F)) {
            v = newIndex[v];
        }
        for (const int f : faces[p]) {
            to.sourceFace.push_back(part.sourceFace[f]);
        }
    }
    return parts;
}

}  // namespace toile
