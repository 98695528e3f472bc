// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/repair.h"

#include <algorithm>
#include <utility>

#include "core/base/place_words.h"
#include "core/base/tolerances.h"
#include "core/geometry/disjoint_sets.h"
#include "core/mesh/disk_check.h"
#include "core/mesh/repair_steps.h"

namespace toile {

void RepairNotes::add(ErrorCode code, std::string_view noun, const char* what,
                      const Eigen::RowVector3d& place) {
    for (Entry& entry : entries_) {
        if (entry.code == code && entry.noun == noun && entry.what == std::string_view(what)) {
            ++entry.count;
            return;
        }
    }
    entries_.push_back({code, noun, what, place, 1});
}

Problems RepairNotes::problems(const std::string& piece) const {
    std::vector<Entry> sorted = entries_;
    std::ranges::stable_sort(sorted, {}, &Entry::code);
    Problems problems;
    for (const Entry& entry : sorted) {
        Wording text = toile::worded(
            "%1 %2", {countWording(entry.count, entry.noun), toile::worded(entry.what)});
        if (entry.first.allFinite()) {
            text += entry.count == 1 ? toile::worded(", at ") : toile::worded(", the first at ");
            text += toile::worded(
                "%1 mm", {barePlaceWording(entry.first.x(), entry.first.y(), entry.first.z())});
        }
        if (!problems.empty() && problems.back().code == entry.code) {
            problems.back().detail += "; ";
            problems.back().detail += text;
        } else {
            problems.push_back({entry.code, Subject::piece(piece), text});
        }
    }
    return problems;
}

namespace {

/// An edge of a face without height also counts as having no length below this part of its longest.
/// Giving such needles to neighbours that are as thin would only pass them around.
constexpr double kFlatNeedle = 1e-8;

bool repeatsCorner(const Triangles& F, int f) {
    return F(f, 0) == F(f, 1) || F(f, 1) == F(f, 2) || F(f, 2) == F(f, 0);
}

/// One round over all faces; false if no edge was collapsed.
bool collapseRound(MeshPart& part, RepairNotes& notes) {
    MeshArrays& mesh = part.mesh;
    bool any = false;
    geometry::DisjointSets same(static_cast<int>(mesh.V.rows()));
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
    }
    eraseFaces(part, erased);
}

void collapseNeedles(MeshPart& part, RepairNotes& notes) {
    // A collapse moves a corner by a tiny length and may leave a neighbour without length, but each
    // time by eight digits less: few rounds are needed.
    while (collapseRound(part, notes)) {
    }
}

EdgeTable dropDuplicates(MeshPart& part, RepairNotes& notes) {
    const Triangles& F = part.mesh.F;
    const int vertexCount = static_cast<int>(part.mesh.V.rows());
    EdgeTable table = buildEdgeTable(F, vertexCount);
    std::vector<char> erased(F.rows(), 0);
    for (int e = 0; e < table.edges.rows(); ++e) {
        for (const int face : doubledFaces(F, table, e)) {
            erased[face] = 1;
            notes.add(ErrorCode::DuplicateFacesRemoved, "face", translatable("removed"),
                      part.mesh.V.row(table.edges(e, 0)));
        }
    }
    if (eraseFaces(part, erased)) {
        table = buildEdgeTable(F, vertexCount);
    }
    return table;
}

namespace {

/// Giving flat triangles to their neighbours can create an edge between coinciding vertices, which
/// the next round collapses; halving a sliver can make it flat. An upper bound: known meshes need
/// fewer rounds.
constexpr int kMaxRounds = 8;

void noteUnusedVertices(const MeshPart& part, RepairNotes& notes) {
    const std::vector<char> used = usedVertices(part.mesh.F, part.mesh.V.rows());
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (used[v] == 0) {
            notes.add(ErrorCode::UnusedVertices, "vertex", translatable("left out"),
                      part.mesh.V.row(static_cast<Eigen::Index>(v)));
        }
    }
}

void noteFlatsLeft(const MeshPart& part, RepairNotes& notes) {
    for (int f = 0; f < part.mesh.F.rows(); ++f) {
        if (shapeOf(part.mesh, f).flat) {
            notes.add(ErrorCode::FlatFacesRemoved, "triangle",
                      translatable("still there: all around is as flat"),
                      part.mesh.V.row(part.mesh.F(f, 0)));
        }
    }
}

}  // namespace

RepairResult repair(MeshPart part, const std::string& name) {
    EdgeTable table = buildEdgeTable(part.mesh.F, static_cast<int>(part.mesh.V.rows()));
    if (isValidSurface(part.mesh, table)) {
        return {std::move(part), {}, std::move(table)};
    }
    table = {};
    RepairNotes notes;
    noteUnusedVertices(part, notes);
    dropUnusableFaces(part, notes);
    bool again = true;
    for (int round = 0; again && round < kMaxRounds; ++round) {
        collapseNeedles(part, notes);
        const EdgeTable edges = dropDuplicates(part, notes);
        Gluing gluing = glue(part.mesh, edges, notes);
        again = removeFlats(part, gluing, notes);
        turnWindings(part, gluing, notes);
        separateFans(part, gluing, notes);
        again = splitDoubledEdges(part, gluing, notes) || again;
    }
    if (again) {
        noteFlatsLeft(part, notes);
    }
    if (!notes.empty()) {
        eraseUnusedVertices(part);
    }
    return {std::move(part), notes.problems(name), std::nullopt};
}

}  // namespace toile
