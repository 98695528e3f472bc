// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/repair.h"

#include <utility>

#include "core/mesh/disk_check.h"
#include "core/mesh/repair_steps.h"

namespace toile {
namespace {

/// Giving flat triangles to their neighbours can bring two vertices of one place together in an
/// edge, which the next round collapses; halving a sliver can make it flat. More rounds than this
/// are not needed, only feared.
constexpr int kMostRounds = 8;

void noteUnusedVertices(const MeshPart& part, RepairNotes& notes) {
    std::vector<char> used(part.mesh.V.rows(), 0);
    for (Eigen::Index corner = 0; corner < part.mesh.F.size(); ++corner) {
        used[part.mesh.F.data()[corner]] = 1;
    }
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

RepairResult repair(MeshPart part, const RepairOptions& options, const std::string& name) {
    EdgeTable table = buildEdgeTable(part.mesh.F, static_cast<int>(part.mesh.V.rows()));
    if (isSoundSurface(part.mesh, table)) {
        return {std::move(part), {}, std::move(table)};
    }
    table = {};
    RepairNotes notes;
    noteUnusedVertices(part, notes);
    dropUnusableFaces(part, notes);
    bool again = true;
    for (int round = 0; again && round < kMostRounds; ++round) {
        collapseNeedles(part, notes);
        const EdgeTable edges = dropDuplicates(part, notes);
        Gluing gluing = glue(part.mesh, edges, options.turnWindings, notes);
        again = removeFlats(part, gluing, notes);
        if (options.turnWindings) {
            turnWindings(part, gluing, notes);
        }
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
