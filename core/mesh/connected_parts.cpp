// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include "core/mesh/edge_table.h"
#include "core/mesh/repair_part.h"

namespace toile {
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
