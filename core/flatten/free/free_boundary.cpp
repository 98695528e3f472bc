// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/free/free_boundary.h"

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "core/quality/measures.h"

namespace toile {
namespace {

/// Of vertices equally far apart (symmetric pieces) the first is taken, whatever rounding says.
constexpr double kClearlyFarther = 1 + 1e-9;
/// Each sweep only lengthens the pair; two or three suffice.
constexpr int kMaxSweeps = 8;

using DistancesFrom = std::function<Eigen::VectorXd(int vertex)>;

int farthest(const std::vector<int>& boundary, const Eigen::VectorXd& distance) {
    int best = boundary.front();
    for (const int v : boundary) {
        if (distance[v] > kClearlyFarther * distance[best]) {
            best = v;
        }
    }
    return best;
}

std::array<int, 2> farPair(const Piece& piece, const DistancesFrom& distancesFrom) {
    Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
    for (const int v : piece.boundary) {
        middle += piece.mesh.V.row(v) / static_cast<double>(piece.boundary.size());
    }
    int first = farthest(piece.boundary, (piece.mesh.V.rowwise() - middle).rowwise().norm());
    int second = first;
    double apart = 0;
    for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
        const Eigen::VectorXd distance = distancesFrom(first);
        const int next = farthest(piece.boundary, distance);
        if (!(distance[next] > kClearlyFarther * apart)) {
            break;
        }
        apart = distance[next];
        second = std::exchange(first, next);
    }
    return {first, second};
}

/// Dijkstra's shortest paths along the edges.
Eigen::VectorXd pathLengths(const Piece& piece, int from) {
    const Edges& edges = piece.table.edges;
    const auto vertexCount = static_cast<std::size_t>(piece.mesh.V.rows());
    std::vector<int> start(vertexCount + 1, 0);
    for (int e = 0; e < edges.rows(); ++e) {
        ++start[edges(e, 0) + 1];
        ++start[edges(e, 1) + 1];
    }
    for (std::size_t v = 0; v < vertexCount; ++v) {
        start[v + 1] += start[v];
    }
    std::vector<int> around(static_cast<std::size_t>(2 * edges.rows()));
    std::vector<int> next(start.begin(), start.end() - 1);
    for (int e = 0; e < edges.rows(); ++e) {
        around[next[edges(e, 0)]++] = edges(e, 1);
        around[next[edges(e, 1)]++] = edges(e, 0);
    }
    Eigen::VectorXd distance = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(vertexCount),
                                                         std::numeric_limits<double>::infinity());
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    distance[from] = 0;
    open.emplace(0, from);
    while (!open.empty()) {
        const auto [reached, v] = open.top();
        open.pop();
        if (reached > distance[v]) {
            continue;
        }
        for (int k = start[v]; k < start[v + 1]; ++k) {
            const int w = around[k];
            const double through = reached + (piece.mesh.V.row(w) - piece.mesh.V.row(v)).norm();
            if (through < distance[w]) {
                distance[w] = through;
                open.emplace(through, w);
            }
        }
    }
    return distance;
}

}  // namespace

std::array<int, 2> farPairInSpace(const Piece& piece) {
    return farPair(piece, [&](int v) -> Eigen::VectorXd {
        return (piece.mesh.V.rowwise() - piece.mesh.V.row(v)).rowwise().norm();
    });
}

std::array<int, 2> farPairAlongEdges(const Piece& piece) {
    return farPair(piece, [&](int v) { return pathLengths(piece, v); });
}

Result<FlatPiece> atTrueSize(const Piece& piece, const Points2& points, const Stopwatch& time) {
    const double scale = boundaryLengths3d(piece.mesh.V, piece.boundary).sum() /
                         boundaryLengths2d(points, piece.boundary).sum();
    FlatPiece flat;
    flat.Q = scale * points;
    if (!flat.Q.allFinite()) {
        return Error{ErrorCode::NotFinite, "", "flat positions"};
    }
    flat.angleEnergy = angleEnergy(boundaryAngles3d(piece.mesh, piece.boundary),
                                   boundaryAngles2d(flat.Q, piece.boundary));
    flat.interiorSeconds = time.seconds();
    return flat;
}

}  // namespace toile
