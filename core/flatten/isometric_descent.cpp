// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/isometric_descent.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/flatten/isometric_objective.h"
#include "core/flatten/length_constraints.h"
#include "core/quality/measures.h"
#include "core/quality/outline_crossings.h"

namespace toile {
namespace {

/// The augmented Lagrangian's stiffness over that of the energy: each back-substitution lowers the
/// violation of the linearised lengths by about this factor.
constexpr double kStiffness = 1e4;
constexpr int kMaxMultiplierUpdates = 12;
/// Change of a length, relative to the largest motion, that a step may leave over.
constexpr double kLinearisedLengths = 1e-7;
/// Added to the diagonal, in parts of it: rotations are nearly free.
constexpr double kRegularisation[] = {1e-9, 1e-6, 1e-3};
constexpr int kMaxCorrections = 6;
constexpr double kSmallCorrection = 1e-3;  // of an edge: the boundary alone may take it
constexpr double kLargestCorrection = 1;   // of an edge: the quadratic model says nothing beyond
constexpr double kSufficientDecrease = 1e-4;
constexpr double kBackOff = 0.9;  // of the way to the first triangle without area
constexpr int kMaxHalvings = 40;
/// An excess of energy below this is rounding.
constexpr double kNoExcess = 1e-10;

double dot(const Points2& a, const Points2& b) {
    return a.cwiseProduct(b).sum();
}

class Descent {
public:
    Descent(const MeshArrays& mesh, const EdgeTable& table, const std::vector<int>& boundary,
            bool keepOutlineSimple, const Progress& progress)
        : progress_(progress),
          boundary_(boundary),
          lengths_(boundaryLengths3d(mesh.V, boundary)),
          objective_(mesh, table, boundary, lengths_, keepOutlineSimple),
          constraints_(boundary, lengths_),
          multipliers_(Eigen::VectorXd::Zero(lengths_.size())) {}

    const IsometricObjective& objective() const { return objective_; }

    /// The step of the quadratic programme, and how much it promises to take off the objective.
    Result<Points2> step(const Points2& Q, const IsometricObjective::Value& at, double& promised) {
        const Points2 g = objective_.gradient(Q, at);
        directions_ = constraints_.directions(Q);
        const auto factorised = factorise(Q, at);
        if (!factorised) {
            return factorised.error();
        }
        auto P = solveKkt(-g, Eigen::VectorXd::Zero(lengths_.size()), multipliers_);
        if (P) {
            promised = -0.5 * dot(g, *P);
        }
        return P;
    }

    /// Takes the step, or as much of it as lowers the objective. False where none does.
    bool advance(Points2& Q, IsometricObjective::Value& at, const Points2& P, double promised) {
        double t = kBackOff * objective_.largestStep(Q, P, 1 / kBackOff);
        for (int k = 0; k < kMaxHalvings && !progress_.isCancelled(); ++k, t *= 0.5) {
            Points2 moved = Q + t * P;
            if (!regainLengths(moved)) {
                continue;
            }
            IsometricObjective::Value reached = objective_.evaluate(moved);
            if (reached.total < at.total - 2 * kSufficientDecrease * t * promised &&
                (!objective_.keepsOutlineSimple() || outlineIsSimple(moved, boundary_))) {
                Q = std::move(moved);
                at = std::move(reached);
                return true;
            }
        }
        return false;
    }

private:
    Result<void> factorise(const Points2& Q, const IsometricObjective::Value& at) {
        Result<void> factorised = Error{ErrorCode::FactorisationFailed, "", ""};
        for (const double regularisation : kRegularisation) {
            const auto hessian = objective_.hessian(Q, at);
            BlockMatrix& K = hessian.matrix;
            // Translations cost nothing: one vertex on a spring takes that freedom and no other.
            K.addVertex(boundary_.front(),
                        K.largestOnDiagonal(boundary_.front()) * Eigen::Matrix2d::Identity());
            const std::size_t n = boundary_.size();
            stiffness_.resize(lengths_.size());
            for (std::size_t i = 0; i < n; ++i) {
                stiffness_[static_cast<Eigen::Index>(i)] =
                    kStiffness * std::max(K.largestOnDiagonal(boundary_[i]),
                                          K.largestOnDiagonal(boundary_[(i + 1) % n]));
            }
            K.scaleDiagonal(1 + regularisation);
            constraints_.addHessian(Q, stiffness_, multipliers_, K);
            factorised = hessian.samePattern ? cholesky_.refactorise(K.matrix())
                                             : cholesky_.factorise(K.matrix());
            if (factorised || factorised.error().code != ErrorCode::FactorisationFailed) {
                break;
            }
        }
        return factorised;
    }

