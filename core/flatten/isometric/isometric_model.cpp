// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/isometric_model.h"

#include <algorithm>

namespace toile {
namespace {

constexpr double kStiffness = 1e4;

}  // namespace

Eigen::VectorXd lengthStiffness(const BlockMatrix& hessian, const EdgeLoops& loops) {
    Eigen::VectorXd stiffness(loops.count());
    for (int i = 0; i < loops.count(); ++i) {
        stiffness[i] = kStiffness * std::max(hessian.largestOnDiagonal(loops.vertex(i)),
                                             hessian.largestOnDiagonal(loops.end(i)));
    }
    return stiffness;
}

void addSpring(BlockMatrix& hessian, int v) {
    hessian.addVertex(v, hessian.largestOnDiagonal(v) * Eigen::Matrix2d::Identity());
}

void addLengths(BlockMatrix& hessian, const LengthConstraints& constraints, const ModelPoint& point,
                const Eigen::VectorXd& stiffness, double regularisation) {
    hessian.scaleDiagonal(1 + regularisation);
    constraints.addHessian(point.Q, stiffness, point.multipliers, hessian);
}

}  // namespace toile
