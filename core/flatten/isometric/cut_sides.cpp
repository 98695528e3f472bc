// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/cut_sides.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

#include "core/garment/piece.h"

namespace toile {
namespace {

/// Per boundary vertex its mate, both by their place in the loop, or -1.
std::vector<int> mates(const Piece& piece) {
    const auto n = static_cast<int>(piece.boundary.size());
    const auto placeOf = [&](int i) {
        const auto at = piece.mesh.V.row(piece.boundary[i]);
        return std::tuple(at.x(), at.y(), at.z());
    };
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) -> bool {
        return std::tuple(placeOf(a), a) < std::tuple(placeOf(b), b);
    });
    std::vector<int> mate(static_cast<std::size_t>(n), -1);
    for (int first = 0, last = 0; first < n; first = last) {
        for (last = first + 1; last < n && placeOf(order[last]) == placeOf(order[first]);) {
            ++last;
        }
        if (last - first == 2) {
            mate[order[first]] = order[first + 1];
            mate[order[first + 1]] = order[first];
        }
    }
    return mate;
}

}  // namespace

void partCutSides(const Piece& piece, const Eigen::VectorXd& gap, Points2& Q) {
    const auto n = static_cast<int>(piece.boundary.size());
    const std::vector<int> mate = mates(piece);
    const Points2 before = Q;
    const auto at = [&](int i) -> Eigen::RowVector2d { return before.row(piece.boundary[i]); };
    const auto inwards = [&](int i) -> Eigen::RowVector2d {
        const Eigen::RowVector2d along = at((i + 1) % n) - at((i + n - 1) % n);
        return Eigen::RowVector2d(-along.y(), along.x()).normalized();
    };
    for (int i = 0; i < n; ++i) {
        if (mate[i] < 0) {
            continue;
        }
        const Eigen::RowVector2d across = (inwards(i) - inwards(mate[i])).normalized();
        const double missing = gap[i] - (at(i) - at(mate[i])).dot(across);
        if (missing > 0 && across.allFinite()) {
            Q.row(piece.boundary[i]) += 0.5 * missing * across;
        }
    }
}

}  // namespace toile