    /// Solves  H P + A^T y = right,  A P = -c  by the augmented Lagrangian: y is the first guess of
    /// the multipliers and then their value.
    Result<Points2> solveKkt(const Points2& right, const Eigen::VectorXd& c, Eigen::VectorXd& y) {
        Points2 P;
        for (int k = 0; k < kMaxMultiplierUpdates; ++k) {
            Points2 forces = right;
            constraints_.addForces(directions_, -(y + stiffness_.cwiseProduct(c)), forces);
            const auto solved =
                cholesky_.solve(Eigen::Map<const Eigen::VectorXd>(forces.data(), forces.size()));
            if (!solved) {
                return solved.error();
            }
            if (!solved->allFinite()) {
                return Error{ErrorCode::NotFinite, "", "a step of the isometric descent"};
            }
            P = Eigen::Map<const Points2>(solved->data(), forces.rows(), 2);
            const Eigen::VectorXd left = constraints_.along(directions_, P) + c;
            y += stiffness_.cwiseProduct(left);
            if (left.lpNorm<Eigen::Infinity>() <=
                kLinearisedLengths * P.lpNorm<Eigen::Infinity>()) {
                break;
            }
        }
        return P;
    }

    /// Gives a stepped piece its exact boundary lengths back. Where they are off by much, the whole
    /// piece moves as the quadratic model finds cheapest, with the step's own factorisation; moving
    /// the boundary alone would flip the triangles along it.
    bool regainLengths(Points2& Q) {
        for (int k = 0; k < kMaxCorrections; ++k) {
            const Eigen::VectorXd c = constraints_.residual(Q);
            const double worst = c.cwiseQuotient(lengths_).lpNorm<Eigen::Infinity>();
            if (worst <= kSmallCorrection) {
                break;
            }
            if (!(worst <= kLargestCorrection)) {
                return false;
            }
            Eigen::VectorXd y = Eigen::VectorXd::Zero(c.size());
            const auto P = solveKkt(Points2::Zero(Q.rows(), 2), c, y);
            if (!P) {
                return false;
            }
            Q += *P;
        }
        return constraints_.restore(Q);
    }

    const Progress& progress_;
    const std::vector<int>& boundary_;
    Eigen::VectorXd lengths_;
    IsometricObjective objective_;
    LengthConstraints constraints_;
    SparseCholesky cholesky_;
    Eigen::VectorXd multipliers_;
    Points2 directions_;         ///< of the boundary edges, as factorised
    Eigen::VectorXd stiffness_;  ///< of the boundary edges, as factorised
};

}  // namespace

Result<DescentResult> lowerIsometricEnergy(const MeshArrays& mesh, const EdgeTable& table,
                                           const std::vector<int>& boundary, const Points2& start,
                                           const DescentOptions& options,
                                           const Progress& progress) {
    Descent descent(mesh, table, boundary, options.keepOutlineSimple, progress);
    DescentResult result;
    result.Q = start;
    IsometricObjective::Value at = descent.objective().evaluate(start);
    if (!std::isfinite(at.total)) {
        return Error{ErrorCode::NotFinite, "", "the start has flipped triangles or touches itself"};
    }
    double first = 0;  // promise over tolerance at the start: the way to go, by its logarithm
    while (result.iterations < options.maxIterations && !progress.isCancelled()) {
        double promised = 0;
        const auto step = descent.step(result.Q, at, promised);
        if (!step && step.error().code == ErrorCode::OutOfMemory) {
            return step.error();
        }
        if (!step) {
            break;  // what was reached stands
        }
        // A step that promises a rise was not found exactly enough to go on with.
        const double wanted = options.tolerance * std::max(at.total - 1, kNoExcess);
        result.converged = std::abs(promised) <= wanted;
        if (promised <= wanted || !descent.advance(result.Q, at, *step, promised)) {
            break;
        }
        ++result.iterations;
        first = std::max(first, std::log(promised / wanted));
        progress.report(1 - std::log(promised / wanted) / first);
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, "", ""};
    }
    // The objective has fallen. Its small terms may have fallen at the cost of the distortion.
    const double before = descent.objective().distortion(start);
    result.distortion = descent.objective().distortion(result.Q);
    if (result.distortion > before && !options.keepOutlineSimple) {
        result.Q = start;
        result.distortion = before;
    }
    return result;
}

}  // namespace toile
