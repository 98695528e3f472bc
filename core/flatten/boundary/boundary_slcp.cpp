// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/QR>

#include "core/base/text.h"
#include "core/flatten/boundary/boundary_problem.h"

namespace toile {
namespace {

constexpr int kMaxPrograms = 500;
/// Size of the gradient of the Lagrangian at which the iteration stops: angles in radians, closure
/// relative to the perimeter.
constexpr double kProgramTolerance = 1e-11;

using Constraints = Eigen::Vector3d;
using Jacobian = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// phi_i = sum over k <= i of (pi - theta_k): summing the turns instead of i*pi - sum theta keeps
/// the digits of long outlines.
Eigen::VectorXd directionsOf(const Eigen::VectorXd& theta) {
    Eigen::VectorXd phi(theta.size());
    double turned = 0;
    for (int i = 0; i < theta.size(); ++i) {
        turned += std::numbers::pi - theta[i];
        phi[i] = turned;
    }
    return phi;
}

/// Eq. (10) to (12): turning once, and closing in x and y.
Constraints constraintsAt(const BoundaryProblem& problem, const Eigen::VectorXd& phi) {
    const int n = static_cast<int>(phi.size());
    return {phi[n - 1] - 2 * std::numbers::pi, (problem.lengths.array() * phi.array().cos()).sum(),
            (problem.lengths.array() * phi.array().sin()).sum()};
}

/// Derivatives of the constraints by theta; rows 2 and 3 are suffix sums, O(n).
Jacobian jacobianAt(const BoundaryProblem& problem, const Eigen::VectorXd& phi) {
    Jacobian A(3, phi.size());
    A.row(0).setConstant(-1);
    double suffixSin = 0;
    double suffixCos = 0;
    for (Eigen::Index i = phi.size() - 1; i >= 0; --i) {
        suffixSin += problem.lengths[i] * std::sin(phi[i]);
        suffixCos += problem.lengths[i] * std::cos(phi[i]);
        A(1, i) = suffixSin;
        A(2, i) = -suffixCos;
    }
    return A;
}

}  // namespace

Result<FlatBoundary> solveBoundarySlcp(const BoundaryProblem& problem, const Progress& progress) {
    Eigen::VectorXd theta = detail::spreadDeficit(problem.angles);
    Eigen::Vector3d lambda = Eigen::Vector3d::Zero();
    double size = 0;
    for (int iteration = 0; iteration <= kMaxPrograms; ++iteration) {
        if (progress.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        const Eigen::VectorXd phi = directionsOf(theta);
        const Constraints c = constraintsAt(problem, phi);
        const Jacobian A = jacobianAt(problem, phi);
        const Eigen::VectorXd gradient =
            problem.angles - theta - A.transpose() * lambda;  // B_theta, eq. (17)
        size = std::max(gradient.lpNorm<Eigen::Infinity>(), c.lpNorm<Eigen::Infinity>());
        if (!std::isfinite(size)) {
            break;
        }
        if (size <= kProgramTolerance) {
            return detail::closeOutline(problem, phi, iteration);
        }
        // Eq. (20): A A^T dlambda = A B_theta - B_lambda with B_lambda = -c. The orthogonal
        // decomposition stands a rank of two (collinear outlines).
        const Eigen::Matrix3d AAt = A * A.transpose();
        const Eigen::Vector3d step = AAt.completeOrthogonalDecomposition().solve(A * gradient + c);
        theta += gradient - A.transpose() * step;  // eq. (21)
        lambda += step;
    }
    return Error{
        ErrorCode::BoundaryNotConverged,
        {},
        worded("not within %1 steps, gradient %2", {figure(kMaxPrograms), shortest(size)})};
}

}  // namespace toile
