// SPDX-License-Identifier: GPL-3.0-or-later
#include <queue>

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
            note(toile::translatable("dropped at the border"), side);
            drop(side / 3);
        } else if (apexOf(F_, side) == apexOf(F_, other)) {
            note(toile::translatable("dropped in pairs"), side);
            zip(side, other);
        } else {
            if (!shapeOf(part_.mesh, other / 3).flat) {  // else it only moves on
                note(toile::translatable("given to the neighbour"), side);
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
                note(toile::translatable("dropped with all around them"), 3 * f);
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

}  // namespace toile
