// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/outline_bending.h"

#include <cmath>
#include <utility>

#include "core/geometry/segment.h"

namespace toile {

OutlineBending::OutlineBending(EdgeLoops loops, Eigen::VectorXd angles,
                               const Eigen::VectorXd& lengths, double stiffness)
    : loops_(std::move(loops)), angles_(std::move(angles)), weights_(lengths.size()) {
    const double whole = lengths.sum();
    for (int i = 0; i < loops_.count(); ++i) {
        weights_[i] = 0.5 * stiffness * (lengths[i] + lengths[loops_.previous(i)]) / whole;
    }
}

OutlineBending::Turn OutlineBending::turnAt(const Points2& Q, int i) const {
    Turn turn{};
    turn.vertex[0] = loops_.vertex(loops_.previous(i));
    turn.vertex[1] = loops_.vertex(i);
    turn.vertex[2] = loops_.end(i);
    const Eigen::RowVector2d next = Q.row(turn.vertex[2]) - Q.row(turn.vertex[1]);
    const Eigen::RowVector2d back = Q.row(turn.vertex[0]) - Q.row(turn.vertex[1]);
    // The inner angle: from the next edge anti-clockwise to the one before.
    const double theta = turnBetween(next, back);
    const double half = 0.5 * (theta - angles_[i]);
    turn.excess = 2 * std::sin(half);
    const auto turned = [](const Eigen::RowVector2d& e) -> Eigen::RowVector2d {
        return Eigen::RowVector2d(-e.y(), e.x()) / e.squaredNorm();
    };
    const double slope = std::cos(half);
    turn.slope[0] = slope * turned(back);
    turn.slope[2] = -slope * turned(next);
    turn.slope[1] = -turn.slope[0] - turn.slope[2];
    return turn;
}

double OutlineBending::energy(const Points2& Q) const {
    double sum = 0;
    for (int i = 0; i < loops_.count(); ++i) {
        const double excess = turnAt(Q, i).excess;
        sum += weights_[i] * excess * excess;
    }
    return sum;
}

void OutlineBending::addGradient(const Points2& Q, Points2& g) const {
    for (int i = 0; i < loops_.count(); ++i) {
        const Turn turn = turnAt(Q, i);
        for (int k = 0; k < 3; ++k) {
            g.row(turn.vertex[k]) += 2 * weights_[i] * turn.excess * turn.slope[k];
        }
    }
}

void OutlineBending::addHessian(const Points2& Q, BlockMatrix& hessian) const {
    for (int i = 0; i < loops_.count(); ++i) {
        const Turn turn = turnAt(Q, i);
        for (int a = 0; a < 3; ++a) {
            const Eigen::RowVector2d pull = 2 * weights_[i] * turn.slope[a];
            hessian.addVertex(turn.vertex[a], pull.transpose() * turn.slope[a]);
            for (int b = a + 1; b < 3; ++b) {
                // Rows belong to the larger vertex.
                const bool rises = turn.vertex[a] < turn.vertex[b];
                const Eigen::Matrix2d block = turn.slope[rises ? b : a].transpose() *
                                              turn.slope[rises ? a : b] * (2 * weights_[i]);
                hessian.addEdge(hessian.findEdge(turn.vertex[a], turn.vertex[b]), block);
            }
        }
    }
}

}  // namespace toile
