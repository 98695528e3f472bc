// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric/kkt_solver.h"

namespace toile::isometric {
namespace {

constexpr int kMaxMultiplierUpdates = 12;
/// Change of a length, relative to the largest motion, that a step may leave: the lengths are
/// restored after it, and the next step starts from its multipliers.
constexpr double kLinearisedLengths = 1e-3;
/// Added to the diagonal, relative to it.
constexpr double kRegularisation[] = {1e-9, 1e-6, 1e-3};
/// Cost of a factorisation, in back-substitutions.
constexpr double kFactorisingCost = 12;
/// Rounds of conjugate gradients that take about as long as a factorisation or two: after so many,
/// more will follow, and back-substitutions would be cheaper.
constexpr int kManyRounds = 100;
/// Cost of a new coarse level, in solutions by conjugate gradients.
constexpr double kCoarseningCost = 1;

}  // namespace

KktSolver::KktSolver(const MeshArrays& mesh, const EdgeTable& table, const Eigen::VectorXd& lengths,
                     const LengthConstraints& constraints, bool keepOutlineSimple,
                     const KktSizes& sizes, const Progress& progress)
    : constraints_(constraints),
      progress_(progress),
      large_(mesh.V.rows() >= sizes.large),
      huge_(mesh.V.rows() >= sizes.huge) {
    if (large_) {
        twoLevel_.emplace(mesh, table, constraints.loops(), lengths, keepOutlineSimple, progress,
                          sizes.accuracy);
    }
}

double KktSolver::renewingCost() const {
    return twoLevel_ ? kCoarseningCost : kFactorisingCost;
}

Result<void> KktSolver::renew(IsometricObjective& objective, const ModelPoint& point) {
    adopted_ = nullptr;
    factorised_ = false;
    directions_ = constraints_.directions(point.Q);
    if (twoLevel_ && !huge_ && twoLevel_->rounds() > kManyRounds) {
        twoLevel_.reset();
    }
    Result<void> ready = Error{ErrorCode::FactorisationFailed};
    for (const double regularisation : kRegularisation) {
        const auto hessian = objective.hessian(point.Q, point.at);
        laidOut_ = laidOut_ && hessian.samePattern;
        K_ = &hessian.matrix;
        addSpring(hessian.matrix, constraints_.loops().vertex(0));
        stiffness_ = lengthStiffness(hessian.matrix, constraints_.loops());
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
        auto ready = twoLevel_->renew(*K_, point, stiffness_, regularisation);
        if (ready || ready.error().code != ErrorCode::FactorisationFailed) {
            return ready;
        }
        twoLevel_.reset();
    }
    return factorise(*K_);
}

Result<void> KktSolver::factorise(const linalg::BlockMatrix& K) {
    if (cholesky_ == nullptr || cholesky_.use_count() > 1) {
        cholesky_ = std::make_shared<linalg::SparseCholesky>();  // a shared factor must not change
        laidOut_ = false;
    }
    if (!laidOut_) {
        if (auto analysed = cholesky_->analyse(K.matrix()); !analysed) {
            return analysed;
        }
        laidOut_ = true;
    }
    auto factorised = cholesky_->refactorise(K.matrix());
    factorised_ = factorised.ok();
    return factorised;
}

std::shared_ptr<const KktModel> KktSolver::share() const {
    if (adopted_ || !factorised_ || large_) {
        return adopted_;
    }
    return std::make_shared<const KktModel>(KktModel{cholesky_, directions_, stiffness_});
}

Result<Points2> KktSolver::solve(const Points2& right, const Eigen::VectorXd& c,
                                 Eigen::VectorXd& y) {
    const Points2& directions = adopted_ ? adopted_->directions : directions_;
    const Eigen::VectorXd& stiffness = adopted_ ? adopted_->stiffness : stiffness_;
    Points2 P = Points2::Zero(right.rows(), 2);
    double first = 0;  // error that conjugate gradients start with
    for (int k = 0; k < kMaxMultiplierUpdates; ++k) {
        Points2 forces = right;
        constraints_.addForces(directions, -(y + stiffness.cwiseProduct(c)), forces);
        if (const auto solved = solveOnce(forces, P, first); !solved) {
            return solved.error();
        }
        constraints_.loops().clearHeld(P);
        const Eigen::VectorXd left = constraints_.along(directions, P) + c;
        y += stiffness.cwiseProduct(left);
        if (left.lpNorm<Eigen::Infinity>() <= kLinearisedLengths * P.lpNorm<Eigen::Infinity>()) {
            break;
        }
    }
    return P;
}

Result<void> KktSolver::solveOnce(const Points2& forces, Points2& P, double& first) {
    if (twoLevel_ && !adopted_) {
        if (twoLevel_->solve(forces, P, first)) {
            return {};
        }
        if (progress_.isCancelled()) {
            return Error{ErrorCode::Cancelled};
        }
        // Rare: factorise after all, which needs more memory.
        twoLevel_.reset();
        if (auto factorised = factorise(*K_); !factorised) {
            return factorised;
        }
    }
    const Eigen::Map<const Eigen::VectorXd> b(forces.data(), forces.size());
    const auto solved = (adopted_ ? *adopted_->factor : *cholesky_).solve(b);
    if (!solved) {
        return solved.error();
    }
    if (!solved->allFinite()) {
        return Error{ErrorCode::NotFinite, {}, "a step of the isometric descent"};
    }
    P = Eigen::Map<const Points2>(solved->data(), forces.rows(), 2);
    return {};
}

}  // namespace toile::isometric
