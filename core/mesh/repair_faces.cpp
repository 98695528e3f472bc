// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "core/base/tolerances.h"
#include "core/geometry/disjoint_sets.h"
#include "core/mesh/repair_steps.h"

namespace toile {
namespace {

/// An edge of a face without height, in parts of its longest, that has no length either. Such
/// needles given to their neighbours would only be passed around where these are as thin.
constexpr double kFlatNeedle = 1e-8;

bool repeatsCorner(const Triangles& F, int f) {
    return F(f, 0) == F(f, 1) || F(f, 1) == F(f, 2) || F(f, 2) == F(f, 0);
}

/// One round over all faces; false where no edge was without length.
bool collapseRound(MeshPart& part, RepairNotes& notes) {
    MeshArrays& mesh = part.mesh;
    bool any = false;
    DisjointSets same(static_cast<int>(mesh.V.rows()));
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const FaceShape shape = shapeOf(mesh, f);
        const double none = (shape.flat ? kFlatNeedle : kDegenerateHeight) * shape.longest;
        if (shape.shortest > none) {
            continue;
        }
        for (int k = 0; k < 3; ++k) {
            const int a = mesh.F(f, k);
            const int b = mesh.F(f, (k + 1) % 3);
            if ((mesh.V.row(b) - mesh.V.row(a)).norm() <= none && same.root(a) != same.root(b)) {
                same.join(a, b);
                notes.add(ErrorCode::EdgesCollapsed, "edge", translatable("collapsed"),
                          mesh.V.row(a));
                any = true;
            }
        }
    }
    if (any) {
        for (int& v : cornersOf(mesh.F)) {
            v = same.root(v);
        }
        std::vector<char> erased(mesh.F.rows(), 0);
        for (int f = 0; f < mesh.F.rows(); ++f) {
            erased[f] = repeatsCorner(mesh.F, f) ? 1 : 0;
        }
        eraseFaces(part, erased);
    }
    return any;
}

}  // namespace

void dropUnusableFaces(MeshPart& part, RepairNotes& notes) {
    const MeshArrays& mesh = part.mesh;
    std::vector<char> erased(mesh.F.rows(), 0);
    bool any = false;
    for (int f = 0; f < mesh.F.rows(); ++f) {
        const auto place = mesh.V.row(mesh.F(f, 0));
        if (!place.allFinite() || !mesh.V.row(mesh.F(f, 1)).allFinite() ||
            !mesh.V.row(mesh.F(f, 2)).allFinite()) {
            notes.add(ErrorCode::NonFinitePosition, "face", translatable("left out"), place);
        } else if (repeatsCorner(mesh.F, f)) {
            notes.add(ErrorCode::DegenerateFaceRecord, "face", translatable("left out"), place);
        } else {
            continue;
        }
        erased[f] = 1;
        any = true;
    }
    if (any) {
        eraseFaces(part, erased);
    }
}

void collapseNeedles(MeshPart& part, RepairNotes& notes) {
    // A collapse over a tiny length moves a corner and may leave a neighbour without length, but
    // each time by eight digits less: the rounds are few.
    while (collapseRound(part, notes)) {
    }
}

EdgeTable dropDuplicates(MeshPart& part, RepairNotes& notes) {
    const Triangles& F = part.mesh.F;
    const int vertexCount = static_cast<int>(part.mesh.V.rows());
    EdgeTable table = buildEdgeTable(F, vertexCount);
    std::vector<char> erased(F.rows(), 0);
    bool any = false;
    std::vector<std::pair<int, int>> apexes;  // third vertex, face
    for (int e = 0; e < table.edges.rows(); ++e) {
        apexes.clear();
        for (int u = table.useStart[e]; u < table.useStart[e + 1]; ++u) {
            const int f = table.use[u] / 3;
            const int apex = F(f, (table.use[u] % 3 + 2) % 3);
            if (apex > table.edges(e, 1)) {  // each face at one of its edges: that of its least two
                apexes.emplace_back(apex, f);
            }
        }
        std::sort(apexes.begin(), apexes.end());
        for (std::size_t i = 1; i < apexes.size(); ++i) {
            if (apexes[i].first == apexes[i - 1].first) {
                erased[apexes[i].second] = 1;
                any = true;
                notes.add(ErrorCode::DuplicateFacesRemoved, "face", translatable("removed"),
                          part.mesh.V.row(table.edges(e, 0)));
            }
        }
    }
    if (any) {
        eraseFaces(part, erased);
        table = buildEdgeTable(F, vertexCount);
    }
    return table;
}

}  // namespace toile
