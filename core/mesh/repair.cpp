// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/repair.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/base/wording.h"
#include "core/geometry/buckets.h"
#include "core/geometry/disjoint_sets.h"
#include "core/mesh/disk_check.h"
#include "core/mesh/mesh_arrays.h"
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
                      translatable("kept because their neighbours are flat too"),
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
