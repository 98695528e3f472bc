// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>

#include "core/mesh/repair_steps.h"

namespace toile {
namespace {

double areaOf(const MeshArrays& mesh, int f) {
    const Eigen::RowVector3d a = mesh.V.row(mesh.F(f, 1)) - mesh.V.row(mesh.F(f, 0));
    const Eigen::RowVector3d b = mesh.V.row(mesh.F(f, 2)) - mesh.V.row(mesh.F(f, 0));
    return a.cross(b).norm() / 2;
}

/// The way that is turned has the larger area by more than rounding; where the two are equal, the
/// first face decides.
bool outweighs(double turned, double kept) {
    return turned > kept * (1 + 1e-9);
}

/// Both sides run the same way: the faces look to opposite sides.
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
            area[sides.turn[queue[at]] == 0 ? 0 : 1] += areaOf(mesh, queue[at]);
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
    // A face keeps its first corner, so its first and last side change places.
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
            notes.add(ErrorCode::WindingsTurned, "face", translatable("turned"),
                      part.mesh.V.row(F(f, 0)));
        }
    }
}

}  // namespace toile
