// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/disk_check.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/base/error.h"
#include "core/base/units.h"
#include "core/base/wording.h"
#include "core/geometry/disjoint_sets.h"
#include "core/mesh/mesh_arrays.h"
#include "core/mesh/repair.h"

namespace toile {
namespace {

constexpr std::size_t kNamedLoops = 4;

/// Counts a fault over the mesh and stores its first position.
struct Fault {
    int count = 0;
    int firstVertex = -1;

    void see(int vertex) {
        if (count++ == 0) {
            firstVertex = vertex;
        }
    }
};

class Checker {
public:
    Checker(const MeshArrays& mesh, const EdgeTable& table, const std::string& name,
            DiskCheck& result)
        : mesh_(mesh), name_(name), table_(table), result_(result) {}

    /// @param valid  the surface is known to be valid: check only loops and edges of the outline
    void run(bool valid) {
        if ((valid || isSurface()) && checkLoops() && (valid || hasShapes())) {
            checkOutlineEdges();
        }
        if (result_.defect) {
            result_.boundary.clear();
        }
    }

    bool isSurface() { return checkFinite() && checkFaces() && checkOrientation() && checkFans(); }

    bool hasShapes() {
        Fault flat;
        for (int f = 0; f < faceCount(); ++f) {
            if (shapeOf(mesh_, f).flat) {
                flat.see(mesh_.F(f, 0));
            }
        }
        return flat.count == 0 || fail(ErrorCode::DegenerateFace, flat, "triangle");
    }

private:
    int vertexCount() const { return static_cast<int>(mesh_.V.rows()); }
    int faceCount() const { return static_cast<int>(mesh_.F.rows()); }
    int edgeCount() const { return static_cast<int>(table_.edges.rows()); }
    std::span<const int> uses(int e) const { return table_.usesOf(e); }

    Wording place(int vertex) const {
        const auto p = mesh_.V.row(vertex);
        return toile::worded("at %1 mm", {barePlaceWording(p.x(), p.y(), p.z())});
    }

    bool fail(ErrorCode code, const Wording& detail) {
        result_.defect = Error{code, Subject::piece(name_), detail};
        return false;
    }

    bool fail(ErrorCode code, const Fault& fault, std::string_view noun) {
        const Wording count = countWording(fault.count, noun), at = place(fault.firstVertex);
        return fail(code, fault.count > 1 ? toile::worded("%1, the first %2", {count, at})
                                          : toile::worded("%1, %2", {count, at}));
    }

    bool checkFinite() {
        // Positions may overflow in the conversion to millimetres.
        return mesh_.V.allFinite() || fail(ErrorCode::NotFinite, toile::worded("positions in mm"));
    }

    /// Repeated corners, faces on the same three vertices, edges with more than two faces.
    bool checkFaces() {
        Fault repeated;
        Fault doubled;
        Fault crowded;
        for (int f = 0; f < faceCount(); ++f) {
            const auto t = mesh_.F.row(f);
            if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
                repeated.see(t[0]);
            }
        }
        if (repeated.count > 0) {
            return fail(ErrorCode::DegenerateFace, repeated, "triangle");
        }
        for (int e = 0; e < edgeCount(); ++e) {
            for ([[maybe_unused]] const int face : doubledFaces(mesh_.F, table_, e)) {
                doubled.see(table_.edges(e, 0));
            }
            if (uses(e).size() > 2) {
                crowded.see(table_.edges(e, 0));
            }
        }
        if (doubled.count > 0) {
            return fail(ErrorCode::DuplicateFace, doubled, "face");
        }
        return crowded.count == 0 || fail(ErrorCode::NonManifoldEdge, crowded, "edge");
    }

    /// Distinguishes windings that can be turned (flood fill by parity) from a one-sided surface.
    bool checkOrientation() {
        Fault opposed;
        geometry::DisjointSets sides(2 * faceCount());  // each face as given, and flipped
        for (int e = 0; e < edgeCount(); ++e) {
            if (uses(e).size() != 2) {
                continue;
            }
            const int a = uses(e)[0], b = uses(e)[1];
            const int same =
                tailOf(mesh_.F, a) == tailOf(mesh_.F, b) ? 1 : 0;  // same direction: opposed
            sides.join(2 * (a / 3), 2 * (b / 3) + same);
            sides.join(2 * (a / 3) + 1, 2 * (b / 3) + 1 - same);
            if (same != 0) {
                opposed.see(table_.edges(e, 0));
            }
        }
        if (opposed.count == 0) {
            return true;
        }
        for (int f = 0; f < faceCount(); ++f) {
            if (sides.root(2 * f) == sides.root(2 * f + 1)) {
                return fail(ErrorCode::NotOrientable, place(mesh_.F(f, 0)));
            }
        }
        return fail(ErrorCode::OpposedWinding, opposed, "edge");
    }

