// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/flatten/isometric/coarsening.h"
#include "core/flatten/isometric/kkt_solver.h"

namespace toile::isometric {
namespace {

/// Remaining error of a follow-up solution, in the energy norm, relative to its first guess: even a
/// small change of the right side must have an effect.
constexpr double kAccuracyAfter = 0.1;
/// Errors below this are rounding.
constexpr double kNoError = 1e-8;
constexpr int kMaxIterations = 200;

}  // namespace

/// The coarse piece and its matrix.
struct TwoLevelSolver::Coarse {
    Coarse(const MeshArrays& mesh, const EdgeTable& fine, const EdgeLoops& loops, const Points2& Q,
           const Eigen::VectorXd& lengths, bool keepOutlineSimple, const Progress& progress)
        : piece(mesh, fine, loops, Q, progress),
          table(buildEdgeTable(piece.mesh().F, static_cast<int>(piece.mesh().V.rows()))),
          objective(piece.mesh(), table, piece.loops(), lengths, keepOutlineSimple),
          constraints(piece.loops(), lengths) {}
    Coarse(const Coarse&) = delete;
    Coarse& operator=(const Coarse&) = delete;

    Coarsening piece;
    EdgeTable table;
    IsometricObjective objective;
    LengthConstraints constraints;
    linalg::SparseCholesky cholesky;
};

TwoLevelSolver::TwoLevelSolver(const MeshArrays& mesh, const EdgeTable& table, EdgeLoops loops,
                               const Eigen::VectorXd& lengths, bool keepOutlineSimple,
                               const Progress& progress, double accuracy)
    : mesh_(mesh),
      table_(table),
      loops_(std::move(loops)),
      lengths_(lengths),
      keepOutlineSimple_(keepOutlineSimple),
      progress_(progress),
      accuracy_(accuracy) {}

TwoLevelSolver::~TwoLevelSolver() = default;

Result<void> TwoLevelSolver::renew(const linalg::BlockMatrix& K, const ModelPoint& point,
                                   const Eigen::VectorXd& stiffness, double regularisation) {
    K_ = &K;
    coarse_.reset();
    // Coarsened again each time: its triangles must not be flipped at this point.
    coarse_ = std::make_unique<Coarse>(mesh_, table_, loops_, point.Q, lengths_, keepOutlineSimple_,
                                       progress_);
    if (progress_.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    if (!coarse_->piece.savesWork()) {
        return Error{ErrorCode::FactorisationFailed, {}, "no coarse piece"};
    }
    const Points2 Q = coarse_->piece.restricted(point.Q);
    const auto at = coarse_->objective.evaluate(Q);
    linalg::BlockMatrix& coarse = coarse_->objective.hessian(Q, at).matrix;
    addSpring(coarse, coarse_->piece.loops().vertex(0));
    addLengths(coarse, coarse_->constraints, {Q, at, point.multipliers}, stiffness, regularisation);
    if (progress_.isCancelled()) {
        return Error{ErrorCode::Cancelled};
    }
    return coarse_->cholesky.factorise(coarse.matrix());
}

bool TwoLevelSolver::solve(const Points2& right, Points2& x, double& first) {
    // Conjugate gradients [NW06].
    Points2 r = right - K_->product(x);
    Points2 d;
    double rz = 0;
    double enough = 0;
    for (int k = 0; k < kMaxIterations; ++k) {
        const auto z = precondition(r);
        if (!z) {
            return false;
        }
        const double before = std::exchange(rz, dot(r, *z));
        if (k == 0) {
            const bool follows = first > 0;
            first = follows ? first : rz;
            enough = accuracy_ * accuracy_ * first;
            if (follows) {
                enough = std::clamp(kAccuracyAfter * kAccuracyAfter * rz,
                                    kNoError * kNoError * first, enough);
            }
        }
        if (!(rz >= 0 && std::isfinite(rz))) {
            return false;
        }
        if (rz <= enough) {
            return true;
        }
        if (k == 0) {
            d = *z;
        } else {
            d = *z + rz / before * d;
        }
        ++rounds_;
        const Points2 Kd = K_->product(d);
        const double stiffness = dot(d, Kd);
        if (!(stiffness > 0)) {
            return false;
        }
        x += rz / stiffness * d;
        r -= rz / stiffness * Kd;
    }
    return false;
}

std::optional<Points2> TwoLevelSolver::precondition(const Points2& residual) {
    // Forward sweep, coarse level, backward sweep: symmetric and positive definite.
    Points2 z = residual;
    K_->sweepForth(z);
    Points2 left = -K_->upperProduct(z);
    if (progress_.isCancelled()) {
        return std::nullopt;
    }
    const Points2 coarse = coarse_->piece.restrictedForces(left);
    const auto solved =
        coarse_->cholesky.solve(Eigen::Map<const Eigen::VectorXd>(coarse.data(), coarse.size()));
    if (!solved) {
        return std::nullopt;
    }
    const Points2 motion =
        coarse_->piece.prolongedMotion(Eigen::Map<const Points2>(solved->data(), coarse.rows(), 2));
    if (progress_.isCancelled()) {
        return std::nullopt;
    }
    z += motion;
    left -= K_->product(motion);
    K_->sweepBack(left);
    z += left;
    return z;
}

}  // namespace toile::isometric
