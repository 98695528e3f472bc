// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/kkt_solver.h"

namespace toile {
namespace {

constexpr int kMaxMultiplierUpdates = 12;
/// Change of a length, relative to the largest motion, that a step may leave over: the lengths are
/// restored after it, and the next step starts from its multipliers.
constexpr double kLinearisedLengths = 1e-3;
/// Added to the diagonal, in parts of it.
constexpr double kRegularisation[] = {1e-9, 1e-6, 1e-3};
/// What a factorisation costs, in back-substitutions.
constexpr double kFactorisingCost = 12;
/// Rounds of conjugate gradients that take about as long as a factorisation or two: after so many
/// there are more to come, and back-substitutions would be cheaper.
constexpr int kManyRounds = 100;
/// What a new coarse level costs, in solutions by conjugate gradients.
constexpr double kCoarseningCost = 1;

}  // namespace

KktSolver::KktSolver(const MeshArrays& mesh, const std::vector<int>& boundary,
                     const Eigen::VectorXd& lengths, const LengthConstraints& constraints,
                     bool keepOutlineSimple, const KktSizes& sizes, const Progress& progress)
    : boundary_(boundary),
      constraints_(constraints),
      progress_(progress),
      huge_(mesh.V.rows() >= sizes.huge) {
    if (mesh.V.rows() >= sizes.large) {
        twoLevel_.emplace(mesh, boundary, lengths, keepOutlineSimple, progress);
    }
}

double KktSolver::renewingCost() const {
    return twoLevel_ ? kCoarseningCost : kFactorisingCost;
}

Result<void> KktSolver::renew(IsometricObjective& objective, const ModelPoint& point) {
    directions_ = constraints_.directions(point.Q);
    if (twoLevel_ && !huge_ && twoLevel_->rounds() > kManyRounds) {
        twoLevel_.reset();
    }
    Result<void> ready = Error{ErrorCode::FactorisationFailed, "", ""};
    for (const double regularisation : kRegularisation) {
        const auto hessian = objective.hessian(point.Q, point.at);
        laidOut_ = laidOut_ && hessian.samePattern;
        K_ = &hessian.matrix;
        addSpring(hessian.matrix, boundary_.front());
        stiffness_ = lengthStiffness(hessian.matrix, boundary_);
        addLengths(hessian.matrix, constraints_, point, stiffness_, regularisation);
        ready = layOut(point, regularisation);
        if (ready || ready.error().code != ErrorCode::FactorisationFailed) {
            break;
        }
    }
    return ready;
}

Result<void> KktSolver::layOut(const ModelPoint& point, double regularisation) {
    if (twoLevel_) {
        const auto ready = twoLevel_->renew(*K_, point, stiffness_, regularisation);
        if (ready || ready.error().code != ErrorCode::FactorisationFailed) {
            return ready;
        }
        twoLevel_.reset();
    }
    return factorise(*K_);
}

Result<void> KktSolver::factorise(const BlockMatrix& K) {
    if (laidOut_) {
        return cholesky_.refactorise(K.matrix());
    }
    const auto factorised = cholesky_.factorise(K.matrix());
    laidOut_ = factorised || factorised.error().code == ErrorCode::FactorisationFailed;
    return factorised;
}

Result<Points2> KktSolver::solve(const Points2& right, const Eigen::VectorXd& c,
                                 Eigen::VectorXd& y) {
    Points2 P = Points2::Zero(right.rows(), 2);
    double first = 0;  // of the errors that conjugate gradients begin with
    for (int k = 0; k < kMaxMultiplierUpdates; ++k) {
        Points2 forces = right;
        constraints_.addForces(directions_, -(y + stiffness_.cwiseProduct(c)), forces);
        if (const auto solved = solveOnce(forces, P, first); !solved) {
            return solved.error();
        }
        const Eigen::VectorXd left = constraints_.along(directions_, P) + c;
        y += stiffness_.cwiseProduct(left);
        if (left.lpNorm<Eigen::Infinity>() <= kLinearisedLengths * P.lpNorm<Eigen::Infinity>()) {
            break;
        }
    }
    return P;
}

Result<void> KktSolver::solveOnce(const Points2& forces, Points2& P, double& first) {
    if (twoLevel_) {
        if (twoLevel_->solve(forces, P, first)) {
            return {};
        }
        if (progress_.isCancelled()) {
            return Error{ErrorCode::Cancelled, "", ""};
        }
        // Rare. Memory is the price of a result.
        twoLevel_.reset();
        if (const auto factorised = factorise(*K_); !factorised) {
            return factorised;
        }
    }
    const auto solved =
        cholesky_.solve(Eigen::Map<const Eigen::VectorXd>(forces.data(), forces.size()));
    if (!solved) {
        return solved.error();
    }
    if (!solved->allFinite()) {
        return Error{ErrorCode::NotFinite, "", "a step of the isometric descent"};
    }
    P = Eigen::Map<const Points2>(solved->data(), forces.rows(), 2);
    return {};
}

}  // namespace toile