    /// The faces around a vertex must be connected by edges.
    bool checkFans() {
        geometry::DisjointSets corners(3 * faceCount());
        for (int e = 0; e < edgeCount(); ++e) {
            if (uses(e).size() == 2) {
                joinCorners(mesh_.F, uses(e)[0], uses(e)[1], corners);
            }
        }
        Fault pinched;
        std::vector<int> fan(vertexCount(), -1);
        for (int c = 0; c < 3 * faceCount(); ++c) {
            const int v = mesh_.F(c / 3, c % 3);
            const int root = corners.root(c);
            if (fan[v] < 0) {
                fan[v] = root;
            } else if (fan[v] != root && root == c) {
                pinched.see(v);
            }
        }
        return pinched.count == 0 || fail(ErrorCode::NonManifoldVertex, pinched, "vertex");
    }

    /// Most pieces have one rim, which is followed here: half-edges would take a third longer.
    bool checkLoops() {
        std::vector<int> next(vertexCount(), -1);
        std::ptrdiff_t rimEdges = 0;
        int least = -1;
        for (int e = 0; e < edgeCount(); ++e) {
            if (table_.isBorder(e)) {
                next[tailOf(mesh_.F, uses(e)[0])] = headOf(mesh_.F, uses(e)[0]);
                least = ++rimEdges == 1 ? table_.edges(e, 0) : least;
            }
        }
        if (rimEdges == 0) {
            return fail(ErrorCode::ClosedSurface, countWording(faceCount(), "face"));
        }
        for (int v = least; next[v] >= 0; v = std::exchange(next[v], -1)) {
            result_.boundary.push_back(v);
        }
        if (std::ssize(result_.boundary) == rimEdges) {
            return hasNoHandle();
        }
        const std::vector<RimLoop> loops = rimsOf(mesh_, table_);
        Wording places;
        for (std::size_t k = 0; k < std::min(loops.size(), kNamedLoops); ++k) {
            places += k > 0 ? "; " : "";
            places += toile::worded("%1 mm %2",
                                    {figure(loops[k].perimeter), place(loops[k].vertices.front())});
        }
        return fail(ErrorCode::SeveralLoops,
                    toile::worded("%1: %2%3", {countWording(std::ssize(loops), "loop"), places,
                                               loops.size() > kNamedLoops ? "; ..." : ""}));
    }

    bool hasNoHandle() {
        if (vertexCount() - edgeCount() + faceCount() != 1) {
            const int handles = (1 - (vertexCount() - edgeCount() + faceCount())) / 2;
            return fail(ErrorCode::Handle, countWording(handles, "handle"));
        }
        return true;
    }

    bool checkOutlineEdges() {
        const std::vector<int>& loop = result_.boundary;
        std::vector<double> lengths;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            lengths.push_back(
                (mesh_.V.row(loop[(i + 1) % loop.size()]) - mesh_.V.row(loop[i])).norm());
        }
        const double perimeter = std::accumulate(lengths.begin(), lengths.end(), 0.0);
        Fault none;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            if (lengths[i] < kZeroLengthEdge * perimeter) {
                none.see(loop[i]);
            }
        }
        return none.count == 0 || fail(ErrorCode::ZeroLengthEdge, none, "edge");
    }

    const MeshArrays& mesh_;
    const std::string& name_;
    const EdgeTable& table_;
    DiskCheck& result_;
};

}  // namespace

DiskCheck checkDisk(const MeshArrays& mesh, const std::string& name,
                    std::optional<EdgeTable> validTable) {
    DiskCheck result;
    const bool isValid = validTable.has_value();
    result.table =
        isValid ? *std::move(validTable) : buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    Checker(mesh, result.table, name, result).run(isValid);
    return result;
}

bool isValidSurface(const MeshArrays& mesh, const EdgeTable& table) {
    const std::string unnamed;
    DiskCheck unread;
    Checker checker(mesh, table, unnamed, unread);
    return checker.isSurface() && checker.hasShapes() &&
           std::ranges::count(usedVertices(mesh.F, mesh.V.rows()), 0) == 0;
}

}  // namespace toile
