// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include <Eigen/Geometry>

#include "core/geometry/disjoint_sets.h"
#include "core/mesh/repair_steps.h"

namespace toile {
namespace {

/// Pairs are compared in steps of this angle, so that rounding does not decide between equals.
constexpr double kAngleStep = 1e-6;
/// Added to the bend of a pair whose windings disagree, and of one that nothing else joins. So a
/// fin never replaces the surface that it is attached to, and two solids that touch along an edge
/// stay separate.
constexpr double kHandicap = std::numbers::pi / 2;
/// If more faces than this share one edge, pairs are meaningless, and comparing all would be
/// quadratic: all are separated.
constexpr std::size_t kMaxFacesPaired = 64;

/// Two faces that might be joined at an edge. The order of the members is the order of preference.
struct Pair {
    int cost;  ///< in steps: the bend, with handicaps
    int edge;
    int a, b;  ///< sides
    int turn;  ///< 1 if their windings disagree

    bool operator<(const Pair& other) const {
        return std::tie(cost, edge, a, b, turn) <
               std::tie(other.cost, other.edge, other.a, other.b, other.turn);
    }
};

class Gluer {
public:
    Gluer(const MeshArrays& mesh, const EdgeTable& table, RepairNotes& notes)
        : mesh_(mesh), notes_(notes), table_(table) {}

    Gluing run() {
        gluing_.twin.assign(mesh_.F.size(), -1);
        gluing_.cutAtVertex.assign(mesh_.V.rows(), 0);
        std::vector<int> crowded;
        for (int e = 0; e < table_.edges.rows(); ++e) {
            const std::span<const int> uses = table_.usesOf(e);
            if (uses.size() == 2) {
                gluing_.join(uses[0], uses[1]);
            } else if (uses.size() > 2) {
                crowded.push_back(e);
                for (const int v : {table_.edges(e, 0), table_.edges(e, 1)}) {
                    gluing_.cutAtVertex[v] = 1;
                }
                notes_.add(ErrorCode::EdgesCutApart, "edge", toile::translatable("cut apart"),
                           mesh_.V.row(table_.edges(e, 0)));
            }
        }
        if (!crowded.empty()) {
            gluing_.mayDouble = true;
            pairUp(crowded);
        }
        return std::move(gluing_);
    }

private:
    void pairUp(const std::vector<int>& crowded) {
        const Sides sides = findSides(mesh_, gluing_.twin);
        std::vector<Pair> pairs;
        for (const int e : crowded) {
            collectPairs(e, sides, pairs);
        }
        std::sort(pairs.begin(), pairs.end());
        // Each component as given, and flipped: a join must not make the two one.
        geometry::DisjointSets ways(2 * static_cast<int>(sides.oneSided.size()));
        for (std::size_t c = 0; c < sides.oneSided.size(); ++c) {
            if (sides.oneSided[c] != 0) {
                ways.join(static_cast<int>(2 * c), static_cast<int>(2 * c + 1));
            }
        }
        for (const Pair& pair : pairs) {
            const int p = 2 * sides.component[pair.a / 3];
            const int q = 2 * sides.component[pair.b / 3];
            const bool isOneSided = ways.root(p) == ways.root(p + 1);
            if (gluing_.twin[pair.a] >= 0 || gluing_.twin[pair.b] >= 0 ||
                isOneSided != (ways.root(q) == ways.root(q + 1)) ||
                (!isOneSided && ways.root(p) == ways.root(q + 1 - pair.turn))) {
                continue;
            }
            gluing_.join(pair.a, pair.b);
            ways.join(p, q + pair.turn);
            ways.join(p + 1, q + 1 - pair.turn);
        }
    }

    void collectPairs(int e, const Sides& sides, std::vector<Pair>& pairs) const {
        const std::span<const int> uses = table_.usesOf(e);
        if (uses.size() > kMaxFacesPaired) {
            return;
        }
        const auto isForward = [&](int side) {
            const bool runs = tailOf(mesh_.F, side) == table_.edges(e, 0);
            return runs != (sides.turn[side / 3] != 0);
        };
        for (std::size_t i = 0; i < uses.size(); ++i) {
            for (std::size_t j = i + 1; j < uses.size(); ++j) {
                const int a = uses[i], b = uses[j];
                const int turn = isForward(a) == isForward(b) ? 1 : 0;
                const int strange = sides.component[a / 3] == sides.component[b / 3] ? 0 : 1;
                const double cost = bend(e, a, b) + (turn + strange) * kHandicap;
                pairs.push_back({static_cast<int>(std::lround(cost / kAngleStep)), e, a, b, turn});
            }
        }
    }

