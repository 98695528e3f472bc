// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"
#include "core/mesh/repair_steps.h"

namespace toile {

void separateFans(MeshPart& part, const Gluing& gluing, RepairNotes& notes) {
    Triangles& F = part.mesh.F;
    geometry::DisjointSets fans(static_cast<int>(F.size()));
    for (int side = 0; side < static_cast<int>(F.size()); ++side) {
        if (gluing.twin[side] > side) {
            joinCorners(F, side, gluing.twin[side], fans);
        }
    }
    const auto vertexCount = static_cast<int>(part.mesh.V.rows());
    std::vector<char> isTaken(static_cast<std::size_t>(vertexCount), 0);
    std::vector<int> vertexOf(static_cast<std::size_t>(F.size()), -1);  // at a fan's first corner
    std::vector<int> copies;
    for (int corner = 0; corner < static_cast<int>(F.size()); ++corner) {
        int& v = F.data()[corner];
        int& vertex = vertexOf[fans.root(corner)];
        if (vertex < 0 && std::exchange(isTaken[v], 1) == 0) {
            vertex = v;
        } else if (vertex < 0) {
            vertex = vertexCount + static_cast<int>(copies.size());
            copies.push_back(v);
        }
        v = vertex;
    }
    std::vector<char> isNoted(gluing.cutAtVertex);
    for (const int v : copies) {
        if (isNoted[v] == 0) {  // the ends of separated edges are part of that note
            isNoted[v] = 1;
            notes.add(ErrorCode::VerticesSplit, "vertex", translatable("split"),
                      part.mesh.V.row(v));
        }
    }
    if (!copies.empty()) {
        appendCopies(part, copies);
    }
}

namespace {

/// One round: each face is halved at most once, so that the sides found remain valid.
class EdgeSplitter {
public:
    EdgeSplitter(MeshPart& part, Gluing& gluing, RepairNotes& notes)
        : part_(part),
          gluing_(gluing),
          twin_(gluing.twin),
          notes_(notes),
          touched_(part.mesh.F.rows(), 0) {}

    /// Returns false if no edge was doubled.
    bool round() {
        collect();
        if (chosen_.empty()) {
            return false;
        }
        // Reserve once: a vertex for each edge, a face for each side.
        int sideCount = 0;
        std::vector<int> ends;
        for (const int side : chosen_) {
            sideCount += twin_[side] < 0 ? 1 : 2;
            ends.push_back(tailOf(part_.mesh.F, side));
        }
        nextVertex_ = static_cast<int>(part_.mesh.V.rows());
        nextFace_ = static_cast<int>(part_.mesh.F.rows());
        appendCopies(part_, ends);
        part_.mesh.F.conservativeResize(nextFace_ + sideCount, 3);
        part_.sourceFace.resize(nextFace_ + sideCount);
        twin_.resize(twin_.size() + static_cast<std::size_t>(3) * sideCount, -1);
        for (const int side : chosen_) {
            split(side);
        }
        return true;
    }

private:
    void collect() {
        const EdgeTable table = buildEdgeTable(part_.mesh.F, static_cast<int>(part_.mesh.V.rows()));
        for (int e = 0; e < table.edges.rows(); ++e) {
            const std::span<const int> uses = table.usesOf(e);
            for (const int side : uses.subspan(1)) {
                const int other = twin_[side];
                // Uses are sorted: handle a joined edge at its smaller side.
                if (other == uses[0] || (other >= 0 && other < side)) {
                    continue;
                }
                if (touched_[side / 3] == 0 && (other < 0 || touched_[other / 3] == 0)) {
                    touched_[side / 3] = 1;
                    if (other >= 0) {
                        touched_[other / 3] = 1;
                    }
                    chosen_.push_back(side);
                }
            }
        }
    }

    void split(int side) {
        Points3& V = part_.mesh.V;
        const int other = twin_[side];
        const bool opposed =
            other >= 0 && tailOf(part_.mesh.F, side) == tailOf(part_.mesh.F, other);
        V.row(nextVertex_) =
            0.5 * (V.row(tailOf(part_.mesh.F, side)) + V.row(headOf(part_.mesh.F, side)));
        part_.sourceVertex[nextVertex_] = -1;
        notes_.add(ErrorCode::VerticesAdded, "vertex", toile::translatable("added"),
                   V.row(nextVertex_));
        const int second = halve(side);
        if (other >= 0) {
            const int otherSecond = halve(other);
            gluing_.join(side, opposed ? other : otherSecond);
            gluing_.join(second, opposed ? otherSecond : other);
        }
        ++nextVertex_;
    }

    /// Divides abc, with `side` from a to b, into amc and a new face mbc. Returns side mb.
    int halve(int side) {
        int* corner = part_.mesh.F.data();
        const int next = nextSide(side);
        const int g = 3 * nextFace_;
        corner[g] = nextVertex_;
        corner[g + 1] = corner[next];
        corner[g + 2] = corner[nextSide(next)];
        corner[next] = nextVertex_;
        part_.sourceFace[nextFace_++] = part_.sourceFace[side / 3];
        gluing_.join(g + 1, twin_[next]);
        gluing_.join(g + 2, next);
        return g;
    }

    MeshPart& part_;
    Gluing& gluing_;
    std::vector<int>& twin_;
    RepairNotes& notes_;
    std::vector<char> touched_;
    std::vector<int> chosen_;
    int nextVertex_ = 0;
    int nextFace_ = 0;
};

}  // namespace

bool splitDoubledEdges(MeshPart& part, Gluing& gluing, RepairNotes& notes) {
    bool any = false;
    while (gluing.mayDouble && EdgeSplitter(part, gluing, notes).round()) {
        any = true;
    }
    return any;
}

}  // namespace toile
