// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/tolerances.h"
#include "core/mesh/disk_check.h"
#include "core/mesh/sides.h"

namespace toile {
namespace {

/// Lengths and heights must be this many times what the careful checks ask for, so that how they
/// round makes no difference.
constexpr double kPlainly = 2;

/// No NaN or infinity passes: a comparison with NaN is false, and so is one of infinities here.
bool hasPlainShape(const MeshArrays& mesh, int face) {
    const Eigen::Vector3d at = mesh.V.row(mesh.F(face, 0));
    const Eigen::Vector3d a = mesh.V.row(mesh.F(face, 1)).transpose() - at;
    const Eigen::Vector3d b = mesh.V.row(mesh.F(face, 2)).transpose() - at;
    const double aa = a.squaredNorm();
    const double bb = b.squaredNorm();
    const double cc = (b - a).squaredNorm();
    const double longest2 = std::max({aa, bb, cc});
    const double least = kPlainly * kDegenerateHeight;
    return std::min({aa, bb, cc}) > least * least * longest2 &&
           a.cross(b).squaredNorm() > least * longest2 * (least * longest2);
}

/// The other side at each side's edge, -1 on the border; nothing where an edge is not plain.
std::vector<int> plainTwins(const Triangles& F, const EdgeTable& table) {
    std::vector<int> twin(static_cast<std::size_t>(F.size()));
    const int edgeCount = static_cast<int>(table.edges.rows());
    for (int e = 0; e < edgeCount; ++e) {
        const std::span<const int> use = table.usesOf(e);
        if (use.size() == 1) {
            twin[use[0]] = -1;
        } else if (use.size() == 2 && tailOf(F, use[0]) != tailOf(F, use[1]) &&
                   apexOf(F, use[0]) != apexOf(F, use[1])) {
            twin[use[0]] = use[1];
            twin[use[1]] = use[0];
        } else {
            return {};
        }
    }
    return twin;
}

/// Every vertex has faces, and a walk around it from one to the next meets them all.
bool hasWholeFans(const Triangles& F, Eigen::Index vertexCount, const std::vector<int>& twin) {
    std::vector<int> first(static_cast<std::size_t>(vertexCount), -1);  // side that leaves it
    std::vector<int> unseen(static_cast<std::size_t>(vertexCount), 0);
    const int sideCount = static_cast<int>(F.size());
    for (int side = 0; side < sideCount; ++side) {
        const int v = tailOf(F, side);
        ++unseen[v];
        if (first[v] < 0 || twin[side] < 0) {  // a walk over an open fan starts at its border
            first[v] = side;
        }
    }
    for (std::size_t v = 0; v < first.size(); ++v) {
        if (first[v] < 0) {
            return false;
        }
        int side = first[v];
        do {
            --unseen[v];
            side = twin[previousSide(side)];
        } while (side >= 0 && side != first[v]);
        if (unseen[v] != 0) {
            return false;
        }
    }
    return true;
}

}  // namespace

bool isSoundSurface(const MeshArrays& mesh, const EdgeTable& table) {
    for (int f = 0; f < mesh.F.rows(); ++f) {
        if (!hasPlainShape(mesh, f)) {
            return false;
        }
    }
    const std::vector<int> twin = plainTwins(mesh.F, table);
    return twin.size() == static_cast<std::size_t>(mesh.F.size()) &&
           hasWholeFans(mesh.F, mesh.V.rows(), twin);
}

}  // namespace toile