    /// The angle between two faces across an edge, in radians; 0 if they continue straight. A flat
    /// face has no direction and counts as a fold.
    double bend(int e, int a, int b) const {
        if (shapeOf(mesh_, a / 3).flat || shapeOf(mesh_, b / 3).flat) {
            return std::numbers::pi;
        }
        const Eigen::RowVector3d p = away(e, a);
        const Eigen::RowVector3d q = away(e, b);
        return std::atan2(p.cross(q).norm(), -p.dot(q));
    }

    /// Unit direction from the edge into a face, perpendicular to the edge.
    Eigen::RowVector3d away(int e, int side) const {
        const Eigen::RowVector3d origin = mesh_.V.row(table_.edges(e, 0));
        const Eigen::RowVector3d along = (mesh_.V.row(table_.edges(e, 1)) - origin).normalized();
        const Eigen::RowVector3d toApex = mesh_.V.row(apexOf(mesh_.F, side)) - origin;
        return (toApex - toApex.dot(along) * along).normalized();
    }

    const MeshArrays& mesh_;
    RepairNotes& notes_;
    const EdgeTable& table_;
    Gluing gluing_;
};

}  // namespace

Gluing glue(const MeshArrays& mesh, const EdgeTable& table, RepairNotes& notes) {
    return Gluer(mesh, table, notes).run();
}

namespace {

/// Whether the flipped winding has the larger area by more than rounding; if both are equal, the
/// first face decides.
bool outweighs(double turned, double kept) {
    return turned > kept * (1 + 1e-9);
}

/// Both sides run the same way: the faces have opposite orientations.
bool isOpposed(const Triangles& F, int side, int twin) {
    return tailOf(F, side) == tailOf(F, twin);
}

}  // namespace

Sides findSides(const MeshArrays& mesh, const std::vector<int>& twin) {
    const int faceCount = static_cast<int>(mesh.F.rows());
    Sides sides;
    sides.component.assign(faceCount, -1);
    sides.turn.assign(faceCount, 0);
    std::vector<int> queue;
    queue.reserve(faceCount);
    for (int seed = 0; seed < faceCount; ++seed) {
        if (sides.component[seed] >= 0) {
            continue;
        }
        const int label = static_cast<int>(sides.oneSided.size());
        bool isOneSided = false;
        bool anyOpposed = false;
        const std::size_t first = queue.size();
        queue.push_back(seed);
        sides.component[seed] = label;
        for (std::size_t at = first; at < queue.size(); ++at) {
            const int f = queue[at];
            for (int side = 3 * f; side < 3 * f + 3; ++side) {
                if (twin[side] < 0) {
                    continue;
                }
                const int g = twin[side] / 3;
                const bool opposed = isOpposed(mesh.F, side, twin[side]);
                const char turn = opposed ? static_cast<char>(1 - sides.turn[f]) : sides.turn[f];
                anyOpposed = anyOpposed || opposed;
                if (sides.component[g] < 0) {
                    sides.component[g] = label;
                    sides.turn[g] = turn;
                    queue.push_back(g);
                } else if (sides.turn[g] != turn) {
                    isOneSided = true;
                }
            }
        }
        sides.oneSided.push_back(isOneSided ? 1 : 0);
        if (!anyOpposed) {
            continue;
        }
        double area[2] = {0, 0};
        for (std::size_t at = first; at < queue.size(); ++at) {
            area[sides.turn[queue[at]] == 0 ? 0 : 1] +=
                0.5 * doubleAreaNormal(mesh, queue[at]).norm();
        }
        for (std::size_t at = first; at < queue.size(); ++at) {
            char& turn = sides.turn[queue[at]];
            turn = isOneSided ? char{0}
                              : static_cast<char>(outweighs(area[1], area[0]) ? 1 - turn : turn);
            sides.anyTurn = sides.anyTurn || turn != 0;
        }
    }
    return sides;
}

void turnWindings(MeshPart& part, Gluing& gluing, RepairNotes& notes) {
    Triangles& F = part.mesh.F;
    const Sides sides = findSides(part.mesh, gluing.twin);
    if (!sides.anyTurn) {
        return;
    }
    // A face keeps its first corner, so its first and last side are swapped.
    const auto moved = [&](int side) {
        return side >= 0 && sides.turn[side / 3] != 0 ? 3 * (side / 3) + 2 - side % 3 : side;
    };
    std::vector<int> twin(gluing.twin.size());
    for (int side = 0; side < static_cast<int>(twin.size()); ++side) {
        twin[moved(side)] = moved(gluing.twin[side]);
    }
    gluing.twin = std::move(twin);
    for (int f = 0; f < F.rows(); ++f) {
        if (sides.turn[f] != 0) {
            std::swap(F(f, 1), F(f, 2));
            notes.add(ErrorCode::WindingsTurned, "face", translatable("flipped"),
                      part.mesh.V.row(F(f, 0)));
        }
    }
}

}  // namespace toile
