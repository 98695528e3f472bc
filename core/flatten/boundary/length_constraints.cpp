// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/boundary/length_constraints.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace toile {
namespace {

constexpr int kMaxSteps = 30;
/// Length error that counts as exact: of the edge, or of the piece's extent if that is more.
constexpr double kExact = 1e-13;
constexpr double kDigits = 4e-15;
/// Multiple of it below which lack of progress also counts as convergence.
constexpr double kNearlyExact = 100;
/// Above this the lengths are too far off to try.
constexpr double kFar = 4;

/// Solves the cyclic tridiagonal system with 2 on the diagonal and beside_i coupling i and i + 1;
/// the corner is removed as a rank one change (Sherman and Morrison).
Eigen::VectorXd solveCyclic(const Eigen::VectorXd& beside, const Eigen::VectorXd& right) {
    const Eigen::Index n = right.size();
    const double corner = beside[n - 1];
    constexpr double kGamma = -2;  // of the order of the diagonal, opposite sign: no cancellation
    Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(n, 2);
    diagonal[0] -= kGamma;
    diagonal[n - 1] -= corner * corner / kGamma;
    Eigen::MatrixX2d b = Eigen::MatrixX2d::Zero(n, 2);
    b.col(0) = right;
    b(0, 1) = kGamma;
    b(n - 1, 1) = corner;
    for (Eigen::Index i = 1; i < n; ++i) {
        const double factor = beside[i - 1] / diagonal[i - 1];
        diagonal[i] -= factor * beside[i - 1];
        b.row(i) -= factor * b.row(i - 1);
    }
    b.row(n - 1) /= diagonal[n - 1];
    for (Eigen::Index i = n - 2; i >= 0; --i) {
        b.row(i) = (b.row(i) - beside[i] * b.row(i + 1)) / diagonal[i];
    }
    const double share = corner / kGamma;
    const Eigen::RowVector2d both = b.row(0) + share * b.row(n - 1);
    return b.col(0) - both[0] / (1 + both[1]) * b.col(1);
}

}  // namespace

EdgeLoops::EdgeLoops(std::vector<int> outline)
    : EdgeLoops(std::vector<std::vector<int>>{std::move(outline)}) {}

EdgeLoops::EdgeLoops(const std::vector<std::vector<int>>& loops) {
    for (const auto& loop : loops) {
        const int first = count();
        const int last = first + static_cast<int>(loop.size()) - 1;
        starts_.push_back(first);
        vertices_.insert(vertices_.end(), loop.begin(), loop.end());
        for (int i = first; i <= last; ++i) {
            next_.push_back(i < last ? i + 1 : first);
            previous_.push_back(i > first ? i - 1 : last);
        }
    }
    starts_.push_back(count());
}

std::vector<int> EdgeLoops::loop(int index) const {
    return {vertices_.begin() + starts_[index], vertices_.begin() + starts_[index + 1]};
}

EdgeLoops EdgeLoops::renumbered(const std::vector<int>& numbers) const {
    EdgeLoops other = *this;
    for (int& v : other.vertices_) {
        v = numbers[v];
    }
    return other;
}

EdgeLoops EdgeLoops::withLengths(Eigen::VectorXd lengths) const {
    EdgeLoops other = *this;
    other.lengths_ = std::move(lengths);
    return other;
}

EdgeLoops EdgeLoops::withOutlineHeld() const {
    EdgeLoops other = *this;
    other.holdsOutline_ = true;
    return other;
}

void EdgeLoops::clearHeld(Points2& motion) const {
    for (int i = 0; i < starts_[1] && holdsOutline_; ++i) {
        motion.row(vertices_[i]).setZero();
    }
}

Eigen::VectorXd EdgeLoops::lengths(const Points3& V) const {
    if (lengths_.size() > 0) {
        return lengths_;
    }
    Eigen::VectorXd lengths(count());
    for (int i = 0; i < count(); ++i) {
        lengths[i] = (V.row(end(i)) - V.row(vertex(i))).norm();
    }
    return lengths;
}

LengthConstraints::LengthConstraints(EdgeLoops loops, Eigen::VectorXd lengths)
    : loops_(std::move(loops)), lengths_(std::move(lengths)) {}

