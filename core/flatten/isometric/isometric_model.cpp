// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/isometric_model.h"

#include <algorithm>

namespace toile {
namespace {

constexpr double kStiffness = 1e4;

}  // namespace

Eigen::VectorXd lengthStiffness(const BlockMatrix& hessian, const std::vector<int>& boundary) {
    const std::size_t n = boundary.size();
    Eigen::VectorXd stiffness(static_cast<Eigen::Index>(n));
    for (std::size_t i = 0; i < n; ++i) {
        stiffness[static_cast<Eigen::Index>(i)] =
            kStiffness * std::max(hessian.largestOnDiagonal(boundary[i]),
                                  hessian.largestOnDiagonal(boundary[(i + 1) % n]));
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
