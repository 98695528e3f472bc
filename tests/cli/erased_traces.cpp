// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/erased_traces.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "core/mesh/edge_table.h"

namespace toile::test {
namespace {

using Ends = std::pair<int, int>;

/// What is left of twice the smaller area, at least; and the cosine of the bend, at most.
constexpr double kMinArea = 0.3, kNearlyFlat = 0.9;

bool staysFlat(const MeshArrays& mesh, int a, int b, int c, int d) {
    const auto at = [&mesh](int v) -> Eigen::Vector3d { return mesh.V.row(v); };
    const auto twice = [&at](int p, int q, int r) -> Eigen::Vector3d {
        return (at(q) - at(p)).cross(at(r) - at(p));
    };
    const Eigen::Vector3d above = twice(a, b, c), below = twice(b, a, d);
    const Eigen::Vector3d normal = (above + below).normalized();
    const double least = kMinArea * std::min(above.norm(), below.norm());
    return twice(a, d, c).dot(normal) > least && twice(b, c, d).dot(normal) > least &&
           above.normalized().dot(below.normalized()) > kNearlyFlat;
}

void flipEdges(MeshArrays& mesh, std::mt19937& random) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    std::vector<int> order(static_cast<std::size_t>(table.edges.rows()));
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t k = order.size(); k > 1; --k) {  // std::shuffle differs between libraries
        std::swap(order[k - 1], order[random() % k]);
    }
    std::set<Ends> edges;
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        edges.emplace(table.edges(e, 0), table.edges(e, 1));
    }
    std::vector<char> isDone(static_cast<std::size_t>(mesh.F.rows()), 0);
    for (const int edge : order) {
        const auto uses = table.usesOf(edge);
        if (random() % 2 == 0 || uses.size() != 2 || isDone[uses[0] / 3] || isDone[uses[1] / 3]) {
            continue;
        }
        const int a = tailOf(mesh.F, uses[0]), b = headOf(mesh.F, uses[0]);
        const int c = apexOf(mesh.F, uses[0]), d = apexOf(mesh.F, uses[1]);
        if (c == d || edges.contains(std::minmax(c, d)) || !staysFlat(mesh, a, b, c, d)) {
            continue;
        }
        edges.erase(std::minmax(a, b));
        edges.insert(std::minmax(c, d));
        mesh.F.row(uses[0] / 3) << a, d, c;
        mesh.F.row(uses[1] / 3) << b, c, d;
        isDone[uses[0] / 3] = isDone[uses[1] / 3] = 1;
    }
}

void smoothAlongSurface(MeshArrays& mesh) {
    const EdgeTable table = buildEdgeTable(mesh.F, static_cast<int>(mesh.V.rows()));
    Points3 sum = Points3::Zero(mesh.V.rows(), 3), normal = sum;
    Eigen::VectorXd degree = Eigen::VectorXd::Zero(mesh.V.rows());
    std::vector<char> isRim(static_cast<std::size_t>(mesh.V.rows()), 0);
    for (Eigen::Index e = 0; e < table.edges.rows(); ++e) {
        const int a = table.edges(e, 0), b = table.edges(e, 1);
        sum.row(a) += mesh.V.row(b);
        sum.row(b) += mesh.V.row(a);
        degree[a] += 1;
        degree[b] += 1;
        if (table.isBorder(e)) {
            isRim[a] = isRim[b] = 1;
        }
    }
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        for (int k = 0; k < 3; ++k) {
            normal.row(mesh.F(f, k)) += doubleAreaNormal(mesh, f).transpose();
        }
    }
    for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
        if (isRim[v] == 0 && degree[v] > 0) {
            const Eigen::RowVector3d up = normal.row(v).normalized();
            const Eigen::RowVector3d move = (sum.row(v) / degree[v] - mesh.V.row(v)) / 2;
            mesh.V.row(v) += move - move.dot(up) * up;
        }
    }
}

}  // namespace

MeshArrays withoutTraces(MeshArrays mesh, unsigned seed) {
    std::mt19937 random(seed);
    for (int round = 0; round < 3; ++round) {
        flipEdges(mesh, random);
        smoothAlongSurface(mesh);
    }
    return mesh;
}

}  // namespace toile::test