Points2 LengthConstraints::directions(const Points2& Q) const {
    const int n = count();
    Points2 u(n, 2);
    for (int i = 0; i < n; ++i) {
        u.row(i) = (Q.row(loops_.end(i)) - Q.row(loops_.vertex(i))).normalized();
    }
    return u;
}

Eigen::VectorXd LengthConstraints::residual(const Points2& Q) const {
    const int n = count();
    Eigen::VectorXd c(n);
    for (int i = 0; i < n; ++i) {
        c[i] = (Q.row(loops_.end(i)) - Q.row(loops_.vertex(i))).norm() - lengths_[i];
    }
    return c;
}

Eigen::VectorXd LengthConstraints::along(const Points2& directions, const Points2& P) const {
    const int n = count();
    Eigen::VectorXd rates(n);
    for (int i = 0; i < n; ++i) {
        rates[i] = directions.row(i).dot(P.row(loops_.end(i)) - P.row(loops_.vertex(i)));
    }
    return rates;
}

void LengthConstraints::addForces(const Points2& directions, const Eigen::VectorXd& y,
                                  Points2& G) const {
    const int n = count();
    for (int i = 0; i < n; ++i) {
        G.row(loops_.vertex(i)) -= y[i] * directions.row(i);
        G.row(loops_.end(i)) += y[i] * directions.row(i);
    }
}

void LengthConstraints::addHessian(const Points2& Q, const Eigen::VectorXd& stiffness,
                                   const Eigen::VectorXd& multipliers,
                                   linalg::BlockMatrix& hessian) const {
    const int n = count();
    for (int i = 0; i < n; ++i) {
        const int v = loops_.vertex(i);
        const int w = loops_.end(i);
        const Eigen::Vector2d edge = Q.row(w) - Q.row(v);
        const double length = edge.norm();
        const Eigen::Matrix2d onto = edge * edge.transpose() / (length * length);
        const double pull = std::max(multipliers[i], 0.0) / length;
        const Eigen::Matrix2d block =
            stiffness[i] * onto + pull * (Eigen::Matrix2d::Identity() - onto);
        hessian.addVertex(v, block);
        hessian.addVertex(w, block);
        hessian.addEdge(hessian.findEdge(v, w), -block);
    }
}

double LengthConstraints::worstError(const Points2& Q, const Eigen::VectorXd& residual) const {
    double extent = 0;
    for (const int v : loops_.vertices()) {
        extent = std::max(extent, Q.row(v).lpNorm<Eigen::Infinity>());
    }
    // The rounding of its ends limits the length accuracy of an edge much shorter than the piece.
    const Eigen::VectorXd allowed = (kExact * lengths_).cwiseMax(kDigits * extent);
    return residual.cwiseQuotient(allowed).lpNorm<Eigen::Infinity>();
}

bool LengthConstraints::areKept(const Points2& Q) const {
    return worstError(Q, residual(Q)) <= kNearlyExact;
}

bool LengthConstraints::restore(Points2& Q) const {
    const int n = count();
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < kMaxSteps; ++step) {
        const Eigen::VectorXd c = residual(Q);
        const double worst = worstError(Q, c);
        if (worst <= 1) {
            return true;
        }
        const bool stalls = worst <= kNearlyExact && worst > 0.5 * before;
        if (stalls || !(c.cwiseQuotient(lengths_).lpNorm<Eigen::Infinity>() <= kFar)) {
            return stalls;
        }
        before = worst;
        const Points2 u = directions(Q);
        Eigen::VectorXd beside(n);
        for (int i = 0; i < n; ++i) {
            beside[i] = -u.row(i).dot(u.row(loops_.next(i)));
        }
        Eigen::VectorXd y(n);
        for (int k = 0; k < loops_.loopCount(); ++k) {
            const int first = loops_.start(k);
            const int size = loops_.start(k + 1) - first;
            y.segment(first, size) =
                solveCyclic(beside.segment(first, size), -c.segment(first, size));
        }
        if (!y.allFinite()) {
            return false;
        }
        addForces(u, y, Q);
    }
    return false;
}

}  // namespace toile
