// SPDX-License-Identifier: GPL-3.0-or-later
#include <queue>
#include <utility>

#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"
#include "core/mesh/repair_steps.h"

namespace toile {
namespace {

constexpr ErrorCode kCode = ErrorCode::FlatFacesRemoved;
/// Flips allowed per flat triangle found at first.
constexpr long long kFlipsPerFace = 32;

struct Flat {
    double longest;
    int face;

    /// Queue order: longest first, then smallest face.
    bool operator<(const Flat& o) const {
        return longest != o.longest ? longest < o.longest : face > o.face;
    }
};

class FlatRemover {
public:
    FlatRemover(MeshPart& part, Gluing& gluing, RepairNotes& notes)
        : part_(part), F_(part.mesh.F), gluing_(gluing), twin_(gluing.twin), notes_(notes) {}

    bool run() {
        for (int f = 0; f < F_.rows(); ++f) {
            push(f);
        }
        if (queue_.empty()) {
            return false;
        }
        gone_.assign(F_.rows(), 0);
        gluing_.mayDouble = true;
        dropFlatComponents();
        long long budget = kFlipsPerFace * static_cast<long long>(queue_.size());
        while (!queue_.empty() && budget-- > 0) {
            const Flat top = queue_.top();
            queue_.pop();
            const FaceShape shape = shapeOf(part_.mesh, top.face);
            if (gone_[top.face] == 0 && shape.flat && shape.longest == top.longest) {
                take(3 * top.face + shape.longestSide);
            }
        }
        compact();
        return true;
    }

private:
    void push(int f) {
        const FaceShape shape = shapeOf(part_.mesh, f);
        if (shape.flat) {
            queue_.push({shape.longest, f});
        }
    }

    void note(const char* what, int side) {
        notes_.add(kCode, "triangle", what, part_.mesh.V.row(apexOf(F_, side)));
    }

    void drop(int f) {
        gone_[f] = 1;
        for (int side = 3 * f; side < 3 * f + 3; ++side) {
            gluing_.join(twin_[side], -1);
            twin_[side] = -1;
        }
    }

    /// Removes the flat face whose longest side is `side`.
    void take(int side) {
        const int other = twin_[side];
        if (other < 0) {
            note(toile::translatable("removed at the boundary"), side);
            drop(side / 3);
        } else if (apexOf(F_, side) == apexOf(F_, other)) {
            note(toile::translatable("removed in pairs"), side);
            zip(side, other);
        } else {
            if (!shapeOf(part_.mesh, other / 3).flat) {  // else it only moves on
                note(toile::translatable("merged into the neighbour"), side);
            }
            flip(side, other);
        }
    }

    /// The side of the face of `side`, other than it, that ends at vertex v.
    int sideAt(int side, int v) const {
        const int next = nextSide(side);
        return tailOf(F_, next) == v ? next : nextSide(next);
    }

    /// Removes two flat faces on the same three vertices and joins the faces beyond them.
    void zip(int side, int other) {
        for (const int v : {tailOf(F_, side), headOf(F_, side)}) {
            const int a = sideAt(side, v);
            const int b = sideAt(other, v);
            if (twin_[a] != b) {
                gluing_.join(twin_[a], twin_[b]);
            }
            twin_[a] = -1;
            twin_[b] = -1;
        }
        gone_[side / 3] = 1;
        gone_[other / 3] = 1;
    }

    /// Divides the neighbour pqd at the flat face's vertex c, in its own winding: pcd and cqd.
    void flip(int side, int other) {
        const int f = side / 3;
        const int g = other / 3;
        const int p = tailOf(F_, other);
        const int q = headOf(F_, other);
        const int c = apexOf(F_, side);
        const int d = apexOf(F_, other);
        const int pc = twin_[sideAt(side, p)];
        const int cq = twin_[sideAt(side, q)];
        const int qd = twin_[sideAt(other, q)];
        const int dp = twin_[sideAt(other, p)];
        F_.row(f) << p, c, d;
        F_.row(g) << c, q, d;
        part_.sourceFace[f] = part_.sourceFace[g];  // its area comes from the neighbour
        gluing_.join(3 * f, pc);
        gluing_.join(3 * f + 1, 3 * g + 2);
        gluing_.join(3 * f + 2, dp);
        gluing_.join(3 * g, cq);
        gluing_.join(3 * g + 1, qd);
        push(f);
        push(g);
    }

    void dropFlatComponents() {
        const Sides sides = findSides(part_.mesh, twin_);
        std::vector<char> hasArea(sides.oneSided.size(), 0);
        for (int f = 0; f < F_.rows(); ++f) {
            if (!shapeOf(part_.mesh, f).flat) {
                hasArea[sides.component[f]] = 1;
            }
        }
        for (int f = 0; f < F_.rows(); ++f) {
            if (hasArea[sides.component[f]] == 0) {
                note(toile::translatable("removed with all around them"), 3 * f);
                gone_[f] = 1;
            }
        }
    }

    void compact() {
        std::vector<int> newFace(F_.rows(), -1);
        int kept = 0;
        for (int f = 0; f < F_.rows(); ++f) {
            if (gone_[f] == 0) {
                newFace[f] = kept++;
            }
        }
        for (int f = 0; f < F_.rows(); ++f) {
            for (int k = 0; newFace[f] >= 0 && k < 3; ++k) {
                const int t = twin_[3 * f + k];
                twin_[3 * newFace[f] + k] = t < 0 ? -1 : 3 * newFace[t / 3] + t % 3;
            }
        }
        twin_.resize(static_cast<std::size_t>(3) * kept);
        eraseFaces(part_, gone_);
    }

    MeshPart& part_;
    Triangles& F_;
    Gluing& gluing_;
    std::vector<int>& twin_;
    RepairNotes& notes_;
    std::priority_queue<Flat> queue_;
    std::vector<char> gone_;
};

}  // namespace

bool removeFlats(MeshPart& part, Gluing& gluing, RepairNotes& notes) {
    return FlatRemover(part, gluing, notes).run();
}

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
